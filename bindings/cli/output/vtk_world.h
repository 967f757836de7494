#pragma once

#include "model/layout.h"
#include "model/model.h"

namespace halfspace::cli {

/// The blocks of any world, as output of a scene has them. Blocks without vertices are not among them.
struct WorldPicture {
  Layout layout;  ///< dimension, faces and kinds only
  Frame frame;
  Frame start;  ///< poses only
};

/// @param start poses of all blocks from which displacements are measured; null: they are 0
WorldPicture picture_of(const Context& context, const hs_world* world, const hs_pose* start);

}  // namespace halfspace::cli
