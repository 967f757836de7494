#include <cmath>

#include "catch.h"
#include "contacts_3d.h"
#include "polygons.h"
#include "world/world.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();
constexpr double density = 2000;
constexpr double thickness = 0.01;
constexpr double time_step = 1e-4;
constexpr double safety = 0.5;

/// A square of side 1 and this thick along x.
template <int D>
Shape<D> plate(double thick) {
  if constexpr (D == 2) {
    return shape_of(rectangle(thick, 1));
  } else {
    return shape_of(completed(box({thick, 1, 1})));
  }
}

template <int D>
Vector<D> along_x(double length) {
  return length * Vector<D>::UnitX();
}

/// Springs that stop a mass of such a speed, over a face of area 1, within this depth.
template <int D>
ContactLaw law_that_stops(StiffnessKind kind, double mass, double speed, double depth) {
  ContactLaw law;
  law.stiffness_kind = kind;
  law.normal_stiffness = mass * speed * speed / (depth * depth);
  law.shear_stiffness = law.normal_damping = law.shear_damping = 0;
  return law;
}

template <int D>
struct Scene {
  World<D> world;

  explicit Scene(const ContactLaw& law, const WorldSettings<D>& made = settings()) : world(made, memory) {
    world.add_material(density);
    Elasticity elasticity;
    elasticity.lame = elasticity.shear_modulus = law.normal_stiffness;
    world.set_elasticity(0, elasticity);
    world.set_default_law(law);
  }
  static WorldSettings<D> settings() {
    WorldSettings<D> settings;
    settings.time_step = time_step;
    settings.safety = safety;
    settings.potential_length = 1;
    return settings;
  }
  std::int32_t add(const Shape<D>& shape, BlockKind kind, double x, double speed = 0) {
    const std::int32_t slot = world.add_block(shape, kind, 0, along_x<D>(x), {});
    if (kind != BlockKind::fixed) world.set_velocity(slot, along_x<D>(speed), Angular<D>::Zero());
    return slot;
  }
  double speed(std::int32_t slot) const { return world.blocks().velocity[std::size_t(slot)].x(); }
  double place(std::int32_t slot) const { return world.blocks().position[std::size_t(slot)].x(); }
};

constexpr double speeds[] = {0.1, 1, 7.3, 100, 1e4};  // in thicknesses a step

const char* name_of(StiffnessKind kind) {
  return kind == StiffnessKind::per_contact ? "per contact"
         : kind == StiffnessKind::per_area  ? "per area"
                                            : "potential";
}

template <int D>
void check_return(StiffnessKind kind, BlockKind of_bar) {
  for (const double speed_in_steps : speeds) {
    const double speed = speed_in_steps * thickness / time_step;
    const double mass = density * thickness;
    Scene<D> scene(law_that_stops<D>(kind, mass, speed, 0.1 * thickness));
    scene.add(plate<D>(thickness), BlockKind::fixed, 0);
    const double start = -thickness * (1.3 + 2.6 * speed_in_steps);
    const std::int32_t bar = scene.add(plate<D>(thickness), of_bar, start, speed);
    INFO(D << "D, " << name_of(kind) << ", " << speed_in_steps << " thicknesses a step");
    int steps = 0;
    for (; scene.speed(bar) > 0 || scene.world.state().contacts.count() > 0; ++steps) {
      REQUIRE(scene.world.step() == StepResult::ok);
      REQUIRE(scene.place(bar) < 0);
      REQUIRE(steps < 1000);
    }
    CHECK(scene.world.state().clock.time() == steps * time_step);
    CHECK(std::abs(scene.speed(bar) + speed) <= 0.02 * speed);
    CHECK(std::abs(scene.world.state().ledger.entries().residual()) <= 0.02 * 0.5 * mass * speed * speed);
  }
}

}  // namespace

/// Verlet's method ends a bounce with a share of the energy changed that is at most (w dt)^2 / 4 where the
/// springs begin and as much where they end; safety times the stable step makes that 2 safety^2 / 32 for bars
/// that do not turn, of which the stable step counts four contacts and the turning. The rest is for springs
/// that grow.
TEMPLATE_TEST_CASE_SIG("however fast a bar is, it meets a plate as thin and returns with its speed", "",
                       ((int D), D), 2, 3) {
  for (const StiffnessKind kind :
       {StiffnessKind::per_contact, StiffnessKind::per_area, StiffnessKind::potential}) {
    check_return<D>(kind, BlockKind::rigid);
  }
}

