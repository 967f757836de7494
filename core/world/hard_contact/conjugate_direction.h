#pragma once

#include <cmath>

namespace halfspace {

/// Accelerates sweeps of projected Gauss-Seidel: forwards and backwards are one step of a symmetric
/// iteration, to which conjugate gradients apply (Fletcher and Reeves; with bounds Silcowitz-Hansen, Niebe
/// and Erleben 2010). A stack of ten takes 9 iterations instead of a thousand, and a block under one a
/// hundred times heavier 4 instead of 78. The next sweep projects impulses beyond their bounds.
class ConjugateDirection {
 public:
  /// After two sweeps whose changes of impulses have this squared length in the metric of the inverse masses.
  void update(double squared_length) {
    is_shorter_ = squared_length <= last_;
    ratio_ = is_shorter_ && squared_length > 0 ? squared_length / last_ : 0;
    last_ = squared_length;
  }
  /// The part of the last direction that is kept, and whether there is any.
  double ratio() const { return ratio_; }
  bool is_shorter() const { return is_shorter_; }
  /// Moves an impulse on along its direction of search, and renews both.
  template <class Impulse>
  Impulse advance(Impulse& impulse, Impulse& previous, Impulse& direction) const {
    const Impulse more = ratio_ * direction;
    direction = is_shorter_ ? Impulse(more + impulse - previous) : Impulse(0 * more);
    impulse += more;
    previous = impulse;
    return more;
  }

 private:
  double last_ = HUGE_VAL;
  double ratio_ = 0;
  bool is_shorter_ = false;
};

}  // namespace halfspace
