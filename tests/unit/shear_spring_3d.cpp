#include <Eigen/Geometry>
#include <cmath>

#include "catch.h"
#include "force/spring/shear_spring.h"
#include "rotations.h"
#include "two_blocks.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double depth = 0.01;
const Vector<3> brick_size(1, 2, 1);

/// A brick on a plate, so deep in it, with friction.
TwoBlocks brick_on_plate(StiffnessKind kind) {
  TwoBlocks two(shape_of(completed(box({20, 20, 2}))), shape_of(completed(box(brick_size))));
  two.blocks.place(1, {0, 0, 1.5 - depth}, Rotation<3>());
  two.meet_at_face_of(0, z_axis);
  two.law.stiffness_kind = kind;
  two.law.normal_stiffness = 1000;
  two.law.shear_stiffness = 400;
  two.law.tan_friction = 0.6;
  return two;
}

/// The mean distance of the base's points from its middle, whatever the springs are.
double twist_radius() {
  const double x = brick_size.x() * brick_size.x() / 12, y = brick_size.y() * brick_size.y() / 12;
  return mean_distance(x + y, x * y);
}

double base(StiffnessKind kind) { return kind == StiffnessKind::per_area ? 2 : 1; }

constexpr StiffnessKind kinds[] = {StiffnessKind::per_contact, StiffnessKind::per_area};

}  // namespace

TEST_CASE("a brick that slips or twists a little is held by springs") {
  for (const StiffnessKind kind : kinds) {
    TwoBlocks two = brick_on_plate(kind);
    const double r = twist_radius(), k = 400 * base(kind), slip = 1e-4, twist = 2e-4;
    two.blocks.set_motion(1, slip * Vector<3>(0.6, 0.8, 5), twist * z_axis);
    const PairLoad<3> load = two.evaluate(1);
    CHECK(load.contact.force.head<2>().isApprox(-k * slip * Vector<2>(0.6, 0.8), 1e-12));
    CHECK(load.contact.couple.isApprox(-k * r * r * twist * z_axis, 1e-12));
    CHECK(energy_of(two.shear) == Approx(0.5 * k * (slip * slip + r * r * twist * twist)));
    CHECK(two.energy.friction_loss == Approx(0).margin(1e-12 * energy_of(two.shear)));
    // And back: nothing is left, and nothing lost.
    two.blocks.set_motion(1, -two.blocks.velocity[1], -two.blocks.spin[1]);
    // But for what the brick's spin has turned the force by on the way.
    CHECK(two.evaluate(1).contact.force.head<2>().norm() < 1.01 * k * slip * 0.5 * twist);
    CHECK(two.energy.friction_loss == Approx(0).margin(k * slip * slip * twist));
  }
}

TEST_CASE("a brick that slides, spins or does both loses by an ellipsoid of friction") {
  Random random(61);
  for (const StiffnessKind kind : kinds) {
    for (int round = 0; round < 100; ++round) {
      TwoBlocks two = brick_on_plate(kind);
      // Pure slip, pure twist, and both. The two spin against each other, so that the contact does not.
      const double way = round % 3 == 1 ? 0 : random.uniform(0, 1), twist = round % 3 == 0 ? 0 : 1;
      const double direction = random.uniform(0, 2 * pi), sense = round % 2 ? 1 : -1;
      const Vector<3> velocity = way * Vector<3>(std::cos(direction), std::sin(direction), 0);
      two.blocks.set_motion(0, {0, 0, 0}, -0.5 * sense * twist * z_axis);
      two.blocks.set_motion(1, velocity, 0.5 * sense * twist * z_axis);
      const PairLoad<3> load = two.evaluate(1);
      const double N = 1000 * base(kind) * depth, limit = 0.6 * N, r = twist_radius();
      CHECK(normal_force(load) == Approx(N));
      const double moment = load.contact.couple.z();
      CHECK(load.contact.couple.head<2>().norm() < 1e-12);
      CHECK(std::hypot(load.contact.force.head<2>().norm(), moment / r) == Approx(limit));
      if (way == 0) CHECK(std::abs(moment) == Approx(limit * r));
      if (twist == 0) CHECK(load.contact.force.head<2>().norm() == Approx(limit));
      // Against the motion, slip and twist in the same measure.
      const double speed = std::hypot(way, r * twist);
      CHECK((load.contact.force + limit / speed * velocity).head<2>().norm() < 1e-12 * limit);
      CHECK(moment == Approx(-limit * r * (r * sense * twist / speed)));

      // On the way to the limit the spring takes up limit^2 / 2 k; all other work is lost, and every further
      // step loses the limit times its way.
      const double k = 400 * base(kind), held = 0.5 * limit * limit / k;
      CHECK(energy_of(two.shear) == Approx(held));
      two.evaluate(0.25);
      CHECK(two.energy.friction_loss == Approx(0.25 * limit * speed));
    }
  }
}

