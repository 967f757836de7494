#include <cmath>
#include <memory>

#include "bare_law.h"
#include "catch.h"
#include "contacts_3d.h"
#include "rotations.h"
#include "world/world.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();
const Vector<3> gravity(0, 0, -10);
const Vector<3> nothing(0, 0, 0);

ContactLaw law(double stiffness, double tan_friction = 0) {
  ContactLaw law = test::bare_law();
  law.normal_stiffness = law.shear_stiffness = stiffness;
  law.tan_friction = tan_friction;
  return law;
}

WorldSettings<3> settings(double time_step, const Vector<3>& weight) {
  WorldSettings<3> settings;
  settings.time_step = time_step;
  settings.gravity = weight;
  return settings;
}

/// Blocks of one material, 1000 kg / m^3.
struct Scene {
  World<3> world;

  Scene(const WorldSettings<3>& how, const ContactLaw& spring) : world(how, memory) {
    world.add_material(1000);
    world.set_default_law(spring);
  }
  std::int32_t add(const Shape<3>& shape, BlockKind kind, const Vector<3>& position,
                   const Rotation<3>& rotation = {}) {
    return world.add_block(shape, kind, 0, position, rotation);
  }
  void step(int steps) {
    for (int i = 0; i < steps; ++i) REQUIRE(world.step() == StepResult::ok);
  }
  const Vector<3>& position(std::int32_t slot) const { return world.blocks().position[std::size_t(slot)]; }
  const Vector<3>& velocity(std::int32_t slot) const { return world.blocks().velocity[std::size_t(slot)]; }
  const Vector<3>& spin(std::int32_t slot) const { return world.blocks().spin[std::size_t(slot)]; }
  const Rotation<3>& rotation(std::int32_t slot) const { return world.blocks().rotation[std::size_t(slot)]; }
  Vector<3> momentum() const {
    Vector<3> sum = nothing;
    for (std::size_t i = 0; i < world.blocks().slot_count(); ++i)
      sum += world.blocks().mass[i] * world.blocks().velocity[i];
    return sum;
  }
  Vector<3> angular_momentum() const {
    Vector<3> sum = nothing;
    for (std::size_t i = 0; i < world.blocks().slot_count(); ++i)
      sum += world.blocks().momentum[i] +
             cross_product(world.blocks().position[i], world.blocks().mass[i] * world.blocks().velocity[i]);
    return sum;
  }
};

Shape<3> cube() { return shape_of(completed(box({1, 1, 1}))); }

}  // namespace

TEST_CASE("in space, free fall and a throw are parabolas, to rounding") {
  // Velocity Verlet is exact under a constant force; n steps round as often, each by half an ulp of the way.
  Random random(91);
  const double step = 0x1p-10;
  const int steps = 2048;
  Scene scene(settings(step, gravity), law(1e6));
  const std::int32_t falls = scene.add(cube(), BlockKind::rigid, {0, 0, 50});
  const std::int32_t thrown =
      scene.add(random_block(random, 12), BlockKind::rigid, {100, 0, 0}, random_turn(random));
  const Vector<3> velocity(3, -4, 12), spin(1, 2, 3);
  scene.world.set_velocity(thrown, velocity, spin);
  REQUIRE(scene.world.prepare() == StepResult::ok);
  const Vector<3> turning = scene.world.blocks().momentum[std::size_t(thrown)];
  const double energy = scene.world.state().ledger.entries().total();
  scene.step(steps);
  const double t = scene.world.state().clock.time();
  CHECK(t == 2);
  CHECK((scene.position(falls) - (Vector<3>(0, 0, 50) + 0.5 * t * t * gravity)).norm() <
        steps * 50 * 0x1p-53);
  CHECK((scene.velocity(falls) - t * gravity).norm() < steps * 20 * 0x1p-53);
  const Vector<3> expected = Vector<3>(100, 0, 0) + t * velocity + 0.5 * t * t * gravity;
  CHECK((scene.position(thrown) - expected).norm() < steps * 100 * 0x1p-52);
  // Nothing turns what is thrown: it keeps its angular momentum, to the bit, and its energy of turning to the
  // square of the spin times the step.
  CHECK(scene.world.blocks().momentum[std::size_t(thrown)] == turning);
  const double share = std::pow(spin.norm() * step, 2) / 24;
  CHECK(scene.world.state().ledger.entries().total() == Approx(energy).epsilon(share));
}

