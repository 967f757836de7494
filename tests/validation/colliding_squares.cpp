// Two squares of 1 m, one at 1 m/s onto one at rest (Zheng et al. 2020, section 4.1), with a linear spring.

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double mass = 2000;
constexpr double stiffness = 1e7;
constexpr double speed = 1;
const double omega = std::sqrt(stiffness / (mass / 2));  // of the reduced mass

struct Collision {
  double velocity_a;
  double velocity_b;
  double momentum_error;  // relative, the largest of all steps
  double largest_overlap;
  double contact_time;
  double shaken;  // largest speed across the motion, and of the corners in turning
};

/// The squares stand on one line, the gap is no multiple of the way of one step.
Collision collide(double time_step, double drift = 0) {
  Scene scene(world_def(time_step, 0), spring_law(stiffness), mass);
  const double gap = 0.0100001234;
  const hs_block a = scene.add(box(-1, 0, 0, 1), {HS_BLOCK_RIGID, {drift + speed, 0}, 0});
  const hs_block b = scene.add(box(gap, 0, 1 + gap, 1), {HS_BLOCK_RIGID, {drift, 0}, 0});
  Collision result{};
  const double momentum = mass * (speed + 2 * drift);
  const std::int64_t steps = std::llround((gap / speed + 1.5 * pi / omega) / time_step);
  for (std::int64_t i = 0; i < steps; ++i) {
    scene.step();
    const Point va = scene.velocity(a), vb = scene.velocity(b);
    result.momentum_error =
        std::max(result.momentum_error, std::abs(mass * (va.x + vb.x) - momentum) / std::abs(momentum));
    result.largest_overlap = std::max(result.largest_overlap, scene.report().largest_overlap);
    result.shaken = std::max(
        {result.shaken, std::abs(va.y), std::abs(vb.y), std::abs(scene.spin(a)), std::abs(scene.spin(b))});
  }
  const hs_world_report report = scene.report();
  result.velocity_a = scene.velocity(a).x - drift;
  result.velocity_b = scene.velocity(b).x - drift;
  // Both free flights carried on to gap 0.
  const double apart = scene.position(b).x - scene.position(a).x - 1;
  result.contact_time = report.time - apart / (result.velocity_b - result.velocity_a) - gap / speed;
  return result;
}

/// Verlet keeps 1/2 v_{n+1/2}^2 + 1/2 omega^2 x_n x_{n+1} while the spring acts. At first and last touch, x_n
/// < 0 < x_{n+1} lie in one free step of length v dt, so that |x_n x_{n+1}| <= (v dt)^2 / 4 and the square of
/// the relative velocity is off by (omega dt)^2 / 4 at most: the relative velocity by half of that, each
/// block's by a quarter. Amplitude: the same energy gives -1/8 (omega dt)^2, the discrete motion's shape
/// +1/8, a peak between two steps -1/8. Duration: the discrete frequency is omega (1 + (omega dt)^2 / 24);
/// the chord over the step of first touch misses the sine's zero by (omega dt)^3 / 6 at most, at both ends.
TEST_CASE(
    "B4.1 two squares exchange their velocities, and the spring's closed form comes out as the step goes to "
    "zero") {
  const double duration = pi / omega, overlap = speed / omega;
  for (double time_step : {4e-4, 2e-4, 1e-4, 5e-5}) {
    const Collision c = collide(time_step);
    const double turn = omega * time_step;
    const double velocity_error = std::max(std::abs(c.velocity_a), std::abs(c.velocity_b - speed));
    const double overlap_error = c.largest_overlap / overlap - 1;
    const double duration_error = c.contact_time / duration - 1;
    std::printf(
        "B4.1 step %.0e: velocities off by %.2e, momentum %.1e, contact time %.6f ms (%+.2e), overlap %.6f "
        "mm (%+.2e)\n",
        time_step, velocity_error, c.momentum_error, 1e3 * c.contact_time, duration_error,
        1e3 * c.largest_overlap, overlap_error);
    CHECK(velocity_error <= turn * turn / 16 + 1e-12);
    CHECK(overlap_error <= turn * turn / 8);
    CHECK(overlap_error >= -turn * turn / 4);
    CHECK(std::abs(duration_error) <= turn * turn / 24 + turn * turn * turn / (3 * pi));
    CHECK(c.momentum_error <= 1e-12);
    if (time_step == 1e-4) CHECK(velocity_error <= 1e-3);  // the step of the paper
    // The force is shared by two points, whose arms of half a metre differ by rounding of the blocks' places
    // (2e-16 m): impulse m v times that over the moment of inertia m/6, in each of the steps with contact.
    CHECK(c.shaken <= 6 * 2 * rounding * double(c.contact_time / time_step));
  }
}

/// The same in a frame in motion: places grow to 100 m/s x 60 ms = 6 m, where a step rounds by 4e-16 m, and a
/// thousand steps by 4e-13 m, to be compared with an overlap of 1 cm: 4e-11 of the velocities.
TEST_CASE("B4.1 is the same in a frame that moves at 100 m/s") {
  const Collision rest = collide(1e-4), moved = collide(1e-4, 100);
  std::printf("B4.1 boosted by 100 m/s: velocities differ by %.2e and %.2e, momentum %.1e\n",
              moved.velocity_a - rest.velocity_a, moved.velocity_b - rest.velocity_b, moved.momentum_error);
  CHECK(std::abs(moved.velocity_a - rest.velocity_a) <= 4e-11);
  CHECK(std::abs(moved.velocity_b - rest.velocity_b) <= 4e-11);
  CHECK(moved.momentum_error <= 1e-12);
}

}  // namespace