TEMPLATE_TEST_CASE_SIG("blocks that fly at each other fast keep momentum and energy, and each returns", "",
                       ((int D), D), 2, 3) {
  for (const StiffnessKind kind :
       {StiffnessKind::per_contact, StiffnessKind::per_area, StiffnessKind::potential}) {
    for (const double speed_in_steps : speeds) {
      const double speed = speed_in_steps * thickness / time_step, mass = density * thickness;
      Scene<D> scene(law_that_stops<D>(kind, 0.5 * mass, speed, 0.1 * thickness));
      const double start = thickness * (0.7 + 1.3 * speed_in_steps);
      const std::int32_t left = scene.add(plate<D>(thickness), BlockKind::rigid, -start, speed / 4);
      const std::int32_t right = scene.add(plate<D>(thickness), BlockKind::rigid, start, -3 * speed / 4);
      INFO(D << "D, " << name_of(kind) << ", " << speed_in_steps << " thicknesses a step");
      int steps = 0;
      for (; scene.speed(left) > scene.speed(right) || scene.world.state().contacts.count() > 0; ++steps) {
        REQUIRE(scene.world.step() == StepResult::ok);
        REQUIRE(scene.place(left) < scene.place(right));
        REQUIRE(steps < 1000);
      }
      // Bars of one mass change their velocities.
      CHECK(std::abs(scene.speed(left) + 3 * speed / 4) <= 0.02 * speed);
      CHECK(std::abs(scene.speed(left) + scene.speed(right) + speed / 2) <= 1e-12 * speed);
      CHECK(std::abs(scene.world.state().ledger.entries().residual()) <= 0.02 * mass * speed * speed);
    }
  }
}

TEMPLATE_TEST_CASE_SIG("a plate that is driven through a bar at rest takes it along at twice its speed", "",
                       ((int D), D), 2, 3) {
  for (const StiffnessKind kind :
       {StiffnessKind::per_contact, StiffnessKind::per_area, StiffnessKind::potential}) {
    for (const double speed_in_steps : speeds) {
      const double speed = speed_in_steps * thickness / time_step, mass = density * thickness;
      Scene<D> scene(law_that_stops<D>(kind, mass, speed, 0.1 * thickness));
      const std::int32_t plate_slot = scene.add(plate<D>(thickness), BlockKind::prescribed,
                                                -thickness * (1.3 + 2.6 * speed_in_steps), speed);
      const std::int32_t bar = scene.add(plate<D>(thickness), BlockKind::rigid, 0);
      INFO(D << "D, " << name_of(kind) << ", " << speed_in_steps << " thicknesses a step");
      int steps = 0;
      for (; scene.speed(bar) < speed || scene.world.state().contacts.count() > 0; ++steps) {
        REQUIRE(scene.world.step() == StepResult::ok);
        REQUIRE(scene.place(plate_slot) < scene.place(bar));
        REQUIRE(steps < 1000);
      }
      CHECK(std::abs(scene.speed(bar) - 2 * speed) <= 0.02 * speed);
    }
  }
}

/// Runs until the bar is refused, or has been sent back.
template <int D>
StepResult result_of_bounce(const ContactLaw& law, double speed, const WorldSettings<D>& settings,
                            FastPair& fast) {
  Scene<D> scene(law, settings);
  scene.add(plate<D>(thickness), BlockKind::fixed, 0);
  const std::int32_t bar = scene.add(plate<D>(thickness), BlockKind::rigid, -10 * thickness, speed);
  StepResult result = StepResult::ok;
  while (result == StepResult::ok && scene.speed(bar) > 0) result = scene.world.step();
  fast = scene.world.state().continuous_collision.pair();
  CHECK(scene.world.state().clock.divided_steps() == 0);
  CHECK(scene.place(bar) < -0.5 * thickness);  // the middles never pass
  return result;
}