TEST_CASE("in space, ten cubes in a stack come to rest and stay: each under the weight above it") {
  const double stiffness = 1e8, weight = 1000 * 10;
  WorldSettings<3> how = settings(0, gravity);
  how.local_damping = 0.7;
  Scene scene(how, law(stiffness, 0.5));
  const Shape<3> block = cube();
  const std::int32_t ground = scene.add(shape_of(completed(box({4, 4, 1}))), BlockKind::fixed, {0, 0, -0.5});
  constexpr int count = 10;
  std::int32_t slots[count];
  for (int i = 0; i < count; ++i) {
    // Each a little askew on the other, in place and turn, so that nothing is level by symmetry.
    const Rotation<3> turn = Rotation<3>().turned_by(0.1 * (i % 3) * z_axis);
    slots[i] = scene.add(block, BlockKind::rigid, {0.03 * (i % 2), -0.02 * (i % 3), 0.5 + i}, turn);
  }
  const auto run_until = [&](double time) {
    while (scene.world.state().clock.time() < time) REQUIRE(scene.world.step() == StepResult::ok);
  };
  run_until(9);
  Vector<3> settled[count];
  for (int i = 0; i < count; ++i) settled[i] = scene.position(slots[i]);
  run_until(11);
  // It gives way by 5e-3 under its weight. Of the sway that goes with it, which falls tenfold in a second,
  // there is less left after 9 s than would be of creep by a hundred-thousandth of that in 2 s.
  double compressed = 0;
  for (int i = 0; i < count; ++i) {
    INFO("cube " << i);
    compressed += (count - i) * weight / stiffness;
    CHECK((scene.position(slots[i]) - settled[i]).norm() < 1e-7);
    CHECK(scene.velocity(slots[i]).norm() < 1e-7);
    CHECK(scene.spin(slots[i]).norm() < 1e-7);
    // Where the centroid of what lies above is off the middle of the face, springs give way unevenly: by the
    // slope of a few centimetres of lever, a few times the compression at 0.5.
    CHECK(scene.position(slots[i]).z() == Approx(0.5 + i - compressed).margin(0.05 * compressed));
  }
  REQUIRE(scene.world.state().contacts.count() == count);
  for (std::size_t c = 0; c < scene.world.state().contacts.count(); ++c) {
    const std::int32_t upper = scene.world.state().contacts.pair_of(c).b;
    CHECK(scene.world.state().forces.of_contact(c).force.z() ==
          Approx((count - (upper - slots[0])) * weight).epsilon(1e-6));
  }
  CHECK(scene.position(ground) == Vector<3>(0, 0, -0.5));
}

