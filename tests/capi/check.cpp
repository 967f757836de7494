// halfspace/check.h: notes on the settings of a world that are outside of their usual range, and on no
// others.

#include "halfspace/check.h"

#include <string>

#include "capi/unchanged.h"
#include "catch.h"

namespace halfspace_test {
namespace {

std::vector<hs_note> notes_on(const hs_world* world) {
  std::int64_t count = -1;
  REQUIRE(hs_world_check(world, nullptr, 0, &count) >= HS_OK);
  std::vector<hs_note> notes(static_cast<std::size_t>(count));
  REQUIRE(hs_world_check(world, notes.data(), count, nullptr) == HS_OK);
  return notes;
}

/// A world of two materials, each with its elasticity, and a moving block: all as usual.
struct UsualWorld {
  UsualWorld() {
    for (const double density : {2700, 2500}) {
      std::int32_t material = -1;
      require_ok(hs_world_add_material(world.get(), density, &material), context.get());
      const hs_elasticity_def elasticity = elasticity_def(5e10);
      require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    }
    const hs_law_def law = law_def(1e9, 0.5);
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    block = add_block(context.get(), world.get(), box(0, 0, 1, 1), HS_BLOCK_RIGID);
  }

  Context context = make_context();
  World world = make_world(context.get(), world_def());
  hs_block block = 0;
};

}  // namespace

TEST_CASE("a world as usual gets no note") {
  UsualWorld s;
  CHECK(notes_on(s.world.get()).empty());
  const double none[3] = {0, 0, 0};
  require_ok(hs_world_set_gravity(s.world.get(), none), s.context.get());  // 0 is usual
  CHECK(notes_on(s.world.get()).empty());
}

TEST_CASE("each setting with an unusual value gets a note that names its owner") {
  UsualWorld s;
  hs_world* const w = s.world.get();
  const double gravity[3] = {0, -9810, 0}, fast[3] = {3000, 4000, 0}, still[3] = {0, 0, 0};
  hs_elasticity_def soft = elasticity_def(50);
  soft.poisson_ratio = -0.25;
  hs_law_def weak = law_def(1e9, 0.01);
  weak.cohesion = 5;
  std::int32_t light = -1;
  require_ok(hs_world_set_gravity(w, gravity), s.context.get());
  require_ok(hs_world_set_damping(w, 0, 1e4), s.context.get());
  require_ok(hs_world_add_material(w, 2.7, &light), s.context.get());
  require_ok(hs_world_set_elasticity(w, 1, &soft), s.context.get());
  require_ok(hs_world_set_law(w, 1, 0, &weak), s.context.get());
  weak.cohesion = 0;
  weak.friction_angle = 0.5;
  weak.normal_stiffness = 1e15;
  require_ok(hs_world_set_default_law(w, &weak), s.context.get());
  require_ok(hs_world_set_velocity(w, s.block, fast, still), s.context.get());
  // The strengths that count are those that were given.
  require_ok(hs_world_set_strength_factor(w, 1e6), s.context.get());

  const std::vector<hs_note> notes = notes_on(w);
  const hs_note expected[] = {
      {HS_SETTING_GRAVITY, -1, -1, 0, 0, 9810, 1, 25},
      {HS_SETTING_MASS_DAMPING, -1, -1, 0, 0, 1e4, 0, 100},
      {HS_SETTING_NORMAL_STIFFNESS, -1, -1, 0, 0, 1e15, 1e3, 1e14},
      {HS_SETTING_YOUNG_MODULUS, 1, -1, 0, 0, 50, 1e6, 2e12},
      {HS_SETTING_POISSON_RATIO, 1, -1, 0, 0, -0.25, 0, 0.495},
      {HS_SETTING_DENSITY, 2, -1, 0, 0, 2.7, 50, 19500},
      {HS_SETTING_FRICTION_ANGLE, 0, 1, 0, 0, 0.01, 0.0349, 1.309},
      {HS_SETTING_COHESION, 0, 1, 0, 0, 5, 100, 1e9},
      {HS_SETTING_VELOCITY, -1, -1, 0, s.block, 5000, 0, 1000},
  };
  REQUIRE(notes.size() == std::size(expected));
  for (std::size_t i = 0; i < notes.size(); ++i) {
    INFO("note " << i);
    CHECK(notes[i].setting == expected[i].setting);
    CHECK(notes[i].material_a == expected[i].material_a);
    CHECK(notes[i].material_b == expected[i].material_b);
    CHECK(notes[i].block == expected[i].block);
    CHECK(notes[i].value == expected[i].value);
    CHECK(notes[i].usual_low == Approx(expected[i].usual_low).epsilon(1e-3));
    CHECK(notes[i].usual_high == Approx(expected[i].usual_high).epsilon(1e-3));
  }
  hs_note first;
  std::int64_t count = 0;
  CHECK(hs_world_check(w, &first, 1, &count) == HS_NOTE_TRUNCATED);
  CHECK(count == std::int64_t(notes.size()));
  CHECK(first.setting == HS_SETTING_GRAVITY);
}

TEST_CASE("stiffness and damping of a law without springs are not looked at") {
  UsualWorld s;
  hs_law_def law = law_def(1, 0.5);
  law.normal_damping = 30;
  law.stiffness_kind = HS_STIFFNESS_NONE;
  require_ok(hs_world_set_default_law(s.world.get(), &law), s.context.get());
  CHECK(notes_on(s.world.get()).empty());
}

TEST_CASE("every setting has a usual range, in numbers and in words") {
  for (std::int32_t setting = HS_SETTING_GRAVITY; setting <= HS_SETTING_VELOCITY; ++setting) {
    INFO("setting " << setting);
    double low = -1, high = -1;
    REQUIRE(hs_setting_get_usual(setting, &low, &high) == HS_OK);
    CHECK(low >= 0);
    CHECK(high > low);
    CHECK(std::string(hs_setting_usual_text(setting)) != "");
  }
  double low = -1, high = -1;
  for (const std::int32_t setting : {-1, HS_SETTING_VELOCITY + 1}) {
    CHECK(hs_setting_get_usual(setting, &low, &high) == HS_ERROR_ARGUMENT);
    CHECK(std::string(hs_setting_usual_text(setting)) == "");
  }
  CHECK(hs_setting_get_usual(HS_SETTING_DENSITY, nullptr, &high) == HS_ERROR_ARGUMENT);
  CHECK(hs_setting_get_usual(HS_SETTING_DENSITY, &low, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(low == -1);
  CHECK(high == -1);
}

TEST_CASE("hs_world_check refuses bad arguments") {
  UsualWorld s;
  hs_note note;
  check_unchanged(s, "hs_world_check",
                  {{"notes", "NULL", [&] { return hs_world_check(s.world.get(), nullptr, 1, nullptr); }},
                   {"capacity", "-1", [&] { return hs_world_check(s.world.get(), &note, -1, nullptr); }}});
  CHECK(hs_world_check(nullptr, &note, 1, nullptr) == HS_ERROR_ARGUMENT);
}

}  // namespace halfspace_test
