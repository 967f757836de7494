// Manifolds of random pairs against their definition in long double, and against b2CollidePolygons.

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "world_fixture.h"

namespace halfspace_test {
namespace {

/// Box2D works on coordinates of at most this size in these tests, in about eight operations that each round
/// by half a unit in the last place.
constexpr double farthest = 4;
constexpr double rounding = 8 * farthest * 0x1p-24;

/// The local normal is that of the reference face, to a float.
void check_normal(const b2Manifold& manifold, const PosedPolygons& pair, const FaceGap& reference) {
  const b2PolygonShape& owner = reference.owner == 0 ? pair.a : pair.b;
  CHECK((owner.m_normals[reference.edge] - manifold.localNormal).Length() <= 4 * 0x1p-24);
}

/// How much farther than along the face rounding moves the point where its strip cuts the incident edge.
double steepness(const PosedPolygons& pair, const FaceGap& reference) {
  const b2Rot a(pair.angle_a), b(pair.angle_b);
  const bool of_a = reference.owner == 0;
  const b2PolygonShape &owner = of_a ? pair.a : pair.b, &other = of_a ? pair.b : pair.a;
  const b2Vec2 normal = b2Mul(of_a ? a : b, owner.m_normals[reference.edge]);
  float most_opposed = 0;
  for (int i = 0; i < other.m_count; ++i)
    most_opposed = std::min(most_opposed, b2Dot(normal, b2Mul(of_a ? b : a, other.m_normals[i])));
  return -1 / most_opposed;
}

/// The features of a point from the side of the reference face: the incident vertex on the face, or the end
/// of the face on the incident edge. Which edge that is Box2D does not tell where both ends of an edge are
/// cut off.
struct Features {
  int type;
  int index;
};
Features features_of(const b2Manifold& manifold, const b2ContactID& id, const FaceGap& reference) {
  const bool of_a = manifold.type == b2Manifold::e_faceA;
  const b2ContactFeature f =
      of_a ? id.cf : b2ContactFeature{id.cf.indexB, id.cf.indexA, id.cf.typeB, id.cf.typeA};
  CHECK(f.typeA != f.typeB);
  if (f.typeA == b2ContactFeature::e_vertex) return {f.typeA, f.indexA};
  CHECK(f.indexA == reference.edge);
  return {f.typeA, f.indexB};
}

/// Every point of one manifold is in the other, under the same id, unless it hangs by rounding on the reach
/// of the skins or on the end of the strip.
void check_points(const b2Manifold& one, const b2Manifold& other, const PosedPolygons& pair,
                  const FaceGap& reference) {
  const double tolerance = rounding * steepness(pair, reference);
  if (std::abs(double(reference.beyond) - radii) < tolerance) return;
  b2WorldManifold in_world;
  in_world.Initialize(&one, pair.transform_a(), pair.a.m_radius, pair.transform_b(), pair.b.m_radius);
  for (int i = 0; i < one.pointCount; ++i) {
    if (std::abs(in_world.separations[i]) < tolerance) continue;
    const b2ManifoldPoint* nearest = &other.points[0];
    const auto distance = [&](const b2ManifoldPoint& p) {
      return (p.localPoint - one.points[i].localPoint).Length();
    };
    if (other.pointCount > 1 && distance(other.points[1]) < distance(*nearest)) nearest = &other.points[1];
    CHECK(distance(*nearest) <= tolerance);
    const Features f = features_of(one, one.points[i].id, reference);
    const Features g = features_of(other, nearest->id, reference);
    CHECK(f.type == g.type);
    CHECK(f.index == g.index);
  }
}

/// What is compared, so that a test is seen to have compared something.
struct Tally {
  int touching = 0;
  int apart = 0;
  int same_face = 0;
};

void check_against_box2d(const PosedPolygons& pair, Tally& tally) {
  const b2Manifold ours = manifold_of(pair, true), box2d = manifold_of(pair, false);
  const std::vector<FaceGap> gaps = face_gaps(pair);
  const FaceGap best = largest(gaps);
  if (best.gap > radii) {
    CHECK(ours.pointCount == 0);
    ++tally.apart;
    return;
  }
  if (ours.pointCount == 0 || box2d.pointCount == 0) {
    // Two corners meet, and the skins reach past the faces but not around.
    CHECK(best.beyond > radii - same_gap - rounding);
    return;
  }
  ++tally.touching;
  const FaceGap of_ours = reference_of(ours, pair, gaps), of_box2d = reference_of(box2d, pair, gaps);
  check_normal(ours, pair, of_ours);
  check_normal(box2d, pair, of_box2d);
  CHECK(best.gap - of_ours.gap <= same_gap + 1e-12);
  if (of_ours.owner != of_box2d.owner || of_ours.edge != of_box2d.edge) {
    CHECK(best.gap - of_box2d.gap <= same_gap + rounding);
    return;
  }
  ++tally.same_face;
  CHECK((ours.localPoint - box2d.localPoint).Length() <= rounding);
  check_points(ours, box2d, pair, of_ours);
  check_points(box2d, ours, pair, of_ours);
}

}  // namespace

TEST_CASE("manifolds are those of Box2D where rounding leaves no choice") {
  Random random(1);
  Tally tally;
  for (const double gap : {-0.3, -0.05, -1e-3, 0.0, 0.01, 0.019, 0.021, 0.05}) {
    for (int i = 0; i < 500; ++i) check_against_box2d(draw_polygons(1, gap, random), tally);
  }
  CHECK(tally.touching > 2500);
  CHECK(tally.apart > 900);
  CHECK(tally.same_face > 0.95 * tally.touching);
}

TEST_CASE("the verdict is exact, also far from the origin") {
  Random random(2);
  int touching = 0, apart = 0;
  for (const double from_origin : {0.0, 1e2, 1e4}) {
    for (int i = 0; i < 2000; ++i) {
      const double off = std::pow(10, halfspace_benchmark::uniform(random, -9, -2));
      const PosedPolygons pair = draw_polygons(from_origin, radii + (i % 2 ? off : -off), random);
      const std::vector<FaceGap> gaps = face_gaps(pair);
      const FaceGap best = largest(gaps);
      if (std::abs(best.gap - radii) < 1e-13L) continue;  // the rounding of the adapter's own doubles
      const bool touches = manifold_of(pair, true).pointCount > 0;
      if (best.gap > radii) {
        CHECK_FALSE(touches);
        ++apart;
      } else if (best.beyond < 0) {
        CHECK(touches);
        ++touching;
      }
    }
  }
  CHECK(touching > 500);
  CHECK(apart > 500);
}

TEST_CASE("a pair moved without rounding has the same manifold, bit by bit") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    PosedPolygons pair = draw_polygons(1, 0.01, random);
    // Multiples of 2^-10 m within 2^13 m are floats.
    const auto to_grid = [](b2Vec2 v) {
      return b2Vec2(std::round(1024 * v.x) / 1024, std::round(1024 * v.y) / 1024);
    };
    pair.at_a = to_grid(pair.at_a);
    pair.at_b = to_grid(pair.at_b);
    const b2Manifold here = manifold_of(pair, true);
    pair.at_a += b2Vec2(4096, -2048);
    pair.at_b += b2Vec2(4096, -2048);
    const b2Manifold there = manifold_of(pair, true);
    REQUIRE(here.pointCount == there.pointCount);
    if (here.pointCount == 0) continue;
    CHECK(here.type == there.type);
    CHECK(here.localNormal == there.localNormal);
    CHECK(here.localPoint == there.localPoint);
    for (int p = 0; p < here.pointCount; ++p) {
      CHECK(here.points[p].id.key == there.points[p].id.key);
      CHECK(here.points[p].localPoint == there.points[p].localPoint);
    }
  }
}

}  // namespace halfspace_test