TEMPLATE_TEST_CASE_SIG("a world that shall not divide its steps tells the pair and the step that would do",
                       "", ((int D), D), 2, 3) {
  for (const StiffnessKind kind :
       {StiffnessKind::per_contact, StiffnessKind::per_area, StiffnessKind::potential}) {
    for (const double speed_in_steps : {0.3, 7.3, 100.0}) {
      INFO(D << "D, " << name_of(kind) << ", " << speed_in_steps << " thicknesses a step");
      const double speed = speed_in_steps * thickness / time_step;
      const ContactLaw law = law_that_stops<D>(kind, density * thickness, speed, 0.1 * thickness);
      WorldSettings<D> settings = Scene<D>::settings();
      settings.fast_blocks = FastBlocks::refuse;
      FastPair fast;
      REQUIRE(result_of_bounce<D>(law, speed, settings, fast) == StepResult::too_fast);
      CHECK(fast.a == 0);
      CHECK(fast.b == 1);
      CHECK(fast.speed == Approx(speed));
      CHECK(fast.thickness == Approx(thickness));
      CHECK(fast.time_step == Approx(0.25 * time_step / speed_in_steps));
      settings.time_step = 0.999 * fast.time_step;
      CHECK(result_of_bounce<D>(law, speed, settings, fast) == StepResult::ok);
      settings.time_step = 0;  // one that is derived minds speeds where it must not be divided
      CHECK(result_of_bounce<D>(law, speed, settings, fast) == StepResult::ok);
    }
  }
}

/// Thin as they are, plates that slide on each other for all of a step would divide it into 4e5 motions.
TEMPLATE_TEST_CASE_SIG("a step that would be divided without end is refused where it has come to", "",
                       ((int D), D), 2, 3) {
  constexpr double thin = 1e-5, speed = 5e3;
  const ContactLaw soft = law_that_stops<D>(StiffnessKind::per_contact, density * thin, 1, 1);
  Scene<D> scene(soft);
  scene.add(plate<D>(thin), BlockKind::fixed, 0);
  const std::int32_t sliding = scene.add(plate<D>(thin), BlockKind::rigid, 0.99 * thin);
  scene.world.set_velocity(sliding, speed * Vector<D>::UnitY(), Angular<D>::Zero());
  for (int calls = 1; calls <= 2; ++calls) {
    REQUIRE(scene.world.step() == StepResult::too_fast);
    const double way = scene.world.blocks().position[std::size_t(sliding)].y();
    CHECK(way == Approx(calls * max_motions * 0.5 * 0.25 * thin));
    CHECK(scene.world.state().clock.steps() == 0);
    CHECK(scene.world.state().continuous_collision.pair().speed == Approx(speed));
    CHECK(scene.world.state().continuous_collision.pair().time_step == Approx(0.25 * thin / speed));
  }
}

namespace {

/// A bar above a wide plate. It falls at 100 m/s, or spins.
struct Throw {
  double x, speed_along, spin, length;
};

/// How deep springs are told to let a bar come that is thrown so.
double told_stop(const Throw& thrown, double step) {
  ContactLaw law = law_that_stops<2>(StiffnessKind::per_contact, density * thickness, 100, 5 * thickness);
  WorldSettings<2> settings = Scene<2>::settings();
  settings.time_step = step;
  Scene<2> scene(law, settings);
  scene.world.add_block(shape_of(rectangle(10, thickness)), BlockKind::fixed, 0, {0, 0}, {});
  const std::int32_t bar = scene.world.add_block(shape_of(rectangle(thrown.length, thickness)),
                                                 BlockKind::rigid, 0, {thrown.x, 0.4}, {});
  Angular<2> spin;
  spin[0] = thrown.spin;
  const double fall = spin[0] != 0 ? 0 : -100;
  scene.world.set_velocity(bar, {thrown.speed_along, fall}, spin);
  while (scene.world.state().clock.time() < 0.03) REQUIRE(scene.world.step() == StepResult::ok);
  return scene.world.state().penetration_bound.deepest();
}

}  // namespace

TEST_CASE("springs too soft for a speed are told however the blocks meet: off the middles, or by a tip") {
  for (const double step : {2e-5, 1e-4, 1e-3}) {
    INFO("time step " << step);
    CHECK(told_stop({0, 0, 0, 1}, step) == Approx(5).epsilon(0.01));
    CHECK(told_stop({-4, -30, 0, 1}, step) == Approx(5).epsilon(0.01));
    CHECK(told_stop({0, 0, 200, 1}, step) > 1);  // the tip comes at 100 m/s
    const double of_small = told_stop({0, 0, 0, 1e-2}, step);
    CHECK(of_small >= 0.5 * (1 - 1e-9));
    CHECK(of_small <= std::hypot(0.5, 0.25));  // by as much it may have entered when it is found
  }
}

