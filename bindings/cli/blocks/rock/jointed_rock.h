#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "model/library.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The blocks of a jointed region.
struct JointedBlocks {
  std::vector<Shape> blocks;               ///< in the order of the cuts, which is fixed by the scene
  int left_out = 0;                        ///< blocks smaller than the smallest size
  double size_left_out = 0;                ///< their total area or volume
  std::vector<const JointSet*> idle_sets;  ///< none of their joints cuts any region
};

/// The distance of joint k of a set from the origin, along the joints' normal. It depends on the set and k
/// only, so that joints continue through neighbouring regions.
double joint_offset(const JointSet& set, std::int64_t k);

/// Unit normal of joints in 2D, with the dip in radians below the horizontal towards +x; upwards for dips
/// below a right angle.
Point joint_normal(double dip);
/// The same in 3D; the dip direction is clockwise from +y (north), seen from above.
Point joint_normal(double dip, double dip_direction);

/// Thrown for joints that cannot be cut.
struct JointFault : std::runtime_error {
  JointFault(const JointSet& set, const std::string& text) : std::runtime_error(text), set(set) {}
  const JointSet& set;
};

/// Cuts convex regions by all joints of all sets. All pieces are cut by the same line or plane, so that
/// neighbouring blocks share their vertices, to rounding.
/// @throws JointFault for more than max_blocks blocks, or a spacing below the rounding of coordinates;
/// LibraryError for a block too small to compute with
JointedBlocks cut_jointed_rock(const Context& context, const JointedRock& rock, std::vector<Shape> regions);

}  // namespace halfspace::cli
