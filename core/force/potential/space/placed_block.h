#pragma once

#include "geometry/outline.h"
#include "geometry/polyhedron/sounding.h"

namespace halfspace {

/// A block, and its centroid in a common frame.
struct PlacedBlock {
  const Outline<3>& outline;
  Vector<3> at;

  Halfspace<3> plane(int face) const {
    const Vector<3> normal = outline.normal(face);
    return {normal, outline.offset[face] + normal.dot(at)};
  }
};

}  // namespace halfspace
