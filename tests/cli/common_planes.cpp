#include "blocks/mesh/common_planes.h"

#include <cmath>

#include "blocks/mesh/surface.h"
#include "catch.h"
#include "common/text.h"
#include "common/vector.h"

using namespace halfspace::cli;

namespace {

/// A cuboid of a file with so many decimals, turned so that no face lies along an axis.
std::string obj_cuboid(const Point& low, const Point& high, int digits, int first_vertex) {
  static const double turn = 0.3, tilt = 0.7;
  std::string text = "o cuboid\n";
  for (int corner = 0; corner < 8; ++corner) {
    const double x = corner & 1 ? high[0] : low[0], y = corner & 2 ? high[1] : low[1],
                 z = corner & 4 ? high[2] : low[2];
    const double u = std::cos(turn) * x - std::sin(turn) * y, v = std::sin(turn) * x + std::cos(turn) * y;
    text += "v " + decimals(u, digits) + ' ' + decimals(std::cos(tilt) * v - std::sin(tilt) * z, digits) +
            ' ' + decimals(std::sin(tilt) * v + std::cos(tilt) * z, digits) + '\n';
  }
  for (const auto& face :
       {std::vector<int>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    text += 'f';
    for (const int v : face) text += ' ' + std::to_string(first_vertex + v);
    text += '\n';
  }
  return text;
}

/// Bricks of 0.4 x 0.2 x 0.15 in running bond on a slab: no two that touch share their corners.
std::string obj_wall(int digits) {
  std::string text = obj_cuboid({-1, -1, -1}, {5, 1, 0}, digits, 1);
  int vertices = 8;
  for (int course = 0; course < 4; ++course) {
    for (int i = 0; i < 6; ++i, vertices += 8) {
      const double x = 0.4 * i + 0.07 * course, z = 0.15 * course;
      text += obj_cuboid({x, 0, z}, {x + 0.4, 0.2, z + 0.15}, digits, vertices + 1);
    }
  }
  return text;
}

std::vector<ConvexSolid> blocks_of(const Context& context, const std::string& obj) {
  std::vector<ConvexSolid> blocks;
  for (const Solid& solid : solids_of(read_obj("a.obj", obj)))
    blocks.push_back(make_convex(context, solid, 1));
  return blocks;
}

/// Half-spaces in the coordinates of the file.
std::vector<HalfSpace> planes_of(const Context& context, const Shape& shape) {
  std::vector<HalfSpace> planes = halfspaces_of(context, shape);
  const Point centroid = point_of(properties_of(context, shape).centroid);
  for (HalfSpace& plane : planes) plane.offset += dot(plane.normal, centroid);
  return planes;
}

/// The distances of faces that look at each other nearer than a length; the largest, and how many there are.
struct Joints {
  double widest = 0;
  int count = 0;
};

Joints joints_of(const Context& context, const std::vector<ConvexSolid>& blocks, double nearer) {
  Joints joints;
  for (std::size_t a = 0; a < blocks.size(); ++a) {
    for (std::size_t b = a + 1; b < blocks.size(); ++b) {
      for (const HalfSpace& f : planes_of(context, blocks[a].shape)) {
        for (const HalfSpace& g : planes_of(context, blocks[b].shape)) {
          const double slope = length(plus(f.normal, g.normal)), gap = std::abs(f.offset + g.offset);
          if (slope > nearer || gap > nearer) continue;
          ++joints.count;
          joints.widest = std::max({joints.widest, slope, gap});
        }
      }
    }
  }
  return joints;
}

}  // namespace

TEST_CASE("faces that overlap in a file of few digits are flush") {
  const Context context = make_context();
  for (const int digits : {3, 4, 6, 9}) {
    CAPTURE(digits);
    std::vector<ConvexSolid> blocks = blocks_of(context, obj_wall(digits));
    const double near = 40 * std::pow(10.0, -digits);
    const Joints before = joints_of(context, blocks, near);
    CHECK(before.widest > 0.1 * std::pow(10.0, -digits));
    CHECK(share_planes(context, blocks) > 24);
    const Joints after = joints_of(context, blocks, near);
    CHECK(after.count >= before.count);
    CHECK(after.widest <= 1e-14);
    for (const ConvexSolid& block : blocks) CHECK(properties_of(context, block.shape).face_count == 6);
  }
}

TEST_CASE("faces that are flush to rounding keep their corners") {
  const Context context = make_context();
  std::vector<ConvexSolid> blocks = blocks_of(context, obj_wall(17));
  std::vector<std::vector<Point>> before;
  for (const ConvexSolid& block : blocks) before.push_back(vertices_of(context, block.shape));
  CHECK(share_planes(context, blocks) == 0);
  for (std::size_t i = 0; i < blocks.size(); ++i) CHECK(vertices_of(context, blocks[i].shape) == before[i]);
}

TEST_CASE("faces that lie apart by more than the digits stay where they are") {
  const Context context = make_context();
  std::vector<ConvexSolid> blocks =
      blocks_of(context, obj_cuboid({0, 0, 0}, {1, 1, 1}, 4, 1) + obj_cuboid({0, 0, 1.002}, {1, 1, 2}, 4, 9));
  CHECK(share_planes(context, blocks) == 0);
}
