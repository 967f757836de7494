// Blocks that sleep: what they may miss of their way, what wakes them, and that nothing else changes.

#include <cstring>

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

constexpr double tolerance = 1e-6;
constexpr std::int32_t kinds[] = {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL};

hs_law_def damped_law(std::int32_t kind) {
  hs_law_def law =
      kind == HS_STIFFNESS_POTENTIAL ? potential_law(1e8, 30 * degree, 1e8) : spring_law(1e8, 30 * degree);
  law.stiffness_kind = kind;
  law.normal_damping = law.shear_damping = 0.3;
  return law;
}

/// Boxes in a wall of so many rows, that fall by a hair; the last one stands far off.
class Wall : public Scene {
 public:
  Wall(double sleep_tolerance, std::int32_t kind, std::int32_t block_kind = HS_BLOCK_RIGID)
      : Scene(definition(sleep_tolerance), damped_law(kind)) {
    if (block_kind == HS_BLOCK_AFFINE) make_elastic();
    add(box(-50, -1, 50, 0), {HS_BLOCK_FIXED, {}, 0});
    for (int row = 0; row < 4; ++row)
      for (int i = 0; i < 6 - row % 2; ++i)
        bricks.push_back(add_at(rectangle(1, 0.5), {i + 0.5 * (row % 2), 0.25 + row * 0.5 + 1e-4}, 0,
                                {block_kind, {}, 0}));
    bricks.push_back(add_at(rectangle(1, 1), {-20, 0.501}, 0, {block_kind, {}, 0}));
  }

  std::vector<hs_block> bricks;

 private:
  static hs_world_def definition(double sleep_tolerance) {
    hs_world_def def = world_def(0);
    def.sleep_tolerance = sleep_tolerance;
    return def;
  }
  void make_elastic() {
    hs_elasticity_def elasticity;
    check(hs_elasticity_def_init(&elasticity, sizeof elasticity));
    elasticity.young_modulus = 1e9;
    elasticity.damping_time = 1e-4;
    check(hs_world_set_elasticity(world(), 0, &elasticity));
  }
};

/// The largest distance of a brick of one wall from that of the other.
double apart(const Wall& one, const Wall& other) {
  double most = 0;
  for (std::size_t i = 0; i < one.bricks.size(); ++i) {
    const Point p = one.position(one.bricks[i]), q = other.position(other.bricks[i]);
    most = std::max(most, std::hypot(p.x - q.x, p.y - q.y));
  }
  return most;
}

/// Steps until so many blocks sleep at once.
void step_to_sleep(Scene& scene, std::int64_t count) {
  for (int i = 0; i < 400 && scene.report().sleeping_count < count; ++i) scene.step(500);
  REQUIRE(scene.report().sleeping_count == count);
}

TEST_CASE("a wall that sleeps stands where one stands that does not") {
  for (const std::int32_t block_kind : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE}) {
    for (const std::int32_t kind : kinds) {
      CAPTURE(block_kind, name_of_stiffness(kind));
      Wall asleep(tolerance, kind, block_kind), awake(0, kind, block_kind);
      int asleep_for = 0;
      for (int i = 0; i < 400 && asleep_for < 10; ++i) {
        asleep.step(500);
        awake.step(500);
        if (asleep.report().sleeping_count == 23) ++asleep_for;
        CHECK(apart(asleep, awake) <= asleep.report().max_sleep_error + 1e-9);
      }
      REQUIRE(asleep_for == 10);
      const hs_world_report report = asleep.report();
      std::printf("wall, %s, %s: %d of 23 asleep, %.1e m missed, %.1e m apart\n", name_of_stiffness(kind),
                  block_kind == HS_BLOCK_AFFINE ? "affine" : "rigid", int(report.sleeping_count),
                  report.max_sleep_error, apart(asleep, awake));
      CHECK(report.max_sleep_error <= tolerance);
      CHECK(awake.report().sleeping_count == 0);
      // A sleeping wall has its contacts, their forces and its energies.
      CHECK(asleep.contacts().size() == awake.contacts().size());
      CHECK(asleep.energy().strain == Approx(awake.energy().strain).epsilon(1e-5));
      CHECK(std::abs(asleep.energy().residual - awake.energy().residual) <
            1e-6 * std::abs(awake.energy().gravity));
      for (std::size_t i = 0; i < asleep.bricks.size(); ++i)
        CHECK(asleep.state(asleep.bricks[i]).force[1] ==
              Approx(awake.state(awake.bricks[i]).force[1]).margin(2 * 1e8 * report.max_sleep_error));
    }
  }
}

