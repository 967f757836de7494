#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "contacts_3d.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

using Turn = Eigen::AngleAxisd;

/// Area of two convex polygons' overlap by definition: the length they share of each of many lines along y.
double area_by_lines(const Points& p, const Points& q) {
  struct Range {
    double lower = HUGE_VAL, upper = -HUGE_VAL;
  };
  const auto range_at = [](const Points& polygon, double x) {
    Range range;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector<2>&s = polygon[i], &e = polygon[i + 1 == polygon.size() ? 0 : i + 1];
      if ((s.x() - x) * (e.x() - x) > 0 || s.x() == e.x()) continue;
      const double y = s.y() + (x - s.x()) / (e.x() - s.x()) * (e.y() - s.y());
      range.lower = std::min(range.lower, y);
      range.upper = std::max(range.upper, y);
    }
    return range;
  };
  constexpr int lines = 20000;
  constexpr double half_width = 2;
  double area = 0;
  for (int i = 0; i < lines; ++i) {
    const double x = half_width * (2 * (i + 0.5) / lines - 1);
    const Range of_p = range_at(p, x), of_q = range_at(q, x);
    area += std::max(0.0, std::min(of_p.upper, of_q.upper) - std::max(of_p.lower, of_q.lower));
  }
  return area * 2 * half_width / lines;
}

double area_of(const Vector<3>* corners, int count, const Vector<3>& normal) {
  Vector<3> sum = Vector<3>::Zero();
  for (int i = 1; i + 1 < count; ++i)
    sum += cross_product(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return 0.5 * sum.dot(normal);
}

/// Of unit inradius.
double regular_polygon_area(int count) { return count * std::tan(pi / count); }

/// Two shapes and where the second is: one of each type, named. Blocks meet at the pair of least depth, but
/// for those that a tip has pierced through the upper face of.
struct Case {
  ContactType type;
  Cloud a;
  Cloud b;
  Vector<3> to_b;
  bool through_upper_face = false;

  Met met(const Shape<3>& shape_a, const Shape<3>& shape_b, const Vector<3>& from_a_to_b) const {
    return meet(shape_a, shape_b, from_a_to_b,
                through_upper_face ? touching_through(shape_a, z_axis) : PairCache<3>());
  }
  Met met() const { return met(block_of(a), block_of(b), to_b); }
};

const Cloud cube = prism(rectangle(1, 1), 1);
const Cloud tip = octahedron(0.3, 0.3, 1);
const double little = 1e-9;  // overlap that is lost in the vertex zone

std::vector<Case> one_of_each_type() {
  const Cloud ridge = wedge(1, 0.5, 0.5), crossing = turned(ridge, 1, z_axis);
  return {
      {ContactType::vertex_vertex, cube, tip, {0.5, 0.5, 1.5 - little}, true},
      {ContactType::vertex_edge, cube, tip, {0.5, 0.125, 1.5 - little}, true},
      {ContactType::edge_edge, ridge, crossing, {0.1, 0, 0.99}},
      {ContactType::edge_face, cube, wedge(0.5, 0.25, 0.5), {0.125, 0, 0.99}},
      {ContactType::face_face, cube, cube, {0.25, 0.125, 0.99}},
      {ContactType::vertex_face, cube, tip, {0.25, 0.125, 1.49}},
  };
}

}  // namespace

TEST_CASE("each contact type in space by its name, and from either block") {
  for (const Case& c : one_of_each_type()) {
    INFO("type " << int(c.type));
    const Shape<3> a = block_of(c.a), b = block_of(c.b);
    const Met met = c.met(a, b, c.to_b);
    CHECK(met.contact.type == c.type);
    CHECK(met.contact.normal.z() > 0);
    check_by_definition(a, b, c.to_b, met.contact);
    const Met from_b = meet(b, a, -c.to_b, swapped(met.witness));
    CHECK(from_b.contact.type == c.type);
    check_by_definition(b, a, -c.to_b, from_b.contact);
  }
}

