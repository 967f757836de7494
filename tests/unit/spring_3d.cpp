#include <algorithm>
#include <cmath>
#include <functional>

#include "bare_law.h"
#include "catch.h"
#include "force/spring/spring.h"
#include "rotations.h"
#include "two_blocks.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double stiffness = 1000;

ContactLaw without_friction(StiffnessKind kind) {
  ContactLaw law = test::bare_law();
  law.stiffness_kind = kind;
  law.normal_stiffness = stiffness;
  return law;
}

/// What the strain energy gives way by when b is moved and turned about its centroid: central differences.
struct Gradient {
  Vector<3> force;
  Vector<3> torque;
};

Gradient gradient(TwoBlocks& two, double way) {
  const Vector<3> position = two.blocks.position[1];
  const Rotation<3> rotation = two.blocks.rotation[1];
  const PotentialPair<3> pair = two.pair;
  const auto strain_at = [&](const Vector<3>& p, const Rotation<3>& r) {
    two.blocks.place(1, p, r);
    two.pair = pair;
    two.evaluate();
    return two.energy.strain;
  };
  Gradient gradient;
  for (int k = 0; k < 3; ++k) {
    const Vector<3> along = way * Vector<3>::Unit(k);
    gradient.force[k] =
        -(strain_at(position + along, rotation) - strain_at(position - along, rotation)) / (2 * way);
    gradient.torque[k] =
        -(strain_at(position, rotation.turned_by(along)) - strain_at(position, rotation.turned_by(-along))) /
        (2 * way);
  }
  strain_at(position, rotation);
  return gradient;
}

/// A plate, whose upper face is the contact plane at z = 0, and a block over its middle; as the two come, or
/// the block first.
TwoBlocks on_plate(const Shape<3>& block, bool block_first) {
  const Shape<3> plate = shape_of(completed(box({20, 20, 2})));
  TwoBlocks two = block_first ? TwoBlocks(block, plate) : TwoBlocks(plate, block);
  two.blocks.place(block_first ? 1 : 0, {0, 0, -1}, Rotation<3>());
  two.meet_at_face_of(block_first ? 1 : 0, z_axis);
  return two;
}

/// Puts the block so that its lowest point is so deep.
void press(TwoBlocks& two, std::int32_t block, const Rotation<3>& rotation, double depth) {
  two.blocks.place(block, {0.3, -0.2, 0}, rotation);
  two.blocks.place(block, {0.3, -0.2, -depth - two.blocks.box(block).lower.z()}, rotation);
}

/// The energy falls as the force says, to what central differences leave: rounding of the gaps, 1e-16 of a
/// size of 1, over twice the way of 1e-7, and less for the cube of the way.
void check_gradient(TwoBlocks& two, double depth, double area) {
  const PairLoad<3> load = two.evaluate();
  const double scale = stiffness * area * depth;
  const Gradient expected = gradient(two, 1e-7);
  CHECK((load.contact.force - expected.force).norm() < 1e-7 * scale);
  CHECK((load.contact.torque_on_b(two.to_b()) - expected.torque).norm() < 1e-7 * scale);
  // Action and reaction about a's centroid.
  const Vector<3> about_a = load.contact.torque_on_a() + load.contact.torque_on_b(two.to_b()) +
                            cross_product(two.to_b(), load.contact.force);
  CHECK(about_a.norm() < 1e-12 * scale * 20);
}

Shape<3> random_prism(Random& random) { return block_of(prism(random_polygon(random, 7, 0.5), 1)); }

}  // namespace