TEST_CASE("what is struck wakes in time to take the blow, and its island with it") {
  for (const std::int32_t kind : kinds) {
    CAPTURE(name_of_stiffness(kind));
    Wall asleep(tolerance, kind), awake(0, kind);
    step_to_sleep(asleep, 23);
    awake.step(asleep.report().steps);
    // The edit wakes all; the ball takes long enough to let them sleep again.
    hs_block balls[2];
    int which = 0;
    constexpr double mass = 2000 * 0.4 * 0.4, blow = 0.5 * mass * (6 * 6 + 9.3 * 9.3);
    for (Wall* wall : {&asleep, &awake})
      balls[which++] = wall->add_at(rectangle(0.4, 0.4), {-12, 1.05}, 0, {HS_BLOCK_RIGID, {6, 9.3}, 0});
    std::int64_t most = 0;
    double farthest = -12;
    const std::int64_t steps = std::int64_t(4 / asleep.report().time_step / 100);
    for (int i = 0; i < 100; ++i) {
      for (Wall* wall : {&asleep, &awake}) wall->step(steps);
      farthest = std::max(farthest, asleep.position(balls[0]).x);
      if (farthest < -2) most = std::max(most, asleep.report().sleeping_count);
    }
    CHECK(most == 23);
    CHECK(farthest > -1.5);
    // A blow amplifies what was different before, here by the micrometre.
    CHECK(apart(asleep, awake) < 1e-3);
    std::printf("struck wall, %s: %.1e m apart, residual %.2f J, awake %.2f J\n", name_of_stiffness(kind),
                apart(asleep, awake), asleep.energy().residual, awake.energy().residual);
    CHECK(asleep.energy().residual == Approx(awake.energy().residual).margin(1e-5 * blow));
  }
}

TEST_CASE("an island that is not touched sleeps on") {
  Wall wall(tolerance, HS_STIFFNESS_PER_CONTACT);
  step_to_sleep(wall, 23);
  const double push = 2000;
  wall.apply(wall.bricks.back(), {push, 0});
  CHECK(wall.report().sleeping_count == 22);
  step_to_sleep(wall, 23);
  wall.apply(wall.bricks.back(), {push, 0});  // the same force as before is no change
  CHECK(wall.report().sleeping_count == 23);
  wall.set_velocity(wall.bricks.back(), {0, 0});
  CHECK(wall.report().sleeping_count == 0);
}

TEST_CASE("a block that creeps misses no more than the tolerance, however long it is let sleep") {
  for (const double speed : {1e-3, 1e-6, 1e-9, 1e-15}) {
    CAPTURE(speed);
    hs_world_def def = world_def(1e-3, 0);
    def.sleep_tolerance = tolerance;
    Scene scene(def, spring_law(1e6));
    const hs_block block = scene.add(rectangle(1, 1), {HS_BLOCK_RIGID, {speed, 0}, 0});
    scene.step(100000);
    const hs_world_report report = scene.report();
    const double missed = speed * report.time - scene.position(block).x;
    CHECK(missed <= report.max_sleep_error * (1 + 1e-9) + 1e-15);
    CHECK(report.max_sleep_error <= tolerance);
    // Half the tolerance is spent in a sleep that is worth its while, if it can be.
    CHECK((report.max_sleep_error > 0) == (speed * 256 * def.time_step <= tolerance / 2));
    CHECK(scene.velocity(block).x == speed);
  }
}

