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
SpringLaw law_that_stops(StiffnessKind kind, double mass, double speed, double depth) {
  SpringLaw law;
  law.stiffness_kind = kind;
  law.normal_stiffness = mass * speed * speed / (depth * depth);
  law.shear_stiffness = law.normal_damping = law.shear_damping = 0;
  return law;
}

template <int D>
struct Scene {
  World<D> world;

  explicit Scene(const SpringLaw& law, const WorldSettings<D>& made = settings()) : world(made, memory) {
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
    for (; scene.speed(bar) > 0 || scene.world.contact_count() > 0; ++steps) {
      REQUIRE(scene.world.step() == StepResult::ok);
      REQUIRE(scene.place(bar) < 0);
      REQUIRE(steps < 1000);
    }
    CHECK(scene.world.time() == steps * time_step);
    CHECK(std::abs(scene.speed(bar) + speed) <= 0.02 * speed);
    CHECK(std::abs(scene.world.ledger().residual()) <= 0.02 * 0.5 * mass * speed * speed);
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
      for (; scene.speed(left) > scene.speed(right) || scene.world.contact_count() > 0; ++steps) {
        REQUIRE(scene.world.step() == StepResult::ok);
        REQUIRE(scene.place(left) < scene.place(right));
        REQUIRE(steps < 1000);
      }
      // Bars of one mass change their velocities.
      CHECK(std::abs(scene.speed(left) + 3 * speed / 4) <= 0.02 * speed);
      CHECK(std::abs(scene.speed(left) + scene.speed(right) + speed / 2) <= 1e-12 * speed);
      CHECK(std::abs(scene.world.ledger().residual()) <= 0.02 * mass * speed * speed);
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
      for (; scene.speed(bar) < speed || scene.world.contact_count() > 0; ++steps) {
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
StepResult result_of_bounce(const SpringLaw& law, double speed, const WorldSettings<D>& settings,
                            FastPair& fast) {
  Scene<D> scene(law, settings);
  scene.add(plate<D>(thickness), BlockKind::fixed, 0);
  const std::int32_t bar = scene.add(plate<D>(thickness), BlockKind::rigid, -10 * thickness, speed);
  StepResult result = StepResult::ok;
  while (result == StepResult::ok && scene.speed(bar) > 0) result = scene.world.step();
  fast = scene.world.fast_pair();
  CHECK(scene.world.divided_steps() == 0);
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
      const SpringLaw law = law_that_stops<D>(kind, density * thickness, speed, 0.1 * thickness);
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
  const SpringLaw soft = law_that_stops<D>(StiffnessKind::per_contact, density * thin, 1, 1);
  Scene<D> scene(soft);
  scene.add(plate<D>(thin), BlockKind::fixed, 0);
  const std::int32_t sliding = scene.add(plate<D>(thin), BlockKind::rigid, 0.99 * thin);
  scene.world.set_velocity(sliding, speed * Vector<D>::UnitY(), Angular<D>::Zero());
  for (int calls = 1; calls <= 2; ++calls) {
    REQUIRE(scene.world.step() == StepResult::too_fast);
    const double way = scene.world.blocks().position[std::size_t(sliding)].y();
    CHECK(way == Approx(calls * most_motions * 0.5 * 0.25 * thin));
    CHECK(scene.world.steps() == 0);
    CHECK(scene.world.fast_pair().speed == Approx(speed));
    CHECK(scene.world.fast_pair().time_step == Approx(0.25 * thin / speed));
  }
}