TEST_CASE("in space, springs at the points pull down the slope of their energy, whatever the tilt") {
  Random random(51);
  const struct {
    const char* name;
    double least, most;  // of the tilt, as shares of the parallel angle
  } zones[] = {{"level", 0, 0},
               {"within the parallel angle", 0.01, 0.99},
               {"where a region is followed as long as it bears", 1.01, 4.9},
               {"beyond", 5.1, 30}};
  for (const auto& zone : zones) {
    int of_type[7] = {};
    for (int round = 0; round < 60; ++round) {
      const bool block_first = round % 2;
      const bool is_edge = round % 3 == 0;
      // A face downwards, or an edge along x.
      const Shape<3> block = is_edge ? block_of(wedge(1, 0.7, 0.5)) : random_prism(random);
      TwoBlocks two = on_plate(block, block_first);
      two.law = without_friction(StiffnessKind::per_contact);
      const double angle = two.detect.parallel_angle, tilt = angle * random.uniform(zone.least, zone.most);
      const double direction = random.uniform(0, 2 * pi);
      const Rotation<3> rotation =
          Rotation<3>()
              .turned_by(is_edge ? Vector<3>(random.uniform(-0.2, 0.2), 0, 0) : Vector<3>::Zero())
              .turned_by(is_edge ? tilt * y_axis
                                 : Vector<3>(tilt * std::cos(direction), tilt * std::sin(direction), 0))
              .turned_by(random.uniform(0, 2 * pi) * z_axis);
      const double depth = random.uniform(0.1, 2) * std::max(tilt, 1e-3);
      press(two, block_first ? 0 : 1, rotation, depth);
      INFO(zone.name << ", round " << round << ", tilt " << tilt << ", depth " << depth);
      check_gradient(two, depth, 1);
      ++of_type[int(two.contact.type)];
    }
    INFO(zone.name);
    if (zone.most < 1) {
      CHECK(of_type[int(ContactType::face_face)] == 40);
      CHECK(of_type[int(ContactType::edge_face)] == 20);
    } else if (zone.least > 5) {
      CHECK(of_type[int(ContactType::vertex_face)] > 40);
    }
  }
}

TEST_CASE("in space, the overlap pulls down the slope of its energy, whatever lies in the face") {
  Random random(52);
  for (int round = 0; round < 200; ++round) {
    const bool block_first = round % 2;
    const Shape<3> block = round % 3 == 0   ? block_of(wedge(1, 0.7, 0.5))
                           : round % 3 == 1 ? random_prism(random)
                                            : random_block(random, 15);
    TwoBlocks two = on_plate(block, block_first);
    two.law = without_friction(StiffnessKind::per_area);
    const double tilt = std::exp(random.uniform(-8, 0)), depth = random.uniform(0.01, 0.3);
    const Rotation<3> rotation =
        Rotation<3>().turned_by(tilt * random_direction(random)).turned_by(random.uniform(0, 6) * z_axis);
    press(two, block_first ? 0 : 1, rotation, depth);
    INFO("round " << round << ", tilt " << tilt << ", depth " << depth);
    check_gradient(two, depth, 1);
  }
}

TEST_CASE("in space, level on a face: stiffness times depth, and times area") {
  const Shape<3> cube = shape_of(completed(box({1, 2, 1})));
  for (const bool block_first : {false, true}) {
    TwoBlocks two = on_plate(cube, block_first);
    press(two, block_first ? 0 : 1, Rotation<3>(), 0.125);
    const double up = block_first ? -1 : 1;
    two.law = without_friction(StiffnessKind::per_contact);
    CHECK(two.evaluate().contact.force.isApprox(up * Vector<3>(0, 0, stiffness * 0.125)));
    CHECK(two.energy.strain == Approx(0.5 * stiffness * 0.125 * 0.125));
    two.law = without_friction(StiffnessKind::per_area);
    CHECK(two.evaluate().contact.force.isApprox(up * Vector<3>(0, 0, stiffness * 2 * 0.125)));
    CHECK(two.energy.strain == Approx(stiffness * 0.125 * 0.125));
  }
}

