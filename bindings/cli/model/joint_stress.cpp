#include "model/joint_stress.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/vector.h"
#include "model/placing.h"

namespace halfspace::cli {
namespace {

/// A plane side of a block: in 2D an edge.
struct Side {
  std::vector<Point> corners;  ///< counter-clockwise seen from outside; 2D: begin and end
  Point normal{};              ///< outwards, unit length
};

Point traction_on(const Tensor& stress, const Point& normal) {
  Point traction{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) traction[i] += stress[3 * i + k] * normal[k];
  }
  return traction;
}

Point middle_of(const std::vector<Point>& points) {
  Point sum{};
  for (const Point& point : points) sum = plus(sum, point);
  return times(1 / static_cast<double>(points.size()), sum);
}

std::vector<Side> sides_of(const std::vector<Point>& vertices, const LayoutBlock& block, int dimension) {
  std::vector<Side> sides;
  if (dimension == 2) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Point &from = vertices[i], &to = vertices[(i + 1) % vertices.size()];
      const Point along = minus(to, from);
      sides.push_back({{from, to}, times(1 / length(along), {along[1], -along[0], 0})});
    }
    return sides;
  }
  for (const std::vector<int>& loop : block.faces) {
    Side side;
    for (const int vertex : loop) side.corners.push_back(vertices[static_cast<std::size_t>(vertex)]);
    side.normal = unit(area_normal(side.corners));
    sides.push_back(std::move(side));
  }
  return sides;
}

/// All blocks where they are placed, and which of them contains a point.
class PlacedBlocks {
 public:
  PlacedBlocks(const Context& context, const Layout& layout) {
    double extent = 0;
    for (const LayoutBlock& block : layout.blocks) {
      std::vector<Point> vertices = vertices_of(context, block.shape);
      for (Point& vertex : vertices) vertex = placed(vertex, block.placing);
      sides_.push_back(sides_of(vertices, block, layout.dimension));
      boxes_.emplace_back(vertices[0], vertices[0]);
      for (const Point& vertex : vertices) {
        for (std::size_t k = 0; k < 3; ++k) {
          boxes_.back().first[k] = std::min(boxes_.back().first[k], vertex[k]);
          boxes_.back().second[k] = std::max(boxes_.back().second[k], vertex[k]);
        }
      }
      sizes_.push_back(length(minus(boxes_.back().second, boxes_.back().first)));
      extent += sizes_.back();
    }
    cell_size_ = extent / static_cast<double>(sizes_.size());
    constexpr double many_cells = 8;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (sizes_[i] > many_cells * cell_size_) {
        large_.push_back(i);
        continue;
      }
      const auto last = cell_of(boxes_[i].second);
      for_each_cell(cell_of(boxes_[i].first), last, [&](const Cell& cell) { in_cell_[cell].push_back(i); });
    }
  }

  const std::vector<Side>& sides_of_block(std::size_t block) const { return sides_[block]; }
  double size_of(std::size_t block) const { return sizes_[block]; }
  /// The first block but one that contains a point.
  std::optional<std::size_t> block_at(const Point& point, std::size_t other_than) const {
    const auto first_in = [&](const std::vector<std::size_t>& blocks) -> std::optional<std::size_t> {
      for (const std::size_t block : blocks) {
        const auto is_behind = [&](const Side& side) {
          return dot(side.normal, minus(point, side.corners[0])) <= 0;
        };
        if (block != other_than && std::all_of(sides_[block].begin(), sides_[block].end(), is_behind))
          return block;
      }
      return std::nullopt;
    };
    const auto cell = in_cell_.find(cell_of(point));
    const std::optional<std::size_t> small = cell == in_cell_.end() ? std::nullopt : first_in(cell->second);
    return small ? small : first_in(large_);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(const Point& point) const {
    Cell cell{};
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::int64_t>(std::floor(point[k] / cell_size_));
    return cell;
  }
  template <class Visit>
  static void for_each_cell(const Cell& first, const Cell& last, Visit visit) {
    for (Cell cell = first; cell[0] <= last[0]; ++cell[0]) {
      for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
        for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) visit(cell);
      }
    }
  }

  std::vector<std::vector<Side>> sides_;
  std::vector<std::pair<Point, Point>> boxes_;
  std::vector<double> sizes_;
  double cell_size_ = 1;
  std::vector<std::size_t> large_;  ///< blocks of many cells
  std::map<Cell, std::vector<std::size_t>> in_cell_;
};