TEST_CASE("in space, two blocks that collide keep momentum, and a boost changes nothing") {
  Random random(92);
  const Shape<3> a = random_block(random, 10), b = random_block(random, 14);
  const auto collided = [&](const Vector<3>& boost, const Vector<3>& place, StiffnessKind kind) {
    ContactLaw spring = law(1e7, 0.3);
    spring.stiffness_kind = kind;
    auto made = std::make_unique<Scene>(settings(1e-4, nothing), spring);
    Scene& scene = *made;
    const std::int32_t at_rest = scene.add(a, BlockKind::rigid, place);
    const std::int32_t striker = scene.add(b, BlockKind::rigid, place + Vector<3>(-2.1, 0.2, 0.1));
    scene.world.set_velocity(at_rest, boost, nothing);
    scene.world.set_velocity(striker, boost + Vector<3>(5, 0, 0), {0.5, 0, 1});
    REQUIRE(scene.world.prepare() == StepResult::ok);
    const Vector<3> momentum = scene.momentum(), turning = scene.angular_momentum();
    double most_strain = 0;
    for (int i = 0; i < 3000; ++i) {
      REQUIRE(scene.world.step() == StepResult::ok);
      most_strain = std::max(most_strain, scene.world.state().ledger.entries().strain);
    }
    CHECK(most_strain > 100);
    CHECK((scene.momentum() - momentum).norm() < 1e-11 * momentum.norm());
    CHECK((scene.angular_momentum() - turning).norm() < 1e-11 * (turning.norm() + momentum.norm()));
    return made;
  };
  for (const StiffnessKind kind : {StiffnessKind::per_contact, StiffnessKind::per_area}) {
    const auto still = collided(nothing, nothing, kind);
    const Vector<3> boost(-17, 4, 9), place(1, 2, 3);
    const auto moving = collided(boost, place, kind);
    for (const std::int32_t slot : {0, 1}) {
      const Vector<3> expected = still->position(slot) + place + still->world.state().clock.time() * boost;
      // Both round alike but for the ulp of the places, which the collision makes some times more.
      CHECK((moving->position(slot) - expected).norm() < 1e-10);
      CHECK((moving->velocity(slot) - boost - still->velocity(slot)).norm() < 1e-10);
      CHECK((moving->spin(slot) - still->spin(slot)).norm() < 1e-10);
      CHECK(moving->rotation(slot).farthest_from(still->rotation(slot)) < 1e-10);
    }
  }
}

TEST_CASE("in space, a tip that strikes a face off its middle keeps all energy: two go away and turn") {
  const double stiffness = 1e7, step = 1e-4;
  for (const StiffnessKind kind : {StiffnessKind::per_contact, StiffnessKind::per_area}) {
    ContactLaw spring = law(stiffness);
    spring.stiffness_kind = kind;
    Scene scene(settings(step, nothing), spring);
    const std::int32_t struck = scene.add(cube(), BlockKind::rigid, nothing);
    const std::int32_t tip = scene.add(block_of(octahedron(0.5, 0.5, 0.7)), BlockKind::rigid,
                                       {0.2, 0.1, 1.25}, Rotation<3>().turned_by({0.1, 0.05, 0}));
    scene.world.set_velocity(tip, {0, 0, -1}, nothing);
    REQUIRE(scene.world.prepare() == StepResult::ok);
    const double energy = scene.world.state().ledger.entries().total();
    double most_strain = 0;
    for (int i = 0; i < 4000; ++i) {
      REQUIRE(scene.world.step() == StepResult::ok);
      most_strain = std::max(most_strain, scene.world.state().ledger.entries().strain);
    }
    CHECK(most_strain > 0.1 * energy);
    CHECK(scene.world.state().ledger.entries().strain == 0);
    // Velocity Verlet keeps an energy that is off by (omega dt)^2 / 4; omega^2 is at most K over the mass of
    // the lighter, 230 kg, times what turning adds, below 5.
    CHECK(scene.world.state().ledger.entries().total() ==
          Approx(energy).epsilon(5 * stiffness / 230 * step * step / 4));
    CHECK(scene.velocity(tip).z() > scene.velocity(struck).z());
    CHECK(scene.spin(struck).norm() > 0.1);
  }
}

