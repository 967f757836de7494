// A block slides on a shaken ground where its inertia exceeds friction (Newmark 1965).

#include <functional>

#include "validation/actions.h"

namespace {

using namespace halfspace_test;

constexpr double row_interval = 0.01, gravity = 9.81, friction = 0.2;

/// Like a record: bursts of several frequencies in an envelope, rows of 0.01 s.
TableRows accelerogram() {
  TableRows rows;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i * row_interval;
    const double envelope = t / 2 * std::exp(1 - t / 2);
    rows.push_back({t, envelope * (2.9 * std::sin(7.3 * t) + 2.1 * std::sin(15.1 * t + 1) +
                                   1.3 * std::sin(31.7 * t + 2))});
  }
  return rows;
}

/// The displacement of the block relative to the ground at each row, by Newmark's model in steps of 1e-6 s.
std::vector<double> newmark(const TableRows& ground, double friction) {
  std::vector<double> displacement{0};
  double velocity = 0, x = 0;
  constexpr int parts = 10000;
  const double h = (ground[1].time - ground[0].time) / parts;
  for (std::size_t row = 0; row + 1 < ground.size(); ++row) {
    for (int k = 0; k < parts; ++k) {
      const double acceleration = ground[row].x + (k + 0.5) / parts * (ground[row + 1].x - ground[row].x);
      const double bound = friction * gravity;
      double next = velocity - acceleration * h;
      if (velocity == 0) {
        next = std::abs(acceleration) <= bound ? 0 : next + std::copysign(bound, acceleration) * h;
      } else {
        next -= std::copysign(bound, velocity) * h;
        if (next * velocity < 0) next = 0;
      }
      x += (velocity + next) / 2 * h;
      velocity = next;
    }
    displacement.push_back(x);
  }
  return displacement;
}

/// The largest error over the range of the displacement. Springs take time to reverse friction, so their
/// error falls with the root of the stiffness.
double error_of(int32_t kind, double time_step) {
  hs_law_def law = spring_law(1e12, std::atan(friction));
  law.stiffness_kind = kind;
  if (kind != HS_STIFFNESS_NONE) law.normal_damping = law.shear_damping = 0.3;
  Scene scene(world_def(time_step), law, 2000);
  const hs_block ground = scene.add(box(-50, -1, 50, 0), {HS_BLOCK_PRESCRIBED, {}, 0});
  const hs_block block = scene.add(box(-1, 0, 1, 1));
  const TableRows rows = accelerogram();
  act(scene, ground, HS_ACTION_ACCELERATION, rows, only_x);
  const std::vector<double> reference = newmark(rows, friction);
  const auto [low, high] = std::minmax_element(reference.begin(), reference.end());
  double error = 0;
  for (std::size_t row = 0; row < reference.size(); ++row) {
    if (row > 0) scene.step(std::llround(row_interval / time_step));
    const double slip = scene.position(block).x - scene.position(ground).x;
    error = std::max(error, std::abs(slip - reference[row]));
  }
  return error / (*high - *low);
}

/// Ground that is shaken by half the acceleration of gravity, as a cosine: the block slides to and fro
/// without a stop. The error of its displacement after 2 s, over the largest.
double error_of_harmonic(double frequency, double time_step) {
  constexpr double rows_per_second = 960, duration = 2, low_friction = 0.1;
  TableRows rows;
  for (int i = 0; i <= rows_per_second * duration; ++i) {
    const double t = i / rows_per_second;
    rows.push_back({t, 0.5 * gravity * std::cos(2 * pi * frequency * t)});
  }
  hs_law_def law = spring_law(1e12, std::atan(low_friction));
  law.stiffness_kind = HS_STIFFNESS_NONE;
  Scene scene(world_def(time_step), law, 2000);
  const hs_block ground = scene.add(box(-50, -1, 50, 0), {HS_BLOCK_PRESCRIBED, {}, 0});
  const hs_block block = scene.add(box(-1, 0, 1, 1));
  act(scene, ground, HS_ACTION_ACCELERATION, rows, only_x);
  const std::vector<double> reference = newmark(rows, low_friction);
  const auto [low, high] = std::minmax_element(reference.begin(), reference.end());
  scene.step(std::llround(duration / time_step));
  const double slip = scene.position(block).x - scene.position(ground).x;
  return std::abs(slip - reference.back()) / std::max(*high, -*low);
}

}  // namespace

TEST_CASE("slip that is reversed within a step is of second order in the step") {
  for (const double frequency : {1.0, 1.7, 0.6}) {
    const double coarse = error_of_harmonic(frequency, 1.0 / 60),
                 fine = error_of_harmonic(frequency, 1.0 / 240);
    std::printf("a block on ground that swings at %g Hz: error %.1e at 1/60 s, %.1e at 1/240 s\n", frequency,
                coarse, fine);
    CHECK(coarse < 1e-2);
    CHECK(fine < 1e-3);
  }
}

TEST_CASE("a block on shaken ground slides as Newmark's") {
  const double by_springs = error_of(HS_STIFFNESS_PER_AREA, 2e-5);
  const double without = error_of(HS_STIFFNESS_NONE, 2e-3);
  std::printf("Newmark's block: error over its range %.1e by springs, %.1e without springs\n", by_springs,
              without);
  CHECK(by_springs < 1e-3);
  CHECK(without < 1e-3);
}
