#pragma once

#include "geometry/polyhedron/sounding.h"
#include "geometry/polyhedron/volume_sums.h"

namespace halfspace {

/// A face of a block that can be the nearest to some point of the overlap with another block, and its cell:
/// the part where it is the nearest.
struct NearFace {
  int face;
  Halfspace<3> plane;
  DepthRange depths;  // of the overlap; initially of its bounds
  VolumeAndMoment cell;
};

}  // namespace halfspace
