#include "jointed_rock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "random.h"
#include "vector.h"

namespace halfspace::cli {
namespace {

void cut_by_joint(const Context& context, const Point& normal, double offset, std::vector<Shape>& blocks) {
  const Point point = times(offset, normal);
  std::vector<Shape> pieces;
  pieces.reserve(blocks.size());
  for (Shape& block : blocks) {
    auto [behind, ahead] = cut(context, block, point, normal);
    if (behind) pieces.push_back(std::move(behind));
    if (ahead) pieces.push_back(std::move(ahead));
  }
  blocks = std::move(pieces);
}

void cut_by_set(const Context& context, const JointSet& set, const std::vector<Point>& region,
                std::vector<Shape>& blocks) {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
  for (const Point& p : region) {
    const double offset = dot(set.normal, p);
    nearest = std::min(nearest, offset);
    farthest = std::max(farthest, offset);
  }
  // A joint lies at most half a spacing from its even place, so one more on each side is enough.
  const auto first = static_cast<std::int64_t>(std::floor((nearest - set.offset) / set.spacing)) - 1;
  const auto last = static_cast<std::int64_t>(std::ceil((farthest - set.offset) / set.spacing)) + 1;
  for (std::int64_t k = first; k <= last; ++k) {
    const double offset = joint_offset(set, k);
    if (offset > nearest && offset < farthest) cut_by_joint(context, set.normal, offset, blocks);
  }
}

}  // namespace

double joint_offset(const JointSet& set, std::int64_t k) {
  // Two neighbouring deviations of at most spread / 2 each change a spacing by at most spread.
  Random mixed(set.seed);
  Random random(mixed.bits() ^ static_cast<std::uint64_t>(k));
  const double deviation = set.spread * (random.uniform() - 0.5);
  return set.offset + set.spacing * (static_cast<double>(k) + deviation);
}

Point joint_normal(double dip) { return {std::sin(dip), std::cos(dip), 0}; }

Point joint_normal(double dip, double dip_direction) {
  return {std::sin(dip) * std::sin(dip_direction), std::sin(dip) * std::cos(dip_direction), std::cos(dip)};
}

JointedBlocks cut_jointed_rock(const Context& context, const JointedRock& rock, std::vector<Shape> regions) {
  JointedBlocks result;
  for (Shape& region : regions) {
    const std::vector<Point> corners = vertices_of(context, region);
    std::vector<Shape> blocks;
    blocks.push_back(std::move(region));
    for (const JointSet& set : rock.joint_sets) cut_by_set(context, set, corners, blocks);
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
  return result;
}

}  // namespace halfspace::cli
