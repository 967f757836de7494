#include "model/near_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/vector.h"
#include "model/placing.h"

namespace halfspace::cli {
namespace {

double distance_to_outline(const std::vector<Point>& loop, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i)
    least = std::min(least, distance_to_segment(p, loop[i], loop[(i + 1) % loop.size()]));
  return least;
}

double distance_to_face(const std::vector<Point>& loop, const Point& p) {
  const Point normal = area_normal(loop);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point& a = loop[i];
    if (dot(normal, cross(minus(loop[(i + 1) % loop.size()], a), minus(p, a))) < 0)
      return distance_to_outline(loop, p);
  }
  return std::abs(dot(normal, minus(p, loop[0]))) / length(normal);
}

double distance_to_surface(const Context& context, const Shape& shape, const Point& p) {
  const std::vector<Point> vertices = vertices_of(context, shape);
  if (properties_of(context, shape).dimension == 2) return distance_to_outline(vertices, p);
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<int>& face : faces_of(context, shape)) {
    std::vector<Point> loop;
    for (const int vertex : face) loop.push_back(vertices[static_cast<std::size_t>(vertex)]);
    least = std::min(least, distance_to_face(loop, p));
  }
  return least;
}

hs_pose pose_of(const Context& context, const LayoutBlock& block) {
  hs_pose pose{};
  const hs_shape_properties properties = properties_of(context, block.shape);
  std::copy(std::begin(properties.centroid), std::end(properties.centroid), pose.position);
  place(pose, block.placing);
  return pose;
}

/// At most `farthest` is of interest: beyond it the result may be any larger number.
double distance_to(const Context& context, const LayoutBlock& block, const Point& at, double farthest) {
  constexpr double rounding = 1e-9;  // of a block's radius: coordinates of the file, placed
  const hs_shape_properties properties = properties_of(context, block.shape);
  const Point local = unplaced(at, block.placing);
  const Point offset = minus(local, point_of(properties.centroid));
  if (length(offset) - properties.bounding_radius >= farthest) return length(offset);
  double outside = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& side : halfspaces_of(context, block.shape))
    outside = std::max(outside, dot(side.normal, offset) - side.offset);
  if (outside <= rounding * properties.bounding_radius) return 0;
  return distance_to_surface(context, block.shape, local);
}

}  // namespace

std::optional<NearBlock> nearest_block_where(const Context& context, const Layout& layout, const Point& at,
                                             const std::function<bool(std::size_t)>& counts) {
  std::optional<NearBlock> nearest;
  for (std::size_t i = 0; i < layout.blocks.size(); ++i) {
    if (!counts(i)) continue;
    const double best = nearest ? nearest->distance : std::numeric_limits<double>::infinity();
    const double distance = distance_to(context, layout.blocks[i], at, best);
    if (distance < best) nearest = {i, distance};
    if (distance == 0) break;
  }
  return nearest;
}

std::optional<NearBlock> nearest_block(const Context& context, const Layout& layout, const Point& at) {
  return nearest_block_where(context, layout, at, [](std::size_t) { return true; });
}

bool can_touch(const Layout& layout, std::size_t a, std::size_t b) {
  const LayoutBlock& one = layout.blocks[a];
  const LayoutBlock& other = layout.blocks[b];
  return a != b && (moves_freely(one.kind) || moves_freely(other.kind)) &&
         !(one.body && one.body == other.body) && !(one.compound && one.compound == other.compound);
}

std::optional<std::pair<std::size_t, std::size_t>> blocks_that_touch_at(const Context& context,
                                                                        const Layout& layout,
                                                                        const Point& at) {
  const std::optional<NearBlock> first = nearest_block(context, layout, at);
  if (!first) return std::nullopt;
  const auto second = nearest_block_where(
      context, layout, at, [&](std::size_t block) { return can_touch(layout, first->block, block); });
  if (!second) return std::nullopt;
  return std::minmax({first->block, second->block});
}

std::optional<PairPlane> plane_between(const Context& context, const LayoutBlock& a, const LayoutBlock& b) {
  constexpr int max_approaches = 100;
  constexpr double small = 1e-6;  // of the smaller radius: an overlap whose region is that of a touch
  const hs_pose pose_a = pose_of(context, a);
  hs_pose pose_b = pose_of(context, b);
  const double overlap = small * std::min(properties_of(context, a.shape).bounding_radius,
                                          properties_of(context, b.shape).bounding_radius);
  Point approach{};
  for (int i = 0; i < max_approaches; ++i) {
    hs_contact contact{};
    require(context,
            hs_pair_detect(a.shape.get(), &pose_a, b.shape.get(), &pose_b, nullptr, nullptr, &contact));
    const Point normal = point_of(contact.normal);
    if (contact.type != HS_CONTACT_NONE)
      return PairPlane{point_of(contact.center), normal, contact.gap - dot(approach, normal)};
    const Point step = times(-std::max(contact.gap, 0.0) - overlap, normal);
    approach = plus(approach, step);
    for (std::size_t axis = 0; axis < 3; ++axis) pose_b.position[axis] += step[axis];
  }
  return std::nullopt;
}

}  // namespace halfspace::cli
