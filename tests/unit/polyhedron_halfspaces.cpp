#include <cmath>
#include <numbers>

#include "catch.h"
#include "geometry/polyhedron/halfspaces.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

using Halfspaces = std::vector<Halfspace<3>>;

struct Result {
  Polyhedron polyhedron{std::pmr::get_default_resource()};
  Fault fault = Fault::none;
  std::int64_t face = -1;
  std::int64_t redundant = 0;
};

Result intersection_of(const Halfspaces& halfspaces) {
  Result result;
  const PolyhedronFault report = polyhedron_from_halfspaces(halfspaces, result.polyhedron, result.redundant);
  result.fault = report.fault;
  result.face = report.face;
  return result;
}

Halfspaces halfspaces_of(const Shape<3>& shape) {
  Halfspaces halfspaces;
  for (int f = 0; f < shape.face_count(); ++f) {
    const Vector<3> normal = shape.outline().normal(f);
    halfspaces.push_back({normal, shape.outline().offset[f] + normal.dot(shape.centroid())});
  }
  return halfspaces;
}

const Halfspaces cube = {{{1, 0, 0}, 1},  {{-1, 0, 0}, 1}, {{0, 2, 0}, 2},
                         {{0, -1, 0}, 1}, {{0, 0, 1}, 1},  {{0, 0, -4}, 4}};

}  // namespace

TEST_CASE("six half-spaces make a cube; those that cut nothing off are counted and dropped") {
  Halfspaces halfspaces = cube;
  const Result plain = intersection_of(halfspaces);
  REQUIRE(plain.fault == Fault::none);
  CHECK(plain.redundant == 0);
  CHECK(shape_of(plain.polyhedron).volume() == Approx(8).epsilon(1e-15));

  halfspaces.push_back({{1, 1, 1}, 4});    // beyond the corner
  halfspaces.push_back({{1, 0, 0}, 1});    // a face once more
  halfspaces.push_back({{0, 0, 1}, 1e6});  // far away
  const Result with_more = intersection_of(halfspaces);
  REQUIRE(with_more.fault == Fault::none);
  CHECK(with_more.redundant == 3);
  CHECK(with_more.polyhedron.vertex_count() == 8);
  CHECK(shape_of(with_more.polyhedron).volume() == Approx(8).epsilon(1e-15));
}

TEST_CASE("half-spaces without a polyhedron are refused with the reason") {
  CHECK(intersection_of({}).fault == Fault::unbounded);
  CHECK(intersection_of({cube.begin(), cube.end() - 1}).fault == Fault::unbounded);
  // A slab, and a prism without ends.
  CHECK(intersection_of({cube[0], cube[1], {{1, 0, 0}, 2}, {{-1, 0, 0}, 2}}).fault == Fault::unbounded);
  CHECK(intersection_of({cube[0], cube[1], cube[2], cube[3]}).fault == Fault::unbounded);

  Halfspaces apart = cube;
  apart.push_back({{1, 1, 1}, -4});
  CHECK(intersection_of(apart).fault == Fault::no_common_point);
  Halfspaces touching = cube;
  touching.push_back({{1, 0, 0}, -1});
  CHECK(intersection_of(touching).fault == Fault::no_common_point);

  Halfspaces without_direction = cube;
  without_direction.push_back({{0, 0, 0}, 1});
  const Result refused = intersection_of(without_direction);
  CHECK(refused.fault == Fault::no_direction);
  CHECK(refused.face == 6);
  Halfspaces not_finite = cube;
  not_finite[2].offset = HUGE_VAL;
  CHECK(intersection_of(not_finite).fault == Fault::out_of_range);
}

TEST_CASE("the half-spaces of a polyhedron give it back, wherever it is") {
  Random random(31);
  for (const double away : {0.0, 100.0, 1e5}) {
    for (int round = 0; round < 100; ++round) {
      Cloud points = random_cloud(random, 30, 0.6, 1);
      for (Vector<3>& p : points) p += Vector<3>(away, -away, away);
      const Shape<3> shape = shape_of(hull_of(points));
      const Result result = intersection_of(halfspaces_of(shape));
      INFO(fault_text(result.fault));
      REQUIRE(int(result.fault) == int(Fault::none));
      CHECK(result.redundant == 0);
      // Far away rounding lets planes miss their common vertex: there may be more vertices, near the one.
      if (away == 0) CHECK(result.polyhedron.vertex_count() == shape.vertex_count());
      // Offsets are rounded by ulps of `away`; a flat corner moves that by the inverse of its angles.
      CHECK(std::abs(shape_of(result.polyhedron).volume() - shape.volume()) < 1e-13 * (1 + away));
    }
  }
}

