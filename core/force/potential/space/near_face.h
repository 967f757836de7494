#pragma once

#include "geometry/polyhedron/sounding.h"
#include "geometry/polyhedron/volume_sums.h"

namespace halfspace {

/// A face of a block that can be the nearest one to some point of what it has in common with another, and its
/// cell: where it is the nearest.
struct NearFace {
  int face;
  Halfspace<3> plane;
  DepthRange depths;  // of what the blocks have in common; at first by its bounds
  VolumeAndMoment cell;
};

}  // namespace halfspace
