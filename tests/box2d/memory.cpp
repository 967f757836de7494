// A pair is judged without asking for memory: neither by the C++ allocator, which the adapter and Box2D use,
// nor by the library's own, for which a Ledger stands in.

#include "capi/ledger.h"
#include "catch.h"
#include "world_fixture.h"

namespace halfspace_test {

TEST_CASE("Evaluate asks for no memory, near and far, at rest and turned") {
  Random random(5);
  int judged = 0;
  for (int i = 0; i < 100; ++i) {
    const PosedPolygons pair = draw_polygons(1, halfspace_benchmark::uniform(random, -0.1, 0.05), random);
    b2World world({0, 0});
    const NarrowPhase narrow_phase(world);
    add_polygon(world, pair.a, pair.at_a, pair.angle_a);
    add_polygon(world, pair.b, pair.at_b, pair.angle_b);
    world.Step(0, 1, 1);
    b2Contact* contact = world.GetContactList();
    if (!contact) continue;
    ++judged;
    b2Manifold manifold;
    const long before = calls_of_new;
    for (int k = 0; k < 50; ++k) {
      const b2Transform at_b(pair.at_b + 1e-3f * b2Vec2(float(k % 7), float(k % 5)),
                             b2Rot(pair.angle_b + 0.1f * float(k)));
      contact->Evaluate(&manifold, pair.transform_a(), at_b);
    }
    CHECK(calls_of_new == before);
  }
  CHECK(judged > 50);
}

TEST_CASE("the library is asked for memory by attached polygons of many vertices only") {
  for (const auto& [count, asks] : {std::pair(12, false), std::pair(32, false), std::pair(33, true)}) {
    Ledger ledger;
    const hs_context_def def = ledger.definition();
    const Context context = make_context(&def);
    Points vertices;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * halfspace_benchmark::pi * i / count;
      vertices.push_back({std::cos(angle), std::sin(angle)});
    }
    const Shape polygon = make_shape(context.get(), vertices);
    b2World world({0, 0});
    halfspace::box2d::Options options;
    options.geometry_of = [&](b2Fixture&) { return FixtureGeometry{false, polygon.get()}; };
    const NarrowPhase narrow_phase(world, options);
    const b2PolygonShape box = halfspace::box2d::box_around(*polygon);
    add_polygon(world, box, {0, 0});
    add_polygon(world, box, {1.99f, 0});
    world.Step(0, 1, 1);
    REQUIRE(world.GetContactList());
    const long before = ledger.allocations;
    b2Manifold manifold;
    for (int k = 0; k < 50; ++k) {
      const b2Transform at_b(b2Vec2(1.99f, 0.01f * float(k)), b2Rot(0.1f * float(k)));
      world.GetContactList()->Evaluate(&manifold, b2Transform(b2Vec2(0, 0), b2Rot(0)), at_b);
    }
    INFO(count << " vertices");
    CHECK((ledger.allocations > before) == asks);
  }
}

}  // namespace halfspace_test
