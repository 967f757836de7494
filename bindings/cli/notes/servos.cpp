#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "common/text.h"
#include "common/vector.h"
#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

using Interval = std::pair<double, double>;

bool overlap(const Interval& a, const Interval& b) { return a.first < b.second && b.first < a.second; }

/// A right-handed frame whose first axis is the direction; in 2D the third is the normal of the plane.
std::array<Point, 3> frame_along(const Point& direction, int dimension) {
  const Point along = unit(direction);
  if (dimension == 2) return {along, Point{-along[1], along[0], 0}, Point{0, 0, 1}};
  Point axis{};
  axis[std::abs(along[0]) < 0.5 ? 0 : 1] = 1;
  const Point across = unit(cross(along, axis));
  return {along, across, cross(along, across)};
}

/// The way of a servo: the blocks that stand ahead of it at the start.
class Way {
 public:
  Way(const Start& start, const Action& servo)
      : start_(start), axes_(frame_along(servo.scale, start.layout.dimension)) {}

  /// The nearest block in the way of the parts of a block, unless they can press on some block there.
  std::optional<std::size_t> obstacle(const std::vector<std::size_t>& parts) const {
    std::optional<std::size_t> nearest;
    for (std::size_t other = 0; other < start_.bodies.size(); ++other) {
      const auto is_in_way = [&](std::size_t part) { return is_ahead(part, other); };
      if (std::count(parts.begin(), parts.end(), other) > 0 ||
          std::none_of(parts.begin(), parts.end(), is_in_way))
        continue;
      if (can_press(parts.front(), other)) return std::nullopt;
      if (!nearest || reach(other, axes_[0]).first < reach(*nearest, axes_[0]).first) nearest = other;
    }
    return nearest;
  }

 private:
  Interval reach(std::size_t block, const Point& direction) const {
    Interval reach{HUGE_VAL, -HUGE_VAL};
    for (const Point& p : start_.frame.blocks[block].vertices) {
      const double place = dot(direction, p);
      reach = {std::min(reach.first, place), std::max(reach.second, place)};
    }
    return reach;
  }
  bool is_ahead(std::size_t block, std::size_t other) const {
    const auto faces = [&](const Point& across) {
      return overlap(reach(block, across), reach(other, across));
    };
    return reach(other, axes_[0]).second > reach(block, axes_[0]).second && faces(axes_[1]) &&
           (start_.layout.dimension == 2 || faces(axes_[2]));
  }
  bool can_press(std::size_t block, std::size_t other) const {
    const hs_block_state &a = start_.bodies[block].state, &b = start_.bodies[other].state;
    return (moves_freely(a.kind) || moves_freely(b.kind)) &&
           has_spring(law_between(start_.scene, a.material, b.material));
  }

  const Start& start_;
  std::array<Point, 3> axes_;
};

/// The parts of a compound, or the block alone. Empty for a later part of a compound.
std::vector<std::size_t> parts_of(const Layout& layout, std::size_t block) {
  if (!layout.blocks[block].compound) return {block};
  const LayoutCompound& compound = layout.compounds[*layout.blocks[block].compound];
  if (block != compound.first_block) return {};
  std::vector<std::size_t> parts(compound.part_count);
  std::iota(parts.begin(), parts.end(), compound.first_block);
  return parts;
}

void note_servo(const Start& start, const Action& action, const std::vector<std::size_t>& blocks,
                Faults& faults) {
  const Way way(start, action);
  for (const std::size_t block : blocks) {
    const std::vector<std::size_t> parts = parts_of(start.layout, block);
    const auto obstacle = parts.empty() ? std::nullopt : way.obstacle(parts);
    if (!obstacle) continue;
    const std::string other = quoted(start.layout.blocks[*obstacle].name);
    const bool is_contact =
        moves_freely(start.bodies[block].state.kind) || moves_freely(start.bodies[*obstacle].state.kind);
    faults.note(
        action.place, action.key,
        "the servo of " + quoted(start.layout.blocks[block].name) + " meets no force: " +
            (is_contact ? "the law towards " + other + " ahead has no springs; usual: a law with springs"
                        : "neither it nor " + other +
                              " ahead moves freely, so they have no contact; usual: a rigid block with "
                              "the key hold"));
    return;
  }
}

}  // namespace

/// Such a servo moves at its max speed. A block may come into its way later: only where others stand there at
/// the start, and none that it can press on, it is noted.
void note_servos(const Start& start, Faults& faults) {
  for (std::size_t i = 0; i < start.scene.actions.size(); ++i) {
    const Action& action = start.scene.actions[i];
    const auto& values = action.table.values;
    const bool presses = std::all_of(values.begin(), values.end(), [](const Point& v) { return v[0] >= 0; });
    if (action.kind == HS_ACTION_SERVO && presses && length(action.scale) > 0)
      note_servo(start, action, start.layout.acted_on[i], faults);
  }
}

}  // namespace halfspace::cli
