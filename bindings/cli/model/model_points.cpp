#include <algorithm>

#include "common/vector.h"
#include "model/model.h"

// Points that blocks of a model carry along.

namespace halfspace::cli {
namespace {

Point product(const double (&tensor)[9], const Point& p) {
  Point result{};
  for (std::size_t row = 0; row < 3; ++row)
    result[row] = dot({tensor[3 * row], tensor[3 * row + 1], tensor[3 * row + 2]}, p);
  return result;
}

Point transposed_product(const double (&tensor)[9], const Point& p) {
  double transposed[9];
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      transposed[3 * row + column] = tensor[3 * column + row];
  return product(transposed, p);
}

/// The rotation matrix of a unit quaternion.
void write_rotation(const double (&quaternion)[4], double (&rotation)[9]) {
  const auto& [x, y, z, w] = quaternion;
  const double rows[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
                          2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                          2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
  std::copy(std::begin(rows), std::end(rows), rotation);
}

}  // namespace

CarriedPoint Model::carry(std::size_t block, const Point& at) const {
  const BlockFrame start = motion_of(block);
  if (layout_.blocks[block].body) return {block, {}, weights_of_nodes(start.vertices, layout_.dimension, at)};
  double rotation[9];
  write_rotation(start.state.pose.rotation, rotation);
  return {block, transposed_product(rotation, minus(at, point_of(start.state.pose.position))), {}};
}

Point Model::position_of(const CarriedPoint& point, const BlockFrame& block) const {
  const Point centroid = point_of(block.state.pose.position);
  if (!point.weights.empty()) {
    Point sum = is_removed(block) ? centroid : Point{};
    for (std::size_t i = 0; i < block.vertices.size(); ++i)
      sum = plus(sum, times(point.weights[i], block.vertices[i]));
    return sum;
  }
  if (block.state.kind == HS_BLOCK_AFFINE)
    return plus(centroid, product(block.deformation.gradient, point.offset));
  double rotation[9];
  write_rotation(block.state.pose.rotation, rotation);
  return plus(centroid, product(rotation, point.offset));
}

Point Model::velocity_of(const CarriedPoint& point) const {
  const BlockFrame now = motion_of(point.block);
  const Point velocity = point_of(now.state.velocity);
  const std::optional<std::size_t> index = layout_.blocks[point.block].body;
  if (index && !is_removed_[point.block]) {
    const LayoutBody& body = layout_.bodies[*index];
    std::vector<Point> velocities(body.node_count);
    require(context_,
            hs_world_get_node_velocities(world_.get(), bodies_[*index], view_of(velocities), nullptr));
    const std::vector<int>& nodes = body.cell_nodes[point.block - body.first_block];
    Point sum{};
    for (std::size_t i = 0; i < nodes.size(); ++i)
      sum = plus(sum, times(point.weights[i], velocities[static_cast<std::size_t>(nodes[i])]));
    return sum;
  }
  if (now.state.kind == HS_BLOCK_AFFINE) return plus(velocity, product(now.deformation.rate, point.offset));
  double rotation[9];
  write_rotation(now.state.pose.rotation, rotation);
  return plus(velocity, cross(point_of(now.state.angular_velocity), product(rotation, point.offset)));
}

}  // namespace halfspace::cli
