#pragma once

#include <vector>

#include "library.h"
#include "scene.h"

namespace halfspace::cli {

/// What the joints made of a region.
struct JointedBlocks {
  std::vector<Shape> blocks;  ///< in the order of the cuts, which is fixed by the scene
  int left_out = 0;           ///< blocks smaller than the smallest area
  double area_left_out = 0;   ///< of all those together
};

/// Where joint k of a set lies: its distance from the origin along the joints' normal. It depends on the set
/// and k only, so the same joints run through neighbouring regions.
double joint_offset(const JointSet& set, std::int64_t k);

/// Unit normal of the joints of a set, upwards for dips below 90 degrees.
Point joint_normal(const JointSet& set);

/// Cuts a convex region by all joints of all sets. Every piece is cut by the same line, so neighbouring
/// blocks share their vertices, to rounding.
/// @throws LibraryError if the region is not a convex polygon
JointedBlocks cut_jointed_rock(const Context& context, const JointedRock& rock);

}  // namespace halfspace::cli
