// Affine blocks that turn: what turning keeps, and the one strain that it causes.

#include <vector>

#include "catch.h"
#include "validation/affine.h"

namespace {

using namespace halfspace_test;

constexpr double density = 2000;
const hs_law_def law = spring_law(1e7);

hs_world_def still_world(int dimension, double time_step) {
  hs_world_def def = solid_world_def(time_step, {0, 0, 0});
  def.dimension = dimension;
  return def;
}

/// A box that turns by itself, about no axis of its own unless it has not been turned before.
struct Spinner {
  SolidScene scene;
  Triple sides;
  hs_block block = 0;

  Spinner(int dimension, double time_step, const Triple& box_sides, const Elastic& elastic,
          const Triple& spin, double turned = 0.3)
      : scene(still_world(dimension, time_step), law, density), sides(box_sides) {
    set_elastic(scene, elastic);
    if (dimension == 2) {
      block = scene.add_at(rectangle(sides[0], sides[1]), {0, 0}, turned, {HS_BLOCK_AFFINE, {}, spin[2]});
    } else {
      block = scene.add_hull(cuboid(sides), {{}, turn_about({1, 2, 3}, turned), HS_BLOCK_AFFINE, {}, spin});
    }
  }

  /// By definition: the sum over its points of place times velocity.
  Eigen::Vector3d angular_momentum() const {
    const hs_deformation now = deformation_of(scene, block);
    const Tensor moments =
        tensor(now.rate) * mass_matrix_of_box(density, sides).asDiagonal() * tensor(now.gradient).transpose();
    return {moments(2, 1) - moments(1, 2), moments(0, 2) - moments(2, 0), moments(1, 0) - moments(0, 1)};
  }
};

/// A step changes gradient and rate by products with a symmetric stress, and by each other: neither has a
/// moment. So nothing but rounding is left: of each of the components of gradient and rate, some ten sums in
/// a step.
///
/// Verlet keeps an energy that differs from the true one by dt^2 (v K v / 12 - F^2 / (24 m)), K the stiffness
/// in the direction of motion: for a vibration of energy E at omega by (omega dt)^2 E / 6 at most, for
/// turning at spin w, whose force is m w^2 r and whose stiffness is that of the stress, by (w dt)^2 of its
/// energy / 4. Turning that begins without strain makes the block vibrate about its centrifugal strain by as
/// much.
void check_spinning(const char* name, Spinner spinner, double frequency) {
  const Eigen::Vector3d momentum = spinner.angular_momentum();
  const double before = spinner.scene.report().energy.kinetic;
  const hs_block_state state = spinner.scene.state(spinner.block);
  const double spin = length(triple(state.angular_velocity)), time_step = spinner.scene.report().time_step;
  constexpr int steps = 100000;
  double strayed = 0, residual = 0, strain_energy = 0;
  for (int i = 0; i < steps; ++i) {
    spinner.scene.step();
    strayed = std::max(strayed, (spinner.angular_momentum() - momentum).norm() / momentum.norm());
    const hs_world_report report = spinner.scene.report();
    residual = std::max(residual, std::abs(report.energy.residual));
    strain_energy = std::max(strain_energy, report.block_strain_energy);
  }
  const double bound = square_of(frequency * time_step) * strain_energy / 3 +
                       square_of(spin * time_step) * before / 2 + steps * 2 * rounding * before;
  std::printf(
      "spinning %s, %d steps, %.0f turns: angular momentum off by %.1e of itself, energy by at most %.1e of "
      "it (bound %.1e), strain energy up to %.1e of it\n",
      name, steps, spin * time_step * steps / (2 * pi), strayed, residual / before, bound / before,
      strain_energy / before);
  CHECK(strayed <= steps * 10 * rounding);
  CHECK(residual <= bound);
}

TEST_CASE("a spinning block keeps its angular momentum to rounding, and its energy in bounds") {
  const Elastic elastic{1e9, 0.25};
  // No mode is faster than V (2 mu + D lame) / M_min, see the stable step.
  check_spinning("plate in 2D", Spinner(2, 1e-5, {2, 1, 1}, elastic, {0, 0, 30}),
                 std::sqrt(12 * (2 * elastic.shear() + 2 * elastic.lame()) / density));
  // About no principal axis, so that it tumbles.
  check_spinning("box in 3D", Spinner(3, 1e-5, {2, 1, 0.5}, elastic, {20, 10, 15}),
                 std::sqrt(12 * (2 * elastic.shear() + 3 * elastic.lame()) / density) / 0.5);
}

/// A block that turns steadily accelerates by -w^2 x: w^2 M = V S, S the second Piola stress in its frame,
/// along its axes w^2 density side^2 / 12, and nothing along the axis of turning. Viscosity leaves of its
/// first vibration exp(-beta omega^2 t / 2). It takes the velocity of half a step before for that of now, in
/// which the block was turned back by w dt / 2: a strain rate of w^2 dt / 2 across the axis, of the shape as
/// it is strained. The steps' places lie on a circle when the force is that of a spin (w dt)^2 / 12 larger,
/// and the spin told is that of a chord.
TEST_CASE("a block that spins strains by the centrifugal stress") {
  constexpr double time_step = 1e-5;
  const Elastic elastic{1e9, 0.25, HS_PLANE_STRAIN, 1e-4};
  for (const int dimension : {2, 3}) {
    const Triple sides{2, 1, 0.5};
    Spinner spinner(dimension, time_step, sides, elastic, {0, 0, 60}, 0);
    spinner.scene.step(60000);
    const double spin = spinner.scene.spin(spinner.block);
    Tensor stress = Tensor::Zero(), unit = Tensor::Zero();
    for (int k = 0; k < 2; ++k) stress(k, k) = spin * spin * density * square_of(sides[std::size_t(k)]) / 12;
    unit.diagonal().head(dimension).setOnes();
    const double mean = elastic.lame() / (dimension * elastic.lame() + 2 * elastic.shear());
    const Tensor expected = (stress - mean * stress.trace() * unit) / (2 * elastic.shear());
    Tensor late = expected;
    const double late_rate = elastic.damping_time * spin * spin * time_step / 2;
    for (int k = 0; k < 2; ++k) late(k, k) -= late_rate * (1 + 2 * late(k, k));
    const Tensor strain = tensor(deformation_of(spinner.scene, spinner.block).strain);
    std::printf(
        "centrifugal strain in %dD: %.6e, %.6e, %.6e; theory %.6e, %.6e, %.6e; off by %.1e of it, but for "
        "late "
        "velocities by %.1e\n",
        dimension, strain(0, 0), strain(1, 1), strain(2, 2), expected(0, 0), expected(1, 1), expected(2, 2),
        (strain - expected).norm() / expected.norm(), (strain - late).norm() / expected.norm());
    CHECK((strain - late).norm() <= (square_of(spin * time_step) + 10 * late_rate * late_rate) * late.norm());
    CHECK((strain - expected).norm() <= 1.5 * late_rate);
  }
}

/// J that the ledger is off by when a torque acts for 0.05 s, or by turns in as many equal parts of them.
double residual_under_torque(int dimension, double time_step, const std::vector<bool>& is_on) {
  Spinner spinner(dimension, time_step, {2, 1, 0.5}, {1e7, 0.25}, {0, 0, 3});
  const double none[3] = {}, torque[3] = {dimension == 3 ? 3e4 : 0, 0, 1e5};
  for (const bool acts : is_on) {
    spinner.scene.check(
        hs_world_set_applied_force(spinner.scene.world(), spinner.block, none, acts ? torque : none));
    spinner.scene.step(int(std::lround(0.05 / double(is_on.size()) / time_step)));
  }
  const hs_world_report report = spinner.scene.report();
  std::printf("torque on an affine block in %dD, step %.1e s: energy off by %.3e J of %.3e J\n", dimension,
              time_step, report.energy.residual, report.energy.outer_work);
  return report.energy.residual;
}

/// Verlet and the ledger are of second order: a quarter is left of what is off at half the step. Each pulse
/// is booked where it acts, from the step that it begins with to the one that it ends with.
TEST_CASE("the work of a torque on an affine block, also of pulses, is booked to the order of the step") {
  for (const int dimension : {2, 3}) {
    for (const std::vector<bool>& is_on : {std::vector{true}, std::vector{false, true, false, true}}) {
      const double residual = residual_under_torque(dimension, 1e-4, is_on);
      CHECK(residual / residual_under_torque(dimension, 5e-5, is_on) == Approx(4).epsilon(0.05));
    }
  }
}

/// A turn rounds each component of the gradient a few times.
TEST_CASE("turning a strained block as a whole costs no strain and no energy") {
  for (const int dimension : {2, 3}) {
    Spinner spinner(dimension, 1e-5, {2, 1, 0.5}, {1e9, 0.25}, {0, 0, 0});
    Tensor gradient, rate;
    gradient << 1.02, 0.03, 0, -0.01, 0.97, 0, 0, 0, 1;
    rate << 3, -5, 0, 2, 1, 0, 0, 0, 0;
    if (dimension == 3) gradient(0, 2) = gradient(2, 1) = 0.01, rate(2, 0) = 4, rate(2, 2) = -1;
    deform(spinner.scene, spinner.block, gradient, rate);
    const hs_deformation before = deformation_of(spinner.scene, spinner.block);
    const double kinetic = spinner.scene.energy().kinetic;
    double strayed = 0, energy = 0, moved = 0;
    for (int i = 1; i <= 60; ++i) {
      hs_pose pose = spinner.scene.state(spinner.block).pose;
      const Quaternion turn =
          dimension == 2 ? turn_about({0, 0, 1}, 0.7 * i) : turn_about({1, 0.1 * i, -2}, i);
      for (std::size_t k = 0; k < 4; ++k) pose.rotation[k] = turn[k];
      spinner.scene.check(hs_world_set_pose(spinner.scene.world(), spinner.block, &pose));
      const hs_deformation now = deformation_of(spinner.scene, spinner.block);
      strayed = std::max(strayed, (tensor(now.strain) - tensor(before.strain)).norm());
      energy = std::max(energy, std::abs(now.strain_energy / before.strain_energy - 1));
      // The spin stays, whichever way the block is turned: of the rate, what strains is the block's own.
      const Tensor straining = tensor(now.gradient).transpose() * tensor(now.rate);
      const Tensor straining_before = tensor(before.gradient).transpose() * tensor(before.rate);
      moved = std::max(
          moved,
          (straining + straining.transpose() - straining_before - straining_before.transpose()).norm());
    }
    std::printf("turned 60 times in %dD: strain off by %.1e, strain energy by %.1e of it, strain rate %.1e\n",
                dimension, strayed, energy, moved);
    CHECK(strayed <= 60 * 8 * rounding);
    CHECK(energy <= 60 * 8 * rounding / tensor(before.strain).norm() * 4);
    CHECK(moved <= 60 * 16 * rounding * tensor(before.rate).norm());
    // In space the spin meets other moments of inertia.
    if (dimension == 2) CHECK(spinner.scene.energy().kinetic == Approx(kinetic).epsilon(60 * 8 * rounding));
  }
}

}  // namespace
