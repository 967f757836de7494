#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "library.h"
#include "scene.h"

namespace halfspace::cli {

/// What the joints made of a region.
struct JointedBlocks {
  std::vector<Shape> blocks;               ///< in the order of the cuts, which is fixed by the scene
  int left_out = 0;                        ///< blocks smaller than the smallest size
  double size_left_out = 0;                ///< of all those together
  std::vector<const JointSet*> idle_sets;  ///< none of their joints cuts any region
};

/// Where joint k of a set lies: its distance from the origin along the joints' normal. It depends on the set
/// and k only, so the same joints run through neighbouring regions.
double joint_offset(const JointSet& set, std::int64_t k);

/// Unit normal of joints that dip so many radians below the horizontal towards +x, in 2D. Upwards for dips
/// below a right angle.
Point joint_normal(double dip);
/// The same in 3D for joints that dip towards a direction, clockwise from +y (north) seen from above.
Point joint_normal(double dip, double dip_direction);

/// Thrown for joints that cannot be cut.
struct JointFault : std::runtime_error {
  JointFault(const JointSet& set, const std::string& text) : std::runtime_error(text), set(set) {}
  const JointSet& set;
};

/// Cuts convex regions by all joints of all sets. Every piece is cut by the same line or plane, so
/// neighbouring blocks share their vertices, to rounding.
/// @throws JointFault if there are more than most_blocks of them, or if joints lie closer than their places
/// can be told apart; LibraryError if a part is too small to compute with
JointedBlocks cut_jointed_rock(const Context& context, const JointedRock& rock, std::vector<Shape> regions);

}  // namespace halfspace::cli
