// Polygons that Box2D cannot have, attached to fixtures.

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "world_fixture.h"

namespace halfspace_test {
namespace {

using halfspace::box2d::Options;
using halfspace_benchmark::pi;

/// On its side, its centre off the origin of the body.
Points regular_polygon(int count, double radius, Point centre) {
  Points polygon;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * (i + 0.5) / count - pi / 2;
    polygon.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return polygon;
}

/// The host keeps a fixture's shape in the fixture's user data.
Options shapes_in_user_data() {
  Options options;
  options.geometry_of = [](b2Fixture& fixture) {
    return FixtureGeometry{false, reinterpret_cast<const hs_shape*>(fixture.GetUserData().pointer)};
  };
  return options;
}

b2Body& add_attached(b2World& world, const hs_shape& shape, b2Vec2 at) {
  b2BodyDef body;
  body.type = b2_dynamicBody;
  body.position = at;
  const b2PolygonShape box = halfspace::box2d::box_around(shape);
  b2FixtureDef fixture;
  fixture.shape = &box;
  fixture.density = 1;
  fixture.userData.pointer = reinterpret_cast<std::uintptr_t>(&shape);
  b2Body& made = *world.CreateBody(&body);
  made.CreateFixture(&fixture);
  const b2MassData mass = halfspace::box2d::mass_of(shape, 1);
  made.SetMassData(&mass);
  return made;
}

}  // namespace

TEST_CASE("a polygon of many vertices rests on its own side, not on the box around it") {
  for (const int count : {12, 40, 300}) {
    const Context context = make_context();
    const double radius = 0.5, apothem = radius * std::cos(pi / count);
    const Points vertices = regular_polygon(count, radius, {0.25, 0.125});
    const Shape polygon = make_shape(context.get(), vertices);
    b2World world({0, -10});
    const NarrowPhase narrow_phase(world, shapes_in_user_data());
    add_polygon(world, box_shape(20, 1), {0, -1}, 0, b2_staticBody);
    b2Body& body = add_attached(world, *polygon, {0, float(apothem - 0.125 + 0.03)});
    step(world, 200);
    const b2Contact* contact = world.GetContactList();
    REQUIRE(contact);
    const b2Manifold& manifold = *contact->GetManifold();
    REQUIRE(manifold.pointCount == 2);
    // Both points are the ends of the lowest side, to a float.
    const bool floor_owns = manifold.type == b2Manifold::e_faceA;
    CHECK(floor_owns);
    for (const b2ManifoldPoint& p : manifold.points) {
      const auto is_it = [&](const Point& v) {
        return std::abs(p.localPoint.x - v.x) < 1e-7 && std::abs(p.localPoint.y - v.y) < 1e-7;
      };
      CHECK(std::any_of(vertices.begin(), vertices.end(), is_it));
    }
    const double height = body.GetWorldPoint({0.25f, 0.125f}).y;
    CHECK(height > apothem + 2 * b2_polygonRadius - 3 * b2_linearSlop);
    CHECK(height < apothem + 2 * b2_polygonRadius);
  }
}

TEST_CASE("an edge that Box2D would weld away is met") {
  // A corner cut off over a thousandth of the block.
  const Context context = make_context();
  const Shape cut =
      make_shape(context.get(), {{-0.5, -0.5}, {0.499, -0.5}, {0.5, -0.499}, {0.5, 0.5}, {-0.5, 0.5}});
  b2World world({0, 0});
  const NarrowPhase narrow_phase(world, shapes_in_user_data());
  // A wedge that points at the cut: the face between them is that of the cut.
  add_attached(world, *cut, {0, 0});
  b2PolygonShape wedge;
  const b2Vec2 corners[] = {{0, 0}, {1, -0.5f}, {0.5f, -1}};
  wedge.Set(corners, 3);
  add_polygon(world, wedge, {0.5035f, -0.5035f});
  world.Step(0, 1, 1);
  const b2Contact* contact = world.GetContactList();
  REQUIRE(contact);
  const b2Manifold& manifold = *contact->GetManifold();
  REQUIRE(manifold.pointCount > 0);
  CHECK(manifold.localNormal.x == Approx(std::sqrt(0.5)));
  CHECK(manifold.localNormal.y == Approx(-std::sqrt(0.5)));
}

TEST_CASE("the box around a polygon holds it, and the mass is that of the polygon") {
  const Context context = make_context();
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    Points vertices = halfspace_benchmark::random_polygon(12, 0.7, random);
    for (Point& v : vertices) v = {v.x + 3, v.y - 2};
    const Shape shape = make_shape(context.get(), vertices);
    const b2PolygonShape box = halfspace::box2d::box_around(*shape);
    b2AABB bounds;
    box.ComputeAABB(&bounds, b2Transform({0, 0}, b2Rot(0)), 0);
    for (const Point& v : vertices) {
      // Box2D rounds the corners of a box once more; its skin is a thousand times as thick as that.
      CHECK(bounds.lowerBound.x < v.x);
      CHECK(bounds.upperBound.x > v.x);
      CHECK(bounds.lowerBound.y < v.y);
      CHECK(bounds.upperBound.y > v.y);
    }
  }
  // Against Box2D's own mass of a polygon that it can have.
  const Points five = halfspace_benchmark::random_polygon(5, 0.7, random);
  b2Vec2 corners[5];
  Points rounded;
  for (std::size_t i = 0; i < 5; ++i) {
    corners[i] = {float(five[i].x + 1), float(five[i].y)};
    rounded.push_back({corners[i].x, corners[i].y});
  }
  b2PolygonShape polygon;
  polygon.Set(corners, 5);
  b2MassData expected;
  polygon.ComputeMass(&expected, 2.5f);
  const Shape shape = make_shape(context.get(), rounded);
  const b2MassData mass = halfspace::box2d::mass_of(*shape, 2.5f);
  CHECK(mass.mass == Approx(expected.mass).epsilon(1e-5));
  CHECK(mass.I == Approx(expected.I).epsilon(1e-5));
  CHECK(mass.center.x == Approx(expected.center.x).epsilon(1e-5));
  CHECK(mass.center.y == Approx(expected.center.y).margin(1e-6));
}

}  // namespace halfspace_test