TEST_CASE("a block at the top of its flight does not fall asleep") {
  hs_world_def def = world_def(1e-5);
  def.sleep_tolerance = tolerance;
  Scene scene(def, spring_law(1e6));
  // It is at its highest when a look is taken.
  const double time = 64 * 10 * def.time_step;
  const hs_block block = scene.add(rectangle(1, 1), {HS_BLOCK_RIGID, {0, 9.81 * time}, 0});
  scene.step(640);
  CHECK(std::abs(scene.velocity(block).y) < 1e-12);
  scene.step(1000);
  CHECK(scene.report().max_sleep_error == 0);
}

TEST_CASE("a sleeping world goes on from its snapshot to the bit") {
  for (const std::int32_t kind : kinds) {
    Wall wall(tolerance, kind);
    step_to_sleep(wall, 23);
    wall.step(17);
    REQUIRE(wall.report().sleeping_count > 0);
    std::size_t size = 0;
    CHECK(hs_world_save(wall.world(), nullptr, 0, &size) == HS_NOTE_TRUNCATED);
    std::vector<unsigned char> saved(size);
    wall.check(hs_world_save(wall.world(), saved.data(), size, &size));
    hs_world* made = nullptr;
    wall.check(hs_world_restore(wall.context(), saved.data(), size, &made));
    const World copy(made);
    for (hs_world* world : {wall.world(), made}) {
      const double force[3] = {0, 1e5, 0}, none[3] = {};
      wall.check(hs_world_step(world, 500));
      wall.check(hs_world_set_applied_force(world, wall.bricks[3], force, none));
      wall.check(hs_world_step(world, 500));
    }
    for (const hs_block block : wall.bricks) {
      hs_block_state one, other;
      wall.check(hs_world_get_block_state(wall.world(), block, &one));
      wall.check(hs_world_get_block_state(made, block, &other));
      CHECK(std::memcmp(&one, &other, sizeof one) == 0);
    }
  }
}

TEST_CASE("cubes in space sleep on each other, and one that is drawn away wakes those that it bore") {
  for (const std::int32_t kind : kinds) {
    CAPTURE(name_of_stiffness(kind));
    hs_world_def def = solid_world_def(0);
    def.sleep_tolerance = tolerance;
    SolidScene scene(def, damped_law(kind));
    scene.add_hull(cuboid({20, 20, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
    std::vector<hs_block> cubes;
    for (int i = 0; i < 3; ++i) cubes.push_back(scene.add_hull(cuboid({1, 1, 1}), {{0, 0, 0.5 + i}}));
    const hs_block apart = scene.add_hull(cuboid({1, 1, 1}), {{5, 0, 0.5}});
    step_to_sleep(scene, 4);
    const double height = scene.place_of(cubes[2])[2];
    scene.apply(cubes[0], {0, 1e6});
    CHECK(scene.report().sleeping_count == 1);
    scene.step(20000);
    CHECK(scene.place_of(cubes[2])[2] < height - 0.5);
    CHECK(std::abs(scene.place_of(apart)[0] - 5) < 1e-6);
  }
}

TEST_CASE("bonded blocks sleep together") {
  hs_world_def def = world_def(0);
  def.sleep_tolerance = tolerance;
  def.local_damping = 0.5;
  Scene scene(def, damped_law(HS_STIFFNESS_PER_CONTACT));
  scene.add(box(-1, -1, 0, 3), {HS_BLOCK_FIXED, {}, 0});
  std::vector<hs_block> bar;
  for (int i = 0; i < 4; ++i) bar.push_back(scene.add(box(i, 1, i + 1, 2)));
  hs_bond_def bond;
  hs_bond_def_init(&bond, sizeof bond);
  bond.normal_stiffness = bond.shear_stiffness = 1e10;
  bond.tensile_strength = bond.cohesion = 1e9;
  std::int64_t count = 0;
  scene.check(hs_world_bond_materials(scene.world(), 0, 0, &bond, &count));
  REQUIRE(count == 4);
  step_to_sleep(scene, 4);
  scene.apply(bar[3], {0, -1e3});
  CHECK(scene.report().sleeping_count == 0);
}

}  // namespace
