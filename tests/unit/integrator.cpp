#include "world/motion/integrator.h"

#include <cmath>
#include <limits>

#include "catch.h"
#include "rotations.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double time_step = 0x1p-6, gravity = 10;
constexpr int steps = 100;

template <int D>
WorldSettings<D> falling() {
  WorldSettings<D> settings;
  settings.gravity = at<D>(0, -gravity);
  return settings;
}

/// Runs without contacts. The last stock comes back.
template <int D>
EnergySample run(WorldParts<D>& parts) {
  parts.list_neighbors();
  double noise = 0;
  EnergySample sample = parts.integrator.begin(time_step, noise);
  for (int i = 0; i < steps; ++i) {
    REQUIRE(parts.integrator.predict(time_step));
    parts.integrator.kick_and_drift();
    sample = parts.integrator.kick();
  }
  return sample;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a block thrown under gravity is on Galilei's parabola, with its energy", "",
                       ((int D), D), 2, 3) {
  WorldParts<D> parts(ContactLaw(), falling<D>(), 2);
  const Vector<D> start = at<D>(1, 2), velocity = at<D>(3, 4);
  parts.add(cube<D>(), BlockKind::rigid, start, velocity);
  const EnergySample sample = run(parts);
  const double time = steps * time_step;
  CHECK(parts.blocks.position[0] == start + time * velocity + at<D>(0, -0.5 * gravity * time * time));
  CHECK(parts.blocks.velocity[0] == velocity + at<D>(0, -gravity * time));
  CHECK(sample.kinetic ==
        Approx(velocity.squaredNorm() / 2 * 2 + 2 * gravity * (2 - parts.blocks.position[0].y())));
  CHECK(sample.gravity == Approx(2 * gravity * parts.blocks.position[0].y()));
  CHECK(sample.squared_speed == Approx(parts.blocks.velocity[0].squaredNorm()));
}

TEST_CASE("in the plane a steady torque turns a block by the half of its acceleration times time squared") {
  WorldParts<2> parts{ContactLaw()};
  parts.add(cuboid<2>({2, 1}), BlockKind::rigid, {0, 0});
  parts.blocks.set_motion(0, {0, 0}, Angular<2>(0.5));
  const double inertia = 2 * (2 * 2 + 1 * 1) / 12.0, torque = 0.25, time = steps * time_step;
  parts.blocks.applied_torque[0] = Angular<2>(torque);
  run(parts);
  const double angle = 0.5 * time + 0.5 * torque / inertia * time * time;
  CHECK(parts.blocks.angle[0] == Approx(angle).epsilon(1e-13));
  CHECK(parts.blocks.spin[0][0] == Approx(0.5 + torque / inertia * time).epsilon(1e-13));
  CHECK(parts.blocks.rotation[0].cosine == Approx(std::cos(angle)).epsilon(1e-13));
  CHECK(parts.blocks.rotation[0].sine == Approx(std::sin(angle)).epsilon(1e-13));
}

TEST_CASE("in space a block spins on about its principal axis by the angle that passes") {
  for (int axis = 0; axis < 3; ++axis) {
    WorldParts<3> parts{ContactLaw()};
    parts.add(cuboid<3>({1, 2, 3}), BlockKind::rigid, {0, 0, 0});
    const Angular<3> spin = 0.5 * Vector<3>::Unit(axis);
    parts.blocks.set_motion(0, Vector<3>::Zero(), spin);
    const EnergySample sample = run(parts);
    const Eigen::Matrix3d expected = matrix_of(Rotation<3>().turned_by(steps * time_step * spin));
    CHECK((matrix_of(parts.blocks.rotation[0]) - expected).norm() <= 1e-13);
    CHECK((parts.blocks.spin[0] - spin).norm() <= 1e-13);
    const double sides = 1 + 4 + 9, along = (axis + 1) * (axis + 1);
    CHECK(sample.kinetic == Approx(0.5 * 6 * (sides - along) / 12 * 0.25));
  }
}

TEMPLATE_TEST_CASE_SIG(
    "local damping takes its share of the weight of a falling block, and adds it to a rising one's", "",
    ((int D), D), 2, 3) {
  WorldSettings<D> settings = falling<D>();
  settings.local_damping = 0.25;
  WorldParts<D> parts(ContactLaw(), settings);
  parts.add(cube<D>(), BlockKind::rigid, at<D>(0, 0), at<D>(0, -1));
  parts.add(cube<D>(), BlockKind::rigid, at<D>(10, 0), at<D>(0, 100));
  const EnergySample sample = run(parts);
  const double time = steps * time_step, down = -1 - 0.75 * gravity * time, up = 100 - 1.25 * gravity * time;
  CHECK(parts.blocks.velocity[0].y() == down);
  CHECK(parts.blocks.velocity[1].y() == up);
  CHECK(sample.power.local_damping == Approx(0.25 * gravity * (up - down)));
}

