// Pairs that move from step to step: what a pair remembers of the last step never shows in its verdict, and
// in its face only where faces are as good as each other.

#include <cmath>

#include "catch.h"
#include "world_fixture.h"

namespace halfspace_test {
namespace {

/// One contact, asked about its two polygons wherever they are.
class Asked {
 public:
  explicit Asked(const PosedPolygons& pair) : pair_(pair) {
    add_polygon(world_, pair.a, {0, 0});
    add_polygon(world_, pair.b, {0, 0});
    world_.Step(0, 1, 1);
    if (world_.GetContactList()->GetFixtureA()->GetBody() == world_.GetBodyList())
      throw std::logic_error("the polygon made first is to be the contact's a");
    at({{0, 0}, b2Rot(0)}, {{100, 0}, b2Rot(0)});  // apart, so that the next is the first sight
  }

  b2Manifold at(const b2Transform& at_a, const b2Transform& at_b) {
    b2Manifold manifold;
    world_.GetContactList()->Evaluate(&manifold, at_a, at_b);
    return manifold;
  }
  b2Manifold where_posed(const PosedPolygons& pair) { return at(pair.transform_a(), pair.transform_b()); }
  const halfspace::box2d::Statistics& statistics() const { return narrow_phase_.statistics(); }

 private:
  PosedPolygons pair_;
  b2World world_{{0, 0}};
  NarrowPhase narrow_phase_{world_};
};

/// How far the reference face of a manifold is behind the best.
long double worse_by(const b2Manifold& manifold, const PosedPolygons& pair,
                     const std::vector<FaceGap>& gaps) {
  return largest(gaps).gap - reference_of(manifold, pair, gaps).gap;
}

}  // namespace

TEST_CASE("along a random walk every verdict is exact, and no face worse than the tolerance") {
  Random random(1);
  int touching = 0, apart = 0;
  for (int i = 0; i < 150; ++i) {
    PosedPolygons pair = draw_polygons(0, radii, random);
    Asked asked(pair);
    // Steps of all sizes, some mainly turns: the largest change by more than any slack, the least by none.
    const double size = std::pow(10, halfspace_benchmark::uniform(random, -6, -1.5));
    const double turn = size * std::pow(10, halfspace_benchmark::uniform(random, -2, 1));
    const b2Vec2 start = pair.at_b;
    for (int step = 0; step < 100; ++step) {
      const auto by = [&](double most) { return float(halfspace_benchmark::uniform(random, -most, most)); };
      pair.angle_a += by(turn);
      pair.angle_b += by(turn);
      // Held near where the skins touch.
      pair.at_b += b2Vec2(by(size), by(size)) + 0.1f * (start - pair.at_b);
      const b2Manifold manifold = asked.where_posed(pair);
      const std::vector<FaceGap> gaps = face_gaps(pair);
      const FaceGap best = largest(gaps);
      if (std::abs(best.gap - radii) < 1e-13L) continue;
      if (best.gap > radii) {
        REQUIRE(manifold.pointCount == 0);
        ++apart;
      } else if (manifold.pointCount > 0) {
        REQUIRE(worse_by(manifold, pair, gaps) <= same_gap + 1e-12);
        ++touching;
      } else {
        REQUIRE(best.beyond > 0);
      }
    }
  }
  CHECK(touching > 2000);
  CHECK(apart > 2000);
}

TEST_CASE("a pair stays at its face until another is better by more than the tolerance") {
  // A box on another: tilted by t, the gap of the lower one's face is less than that of the upper one's by
  // nearly t times the 0.2 m by which the upper one's corner is past the end of the lower.
  PosedPolygons pair{box_shape(0.5f, 0.5f), box_shape(0.5f, 0.5f), {0, 0}, {0.2f, 1.01f}, 0, 0};
  Asked asked(pair);
  const auto type_at = [&](float tilt) {
    pair.angle_b = tilt;
    const b2Manifold manifold = asked.where_posed(pair);
    REQUIRE(manifold.pointCount > 0);
    return manifold.type;
  };
  const auto ahead = [&] {
    long double of_each[2] = {-1, -1};
    for (const FaceGap& g : face_gaps(pair)) of_each[g.owner] = std::max(of_each[g.owner], g.gap);
    return of_each[1] - of_each[0];
  };
  CHECK(type_at(0) == b2Manifold::e_faceA);  // a tie at first sight
  CHECK(type_at(-1e-3f) == b2Manifold::e_faceA);
  CHECK(std::abs(ahead()) < same_gap);
  const auto most_ahead_of_b = [&] {
    float best = 0;
    long double most = 0;
    for (const float tilt : {-0.01f, 0.01f}) {
      pair.angle_b = tilt;
      if (ahead() > most) {
        most = ahead();
        best = tilt;
      }
    }
    return best;
  };
  const float for_b = most_ahead_of_b();
  REQUIRE(for_b != 0);
  CHECK(type_at(for_b) == b2Manifold::e_faceB);
  // Back at the tie, and a little past it: it stays at b's face, where it came from a's before.
  CHECK(type_at(0.05f * for_b) == b2Manifold::e_faceB);
  CHECK(type_at(0) == b2Manifold::e_faceB);
  for (int i = 0; i < 50; ++i) CHECK(type_at(i % 2 ? 1e-4f : -1e-4f) == b2Manifold::e_faceB);
}

TEST_CASE("a pair parts as soon as any face says so, not only its own") {
  // The face of the upper box is the better one, but by less than the tolerance: the lower one's is taken.
  PosedPolygons pair{box_shape(0.5f, 0.5f), box_shape(0.5f, 0.5f), {0, 0}, {0.2f, 1}, 0, 0};
  Asked asked(pair);
  int told_apart = 0;
  for (const float tilt : {-5e-4f, 5e-4f}) {
    pair.angle_b = tilt;
    pair.at_b.y = 1;
    const long double touching_at = largest(face_gaps(pair)).gap;
    pair.at_b.y += float(radii - 1e-4L - touching_at);
    const b2Manifold touching = asked.where_posed(pair);
    REQUIRE(touching.pointCount > 0);
    const long double behind = worse_by(touching, pair, face_gaps(pair));
    pair.at_b.y += 1.2e-4f;
    const long double past = largest(face_gaps(pair)).gap - radii;
    REQUIRE(past > 0);
    CHECK(asked.where_posed(pair).pointCount == 0);
    INFO("the pair's own face is behind by " << double(behind));
    told_apart += behind > 0;
    if (behind > 0) CHECK(past < behind);  // by its own face alone the pair would still touch
  }
  CHECK(told_apart > 0);
}

TEST_CASE("a turn by half a circle, exactly and nearly, is a turn like others") {
  const PosedPolygons pair{box_shape(0.5f, 0.5f), box_shape(0.5f, 0.5f), {0, 0}, {0.1f, 1.01f}, 0, 0};
  Asked asked(pair);
  b2Rot turn;
  for (const float sine : {0.0f, -0.0f, 8.7e-8f, -8.7e-8f, 1e-20f, -1e-30f}) {
    turn.c = -1;
    turn.s = sine;
    CHECK(asked.at({pair.at_a, b2Rot(0)}, {pair.at_b, turn}).pointCount == 2);
    CHECK(asked.at({pair.at_b, turn}, {pair.at_a, b2Rot(0)}).pointCount == 2);
  }
  CHECK(asked.statistics().refused == 0);
}

}  // namespace halfspace_test