TEST_CASE("in space, fixed blocks stay, prescribed ones go as told, and rigid ones are pushed") {
  Scene scene(settings(1e-4, nothing), law(1e7));
  const Shape<3> block = cube();
  const std::int32_t wall = scene.add(block, BlockKind::fixed, {4.5, 0, 0});
  const std::int32_t pushed = scene.add(block, BlockKind::rigid, {1.2, 0, 0});
  const std::int32_t ram = scene.add(block, BlockKind::prescribed, {0, 0, 0});
  const std::int32_t drum = scene.add(block, BlockKind::prescribed, {0, 10, 0});
  scene.world.set_velocity(ram, {1, 0, 0}, nothing);
  const Vector<3> spin(0.3, -0.2, 0.5);
  scene.world.set_velocity(drum, nothing, spin);
  // Until just before the block reaches the wall. Elastically, it leaves the ram at twice its speed.
  const int steps = 10000;
  scene.step(steps);
  CHECK(scene.position(wall) == Vector<3>(4.5, 0, 0));
  CHECK(scene.position(ram).isApprox(Vector<3>(1, 0, 0), 1e-12));
  CHECK(scene.velocity(pushed).x() == Approx(2).epsilon(1e-3));
  CHECK(scene.velocity(pushed).tail<2>().norm() < 1e-12);
  CHECK((scene.position(drum) - Vector<3>(0, 10, 0)).norm() == 0);
  CHECK(scene.rotation(drum).farthest_from(Rotation<3>().turned_by(spin)) < steps * 1e-15);
  CHECK(scene.spin(drum) == spin);
  // The work of the ram is the block's energy, to the square of omega dt = 0.01.
  CHECK(scene.world.state().ledger.entries().kinetic == Approx(0.5 * 1000 * 4).epsilon(1e-3));
  CHECK(scene.world.state().ledger.entries().outer_work ==
        Approx(scene.world.state().ledger.entries().kinetic).epsilon(1e-4));
  // Off the wall it comes back.
  scene.step(5000);
  CHECK(scene.velocity(pushed).x() == Approx(-2).epsilon(1e-3));
  CHECK(scene.position(wall) == Vector<3>(4.5, 0, 0));
}

TEST_CASE("in space, applied force and torque do what Newton and Euler say") {
  Scene scene(settings(0x1p-12, nothing), law(1e6));
  const std::int32_t slot = scene.add(shape_of(completed(box({1, 2, 3}))), BlockKind::rigid, nothing);
  REQUIRE(scene.world.prepare() == StepResult::ok);
  const Vector<3> force(600, 0, -1200), torque(0, 0, 250);
  scene.world.set_applied_force(slot, force, torque);
  scene.step(4096);
  // 6000 kg; about the third axis a twelfth of it times 1 + 4. The torque stays along that axis.
  CHECK(scene.position(slot).isApprox(0.5 * force / 6000, 1e-12));
  CHECK(scene.spin(slot).isApprox(torque / 2500, 1e-12));
  CHECK(scene.rotation(slot).farthest_from(Rotation<3>().turned_by(0.5 * torque / 2500)) < 1e-11);
  const double kinetic = 0.5 * force.squaredNorm() / 6000 + 0.5 * torque.squaredNorm() / 2500;
  CHECK(scene.world.state().ledger.entries().kinetic == Approx(kinetic).epsilon(1e-12));
  CHECK(scene.world.state().ledger.entries().outer_work == Approx(kinetic).epsilon(1e-12));
}

TEST_CASE("in space, removed blocks leave their slots to others, and the rest goes on") {
  Random random(93);
  const Shape<3> block = cube(), other = random_block(random, 20);
  WorldSettings<3> how = settings(1e-3, gravity);
  how.local_damping = 0.7;
  Scene scene(how, law(1e6, 0.3));
  scene.add(shape_of(completed(box({20, 20, 1}))), BlockKind::fixed, {0, 0, -0.5});
  std::vector<std::int32_t> slots;
  for (int i = 0; i < 9; ++i)
    slots.push_back(
        scene.add(i % 2 ? block : other, BlockKind::rigid, {2.5 * (i % 3) - 2.5, 2.5 * (i / 3) - 2.5, 1.2}));
  scene.step(300);
  scene.world.remove_block(slots[4]);
  scene.world.remove_block(slots[7]);
  scene.step(100);
  const std::int32_t again = scene.add(other, BlockKind::rigid, {0, 0, 3});
  CHECK((again == slots[4] || again == slots[7]));
  CHECK(scene.world.state().is_consistent());
  scene.step(2000);
  CHECK(scene.world.blocks().count() == 9);
  CHECK(scene.world.state().contacts.count() >= 8);
  for (std::size_t i = 0; i < scene.world.blocks().slot_count(); ++i)
    if (scene.world.blocks().lives(i)) CHECK(scene.position(std::int32_t(i)).z() > -0.6);
}