TEMPLATE_TEST_CASE_SIG("mass damping slows a block as the exponential does, to second order", "",
                       ((int D), D), 2, 3) {
  WorldSettings<D> settings;
  settings.mass_damping = 0.5;
  WorldParts<D> parts(ContactLaw(), settings);
  parts.add(cube<D>(), BlockKind::rigid, at<D>(0, 0), at<D>(8, 0));
  const EnergySample sample = run(parts);
  const double passed = 0.5 * steps * time_step, speed = 8 * std::exp(-passed);
  // The share of each step that is off is (alpha dt)^3 / 12 or less; half as much for the last one's kick.
  CHECK(parts.blocks.velocity[0].x() == Approx(speed).epsilon(passed * 0.5 * time_step));
  CHECK(sample.power.mass_damping == Approx(0.5 * speed * speed).epsilon(2 * 0.5 * time_step));
}

TEMPLATE_TEST_CASE_SIG(
    "a prescribed block keeps to its motion whatever loads it, and works; a fixed one stays", "",
    ((int D), D), 2, 3) {
  WorldParts<D> parts(ContactLaw(), falling<D>());
  parts.add(cube<D>(), BlockKind::prescribed, at<D>(0, 0), at<D>(2, 1));
  parts.add(cube<D>(), BlockKind::fixed, at<D>(10, 0));
  Angular<D> turn = Angular<D>::Zero();
  turn[0] = 0.5;
  const Rotation<D> turned = Rotation<D>().turned_by(turn);
  parts.blocks.place(1, at<D>(10, 0), turned);
  for (Vector<D>& force : parts.blocks.force) force = at<D>(3, 5);
  const EnergySample sample = run(parts);
  const double time = steps * time_step;
  CHECK(parts.blocks.position[0] == at<D>(2 * time, time));
  CHECK(parts.blocks.velocity[0] == at<D>(2, 1));
  CHECK(parts.blocks.position[1] == at<D>(10, 0));
  CHECK(parts.blocks.rotation[1].farthest_from(turned) == 0);
  CHECK(sample.power.outer == -(3 * 2 + 5 * 1));
  CHECK(sample.kinetic == 0);
}

TEMPLATE_TEST_CASE_SIG("energy that blocks gain as they fall by their own size is noise", "", ((int D), D), 2,
                       3) {
  WorldParts<D> parts(ContactLaw(), falling<D>(), 4);
  parts.add(cube<D>(), BlockKind::rigid, at<D>(0, 0));
  parts.add(cube<D>(), BlockKind::fixed, at<D>(10, 0));
  parts.list_neighbors();
  double noise = 0;
  parts.integrator.begin(time_step, noise);
  CHECK(noise == Approx(4 * gravity * std::sqrt(D) / 2));
}

TEST_CASE("work of an applied force is by the velocity in the middle of a motion") {
  WorldParts<2> parts(ContactLaw(), {}, 4);
  parts.add(cube<2>(), BlockKind::rigid, {0, 0}, {3, 0});
  parts.blocks.applied_force[0] = {8, 0};
  parts.list_neighbors();
  double noise = 0;
  parts.integrator.begin(time_step, noise);
  REQUIRE(parts.integrator.predict(time_step));
  parts.integrator.kick_and_drift();
  CHECK(parts.integrator.kick().applied_power == 8 * (3 + 8 / 4.0 * time_step / 2));
}

TEST_CASE("a predicted motion is as long as the way of the centroid and the swing of the corners") {
  WorldParts<2> parts(ContactLaw(), falling<2>());
  parts.add(cube<2>(), BlockKind::rigid, {0, 0});
  parts.blocks.set_motion(0, {3, 4}, Angular<2>(2));
  parts.list_neighbors();
  double noise = 0;
  parts.integrator.begin(time_step, noise);
  REQUIRE(parts.integrator.predict(time_step));
  const Vector<2> predicted = time_step * Vector<2>(3, 4 - 0.5 * gravity * time_step);
  CHECK(parts.integrator.predicted_displacement(0) == predicted);
  CHECK(parts.integrator.predicted_turn(0)[0] == Approx(2 * time_step));
  const double way = predicted.norm(), arc = std::sqrt(0.5) * 2 * time_step;
  CHECK(parts.integrator.longest_motion() >= (way + arc) * (1 - 1e-12));
  CHECK(parts.integrator.longest_motion() <= way + 1.5 * arc);
}

TEST_CASE("a motion that is not finite is not predicted") {
  WorldParts<2> parts{ContactLaw()};
  parts.add(cube<2>(), BlockKind::rigid, {0, 0}, {1, 0});
  parts.list_neighbors();
  double noise = 0;
  parts.integrator.begin(time_step, noise);
  CHECK(parts.integrator.predict(time_step));
  parts.blocks.velocity[0].x() = std::numeric_limits<double>::infinity();
  CHECK_FALSE(parts.integrator.predict(time_step));
}