TEST_CASE("vertex-face: a tip on a cube") {
  const Met met = meet(block_of(cube), block_of(tip), {0.25, 0.125, 1.4});
  CHECK(met.contact.type == ContactType::vertex_face);
  CHECK(met.contact.normal == z_axis);
  CHECK(met.contact.gap == Approx(-0.1));
  CHECK(met.contact.point_count == 1);
  CHECK(met.contact.points[0].isApprox(Vector<3>(0.25, 0.125, 0.5)));
  CHECK(met.contact.area == 0);
  CHECK(met.contact.length == 0);
}

TEST_CASE("vertex-edge: a tip on a cube's edge is pushed along the sum of both half-spaces' normals") {
  const Shape<3> block = block_of(cube);
  const Met met = meet(block, block_of(tip), {0.5, 0.125, 1.5 - little}, touching_through(block, z_axis));
  REQUIRE(met.contact.type == ContactType::vertex_edge);
  // From the top towards the cube's side, until the tip's edge (-0.3, 0, 1) comes to lie in the plane.
  const Vector<3> expected = z_axis + Vector<3>(1, 0, 0.3).normalized();
  CHECK(met.contact.normal.isApprox(expected.normalized()));
  CHECK(met.contact.gap == Approx(-little * met.contact.normal.z()));
  CHECK(met.contact.points[0].isApprox(Vector<3>(0.5, 0.125, 0.5)));
}

TEST_CASE("vertex-vertex: a tip on a cube's corner is pushed along the sum of the normals around") {
  const Shape<3> block = block_of(cube);
  const Met met = meet(block, block_of(tip), {0.5, 0.5, 1.5 - little}, touching_through(block, z_axis));
  REQUIRE(met.contact.type == ContactType::vertex_vertex);
  // The pairs that come together there: the cube's top; the cube's edges along y and x, with the tip's edges
  // below x and y; the tip's face between these.
  const Vector<3> expected = z_axis + Vector<3>(1, 0, 0.3).normalized() + Vector<3>(0, 1, 0.3).normalized() +
                             Vector<3>(1, 1, 0.3).normalized();
  CHECK(met.contact.normal.isApprox(expected.normalized()));
  CHECK(met.contact.points[0].isApprox(Vector<3>(0.5, 0.5, 0.5)));
}

TEST_CASE("edge-edge: crossed ridges meet at the nearest points of both lines") {
  const Shape<3> ridge = block_of(wedge(1, 0.5, 0.5));
  const Shape<3> crossed = block_of(turned(wedge(1, 0.5, 0.5), pi / 2, z_axis));
  const Met met = meet(ridge, crossed, {0.25, 0.125, 0.9});
  REQUIRE(met.contact.type == ContactType::edge_edge);
  CHECK(met.contact.normal.isApprox(z_axis));
  CHECK(met.contact.gap == Approx(-0.1));
  CHECK(met.contact.point_count == 1);
  // Between the line y = 0, z = 0.5 and the line x = 0.25, z = 0.4.
  CHECK(met.contact.points[0].isApprox(Vector<3>(0.25, 0, 0.45)));
}

TEST_CASE("edge-face: as long as the part of the edge over the face") {
  const Shape<3> block = block_of(cube);
  const auto length = [&](const Cloud& edge, const Vector<3>& to_b) {
    const Met met = meet(block, block_of(edge), to_b, touching_through(block, z_axis));
    CHECK(met.contact.type == ContactType::edge_face);
    CHECK(met.contact.point_count == 2);
    CHECK(met.contact.gap == Approx(-0.1));
    CHECK((met.contact.points[0] - met.contact.points[1]).norm() == Approx(met.contact.length));
    return met.contact.length;
  };
  CHECK(length(wedge(0.5, 1, 1), {0.125, 0, 1.4}) == Approx(0.5));    // within
  CHECK(length(wedge(0.5, 1, 1), {0.375, 0, 1.4}) == Approx(0.375));  // across one side
  CHECK(length(wedge(3, 1, 1), {0.25, 0.5, 1.4}) == Approx(1));       // across both, along the border
  // Across a corner of the face, 0.25 sqrt(2) from it.
  const Cloud diagonal = turned(wedge(3, 1, 1), -pi / 4, z_axis);
  CHECK(length(diagonal, {0.25, 0.25, 1.4}) == Approx(std::sqrt(0.5)));
}