TEST_CASE("more than three planes through a vertex make one vertex") {
  for (const PlatonicSolid& solid : platonic_solids()) {
    INFO(solid.name);
    const Shape<3> shape = shape_of(hull_of(solid.vertices));
    const Result result = intersection_of(halfspaces_of(shape));
    REQUIRE(int(result.fault) == int(Fault::none));
    CHECK(result.polyhedron.vertex_count() == shape.vertex_count());
    CHECK(shape_of(result.polyhedron).volume() == Approx(shape.volume()).epsilon(1e-14));
  }
}

TEST_CASE("thousands of half-spaces around a ball") {
  Random random(32);
  Halfspaces halfspaces;
  for (int i = 0; i < 2000; ++i) halfspaces.push_back({random_direction(random), 1});
  const Result result = intersection_of(halfspaces);
  INFO(fault_text(result.fault));
  REQUIRE(int(result.fault) == int(Fault::none));
  CHECK(result.redundant == 0);
  const Shape<3> shape = shape_of(result.polyhedron);
  // Faces at distance 1: three times the volume is the surface. Each face's area from its own loop.
  double surface = 0;
  for (std::int32_t f = 0; f < result.polyhedron.face_count(); ++f) {
    for (std::size_t i = 1; i + 1 < result.polyhedron.loop(f).size(); ++i) {
      const Vector<3> a = result.polyhedron.corner(f, i) - result.polyhedron.corner(f, 0);
      const Vector<3> b = result.polyhedron.corner(f, i + 1) - result.polyhedron.corner(f, 0);
      surface += 0.5 * cross_product(a, b).norm();
    }
  }
  CHECK(3 * shape.volume() == Approx(surface).epsilon(1e-12));
}

TEST_CASE("a thin plate keeps all its edges, short ones too") {
  // Seen from inside, the two large faces are 1e4 or 1e6 times nearer than the others, and the last
  // half-space, which cuts 1e-10 off a corner, looks like its neighbours.
  const double thickness = GENERATE(1e-4, 1e-6);
  const int n = 40;
  const double half_angle = std::numbers::pi / n;
  Halfspaces halfspaces = {{{0, 0, 1}, thickness / 2}, {{0, 0, -1}, thickness / 2}};
  for (const Vector<2>& side : regular_polygon(n, 1)) halfspaces.push_back({{side.x(), side.y(), 0}, 1});
  halfspaces.push_back({{std::cos(half_angle), std::sin(half_angle), 0}, 1 / std::cos(half_angle) - 1e-10});
  const Result result = intersection_of(halfspaces);
  INFO(fault_text(result.fault));
  REQUIRE(int(result.fault) == int(Fault::none));
  CHECK(result.redundant == 0);
  CHECK(result.polyhedron.face_count() == n + 3);
  // Each coordinate carries an ulp or two; the thickness one of its own.
  CHECK(shape_of(result.polyhedron).volume() == Approx(n * std::tan(half_angle) * thickness).epsilon(1e-14));
}

TEST_CASE("planes that are opposite but for rounding bound a box") {
  // Fitted to the corners of a cube, written with 4 decimals: opposite normals differ by 1e-16.
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3d turn = random_rotation(random);
    Halfspaces halfspaces;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector<3> normal = turn.col(axis), noise = 0x1p-53 * random_direction(random);
      halfspaces.push_back({normal, 1e-5 * axis});
      halfspaces.push_back({-normal + noise, 1 + 1e-5 * axis});
    }
    const Result made = intersection_of(halfspaces);
    REQUIRE(made.fault == Fault::none);
    CHECK(made.polyhedron.vertex_count() == 8);
  }
}