TEST_CASE("in space, action and reaction: the torques about any one point cancel, whatever acts") {
  Random random(53);
  for (int round = 0; round < 300; ++round) {
    const Shape<3> a = random_block(random, 12), b = random_block(random, 12);
    TwoBlocks two(a, b);
    two.law.stiffness_kind = StiffnessKind(round % 2);
    two.law.normal_stiffness = stiffness;
    two.law.shear_stiffness = 0.5 * stiffness;
    two.law.tan_friction = random.uniform(0, 1);
    two.law.normal_damping = 0.1;
    two.law.shear_damping = 0.2;
    two.law.cohesion = round % 3 == 0 ? 1e3 : 0;
    two.bonded = round % 3 == 0;
    const Vector<3> to_b = random.uniform(1.2, 1.8) * random_direction(random);
    two.blocks.place(0, random_vector(random, -1, 1), Rotation<3>());
    two.blocks.place(1, two.blocks.position[0] + to_b, Rotation<3>());
    for (const std::int32_t slot : {0, 1})
      two.blocks.set_motion(slot, random_vector(random, -1, 1), random_vector(random, -3, 3));
    two.pair = pair_of_largest_gap(a.outline(), b.outline(), to_b).pair;
    for (int step = 0; step < 3; ++step) {
      const PairLoad<3> load = two.evaluate(1e-3);
      const Vector<3> point = random_vector(random, -2, 2);
      const Vector<3> on_a =
          load.contact.torque_on_a() - cross_product(two.blocks.position[0] - point, load.contact.force);
      const Vector<3> on_b = load.contact.torque_on_b(two.to_b()) +
                             cross_product(two.blocks.position[1] - point, load.contact.force);
      const double scale = 5 * load.contact.force.norm() + load.contact.torque_on_a().norm();
      CHECK((on_a + on_b).norm() <= 32 * 0x1p-52 * scale);
      // Nothing but compression and friction, and what the bond adds.
      if (!two.bonded) CHECK(normal_force(load) >= 0);
    }
  }
}

TEST_CASE("in space, swapping the blocks turns the force round") {
  Random random(54);
  for (int round = 0; round < 100; ++round) {
    const Shape<3> a = random_block(random, 10), b = random_prism(random);
    TwoBlocks two(a, b), swapped(b, a);
    const Rotation<3> turn = random_turn(random);
    const Vector<3> to_b = random.uniform(0.9, 1.3) * random_direction(random);
    two.blocks.place(1, to_b, turn);
    swapped.blocks.place(0, Vector<3>::Zero(), turn);
    swapped.blocks.place(1, -to_b, Rotation<3>());
    for (TwoBlocks* each : {&two, &swapped}) {
      each->law = without_friction(StiffnessKind(round % 2));
      each->law.tan_friction = 0.5;
    }
    const Vector<3> velocity = random_vector(random, -1, 1), spin_a = random_vector(random, -1, 1),
                    spin_b = random_vector(random, -1, 1);
    two.blocks.set_motion(0, Vector<3>::Zero(), spin_a);
    two.blocks.set_motion(1, velocity, spin_b);
    swapped.blocks.set_motion(0, velocity, spin_b);
    swapped.blocks.set_motion(1, Vector<3>::Zero(), spin_a);
    two.pair = pair_of_largest_gap(two.blocks.outline(0), two.blocks.outline(1), to_b).pair;
    const PairCache<3> other = test::swapped(PairCache<3>{PairCache<3>::touching, two.pair});
    swapped.pair = other.pair;
    const PairLoad<3> load = two.evaluate(1e-3), turned = swapped.evaluate(1e-3);
    const double rounding = 1e-12 * (load.contact.force.norm() + load.contact.torque_on_b(two.to_b()).norm());
    CHECK((load.contact.force + turned.contact.force).norm() <= rounding);
    CHECK((load.contact.torque_on_b(two.to_b()) - turned.contact.torque_on_a()).norm() <= rounding);
    CHECK((load.contact.torque_on_a() - turned.contact.torque_on_b(swapped.to_b())).norm() <= rounding);
    CHECK(two.energy.strain == Approx(swapped.energy.strain).epsilon(1e-12));
  }
}
