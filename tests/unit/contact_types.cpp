#include "catch.h"
#include "geometry/rotation.h"
#include "narrow_phase/pair.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

struct Met {
  Contact<2> contact;
  PairCache<2> witness;
};

Met meet(const Shape<2>& a, const Shape<2>& b, const Vector<2>& to_b, PairCache<2> witness = {},
         const DetectOptions& options = {}) {
  Met met{{}, witness};  // no contact yet
  judge_pair(a.outline(), b.outline(), to_b, met.witness);
  if (met.witness.state == PairCache<2>::touching)
    describe_contact(a.outline(), b.outline(), to_b, met.witness.pair, options, met.contact);
  return met;
}

const Shape<2> square = shape_of(rectangle(2, 2));
const Shape<2> diamond = shape_of({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});

}  // namespace

TEST_CASE("edge-edge: two squares side by side share the overlap of their edges") {
  const Met met = meet(square, square, {1.9, 0.5});
  CHECK(met.contact.type == ContactType::edge_edge);
  CHECK(met.contact.normal == Vector<2>(1, 0));
  CHECK(met.contact.gap == Approx(-0.1));
  CHECK(met.contact.length == Approx(1.5));
  CHECK(met.contact.point_count == 2);
  CHECK(met.contact.gaps[0] == Approx(-0.1));
  CHECK(met.contact.gaps[1] == Approx(-0.1));
}

TEST_CASE("vertex-edge: a diamond's corner on a square's edge") {
  const Met met = meet(square, diamond, {1.9, 0.3});
  CHECK(met.contact.type == ContactType::vertex_edge);
  CHECK(met.contact.normal == Vector<2>(1, 0));
  CHECK(met.contact.gap == Approx(-0.1));
  CHECK(met.contact.length == 0);
  CHECK(met.contact.points[0].isApprox(Vector<2>(1, 0.3)));
}

TEST_CASE("vertex-vertex: a diamond's corner at a square's corner is pushed along the sum of the normals") {
  // The diamond's left corner lies a little inside the end of the square's right edge.
  const Met met = meet(square, diamond, {1.9999, 0.99995}, {}, {.vertex_zone = 0.001});
  CHECK(met.contact.type == ContactType::vertex_vertex);
  const Vector<2> right_edge(1, 0), lower_right_edge_of_diamond_opposed = Vector<2>(1, 1).normalized();
  CHECK(met.contact.normal.isApprox((right_edge + lower_right_edge_of_diamond_opposed).normalized()));
}

TEST_CASE("swapping the blocks turns the normal and nothing else") {
  const Met met = meet(square, diamond, {1.9, 0.3});
  const Met swapped = meet(diamond, square, {-1.9, -0.3});
  CHECK(swapped.contact.type == met.contact.type);
  CHECK(swapped.contact.gap == met.contact.gap);
  CHECK(swapped.contact.normal == -met.contact.normal);
  CHECK(swapped.contact.pair.owner == 1 - met.contact.pair.owner);
}

TEST_CASE("edges within the parallel angle are edge-edge, beyond it vertex-edge") {
  const auto tilted = [](double angle) {
    Points points = rectangle(2, 2);
    for (Vector<2>& p : points) p = Rotation<2>::from_angle(angle) * p;
    return shape_of(points);
  };
  const double limit = DetectOptions().parallel_angle;
  CHECK(meet(square, tilted(0.9 * limit), {1.99, 0}).contact.type == ContactType::edge_edge);
  CHECK(meet(square, tilted(1.1 * limit), {1.99, 0}).contact.type == ContactType::vertex_edge);
  CHECK(meet(square, tilted(1e-12), {1.99, 0}).contact.type == ContactType::edge_edge);
}