TEST_CASE("edge-face: the gap is linear along a tilted edge, and its deeper end counts") {
  const double tilt = 0.005;
  const Cloud edge = turned(wedge(0.5, 1, 1), tilt, y_axis);
  const Met met = meet(block_of(cube), block_of(edge), {0, 0, 1.4});
  REQUIRE(met.contact.type == ContactType::edge_face);
  const double middle = 1.4 - std::cos(tilt) - 0.5;
  CHECK(met.contact.center_gap == Approx(middle));
  CHECK(met.contact.gap == Approx(middle - 0.25 * std::sin(tilt)));
  CHECK(std::max(met.contact.gaps[0], met.contact.gaps[1]) == Approx(middle + 0.25 * std::sin(tilt)));
}

TEST_CASE("face-face: cubes share the overlap of their faces") {
  const Shape<3> a = block_of(cube);
  const Met met = meet(a, a, {0.25, 0.125, 0.9});
  REQUIRE(met.contact.type == ContactType::face_face);
  CHECK(met.contact.normal == z_axis);
  CHECK(met.contact.gap == Approx(-0.1));
  CHECK(met.contact.area == 0.75 * 0.875);
  CHECK(met.contact.center.isApprox(Vector<3>(0.125, 0.0625, 0.5)));
  REQUIRE(met.contact.point_count == 4);
  CHECK(area_of(met.contact.points, 4, met.contact.normal) == Approx(met.contact.area));
  for (int i = 0; i < 4; ++i) CHECK(met.contact.gaps[i] == Approx(-0.1));
}

TEST_CASE("face-face: areas that are known") {
  const Shape<3> block = block_of(cube);
  const auto contact_with = [&](const Cloud& above, const Vector<3>& to_b) {
    const Shape<3> b = block_of(above);
    const Contact<3> contact = meet(block, b, to_b).contact;
    CHECK(contact.type == ContactType::face_face);
    const Contact<3> swapped = meet(b, block, -to_b).contact;
    CHECK(swapped.area == Approx(contact.area));
    CHECK(swapped.point_count == contact.point_count);
    return contact;
  };
  SECTION("a cube turned by 45 degrees: an octagon") {
    const Contact<3> contact = contact_with(turned(cube, pi / 4, z_axis), {0, 0, 0.9});
    CHECK(contact.area == Approx(2 * std::sqrt(2.0) - 2).epsilon(1e-14));
    CHECK(contact.point_count == 8);
    CHECK((contact.center - Vector<3>(0, 0, 0.5)).norm() < 1e-15);
    CHECK(area_of(contact.points, 8, contact.normal) == Approx(contact.area));
  }
  SECTION("a triangle over a side") {
    // Legs 2 along x and 1 along y; its centroid is 2/3 and 1/3 from the right angle, which lies at (-1,
    // -0.25).
    const Contact<3> contact =
        contact_with(prism({{0, 0}, {2, 0}, {0, 1}}, 1), {-1 + 2.0 / 3, -0.25 + 1.0 / 3, 0.9});
    // Over x from -0.5 to 0.5: heights 0.75 and 0.25 above y = -0.25.
    CHECK(contact.area == Approx(0.5).epsilon(1e-14));
    CHECK(contact.point_count == 4);
  }
  SECTION("a small polygon of 100 corners: its own area, and 8 of its corners") {
    const double r = 0.4;
    const Contact<3> contact = contact_with(prism(regular_polygon(100, r), 1), {0.05, -0.05, 0.9});
    CHECK(contact.area == Approx(50 * r * r * std::sin(2 * pi / 100)).epsilon(1e-13));
    CHECK((contact.center - Vector<3>(0.05, -0.05, 0.5)).norm() < 1e-14);
    REQUIRE(contact.point_count == 8);
    // Corners are at most 1.8 degrees off the directions in which they are farthest, an eighth of a turn
    // apart.
    CHECK(area_of(contact.points, 8, contact.normal) > 4 * r * r * std::sin(2 * pi / 8) * 0.95);
  }
  SECTION("a large polygon of 100 corners: the cube's face") {
    const Contact<3> contact = contact_with(prism(regular_polygon(100, 1.5), 1), {0.05, -0.05, 0.9});
    CHECK(contact.area == Approx(1).epsilon(1e-13));
    CHECK((contact.center - Vector<3>(0, 0, 0.5)).norm() < 1e-14);
    REQUIRE(contact.point_count == 4);
    for (int i = 0; i < 4; ++i) CHECK(contact.points[i].cwiseAbs().isApprox(Vector<3>(0.5, 0.5, 0.5)));
  }
}