TEST_CASE("a bar that flies along a plate is not told to be stopped by it") {
  const ContactLaw law =
      law_that_stops<2>(StiffnessKind::per_contact, density * thickness, 100, 5 * thickness);
  Scene<2> scene(law);
  scene.world.add_block(shape_of(rectangle(10, thickness)), BlockKind::fixed, 0, {0, 0}, {});
  const std::int32_t bar = scene.world.add_block(shape_of(rectangle(1, thickness)), BlockKind::rigid, 0,
                                                 {-2, 1.5 * thickness}, {});
  scene.world.set_velocity(bar, {100, 0}, Angular<2>::Zero());
  for (int i = 0; i < 100; ++i) {
    REQUIRE(scene.world.step() == StepResult::ok);
    CHECK(scene.world.state().penetration_bound.deepest() <= 1e-9);
  }
}

TEST_CASE("what lies deep at rest is told as deep") {
  const double depth = 0.3 * thickness, gravity = 10;
  WorldSettings<2> settings = Scene<2>::settings();
  settings.gravity = {-gravity, 0};
  ContactLaw law = law_that_stops<2>(StiffnessKind::per_contact, 1, 1, 1);
  law.normal_stiffness = density * thickness * gravity / depth;
  Scene<2> scene(law, settings);
  scene.add(plate<2>(thickness), BlockKind::fixed, 0);
  scene.add(plate<2>(thickness), BlockKind::rigid, thickness - depth);
  REQUIRE(scene.world.step() == StepResult::ok);
  CHECK(scene.world.state().penetration_bound.deepest() == Approx(0.3).epsilon(1e-3));
}

namespace {

/// Through which side a square, thrown past the corner of a block so that it clears one side last, meets it:
/// the normal at the first contact.
template <int D>
Vector<D> first_normal(const Vector<2>& start, const Vector<2>& velocity, double step) {
  const auto cube = [] {
    if constexpr (D == 2) {
      return shape_of(rectangle(1, 1));
    } else {
      return shape_of(completed(box({1, 1, 1})));
    }
  };
  WorldSettings<D> settings = Scene<D>::settings();
  settings.time_step = step;
  Scene<D> scene(law_that_stops<D>(StiffnessKind::per_contact, density, 1, 0.1), settings);
  const auto placed = [](const Vector<2>& v) {
    Vector<D> wide = Vector<D>::Zero();
    wide.template head<2>() = v;
    return wide;
  };
  scene.world.add_block(cube(), BlockKind::fixed, 0, Vector<D>::Zero(), {});
  const std::int32_t thrown = scene.world.add_block(cube(), BlockKind::rigid, 0, placed(start), {});
  scene.world.set_velocity(thrown, placed(velocity), Angular<D>::Zero());
  for (int i = 0; i < 100000 && scene.world.state().contacts.count() == 0; ++i) {
    REQUIRE(scene.world.step() == StepResult::ok);
  }
  REQUIRE(scene.world.state().contacts.count() == 1);
  return scene.world.state().contacts.contact(0).normal;
}

}  // namespace

/// Both sides keep the blocks apart when the last coarse step begins, and neither at its end. The one to
/// close last is the entrance, though it may be the deeper one by then.
TEMPLATE_TEST_CASE_SIG("a block meets another through the side that closes last, whatever the step", "",
                       ((int D), D), 2, 3) {
  const double step = 0.1;  // in which a block moves by less than a quarter of its width
  for (const Vector<2>& closing :
       {Vector<2>(0.6, 0.3), Vector<2>(0.3, 0.6), Vector<2>(0.6, 0.5), Vector<2>(0.4, 0.6)}) {
    for (const Vector<2>& towards :
         {Vector<2>(1, 1), Vector<2>(-1, 1), Vector<2>(1, -1), Vector<2>(-1, -1)}) {
      // Both sides close at these shares of the third step, by 0.15 in it across x and by 0.03 across y.
      const Vector<2> motion(0.15, 0.03);
      const Vector<2> way = motion.cwiseProduct(closing + Vector<2>(2, 2));
      const Vector<2> start = -towards.cwiseProduct(Vector<2>(1, 1) + way);
      const Vector<2> velocity = towards.cwiseProduct(motion) / step;
      INFO(D << "D, closing at " << closing.x() << ", " << closing.y() << ", towards " << towards.x() << ", "
             << towards.y());
      const Vector<D> coarse = first_normal<D>(start, velocity, step);
      CHECK(coarse.isApprox(first_normal<D>(start, velocity, 1e-3 * step)));
      CHECK(std::abs(coarse[closing.x() > closing.y() ? 0 : 1]) == 1);
    }
  }
}
