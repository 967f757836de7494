#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"

namespace halfspace {

/// The fraction of the coefficient of restitution at which the impulses of an impact do no work. It is 1
/// where Newton's rule loses energy. Where friction makes it gain some (Kane and Levinson 1985), the fraction
/// makes the rule an energetic one (Stronge 1990). Impulses without rebound lose energy. Their work is nearly
/// linear in the square of the fraction, so that a chord between a loss and a gain finds it.
class ReboundFraction {
 public:
  double value() const { return value_; }

  /// Takes the work at the present value. `size`: of all its terms. True if another value is better.
  bool improve(double work, double size) {
    const bool gains = work > work_rounding * size;
    if (gains ? value_ == 0 : value_ == 1 || work > -lost_) return false;
    (gains ? gain_ : loss_) = {value_ * value_, work};
    if (value_ == 1) lost_ = std::min(std::max(4 * work, min_loss * size), max_loss * size);
    if (value_ < 1 && gains) lost_ *= 4;  // the solver's tolerance hides less
    value_ = std::isnan(loss_.work) ? 0 : std::sqrt(square_at(-0.5 * lost_));
    return true;
  }
  /// Returns to the best value at which energy was lost.
  void settle() {
    if (value_ != 1) value_ = std::sqrt(loss_.square);
  }

 private:
  struct End {
    double square;  // of the value
    double work;
  };
  double square_at(double work) const {
    const double part = (loss_.work - work) / (loss_.work - gain_.work);
    return loss_.square + std::clamp(part, 0.0, 1.0) * (gain_.square - loss_.square);
  }

  double value_ = 1;
  double lost_ = 0;  // J, that may be lost for a work below zero
  End loss_ = {0, NAN};
  End gain_ = {1, 0};
};

}  // namespace halfspace