TEST_CASE("the plane of a region is that of the edge of smaller depth, whichever the blocks met through") {
  const auto tilted = [](double angle) {
    Points points = rectangle(2, 2);
    for (Vector<2>& p : points) p = Rotation<2>::from_angle(angle) * p;
    return shape_of(points);
  };
  constexpr double tilt = 0.005;
  // As the pair through which the blocks met: the top of the lower one, then the bottom of the upper one.
  const auto through = [](int owner) {
    return PairCache<2>{PairCache<2>::touching, {owner, owner == 0 ? 2 : 0, 0}};
  };
  const Shape<2> floor = shape_of(rectangle(20, 2)), box = tilted(tilt);
  for (const int owner : {0, 1}) {
    INFO("met through an edge of " << owner);
    // A box on a longer floor sinks in by its corner.
    const Contact<2> on_floor = meet(floor, box, {0.3, 1.99}, through(owner)).contact;
    CHECK(on_floor.type == ContactType::edge_edge);
    CHECK(on_floor.normal == Vector<2>(0, 1));
    CHECK(on_floor.gap == Approx(0.99 - std::cos(tilt) - std::sin(tilt)));
    CHECK(on_floor.points[0].y() == 1);
    // On a block of its width its corner is in front of the block, or beside that, beyond the block's corner.
    const Contact<2> left_over = meet(square, box, {-0.5, 1.99}, through(owner)).contact;
    CHECK(left_over.normal.isApprox(Vector<2>(-std::sin(tilt), std::cos(tilt))));
    const Vector<2> corner_of_square = Vector<2>(-1, 1) - Vector<2>(-0.5, 1.99);
    CHECK(left_over.gap == Approx(-1 - left_over.normal.dot(corner_of_square)));
    const Contact<2> right_over = meet(square, box, {0.5, 1.99}, through(owner)).contact;
    CHECK(right_over.normal == Vector<2>(0, 1));
    CHECK(right_over.gap == Approx(0.99 - std::cos(tilt) - std::sin(tilt)));
  }
}

TEST_CASE("of edges of one length that end flush, none of smaller depth is left") {
  Random random(5);
  const auto little = [&] {
    return (random.integer(0, 1) ? 1 : -1) * std::pow(10, random.uniform(-17, -2.1));
  };
  for (int i = 0; i < 2000; ++i) {
    Points points = rectangle(2, 2);
    for (Vector<2>& p : points) p = Rotation<2>::from_angle(little()) * p;
    const Shape<2> upper = shape_of(points);
    const Vector<2> to_upper(little(), 1.99 - std::abs(little()));
    const auto through = [&](int owner) {
      const PairCache<2> witness{PairCache<2>::touching, {owner, owner == 0 ? 2 : 0, 0}};
      const Contact<2> contact = meet(square, upper, to_upper, witness).contact;
      CHECK(contact.normal == normal_of(square.outline(), upper.outline(), contact.pair));
      return contact.gap;
    };
    // Either plane where both depths are equal to rounding.
    CHECK(std::abs(through(0) - through(1)) <= 1e-15);
  }
}

TEST_CASE("a thin block that is overlapped past its middle keeps the side through which it was met") {
  const Shape<2> slab = shape_of(rectangle(10, 0.1));
  const Met above = meet(slab, diamond, {0, 1.06});
  REQUIRE(above.contact.type == ContactType::none);
  // Nine tenths through in one step: the least depth would push it out below.
  const Met through = meet(slab, diamond, {0, 0.96}, above.witness);
  CHECK(through.contact.normal == Vector<2>(0, 1));
  CHECK(through.contact.gap == Approx(-0.09));
  // With no history the least depth stands in; here it is above, too, until past the middle of the whole.
  CHECK(meet(slab, diamond, {0, -0.96}).contact.normal == Vector<2>(0, -1));
}

TEST_CASE("the violated pair is kept, tried first, and left when it no longer holds") {
  const Met apart = meet(square, diamond, {2.5, 0});
  REQUIRE(apart.witness.state == PairCache<2>::separated);
  PairCache<2> witness = apart.witness;
  CHECK(still_separated(square.outline(), diamond.outline(), {2.4, 0.1}, witness));
  CHECK(witness.pair.edge == apart.witness.pair.edge);
  CHECK_FALSE(still_separated(square.outline(), diamond.outline(), {0, 2.5}, witness));
  Met around = meet(square, diamond, {0, 2.5}, apart.witness);
  CHECK(around.witness.pair.edge != apart.witness.pair.edge);
  CHECK(still_separated(square.outline(), diamond.outline(), {0, 2.5}, around.witness));
}

TEST_CASE("a vertex that slides off the end of an edge goes on at the next one") {
  const Shape<2> octagon = shape_of(regular_polygon(8, 1, 0));
  Met met = meet(octagon, diamond, {0.9, 1.5});
  // Round the octagon in small steps, always overlapping: the normal follows, from a to b.
  for (double angle = 1.0; angle < 7; angle += 0.01) {
    const Vector<2> to_b = 1.7 * Vector<2>(std::cos(angle), std::sin(angle));
    met = meet(octagon, diamond, to_b, met.witness);
    REQUIRE(met.contact.type != ContactType::none);
    CHECK(met.contact.normal.dot(to_b) > 0);
  }
}
