// Options::compared: Box2D's narrow phase asked about the same pairs, and both answers told.

#include <cmath>

#include "catch.h"
#include "world_fixture.h"

namespace halfspace_test {
namespace {

using halfspace::box2d::Comparison;
using halfspace::box2d::Options;
using halfspace::box2d::Statistics;

bool have_same_points(const b2Manifold& one, const b2Manifold& other) {
  bool same = one.pointCount == other.pointCount;
  for (int i = 0; same && i < one.pointCount; ++i)
    same = one.points[i].id.key == other.points[i].id.key &&
           one.points[i].localPoint == other.points[i].localPoint;
  return same;
}

}  // namespace

TEST_CASE("comparing: both answers, the pair and its poses are told, once for each pair") {
  b2World world({0, -10});
  std::int64_t told = 0, unlike_box2d = 0, not_in_use = 0;
  double seconds = 0, box2d_seconds = 0;
  Options options;
  options.compared = [&](const Comparison& pair) {
    ++told;
    seconds += pair.seconds;
    box2d_seconds += pair.box2d_seconds;
    b2Manifold expected;
    b2CollidePolygons(&expected, static_cast<const b2PolygonShape*>(pair.a.GetShape()), pair.at_a,
                      static_cast<const b2PolygonShape*>(pair.b.GetShape()), pair.at_b);
    unlike_box2d += !have_same_points(pair.box2d, expected);
    // Both are told while the contact's own manifold is being written: that is the half-space one.
    bool is_known = false;
    for (const b2Contact* contact : contacts_of(world)) is_known |= contact->GetManifold() == &pair.halfspace;
    not_in_use += !is_known;
  };
  const NarrowPhase narrow_phase(world, options);
  add_stack(world, 5);
  step(world, 60);
  const Statistics& statistics = narrow_phase.statistics();
  CHECK(told > 0);
  CHECK(told == statistics.pairs);
  CHECK(told == statistics.compared);
  CHECK(unlike_box2d == 0);
  CHECK(not_in_use == 0);
  CHECK(statistics.disagreements == 0);
  CHECK(seconds > 0);
  CHECK(box2d_seconds > 0);
  CHECK(statistics.seconds == Approx(seconds));
  CHECK(statistics.box2d_seconds == Approx(box2d_seconds));
}

TEST_CASE("comparing changes no bit of the world, and nothing is compared unasked") {
  b2World plain({0, -10}), watched({0, -10});
  Options options;
  options.compared = [](const Comparison&) {};
  const NarrowPhase unasked(plain), asked(watched, options);
  for (b2World* world : {&plain, &watched}) add_stack(*world, 5);
  for (int i = 0; i < 100; ++i) {
    step(plain);
    step(watched);
    REQUIRE(state_of(plain) == state_of(watched));
  }
  CHECK(asked.statistics().compared == asked.statistics().pairs);
  CHECK(unasked.statistics().compared == 0);
  CHECK(unasked.statistics().seconds == 0);
}

TEST_CASE("comparing where a polygon is attached: Box2D is asked about the fixture's own shape") {
  // A diamond in its box: the box touches the floor all along, the diamond at one corner, or not at all.
  const Context context = make_context();
  const Shape diamond = make_shape(context.get(), {{0.5, 0}, {0, 0.5}, {-0.5, 0}, {0, -0.5}});
  const b2PolygonShape box = halfspace::box2d::box_around(*diamond);
  b2World world({0, 0});
  int halfspace_points = 0, box2d_points = 0;
  Options options;
  options.geometry_of = [&](b2Fixture& fixture) {
    const bool is_box = fixture.GetBody()->GetType() == b2_dynamicBody;
    return FixtureGeometry{false, is_box ? diamond.get() : nullptr};
  };
  options.compared = [&](const Comparison& pair) {
    halfspace_points = pair.halfspace.pointCount;
    box2d_points = pair.box2d.pointCount;
  };
  const NarrowPhase narrow_phase(world, options);
  add_polygon(world, box_shape(20, 1), {0, -1}, 0, b2_staticBody);
  b2Body& body = *add_polygon(world, box, {0, 0.51f}).GetBody();
  world.Step(0, 1, 1);
  CHECK(halfspace_points == 1);
  CHECK(box2d_points == 2);
  // On its side: the box's corner is in the floor, the side of the diamond above it.
  body.SetTransform({0, 0.45f}, float(halfspace_benchmark::pi / 4));
  world.Step(0, 1, 1);
  CHECK(halfspace_points == 0);  // its side is 0.35 m from its centre
  CHECK(box2d_points == 1);
  CHECK(narrow_phase.statistics().disagreements == 1);
}

}  // namespace halfspace_test
