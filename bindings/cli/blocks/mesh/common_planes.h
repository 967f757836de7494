#pragma once

#include <vector>

#include "blocks/mesh/convex_solid.h"

namespace halfspace::cli {

/// Makes faces flush that two blocks share within the sum of their tolerances. Planes fitted to each block
/// separately differ where the blocks do not share corners, or where only one of them has merged a facet. All
/// overlapping faces of a joint get the least-squares plane through their corners, if it is within the
/// tolerance of each. Faces that are flush to rounding stay unchanged. @return the number of moved faces
int share_planes(const Context& context, std::vector<ConvexSolid>& blocks);

}  // namespace halfspace::cli
