// Errors of Box2D's own narrow phase at the shapes that the adapter leaves to it: circles and chains.
//
//   box2d_edges
//
// Prints the largest error of the gap of circles against polygons and edges, by long double, and how a box
// slides over the joints of a level chain.

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace {

using Real = long double;

/// The distance of a point from a box with given half sides, negative inside, at a transform.
Real distance_from_box(const b2Transform& at, const b2Vec2& half, const b2Vec2& point) {
  const Real c = at.q.c, s = at.q.s, norm = std::sqrt(c * c + s * s);
  const Real dx = Real(point.x) - at.p.x, dy = Real(point.y) - at.p.y;
  const Real x = std::abs((c * dx + s * dy) / norm) - half.x, y = std::abs((c * dy - s * dx) / norm) - half.y;
  if (x > 0 && y > 0) return std::sqrt(x * x + y * y);
  return std::max(x, y);
}

/// The gap that the solver sees, at the only point of a manifold.
Real gap_of(const b2Manifold& manifold, const b2Transform& at_a, float radius_a, const b2Transform& at_b,
            float radius_b) {
  b2WorldManifold world;
  world.Initialize(&manifold, at_a, radius_a, at_b, radius_b);
  return world.separations[0];
}

struct Worst {
  Real error = 0;
  long touching = 0;
};

Worst worst_circle(float far, bool on_edge) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> angle(0, 6.2831853f), unit(-1, 1), depth(-0.05f, 0.009f);
  const b2Vec2 half(0.5f, on_edge ? 0.0f : 0.25f);
  b2PolygonShape box;
  if (!on_edge) box.SetAsBox(half.x, half.y);
  b2EdgeShape edge;
  edge.SetTwoSided({-half.x, 0}, {half.x, 0});
  b2CircleShape circle;
  circle.m_radius = 0.25f;
  Worst worst;
  for (int i = 0; i < 100000; ++i) {
    b2Transform at_a, at_b;
    at_a.Set({far + unit(random), unit(random)}, angle(random));
    const b2Vec2 local(0.5f * unit(random), half.y + circle.m_radius + depth(random));
    at_b.Set(b2Mul(at_a, local), angle(random));
    b2Manifold manifold;
    const float skin = on_edge ? edge.m_radius : box.m_radius;
    if (on_edge) {
      b2CollideEdgeAndCircle(&manifold, &edge, at_a, &circle, at_b);
    } else {
      b2CollidePolygonAndCircle(&manifold, &box, at_a, &circle, at_b);
    }
    if (manifold.pointCount == 0) continue;
    ++worst.touching;
    const Real expected = distance_from_box(at_a, half, at_b.p) - circle.m_radius - skin;
    worst.error =
        std::max(worst.error, std::abs(gap_of(manifold, at_a, skin, at_b, circle.m_radius) - expected));
  }
  return worst;
}

/// A box slides at 5 m/s without friction over a level floor of segments of 0.25 m, or over one edge.
void slide(const char* name, int kind) {
  b2World world({0, -10});
  const b2BodyDef ground;
  b2Body* const floor = world.CreateBody(&ground);
  constexpr int segments = 240;
  b2Vec2 points[segments + 1];
  for (int i = 0; i <= segments; ++i) points[i].Set(30 - 0.25f * float(i), 0);  // solid below
  if (kind == 0) {
    b2EdgeShape edge;
    edge.SetTwoSided(points[segments], points[0]);
    floor->CreateFixture(&edge, 0);
  } else if (kind == 1) {
    b2ChainShape chain;
    chain.CreateChain(points, segments + 1, {31, 0}, {-31, 0});
    floor->CreateFixture(&chain, 0);
  } else {
    for (int i = 0; i < segments; ++i) {
      b2EdgeShape edge;
      edge.SetTwoSided(points[i + 1], points[i]);
      floor->CreateFixture(&edge, 0);
    }
  }
  b2BodyDef moving;
  moving.type = b2_dynamicBody;
  moving.position = {-25, 0.5f};
  moving.linearVelocity = {5, 0};
  moving.allowSleep = false;
  b2Body* const body = world.CreateBody(&moving);
  b2PolygonShape box;
  box.SetAsBox(0.5f, 0.5f);
  b2FixtureDef fixture;
  fixture.shape = &box;
  fixture.density = 1;
  fixture.friction = 0;
  body->CreateFixture(&fixture);
  float highest = 0, most_tilt = 0;
  for (int i = 0; i < 540; ++i) {
    world.Step(1 / 60.0f, 8, 3);
    if (i < 60) continue;
    highest = std::max(highest, body->GetPosition().y - 0.515f);
    most_tilt = std::max(most_tilt, std::abs(body->GetAngle()));
  }
  std::printf("  %-22s speed %.4f m/s of 5, jump %7.3f mm, tilt %8.5f rad\n", name,
              double(body->GetLinearVelocity().x), 1e3 * double(highest), double(most_tilt));
}

}  // namespace

int main() {
  std::printf("largest error of the gap, touching pairs of 100000:\n");
  for (const float far : {0.0f, 1000.0f, 10000.0f}) {
    const Worst polygon = worst_circle(far, false), edge = worst_circle(far, true);
    std::printf("  %6.0f m: circle on polygon %.2Lg m (%ld), circle on edge %.2Lg m (%ld)\n", double(far),
                polygon.error, polygon.touching, edge.error, edge.touching);
  }
  std::printf("a box slides 40 m over a level floor:\n");
  slide("one edge", 0);
  slide("chain, ghost vertices", 1);
  slide("edges without ghosts", 2);
}
