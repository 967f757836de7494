// Creep on slopes at the friction angle, by Box2D's solver and in force mode, in the scenes of the
// comparison. Each bound on the creep of force mode is derived; where Box2D's world creeps more than ten
// times as far, that of force mode must creep less than a tenth of it.

#include <algorithm>
#include <vector>

#include "catch.h"
#include "engines.h"
#include "forces.h"

namespace box2d_comparison {
namespace {

constexpr double gravity = 10;

/// m, of a slope and a friction that are floats, and so off each other by some 2^-22.
double creep_of_rounding(double seconds) { return 0.5 * gravity * 0x1p-22 * seconds * seconds; }

Scene scene_named(const std::string& name) {
  const std::vector<Scene> scenes = all_scenes();
  return *std::find_if(scenes.begin(), scenes.end(), [&](const Scene& scene) { return scene.name == name; });
}

EngineKind kind_named(const std::string& name, int bearers) {
  const std::vector<EngineKind> kinds = engine_kinds(borne_by(bearers));
  return *std::find_if(kinds.begin(), kinds.end(), [&](const EngineKind& kind) { return kind.name == name; });
}

void run(Engine& engine, double seconds) {
  for (double time = 0; time < seconds - frame_seconds / 2; time += frame_seconds) engine.step();
}

/// A slope and the topmost block on it.
struct Slope {
  b2Body* floor;
  b2Body* top;
  double place() const { return b2Dot(top->GetWorldCenter(), floor->GetWorldVector({1, 0})); }
};

/// Box2D lists what was made last first.
std::vector<Slope> slopes_of(b2World& world) {
  std::vector<Slope> slopes;
  b2Body* top = nullptr;
  for (b2Body* body = world.GetBodyList(); body; body = body->GetNext()) {
    if (!top) top = body;
    if (body->GetType() != b2_staticBody) continue;
    slopes.push_back({body, top});
    top = nullptr;
  }
  return slopes;
}

std::vector<double> places_of(b2World& world) {
  std::vector<double> places;
  for (const Slope& slope : slopes_of(world)) places.push_back(slope.place());
  return places;
}

/// m, of the topmost block of each slope.
std::vector<double> creep_in(Stage& stage, Engine& engine, double seconds) {
  const std::vector<double> before = places_of(stage.world());
  run(engine, seconds);
  std::vector<double> creep = places_of(stage.world());
  for (std::size_t i = 0; i < creep.size(); ++i) creep[i] = std::abs(creep[i] - before[i]);
  return creep;
}

/// Of a block that is let go, once it has come down.
double creep_let_go(const std::string& kind_name, double seconds) {
  const Scene scene = scene_named("slope_at_friction");
  const EngineKind kind = kind_named(kind_name, 1);
  Stage stage(kind.rest_gap);
  scene.build(stage);
  const auto engine = kind.begin(stage);
  run(*engine, 0.5);
  return creep_in(stage, *engine, seconds).front();
}

/// Of the upper one of two blocks that have lain for 2 s with four times the friction, on slopes of the
/// indices that are wanted, which are increasing; on all when there are none.
std::vector<double> creep_of_two(const std::string& kind_name, const std::vector<std::size_t>& wanted,
                                 double seconds) {
  const Scene scene = scene_named("slopes_of_two");
  const EngineKind kind = kind_named(kind_name, wanted.empty() ? scene.forces.bearers : int(wanted.size()));
  Stage stage(kind.rest_gap);
  scene.build(stage);
  const std::vector<Slope> slopes = slopes_of(stage.world());
  for (std::size_t i = 0; i < slopes.size() && !wanted.empty(); ++i) {
    if (std::binary_search(wanted.begin(), wanted.end(), i)) continue;
    for (b2Body *body = slopes[i].top, *next = nullptr; body; body = next) {
      next = body == slopes[i].floor ? nullptr : body->GetNext();
      stage.world().DestroyBody(body);
    }
  }
  const auto engine = kind.begin(stage);
  run(*engine, 2);
  scene.let_go(stage);
  return creep_in(stage, *engine, seconds);
}

}  // namespace

// It falls vertically, along the edge of the friction cone, and nothing is left to move it along; whether it
// begins where it just touches, 45 um above the slope or as deep within it.
TEST_CASE("a block that is let go at the friction angle creeps less than a tenth of Box2D's in force mode") {
  constexpr double seconds = 9.5;
  const double bound = creep_of_rounding(0.5 + seconds);
  double farthest_by_box2d = 0;
  for (const std::string begun : {"", "_nudged", "_nudged_back"}) {
    const double by_box2d = creep_let_go("box2d" + begun, seconds),
                 by_forces = creep_let_go("forces" + begun, seconds);
    INFO("Box2D" << begun << ' ' << by_box2d << " m, force mode " << by_forces << " m");
    CHECK(by_forces < bound);
    CHECK(by_forces < by_box2d / 10);
    farthest_by_box2d = std::max(farthest_by_box2d, by_box2d);
  }
  REQUIRE(farthest_by_box2d > 10 * bound);
}

// The whole face of the lower block is in touch, overlaps by no more than d = W/k in its middle and by no
// less than nothing at its end, half a width w away: so it leans downhill by no more than 2 d / w. Friction
// that is the tangent of the slope leaves the upper block an acceleration of g sin(lean) / cos(slope); and d
// is less by that cosine, as the face bears no more than the weight's part across it.
TEST_CASE("two blocks at the friction angle creep less than a tenth of Box2D's in force mode") {
  constexpr double seconds = 5, width = 1.9;
  const double bound =
      0.5 * gravity * 2 * bearing_overlap / width * seconds * seconds + creep_of_rounding(seconds);
  std::vector<std::size_t> creeping;
  std::vector<double> by_box2d;
  const std::vector<double> on_all = creep_of_two("box2d", {}, seconds);
  for (std::size_t i = 0; i < on_all.size(); ++i) {
    if (on_all[i] < 10 * bound) continue;
    creeping.push_back(i);
    by_box2d.push_back(on_all[i]);
  }
  REQUIRE(!creeping.empty());
  const std::vector<double> by_forces = creep_of_two("forces", creeping, seconds);
  REQUIRE(by_forces.size() == by_box2d.size());
  for (std::size_t i = 0; i < by_forces.size(); ++i) {
    INFO("Box2D " << by_box2d[i] << " m, force mode " << by_forces[i] << " m, bound " << bound << " m");
    CHECK(by_forces[i] < bound);
  }
}

}  // namespace box2d_comparison
