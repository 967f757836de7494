#include "output/joints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "common/box.h"
#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// A face of a block, or an edge in the plane.
struct Side {
  std::vector<Point> corners;
  Point normal{};  ///< outwards, of unit length
};

struct BlockBox : Box {
  std::size_t block = 0;

  double size() const { return length(sides()); }
  bool meets(const Box& other, double margin) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (low[axis] > other.high[axis] + margin || other.low[axis] > high[axis] + margin) return false;
    return true;
  }
};

constexpr double max_distance = 0.01;  ///< of common faces, over the size of the smaller block

BlockBox box_around(std::size_t block, const BlockFrame& frame) { return {box_of(frame.vertices), block}; }

std::vector<Side> sides_of_block(const Layout& layout, std::size_t block, const Frame& frame) {
  std::vector<Side> sides;
  const std::vector<Point>& vertices = frame.blocks[block].vertices;
  for (const std::vector<int>& loop : layout.blocks[block].faces) {
    std::vector<Point> corners;
    for (const int vertex : loop) corners.push_back(vertices[static_cast<std::size_t>(vertex)]);
    if (layout.dimension == 3) {
      sides.push_back({corners, unit(area_normal(corners))});
      continue;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point &p = corners[i], &q = corners[(i + 1) % corners.size()];
      sides.push_back({{p, q}, unit({q[1] - p[1], p[0] - q[0], 0})});
    }
  }
  return sides;
}

/// The part of a segment or of a convex polygon ahead of a plane.
std::vector<Point> clipped(const std::vector<Point>& corners, const Point& on_plane, const Point& ahead) {
  std::vector<Point> kept;
  const std::size_t edges = corners.size() == 2 ? 1 : corners.size();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const double at_p = dot(ahead, minus(p, on_plane)), at_q = dot(ahead, minus(q, on_plane));
    if (at_p >= 0) kept.push_back(p);
    if (i < edges && (at_p >= 0) != (at_q >= 0))
      kept.push_back(plus(p, times(at_p / (at_p - at_q), minus(q, p))));
  }
  return kept;
}

/// The part of one side that lies over another one, which looks against it.
std::vector<Point> common_part(const Side& side, const Side& other) {
  std::vector<Point> part = side.corners;
  const std::vector<Point>& around = other.corners;
  for (std::size_t i = 0; i < around.size() && part.size() > 1; ++i) {
    const Point along = minus(around[(i + 1) % around.size()], around[i]);
    part = clipped(part, around[i], around.size() == 2 ? along : cross(other.normal, along));
  }
  return part;
}

double size_of_part(const std::vector<Point>& corners) {
  if (corners.size() < 2) return 0;
  return corners.size() == 2 ? length(minus(corners[1], corners[0])) : 0.5 * length(area_normal(corners));
}

/// Adds the largest common part of the sides of two blocks, if there is any.
void add_joint(const Layout& layout, const Frame& start, const BlockBox& a, const BlockBox& b,
               std::vector<Joint>& joints) {
  const double size = std::min(a.size(), b.size());
  const double parallel = std::cos(std::numbers::pi / 180);
  Joint joint{.a = a.block, .b = b.block};
  for (const Side& of_a : sides_of_block(layout, a.block, start)) {
    for (const Side& of_b : sides_of_block(layout, b.block, start)) {
      if (dot(of_a.normal, of_b.normal) > -parallel ||
          std::abs(dot(of_a.normal, minus(of_b.corners[0], of_a.corners[0]))) > max_distance * size)
        continue;
      std::vector<Point> part = common_part(of_a, of_b);
      const double size_of_this = size_of_part(part);
      if (size_of_this <= joint.size) continue;
      joint.corners = std::move(part);
      joint.normal = of_a.normal;
      joint.size = size_of_this;
    }
  }
  constexpr double min_ratio = 1e-3;  // of the smaller block; corners touch in less
  if (joint.size > std::pow(min_ratio * size, layout.dimension - 1)) joints.push_back(std::move(joint));
}

/// A vector turned by a unit quaternion x, y, z, w, or back.
Point turned(const double q[4], const Point& v, bool back) {
  const Point axis = times(back ? -1 : 1, {q[0], q[1], q[2]});
  const Point once = times(2, cross(axis, v));
  return plus(v, plus(times(q[3], once), cross(axis, once)));
}

Point carried_vector(const BlockFrame& then, const BlockFrame& now, const Point& vector) {
  return turned(now.state.pose.rotation, turned(then.state.pose.rotation, vector, true), false);
}

Point carried_point(const BlockFrame& then, const BlockFrame& now, const Point& point) {
  return plus(point_of(now.state.pose.position),
              carried_vector(then, now, minus(point, point_of(then.state.pose.position))));
}

/// The sum of the contact forces on block b of a joint.
struct Resultant {
  Point force{};
  Point moment{};  ///< about the origin
};