TEST_CASE("a contact turned as a whole takes its shear along and neither gains nor loses") {
  Random random(62);
  for (const StiffnessKind kind : kinds) {
    for (int round = 0; round < 12; ++round) {
      TwoBlocks two = brick_on_plate(kind);
      two.blocks.set_motion(1, 1e-3 * Vector<3>(0.6, -0.8, 0), 2e-3 * z_axis);
      two.evaluate(1);
      const Shear<3> before = two.shear.force;
      const double strain = two.energy.strain;

      // Both blocks turn about one axis through one point: along the normal, across it, or askew.
      const Vector<3> axis = round == 0 ? z_axis : round == 1 ? x_axis : random_direction(random);
      const Vector<3> fixed = random_vector(random, -3, 3);
      const double angle = 5;
      const int steps = round % 2 ? 400 : 100;
      const Vector<3> start[] = {two.blocks.position[0], two.blocks.position[1]};
      double lost = 0;
      for (int i = 1; i <= steps; ++i) {
        const Rotation<3> turn = Rotation<3>().turned_by(angle * i / steps * axis);
        for (const std::int32_t slot : {0, 1}) {
          const Vector<3> arm = turn * Vector<3>(start[slot] - fixed);
          two.blocks.place(slot, fixed + arm, turn);
          // The mean spin of the step, which takes the velocity at its end, too.
          const Vector<3> spin = 2 * steps * std::tan(0.5 * angle / steps) * axis;
          two.blocks.set_motion(slot, cross_product(spin, arm), spin);
        }
        two.evaluate(1.0 / steps);
        lost += std::abs(two.energy.friction_loss);
        // Velocities of some 20 cancel to rounding.
        CHECK(two.energy.strain == Approx(strain).epsilon(1e-9));
      }
      CHECK(lost < 1e-9 * strain);
      const Rotation<3> turn = Rotation<3>().turned_by(angle * axis);
      const Vector<3> expected = turn * Vector<3>(before.head<3>());
      CHECK((two.shear.force.head<3>() - expected).norm() < 1e-9 * expected.norm());
      CHECK(two.shear.force.head<3>().norm() == Approx(expected.norm()).epsilon(1e-9));
      CHECK(two.shear.force[3] == Approx(before[3]).epsilon(1e-9));
    }
  }
}

TEST_CASE("a shear force goes along with the normal by the least turn, whatever is between the normals") {
  Random random(63);
  const PairMotion<3> at_rest{Vector<3>::Zero(), Vector<3>::Zero(), Vector<3>::Zero(), Vector<3>::Zero()};
  for (int round = 0; round < 300; ++round) {
    ShearSpring<3> spring;
    spring.normal = random_direction(random);
    const Vector<3> force = cross_product(spring.normal, random_direction(random));
    spring.force << force, 0.5;
    const Vector<3> axis = cross_product(spring.normal, random_direction(random)).normalized();
    const double angle = random.uniform(-3, 3);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const Shear<3> moved = carried(spring, turn * spring.normal, at_rest, 1);
    // Up to opposite normals the least turn loses digits as 1 / (1 + cosine) grows.
    CHECK((moved.head<3>() - turn * force).norm() < 1e-13 / (1 + std::cos(angle)));
    CHECK(moved[3] == 0.5);

    // Turned over all the way, the force lies in both planes and stays.
    CHECK((carried(spring, -spring.normal, at_rest, 1).head<3>() - force).norm() < 1e-14);

    // The mean of both mean spins about the normal, half the tangent of half the angle, takes it along.
    PairMotion<3> spinning = at_rest;
    spinning.spin_a = random_vector(random, -2, 2);
    spinning.spin_b = random_vector(random, -2, 2);
    const double spun =
        2 * std::atan(0.5 * 0.25 * (0.5 * (spinning.spin_a + spinning.spin_b)).dot(spring.normal));
    const Vector<3> expected = Eigen::AngleAxisd(spun, spring.normal) * force;
    CHECK((carried(spring, spring.normal, spinning, 0.25).head<3>() - expected).norm() < 1e-14);
  }
}

TEST_CASE("in space, a shear force set from outside counts in the plane only, and is no loss") {
  TwoBlocks two = brick_on_plate(StiffnessKind::per_contact);
  two.evaluate();
  remember(two.shear, shear_of(Vector<3>(3, 1, 7), two.contact.normal), preloaded, two.contact.normal);
  const PairLoad<3> load = two.evaluate(1);
  CHECK(load.contact.force.isApprox(Vector<3>(3, 1, 10)));
  CHECK(energy_of(two.shear) == Approx(0.5 * 10 / 400));
  CHECK(two.energy.friction_loss == Approx(0).margin(1e-15));
}

TEST_CASE("where a wrench moves with a block that rolls, the floor's thickness does not matter") {
  const double half_height = 0.5, elapsed = 1e-3, r = 0.3;
  for (const double half_thickness : {0.1, 0.5, 5.0}) {
    const PairMotion<3> motion{Vector<3>::Zero(), (half_height + half_thickness) * z_axis, Vector<3>::Zero(),
                               y_axis};
    const Vector<3> point = half_thickness * z_axis;
    ShearSpring<3> spring;
    spring.force << 0, 1, 0, 0;
    spring.stiffness = 1;
    spring.normal = z_axis;
    spring.arm = point - 0.5 * motion.to_b;
    Shear<3> force = spring.force;
    move(spring, force, point, r, z_axis, motion, elapsed);
    // The mean of both materials has moved along x by half of what the block rolls.
    CHECK(force[3] / force[1] == Approx(-0.5 * half_height * elapsed / r).epsilon(1e-6));
    CHECK(force.norm() == Approx(1));
  }
}