TEST_CASE("face-face: two polygons of 100 corners, one turned, have an overlap of 200") {
  const Shape<3> a = block_of(prism(regular_polygon(100, 1), 1));
  const Shape<3> b = block_of(prism(regular_polygon(100, 1, pi / 100), 1));
  const Contact<3> contact = meet(a, b, {0, 0, 0.9}).contact;
  REQUIRE(contact.type == ContactType::face_face);
  const double inradius = std::cos(pi / 100);
  CHECK(contact.area == Approx(regular_polygon_area(200) * inradius * inradius).epsilon(1e-13));
  CHECK((contact.center - Vector<3>(0, 0, 0.5)).norm() < 1e-14);
  CHECK(contact.point_count == 8);
}

TEST_CASE("face-face: area of random overlaps against lines") {
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    const Points p = random_polygon(random, 12, 1), q = random_polygon(random, 70, 1);
    const Vector<2> shift = {random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7)};
    const Shape<3> a = block_of(prism(p, 10)), b = block_of(prism(q, 10));
    const Vector<3> from_a(a.centroid()), from_b(b.centroid());
    const Vector<3> to_b = from_b - from_a + Vector<3>(shift.x(), shift.y(), 9.999);
    const Contact<3> contact = meet(a, b, to_b).contact;
    Points moved = q;
    for (Vector<2>& corner : moved) corner += shift;
    // The length shared has a slope of some 1e3 at most, but for ends: off by less than a line's width times
    // the height of the shapes there.
    CHECK(contact.area == Approx(area_by_lines(p, moved)).margin(1e-3));
    check_by_definition(a, b, to_b, contact);
  }
}

