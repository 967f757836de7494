#include "jointed_rock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "random.h"

namespace halfspace::cli {
namespace {

void cut_by_joint(const Context& context, Point point, Point normal, std::vector<Shape>& blocks) {
  const double point3[] = {point[0], point[1], 0};
  const double normal3[] = {normal[0], normal[1], 0};
  std::vector<Shape> pieces;
  pieces.reserve(blocks.size());
  for (Shape& block : blocks) {
    hs_shape* behind = nullptr;
    hs_shape* ahead = nullptr;
    require(context, hs_shape_cut(block.get(), point3, normal3, &behind, &ahead));
    if (behind) pieces.emplace_back(behind);
    if (ahead) pieces.emplace_back(ahead);
  }
  blocks = std::move(pieces);
}

void cut_by_set(const Context& context, const JointSet& set, const std::vector<Point>& region,
                std::vector<Shape>& blocks) {
  const Point normal = joint_normal(set);
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
  for (const Point& p : region) {
    const double offset = p[0] * normal[0] + p[1] * normal[1];
    nearest = std::min(nearest, offset);
    farthest = std::max(farthest, offset);
  }
  // A joint lies at most half a spacing from its even place, so one more on each side is enough.
  const auto first = static_cast<std::int64_t>(std::floor((nearest - set.offset) / set.spacing)) - 1;
  const auto last = static_cast<std::int64_t>(std::ceil((farthest - set.offset) / set.spacing)) + 1;
  for (std::int64_t k = first; k <= last; ++k) {
    const double offset = joint_offset(set, k);
    if (offset <= nearest || offset >= farthest) continue;
    cut_by_joint(context, {offset * normal[0], offset * normal[1]}, normal, blocks);
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

Point joint_normal(const JointSet& set) { return {std::sin(set.dip), std::cos(set.dip)}; }

JointedBlocks cut_jointed_rock(const Context& context, const JointedRock& rock) {
  std::vector<Shape> blocks;
  blocks.push_back(make_polygon(context, rock.region));
  for (const JointSet& set : rock.joint_sets) cut_by_set(context, set, rock.region, blocks);

  JointedBlocks result;
  for (Shape& block : blocks) {
    const double area = properties_of(context, block).volume;
    if (area >= rock.smallest_area) {
      result.blocks.push_back(std::move(block));
    } else {
      ++result.left_out;
      result.area_left_out += area;
    }
  }
  return result;
}

}  // namespace halfspace::cli
