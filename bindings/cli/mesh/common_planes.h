#pragma once

#include <vector>

#include "mesh/convex_solid.h"

namespace halfspace::cli {

/// Makes faces flush that two blocks have in common within the sum of their tolerances. Planes that were
/// fitted to each block by itself differ where the blocks do not share corners, or where one has merged a
/// facet that the other has not. All faces of a joint, those that overlap from block to block, get one plane:
/// that of least squares through their corners. It is taken if it lies within the tolerance of each of them.
/// Faces that are flush to rounding stay as they are. Says how many faces were moved.
int share_planes(const Context& context, std::vector<ConvexSolid>& blocks);

}  // namespace halfspace::cli