using Resultants = std::map<std::pair<std::size_t, std::size_t>, Resultant>;

Resultants resultants_of(const std::vector<hs_contact>& contacts) {
  Resultants resultants;
  for (const hs_contact& contact : contacts) {
    const bool is_swapped = contact.block_a > contact.block_b;
    const double sign = is_swapped ? -1 : 1;
    Resultant& sum = resultants[std::minmax<std::size_t>(contact.block_a, contact.block_b)];
    const Point force = times(sign, point_of(contact.force));
    sum.force = plus(sum.force, force);
    sum.moment = plus(
        sum.moment, plus(times(sign, point_of(contact.torque)), cross(point_of(contact.force_point), force)));
  }
  return resultants;
}

void add_components(std::string& row, const Point& values, int count) {
  for (int i = 0; i < count; ++i) row += ',' + shortest(values[static_cast<std::size_t>(i)]);
}

}  // namespace

std::vector<Joint> joints_of(const Layout& layout, const Frame& start) {
  std::vector<BlockBox> boxes;
  for (std::size_t i = 0; i < start.blocks.size(); ++i)
    if (!is_removed(start.blocks[i]) && !deforms(layout.blocks[i].kind))
      boxes.push_back(box_around(i, start.blocks[i]));
  std::sort(boxes.begin(), boxes.end(),
            [](const BlockBox& p, const BlockBox& q) { return p.low[0] < q.low[0]; });
  double margin = 0;
  for (const BlockBox& box : boxes) margin = std::max(margin, max_distance * box.size());
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = i + 1; k < boxes.size() && boxes[k].low[0] <= boxes[i].high[0] + margin; ++k) {
      const auto& [first, second] = std::minmax(
          boxes[i], boxes[k], [](const BlockBox& p, const BlockBox& q) { return p.block < q.block; });
      const bool is_free =
          moves_freely(layout.blocks[first.block].kind) || moves_freely(layout.blocks[second.block].kind);
      if (is_free && first.meets(second, max_distance * std::min(first.size(), second.size())))
        add_joint(layout, start, first, second, joints);
    }
  }
  std::sort(joints.begin(), joints.end(),
            [](const Joint& p, const Joint& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
  return joints;
}

double JointSides::opening() const { return *std::max_element(gaps.begin(), gaps.end()); }

Point JointSides::centre() const {
  Point sum{};
  for (const Point& corner : of_a) sum = plus(sum, corner);
  return times(1 / static_cast<double>(of_a.size()), sum);
}

JointSides sides_of(const Joint& joint, const Frame& start, const Frame& now) {
  const BlockFrame &a = start.blocks[joint.a], &b = start.blocks[joint.b];
  JointSides sides;
  sides.normal = carried_vector(a, now.blocks[joint.a], joint.normal);
  for (const Point& corner : joint.corners) {
    sides.of_a.push_back(carried_point(a, now.blocks[joint.a], corner));
    sides.of_b.push_back(carried_point(b, now.blocks[joint.b], corner));
    sides.gaps.push_back(dot(sides.normal, minus(sides.of_b.back(), sides.of_a.back())));
  }
  return sides;
}

std::string joints_table(const Layout& layout, const Frame& start, const Frame& now,
                         const std::vector<hs_contact>& contacts) {
  const bool in_space = layout.dimension == 3;
  const Resultants resultants = resultants_of(contacts);
  std::string text = std::string("block_a,block_b,") + (in_space ? "area,x,y,z" : "length,x,y") +
                     (in_space ? ",normal_x,normal_y,normal_z" : ",normal_x,normal_y") +
                     ",normal_force,shear_force,eccentricity,opening\n";
  for (const Joint& joint : joints_of(layout, start)) {
    if (is_removed(now.blocks[joint.a]) || is_removed(now.blocks[joint.b])) continue;
    const JointSides sides = sides_of(joint, start, now);
    const Point centre = sides.centre();
    const auto found = resultants.find({joint.a, joint.b});
    const Resultant sum = found == resultants.end() ? Resultant{} : found->second;
    const double normal_force = dot(sum.force, sides.normal);
    const Point moment = minus(sum.moment, cross(centre, sum.force));
    text += layout.blocks[joint.a].name + ',' + layout.blocks[joint.b].name + ',' + shortest(joint.size);
    add_components(text, centre, layout.dimension);
    add_components(text, sides.normal, layout.dimension);
    text += ',' + shortest(normal_force) + ',' +
            shortest(length(minus(sum.force, times(normal_force, sides.normal)))) + ',';
    // The resultant meets the joint where it has no moment in its plane.
    if (normal_force != 0) text += shortest(length(cross(sides.normal, moment)) / std::abs(normal_force));
    text += ',' + shortest(sides.opening()) + '\n';
  }
  return text;
}

}  // namespace halfspace::cli
