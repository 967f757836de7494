#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The velocity of a rigid block and its spin, or a change of both.
template <int D>
struct BlockMotion {
  Vector<D> velocity = Vector<D>::Zero();
  Angular<D> spin = Angular<D>::Zero();

  BlockMotion& operator+=(const BlockMotion& change) {
    velocity += change.velocity;
    spin += change.spin;
    return *this;
  }
  BlockMotion operator-(const BlockMotion& other) const {
    return {velocity - other.velocity, spin - other.spin};
  }
};

}  // namespace halfspace