TEST_CASE("faces and edges that are parallel but for rounding") {
  const Shape<3> block = block_of(cube);
  for (const double angle : {0.0, 1e-17, 1e-16, 1e-15, 1e-14, 1e-12, 1e-10}) {
    for (const Vector<3>& axis : {x_axis, y_axis, z_axis, Vector<3>(1, 2, 3)}) {
      INFO("angle " << angle << " about " << axis.transpose());
      const Shape<3> tilted = block_of(turned(cube, angle, axis));
      const Met met = meet(block, tilted, {0, 0, 0.9});
      CHECK(met.contact.type == ContactType::face_face);
      CHECK(met.contact.area == Approx(1).epsilon(1e-9));
      CHECK(met.contact.gap == Approx(-0.1));
      // Sides that coincide but for rounding make no corners of their own.
      if (angle <= 1e-15) CHECK(met.contact.point_count == 4);
      check_by_definition(block, tilted, {0, 0, 0.9}, met.contact);

      // Two ridges along each other, the upper one sharper: its edge comes to lie on a face of the lower.
      const Shape<3> lower = block_of(wedge(1, 1, 0.5)),
                     upper = block_of(turned(wedge(1, 0.25, 0.5), angle, axis));
      const Vector<3> to_upper(0.125, 0.25, 0.7);
      const Met ridges = meet(lower, upper, to_upper);
      CHECK(ridges.contact.type == ContactType::edge_face);
      CHECK(ridges.contact.length == Approx(0.875));
      CHECK(ridges.contact.normal.isApprox(Vector<3>(0, 0.5, 1).normalized(), 1e-9));
      // Whatever pair of parallel edges it is described at, it comes to be the same.
      for (int i = 0; i < lower.edge_count(); ++i) {
        for (int j = 0; j < upper.edge_count(); ++j) {
          Pair pair{Pair::edge_edge, i, j};
          Contact<3> contact;
          describe_contact(lower.outline(), upper.outline(), to_upper, pair, {}, contact);
          CHECK(contact.normal.norm() == Approx(1));
          CHECK(contact.center.allFinite());
          CHECK(std::isfinite(contact.gap));
        }
      }
    }
  }
}

TEST_CASE("faces within the parallel angle are face-face, beyond it edge-face, and then vertex-face") {
  const Shape<3> block = block_of(cube);
  const double limit = DetectOptions().parallel_angle;
  // Only corners that tilting brings down overlap: with more of them the region would be followed further.
  const auto type_of = [&](double about_x, double about_y) {
    const Eigen::Matrix3d turn = (Turn(about_x, x_axis) * Turn(about_y, y_axis)).toRotationMatrix();
    return meet(block, block_of(turned(cube, turn)), {0.1, -0.1, 1.0001}).contact.type;
  };
  CHECK(type_of(0.9 * limit, 0) == ContactType::face_face);
  CHECK(type_of(1.1 * limit, 0) == ContactType::edge_face);
  CHECK(type_of(1.1 * limit, 1.1 * limit) == ContactType::vertex_face);
  CHECK(type_of(1.1 * limit, 0.9 * limit) == ContactType::edge_face);
}

TEST_CASE(
    "in space, the plane of a region is that of the face of smaller depth, whichever the blocks met "
    "through") {
  constexpr double tilt = 0.005;
  const Shape<3> floor = block_of(prism(rectangle(10, 10), 1)), lower = block_of(cube);
  // Tilted about both horizontal axes: a cube sinks in by one corner.
  const Eigen::Matrix3d turn = (Turn(tilt, x_axis) * Turn(tilt, y_axis)).toRotationMatrix();
  const Shape<3> box = block_of(turned(cube, turn));
  const Vector<3> bottom = turn * Vector<3>(0, 0, -1);
  double lowest = 0;
  for (int v = 0; v < box.outline().vertex_count(); ++v)
    lowest = std::min(lowest, box.outline().vertex(v).z());
  for (const bool through_lower : {true, false}) {
    INFO("met through a face of the " << (through_lower ? "lower" : "upper"));
    const auto met = [&](const Shape<3>& below, const Vector<3>& to_box) {
      const PairCache<3> witness =
          through_lower ? touching_through(below, z_axis) : swapped(touching_through(box, -z_axis));
      const Met met = meet(below, box, to_box, witness);
      check_by_definition(below, box, to_box, met.contact);
      return met.contact;
    };
    const Contact<3> on_floor = met(floor, {0.3, 0.2, 0.99});
    CHECK(on_floor.type == ContactType::face_face);
    CHECK(on_floor.normal == z_axis);
    CHECK(on_floor.gap == Approx(0.49 + lowest));
    // Beyond the sides of a cube, the corner is in front of no face.
    const double side = bottom.x() > 0 ? 0.2 : -0.2, other_side = bottom.y() > 0 ? 0.2 : -0.2;
    const Contact<3> over = met(lower, {side, other_side, 0.99}),
                     back = met(lower, {-side, -other_side, 0.99});
    CHECK((over.normal == z_axis) != (back.normal == z_axis));
    CHECK((over.normal.isApprox(-bottom) || back.normal.isApprox(-bottom)));
  }
}

