#pragma once

#include <algorithm>

#include "geometry/tolerances.h"
#include "world/hard_contact/conjugate_direction.h"
#include "world/hard_contact/stall.h"

namespace halfspace {

/// Projected Gauss-Seidel (NLGS, Jean 1999): sweeps over rows, in turn forwards and backwards, accelerated by
/// nonsmooth conjugate gradients after each two. Rows are manifolds (ManifoldRows), points (PointRows), or
/// both (MixedRows). They have `sweep(is_backwards)`, which returns the largest change, as a velocity;
/// `squared_change()` and `accelerate(direction)`; those that are restarted also have
/// `restart_acceleration()`.
template <class Rows>
class AcceleratedSweeps {
 public:
  explicit AcceleratedSweeps(Rows& rows, bool begins_backwards = false)
      : rows_(rows), is_backwards_(begins_backwards) {}

  /// Makes the next sweep. Returns the largest change, as a velocity.
  double next() {
    if (is_symmetric_) accelerate();
    const double changed = rows_.sweep(is_backwards_);
    is_backwards_ = !is_backwards_;
    is_symmetric_ = is_second_;
    is_second_ = !is_second_;
    return changed;
  }
  void accelerate() {
    direction_.update(rows_.squared_change());
    rows_.accelerate(direction_);
  }
  /// The impulses are no longer those that the last sweep left.
  void restart() {
    direction_ = {};
    is_symmetric_ = false;
    rows_.restart_acceleration();
  }

 private:
  Rows& rows_;
  ConjugateDirection direction_;
  bool is_backwards_;
  bool is_second_ = false;     // the next sweep
  bool is_symmetric_ = false;  // since the last acceleration: as many sweeps forwards as backwards
};

struct ImpulseResult {
  int iterations = 0;
  double unbalanced = 0;  // m/s, the largest velocity that the last iteration changed
  bool has_converged = true;
  double fastest = 0;  // m/s, the largest velocity by an impulse

  /// Would no point leave its face by what remains?
  bool is_balanced() const { return unbalanced <= converged_change * fastest; }
  /// Takes that of another island, too.
  void add(const ImpulseResult& other) {
    iterations = std::max(iterations, other.iterations);
    unbalanced = std::max(unbalanced, other.unbalanced);
    has_converged = has_converged && other.has_converged;
    fastest = std::max(fastest, other.fastest);
  }
};

/// Sweeps until all is balanced or changes stall. `fastest`: the largest velocity by an impulse of the start.
template <class Rows>
ImpulseResult balance(Rows& rows, double fastest, int max_sweeps, bool begins_backwards = false) {
  AcceleratedSweeps sweeps(rows, begins_backwards);
  Stall stall;
  ImpulseResult result{.fastest = fastest};
  while (result.iterations < max_sweeps) {
    ++result.iterations;
    result.unbalanced = sweeps.next();
    result.fastest = std::max(result.fastest, result.unbalanced);
    if (result.is_balanced() || stall.is_reached(result.unbalanced)) break;
  }
  return result;
}

}  // namespace halfspace
