// Two affine squares of 1 m, one at 1 m/s onto one at rest (Zheng et al. 2020, section 4.1), by each law.

#include "catch.h"
#include "validation/affine.h"

namespace {

using namespace halfspace_test;

constexpr double mass = 2000;
constexpr double stiffness = 1e7;
constexpr double duration = 0.05;  // s, with all of the contact in it
const Elastic elastic{1e9, 0.25};

struct Collision {
  double velocity_a;
  double velocity_b;
  double strain_energy;   // relative to the energy there was, as the residuals are
  double momentum_error;  // relative, the largest of all steps
  double largest_residual;
  double residual;  // in the end
  double shaken;    // largest speed across the motion
};

Collision collide(int32_t kind, double time_step, double gap) {
  hs_law_def law = spring_law(stiffness);
  law.stiffness_kind = kind;
  Scene scene(world_def(time_step, 0), law, mass);
  set_elastic(scene, elastic);
  const hs_block a = scene.add(box(-1, 0, 0, 1), {HS_BLOCK_AFFINE, {1, 0}, 0});
  const hs_block b = scene.add(box(gap, 0, 1 + gap, 1), {HS_BLOCK_AFFINE, {0, 0}, 0});
  Collision result{};
  const double energy = scene.energy().kinetic;
  const std::int64_t steps = std::llround(duration / time_step);
  for (std::int64_t i = 0; i < steps; ++i) {
    scene.step();
    const Point va = scene.velocity(a), vb = scene.velocity(b);
    result.momentum_error = std::max(result.momentum_error, std::abs(va.x + vb.x - 1));
    result.largest_residual = std::max(result.largest_residual, std::abs(scene.energy().residual) / energy);
    result.shaken = std::max({result.shaken, std::abs(va.y), std::abs(vb.y)});
  }
  REQUIRE(scene.report().contact_count == 0);
  result.velocity_a = scene.velocity(a).x;
  result.velocity_b = scene.velocity(b).x;
  result.strain_energy = scene.report().block_strain_energy / energy;
  result.residual = scene.energy().residual / energy;
  return result;
}

/// Root mean square of the residual over the places of first and last touch within a step.
double mean_residual(int32_t kind, double time_step) {
  constexpr int samples = 64;
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double phase = std::fmod(0.7548776662466927 * i, 1), longer = std::fmod(0.5698402909980532 * i, 1);
    const double step = time_step * (1 + 0.05 * longer);
    sum += square_of(collide(kind, step, 0.01 + phase * step).residual);
  }
  return std::sqrt(sum / samples);
}

/// Forces are equal and opposite, so that in a step what one block gains is what the other loses, each
/// rounded once. The contact of two faces that meet squarely does not push across.
TEST_CASE("B4.1 with affine blocks: momentum stays to rounding, and the ledger says what energy did") {
  for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL}) {
    for (const double time_step : {1e-4, 5e-5, 2.5e-5}) {
      const Collision c = collide(kind, time_step, 0.0100001234);
      std::printf(
          "B4.1 affine, law %d, step %.1e: velocities %+.4e, 1 %+.4e, momentum %.1e, strain energy left "
          "%.1e, "
          "residual at most %.1e, in the end %+.1e of the energy\n",
          kind, time_step, c.velocity_a, c.velocity_b - 1, c.momentum_error, c.strain_energy,
          c.largest_residual, c.residual);
      CHECK(c.momentum_error <= duration / time_step * 2 * rounding);
      CHECK(c.shaken <= 1e-12);
    }
  }
}

/// Of the law of potentials energy is kept to the order dt^2: as for rigid blocks, a mean over phases halves
/// to a fourth. 64 samples know a mean to 1/sqrt(128) = 9 %, a ratio of two to 12.5 %: twice that is 1 of 4.
TEST_CASE("B4.1 with affine blocks and potentials: the residual falls with the square of the step") {
  const double coarse = mean_residual(HS_STIFFNESS_POTENTIAL, 1e-4),
               middle = mean_residual(HS_STIFFNESS_POTENTIAL, 5e-5),
               fine = mean_residual(HS_STIFFNESS_POTENTIAL, 2.5e-5);
  std::printf(
      "B4.1 affine, potentials: residual %.2e, %.2e, %.2e at steps 1e-4, 5e-5, 2.5e-5: ratios %.2f, %.2f\n",
      coarse, middle, fine, coarse / middle, middle / fine);
  CHECK(coarse / middle >= 3);
  CHECK(middle / fine >= 3);
}

}  // namespace
