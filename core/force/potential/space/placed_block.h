#pragma once

#include "geometry/outline.h"
#include "geometry/polyhedron/sounding.h"

namespace halfspace {

/// A block, and where its centroid is seen from where others are placed as well.
struct PlacedBlock {
  const Outline<3>& outline;
  Vector<3> at;

  Halfspace<3> plane(int face) const {
    const Vector<3> normal = outline.normal(face);
    return {normal, outline.offset[face] + normal.dot(at)};
  }
};

}  // namespace halfspace
