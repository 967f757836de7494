#include "geometry/polyhedron/gauss_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.h"
#include "narrow_phase/space/separation.h"
#include "narrow_phase/space/support.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// A candidate is the deepest of all vertices, to the rounding of heights.
void check_direction(const GaussMap& map, const Outline<3>& outline, const Vector<3>& direction) {
  double of_candidates = HUGE_VAL, reach = 0;
  for (const std::int32_t v : map.candidates(direction))
    of_candidates = std::min(of_candidates, direction.dot(outline.vertex(v)));
  for (int v = 0; v < outline.vertex_count(); ++v) reach = std::max(reach, outline.vertex(v).norm());
  const double rounding = 1e-15 * reach * direction.norm();
  CHECK(of_candidates <= deepest_among_all(outline, direction).height + rounding);
}

void check_map(const Shape<3>& shape, Random& random) {
  const Outline<3>& outline = shape.outline();
  const GaussMap map(outline, std::pmr::get_default_resource());
  std::size_t candidates = 0;
  constexpr int directions = 2000;
  for (int i = 0; i < directions; ++i) {
    const Vector<3> direction = random.uniform(1e-3, 1e3) * random_direction(random);
    check_direction(map, outline, direction);
    candidates += map.candidates(direction).size();
  }
  // Axes, diagonals, and what else lies where cells meet.
  for (const double x : {-1.0, -0.5, -1e-300, 0.0, 0.25, 1.0}) {
    for (const double y : {-1.0, 0.0, 0.5, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        const Vector<3> direction(x, y, z);
        if (direction.cwiseAbs().maxCoeff() > 1e-200) check_direction(map, outline, direction);
      }
    }
  }
  // Normals: several vertices are deepest.
  for (int f = 0; f < outline.face_count(); ++f) check_direction(map, outline, -outline.normal(f));
  CHECK(double(candidates) / directions < 0.25 * outline.vertex_count());
}

/// A prism with that many sides, wide or long.
Shape<3> prism(int sides, double height) {
  Cloud points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * 3.141592653589793 * i / sides;
    for (const double z : {-0.5 * height, 0.5 * height})
      points.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  return shape_of(hull_of(points));
}

}  // namespace

TEST_CASE("a Gauss map knows the deepest vertex along any direction") {
  Random random(1);
  for (const int points : {60, 200, 1000}) {
    INFO(points << " points");
    check_map(shape_of(hull_of(random_cloud(random, points, 0.9, 1))), random);
  }
  for (const double height : {1e-3, 1.0, 1e3}) {
    INFO("a prism " << height << " high");
    check_map(prism(40, height), random);
  }
}

TEST_CASE("a Gauss map has candidates for what is no direction") {
  Random random(3);
  for (const int points : {200, 300}) {  // an odd and an even number of cells
    const Shape<3> shape = shape_of(hull_of(random_cloud(random, points, 0.99, 1)));
    const GaussMap map(shape.outline(), std::pmr::get_default_resource());
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double length : {0.0, 5e-324, 1e-310, infinite, std::numeric_limits<double>::quiet_NaN()}) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
          const auto candidates = map.candidates(sign * length * Vector<3>::Unit(axis));
          REQUIRE_FALSE(candidates.empty());
          CHECK(candidates[0] < shape.vertex_count());
        }
      }
    }
  }
}

TEST_CASE("blocks of many vertices all but in one place overlap") {
  Random random(4);
  const Shape<3> shape = shape_of(hull_of(random_cloud(random, 300, 0.99, 1)));
  for (const double distance : {0.0, 5e-324, 1e-310, 1e-200}) {
    const Separation<3> found =
        find_separation(shape.outline(), shape.outline(), distance * Vector<3>::UnitX(), Rotation<3>());
    CHECK(found.gap < -1);
    CHECK(found.gap > -2);
  }
}

TEST_CASE("shapes of many vertices have a Gauss map, others none") {
  Random random(2);
  CHECK(shape_of(hull_of(random_cloud(random, 1000, 0.99, 1))).outline().gauss_map != nullptr);
  CHECK(shape_of(completed(box({1, 1, 1}))).outline().gauss_map == nullptr);
}