TEST_CASE("in space, swapping the blocks turns the normal and nothing else") {
  for (const Case& c : one_of_each_type()) {
    INFO("type " << int(c.type));
    const Shape<3> a = block_of(c.a), b = block_of(c.b);
    // At the same pair: of two faces that meet, either may own the contact plane.
    const Met met = c.met(a, b, c.to_b);
    const Contact<3> contact = met.contact, from_b = meet(b, a, -c.to_b, swapped(met.witness)).contact;
    CHECK(from_b.type == contact.type);
    CHECK(from_b.gap == contact.gap);
    CHECK(from_b.normal == -contact.normal);
    CHECK(from_b.area == contact.area);
    CHECK(from_b.length == contact.length);
    CHECK(from_b.center_gap == contact.center_gap);
    REQUIRE(from_b.point_count == contact.point_count);
    CHECK((from_b.center + c.to_b - contact.center).norm() < 1e-15);
    for (int i = 0; i < contact.point_count; ++i) {
      const int j = contact.point_count - 1 - i;  // still counter-clockwise about the normal
      CHECK((from_b.points[j] + c.to_b - contact.points[i]).norm() < 1e-15);
      CHECK(from_b.gaps[j] == contact.gaps[i]);
    }
  }
}

TEST_CASE("in space, scaling by a power of two scales the bits") {
  for (const Case& c : one_of_each_type()) {
    const Contact<3> contact = c.met().contact;
    for (const int power : {-40, -3, 1, 60}) {
      INFO("type " << int(c.type) << " times 2^" << power);
      const double factor = std::ldexp(1.0, power);
      const Shape<3> a = block_of(scaled(c.a, factor)), b = block_of(scaled(c.b, factor));
      const Contact<3> large = c.met(a, b, factor * c.to_b).contact;
      CHECK(large.type == contact.type);
      CHECK(large.gap == factor * contact.gap);
      CHECK(large.normal == contact.normal);
      CHECK(large.area == factor * factor * contact.area);
      CHECK(large.length == factor * contact.length);
      CHECK(large.center == factor * contact.center);
      CHECK(large.center_gap == factor * contact.center_gap);
      REQUIRE(large.point_count == contact.point_count);
      for (int i = 0; i < contact.point_count; ++i) {
        CHECK(large.points[i] == factor * contact.points[i]);
        CHECK(large.gaps[i] == factor * contact.gaps[i]);
      }
    }
  }
}

TEST_CASE("in space, a turned scene has the turned contact") {
  const Eigen::Matrix3d turns[] = {Turn(pi / 2, x_axis).toRotationMatrix(),
                                   Turn(pi / 2, y_axis).toRotationMatrix(),
                                   Turn(2.1, Vector<3>(1, 2, 3).normalized()).toRotationMatrix()};
  for (const Case& c : one_of_each_type()) {
    const Contact<3> contact = c.met().contact;
    for (const Eigen::Matrix3d& turn : turns) {
      INFO("type " << int(c.type));
      const Shape<3> a = block_of(turned(c.a, turn)), b = block_of(turned(c.b, turn));
      const Vector<3> to_b = turn * c.to_b;
      const Contact<3> other =
          meet(a, b, to_b, c.through_upper_face ? touching_through(a, turn * z_axis) : PairCache<3>())
              .contact;
      CHECK(other.type == contact.type);
      CHECK(other.gap == Approx(contact.gap).margin(1e-15));
      CHECK(other.area == Approx(contact.area));
      CHECK(other.length == Approx(contact.length));
      CHECK(other.point_count == contact.point_count);
      CHECK((other.normal - turn * contact.normal).norm() < 1e-12);
      CHECK((other.center - turn * contact.center).norm() < 1e-12);
    }
  }
}
