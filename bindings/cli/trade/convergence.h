#pragma once

#include <vector>

namespace halfspace::cli {

/// The change of values while a step is halved again and again (Richardson 1911).
struct Convergence {
  bool is_known = false;   ///< three values or more
  bool converges = false;  ///< the last change is smaller than the one before, or nothing but rounding
  double order = 0;        ///< the power of the step with which the change falls; 0 where rounding is all
  double last_change = 0;  ///< between the two finest
  double limit = 0;        ///< what the values tend to, extrapolated; the finest where that cannot be told
};

/// Values go from the coarsest to the finest; `rounding` is what counts as no change.
Convergence convergence_of(const std::vector<double>& values, double rounding);

}  // namespace halfspace::cli