/// Moves a side outwards at each corner by the overlap that bears the normal stress there.
void move_out(Side& side, const Scene& scene, const InSitu& in_situ, double stiffness) {
  for (Point& corner : side.corners) {
    const double pressure = -dot(side.normal, traction_on(stress_at(scene, in_situ, corner), side.normal));
    corner = plus(corner, times(std::max(0.0, pressure) / stiffness, side.normal));
  }
}

/// The point where two edges in the plane meet.
Point meeting_of(const Side& before, const Side& after) {
  const Point along = minus(before.corners[1], before.corners[0]),
              next = minus(after.corners[1], after.corners[0]);
  const Point gap = minus(after.corners[0], before.corners[0]);
  const double part = (gap[0] * next[1] - gap[1] * next[0]) / (along[0] * next[1] - along[1] * next[0]);
  return plus(before.corners[0], times(part, along));
}

Shape shape_of(const Context& context, const std::vector<Side>& sides, int dimension) {
  if (dimension == 2) {
    std::vector<Point> vertices;
    for (std::size_t i = 0; i < sides.size(); ++i)
      vertices.push_back(meeting_of(sides[(i + sides.size() - 1) % sides.size()], sides[i]));
    return make_polygon(context, vertices);
  }
  std::vector<HalfSpace> halfspaces;
  for (const Side& side : sides) {
    const Point normal = unit(area_normal(side.corners));
    halfspaces.push_back({normal, dot(normal, middle_of(side.corners))});
  }
  return make_from_halfspaces(context, halfspaces);
}

}  // namespace

Tensor stress_at(const Scene& scene, const InSitu& in_situ, const Point& place) {
  const std::size_t up = up_axis(scene.world.dimension);
  const double depth = std::max(0.0, in_situ.surface - place[up]);
  const double vertical =
      scene.materials[static_cast<std::size_t>(in_situ.material)].density * scene.world.gravity[up] * depth;
  Tensor stress{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.world.dimension); ++axis)
    stress[4 * axis] = axis == up ? vertical : in_situ.ratio * vertical;
  return stress;
}

void stress_joints(const Context& context, const Scene& scene, Layout& layout, Faults& faults) {
  const InSitu& in_situ = *scene.in_situ;
  const PlacedBlocks blocks(context, layout);
  const auto grows = [&](std::size_t i) {
    return !deforms(layout.blocks[i].kind) && !layout.blocks[i].compound;
  };
  constexpr double just_outside = 1e-6;
  for (std::size_t i = 0; i < layout.blocks.size(); ++i) {
    if (!grows(i)) continue;
    LayoutBlock& block = layout.blocks[i];
    std::vector<Side> sides = blocks.sides_of_block(i);
    for (Side& side : sides) {
      const Point outside =
          plus(middle_of(side.corners), times(just_outside * blocks.size_of(i), side.normal));
      const std::optional<std::size_t> neighbor = blocks.block_at(outside, i);
      const int other = neighbor ? layout.blocks[*neighbor].material : block.material;
      const hs_law_def& law = law_between(scene, block.material, other);
      if (law.stiffness_kind != HS_STIFFNESS_PER_AREA) {
        if (!neighbor) continue;
        faults.add(in_situ.place, "in_situ",
                   "the joints of \"" + block.name +
                       "\" have no stiffness per area; allowed: with stiffness = "
                       "\"per area\" in the law of its materials");
        return;
      }
      // Both blocks of a joint grow by half of the overlap, also where a side has several neighbours.
      move_out(side, scene, in_situ, (neighbor && !grows(*neighbor) ? 1 : 2) * law.normal_stiffness);
    }
    block.shape = shape_of(context, sides, layout.dimension);
    block.placing = {};
    if (layout.dimension == 3) block.faces = faces_of(context, block.shape);
  }
}

Point shear_force_at(const Scene& scene, const InSitu& in_situ, const hs_contact& contact) {
  const Point normal = point_of(contact.normal);
  const Point traction = traction_on(stress_at(scene, in_situ, point_of(contact.center)), normal);
  return times(-contact.area, minus(traction, times(dot(traction, normal), normal)));
}

}  // namespace halfspace::cli
