#pragma once

#include <vector>

namespace halfspace::cli {

/// Convergence under repeated halving of a step (Richardson 1911).
struct Convergence {
  bool is_known = false;   ///< three values or more
  bool converges = false;  ///< the last change is smaller than the one before, or rounding
  double order = 0;        ///< observed order; 0 if the last change is rounding
  double last_change = 0;  ///< between the two finest
  double limit = 0;        ///< extrapolated; the finest value without extrapolation
};

/// `values` go from the coarsest to the finest; changes up to `rounding` are none.
Convergence convergence_of(const std::vector<double>& values, double rounding);

}  // namespace halfspace::cli
