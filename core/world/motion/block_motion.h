#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The velocity of a rigid block and its spin, or a change of both.
template <int D>
struct BlockMotion {
  Vector<D> velocity = Vector<D>::Zero();
  Angular<D> spin = Angular<D>::Zero();
};

}  // namespace halfspace
