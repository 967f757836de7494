#include "blocks/rock/jointed_rock.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "common/random.h"
#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// The extent of points along a normal.
struct Reach {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
};

Reach reach_of(const std::vector<Point>& points, const Point& normal) {
  Reach reach;
  for (const Point& p : points) {
    const double offset = dot(normal, p);
    reach.nearest = std::min(reach.nearest, offset);
    reach.farthest = std::max(reach.farthest, offset);
  }
  return reach;
}

/// The joints that may cut this extent. Each is at most half a spacing from its regular position, so that one
/// more on each side suffices.
struct JointRange {
  JointRange(const JointSet& set, const Reach& reach)
      : first(static_cast<std::int64_t>(std::floor((reach.nearest - set.offset) / set.spacing)) - 1),
        last(static_cast<std::int64_t>(std::ceil((reach.farthest - set.offset) / set.spacing)) + 1) {}
  std::int64_t first, last;
};

/// Refuses a set before any cut: each joint in a region adds at least one block.
void require_joints(const JointSet& set, const Reach& reach) {
  const double joints = (reach.farthest - reach.nearest) / set.spacing;
  if (!(joints <= static_cast<double>(max_blocks))) {
    throw JointFault(set, "about " + rounded(joints, 3) + " joints in a region of " +
                              rounded(reach.farthest - reach.nearest, 3) + " m; allowed: at most " +
                              std::to_string(max_blocks) + " blocks");
  }
  const double farthest = std::max({std::abs(reach.nearest), std::abs(reach.farthest), std::abs(set.offset)});
  if (set.spacing < std::ldexp(farthest, -46)) {
    throw JointFault(set, "below the rounding of coordinates " + rounded(farthest, 3) +
                              " m from the origin; allowed: a spacing of at least 2^-46 of that");
  }
}

/// The number of blocks between the joints of two sets (in 3D of three) in a region: a lower bound, except at
/// the boundary of the region.
double crossings(const JointSet& a, const JointSet& b, double area) {
  return area * length(cross(a.normal, b.normal)) / (a.spacing * b.spacing);
}

double crossings(const JointSet& a, const JointSet& b, const JointSet& c, double volume) {
  return volume * std::abs(dot(cross(a.normal, b.normal), c.normal)) / (a.spacing * b.spacing * c.spacing);
}

/// Refuses sets that together would make too many blocks, before any cut.
void require_crossings(const std::vector<JointSet>& sets, const hs_shape_properties& region) {
  const bool in_plane = region.dimension == 2;
  const double volume = region.volume;
  double blocks = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (in_plane) blocks += crossings(sets[i], sets[j], volume);
      for (std::size_t k = 0; !in_plane && k < j; ++k) blocks += crossings(sets[i], sets[j], sets[k], volume);
    }
    if (!(blocks <= static_cast<double>(max_blocks))) {
      throw JointFault(sets[i], "about " + rounded(blocks, 3) +
                                    " blocks between the joints of all sets; allowed: at most " +
                                    std::to_string(max_blocks));
    }
  }
}

/// Cuts a block by the joints of a set in order. No later joint cuts the piece behind a joint.
void cut_by_set(const Context& context, const JointSet& set, Shape block, std::vector<Shape>& pieces) {
  const Reach reach = reach_of(vertices_of(context, block), set.normal);
  const JointRange joints(set, reach);
  for (std::int64_t k = joints.first; k <= joints.last && block; ++k) {
    const double offset = joint_offset(set, k);
    if (offset <= reach.nearest || offset >= reach.farthest) continue;
    auto [behind, ahead] = cut(context, block, times(offset, set.normal), set.normal);
    if (behind) pieces.push_back(std::move(behind));
    block = std::move(ahead);
  }
  if (block) pieces.push_back(std::move(block));
}

/// Cuts all blocks by a set; `finished` is the number of other blocks.
void cut_by_set(const Context& context, const JointSet& set, std::size_t finished,
                std::vector<Shape>& blocks) {
  std::vector<Shape> pieces;
  for (Shape& block : blocks) {
    cut_by_set(context, set, std::move(block), pieces);
    if (finished + pieces.size() > static_cast<std::size_t>(max_blocks))
      throw JointFault(set, "more than " + std::to_string(max_blocks) + " blocks; increase the spacing");
  }
  blocks = std::move(pieces);
}

}  // namespace

double joint_offset(const JointSet& set, std::int64_t k) {
  // Two neighbouring deviations of at most jitter / 2 each change a spacing by at most jitter.
  Random mixed(set.seed);
  Random random(mixed.bits() ^ static_cast<std::uint64_t>(k));
  const double deviation = set.jitter * (random.uniform() - 0.5);
  return set.offset + set.spacing * (static_cast<double>(k) + deviation);
}

Point joint_normal(double dip) { return {std::sin(dip), std::cos(dip), 0}; }

Point joint_normal(double dip, double dip_direction) {
  return {std::sin(dip) * std::sin(dip_direction), std::sin(dip) * std::cos(dip_direction), std::cos(dip)};
}

JointedBlocks cut_jointed_rock(const Context& context, const JointedRock& rock, std::vector<Shape> regions) {
  JointedBlocks result;
  std::set<const JointSet*> busy;
  for (Shape& region : regions) {
    const std::vector<Point> corners = vertices_of(context, region);
    require_crossings(rock.joint_sets, properties_of(context, region));
    std::vector<Shape> blocks;
    blocks.push_back(std::move(region));
    for (const JointSet& set : rock.joint_sets) {
      require_joints(set, reach_of(corners, set.normal));
      const std::size_t before = blocks.size();
      cut_by_set(context, set, result.blocks.size(), blocks);
      if (blocks.size() > before) busy.insert(&set);
    }
    for (Shape& block : blocks) {
      const double size = properties_of(context, block).volume;
      if (size >= rock.smallest_size) {
        result.blocks.push_back(std::move(block));
      } else {
        ++result.left_out;
        result.size_left_out += size;
      }
    }
  }
  for (const JointSet& set : rock.joint_sets) {
    if (!busy.count(&set)) result.idle_sets.push_back(&set);
  }
  return result;
}

}  // namespace halfspace::cli
