// An elastic bounce keeps its energy to the order dt^2, and the ledger says by how much it does not.

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

/// Falls without gravity, at 1 m/s.
struct Bounce {
  const char* name;
  Points falling;
  int32_t stiffness_kind;
  double spin;
};

struct Loss {
  double at_end;  // relative to the energy there was
  double kinetic;
  double largest;
};

constexpr double density = 2000;
constexpr double stiffness = 1e7;

/// Of a contact over a whole edge of 1 m: by potentials, of either block.
double hardest(int32_t stiffness_kind) {
  return stiffness_kind == HS_STIFFNESS_POTENTIAL ? 2 * stiffness : stiffness;
}

Loss bounce(const Bounce& b, double time_step, double phase) {
  hs_law_def law = spring_law(stiffness);
  law.stiffness_kind = b.stiffness_kind;
  hs_world_def def = world_def(time_step, 0);
  def.potential_length = 1;
  Scene scene(def, law, density);
  scene.add(box(-3, -1, 3, 0), {HS_BLOCK_FIXED, {}, 0});
  Points falling = b.falling;
  for (Point& p : falling) p.y += 0.02 + phase * time_step;
  const hs_block block = scene.add(falling, {HS_BLOCK_RIGID, {0, -1}, b.spin});
  const double before = scene.energy().kinetic;
  Loss loss{0, 0, 0};
  const std::int64_t steps = std::llround(0.4 / time_step);
  for (std::int64_t i = 0; i < steps; ++i) {
    scene.step();
    loss.largest = std::max(loss.largest, std::abs(scene.energy().residual) / before);
  }
  REQUIRE(scene.velocity(block).y > 0);
  REQUIRE(scene.report().contact_count == 0);
  const hs_energy energy = scene.energy();
  loss.at_end = energy.residual / before;
  loss.kinetic = energy.kinetic / before - 1;
  return loss;
}

/// Root mean square over all places of first and last touch within a step: low-discrepancy shares of a step
/// for the first, steps longer by up to 5 % for the last.
double mean_loss(const Bounce& b, double time_step) {
  constexpr int samples = 256;
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double phase = std::fmod(0.7548776662466927 * i, 1), longer = std::fmod(0.5698402909980532 * i, 1);
    const Loss loss = bounce(b, time_step * (1 + 0.05 * longer), phase);
    CHECK(std::abs(loss.kinetic - loss.at_end) <= 1e-12);  // the ledger books no loss where no law takes any
    sum += square_of(loss.at_end);
  }
  return std::sqrt(sum / samples);
}

/// Verlet's energy error is bounded by the jumps of the force's slope at first and last touch, each of which
/// leaves a share of (omega dt)^2 / 4 at most, omega^2 = K / m_eff, with the phase of the step (see B4.1).
/// For a mean over the phases, halving the step quarters it. 256 samples know such a mean to 1/sqrt(512)
/// = 4.4 %, a ratio of two to 6 %: three times that is 0.75 of 4. The force per area on a vertex grows as the
/// depth squared, and so do potentials: no jump, and better than the fourth part.
///
/// The force must come from a potential for this. That of a vertex does; so do two fixed points of parallel
/// edges, and the overlap area as long as its ends lie inside the edge.
TEST_CASE("an elastic bounce keeps its energy to the order dt^2") {
  const Points square = rectangle(1, 1);
  Points raised = square;
  for (Point& p : raised) p.y += 0.5;
  const double r = std::sqrt(0.5);
  const Points corner{{0, 0}, {r, r}, {0, 2 * r}, {-r, r}};
  const Points leaning{{0, 0}, {0.9, 0.3}, {0.6, 1.2}, {-0.3, 0.9}};
  for (int32_t kind : all_stiffness_kinds) {
    const Bounce bounces[] = {{"edge-edge", raised, kind, 0},
                              {"vertex-edge through the centroid", corner, kind, 0},
                              {"vertex-edge, off centre, spinning", leaning, kind, 0.5}};
    for (const Bounce& b : bounces) {
      const double coarse = mean_loss(b, 4e-4), middle = mean_loss(b, 2e-4), fine = mean_loss(b, 1e-4);
      std::printf(
          "energy, %s, %s: lost %.2e, %.2e, %.2e at steps 4e-4, 2e-4, 1e-4 s: ratios %.2f, %.2f; within the "
          "bounce %.1e\n",
          b.name, name_of_stiffness(kind), coarse, middle, fine, coarse / middle, middle / fine,
          bounce(b, 1e-4, 0.5).largest);
      const bool jumps = kind == HS_STIFFNESS_PER_CONTACT || &b == &bounces[0];
      CHECK(coarse / middle >= 4 - 0.75);
      CHECK(middle / fine >= 4 - 0.75);
      if (jumps) CHECK(coarse / middle <= 4 + 0.75);
      if (jumps) CHECK(middle / fine <= 4 + 0.75);
      const double min_mass = density / 4;  // at a vertex: 1 + m r^2 / I <= 4
      CHECK(fine <= 0.5 * hardest(kind) / min_mass * square_of(1.05e-4));
    }
  }
}

/// A square that falls nearly flat passes from vertex-edge to edge-edge and back. The force has a potential
/// throughout, and the bound is as above: per contact, two corners of half the stiffness come and go.
TEST_CASE("an elastic bounce keeps its energy through the parallel angle") {
  constexpr double parallel_angle = 0.01;
  for (int32_t kind : all_stiffness_kinds) {
    for (double tilt : {0.001, 0.004, 0.008, 0.02, 0.1}) {
      for (double time_step : {1e-4, 1e-5}) {
        hs_world_def def = world_def(time_step, 0);
        def.parallel_angle = parallel_angle;
        def.potential_length = 1;
        hs_law_def law = spring_law(stiffness);
        law.stiffness_kind = kind;
        Scene scene(def, law, density);
        scene.add(box(-3, -1, 3, 0), {HS_BLOCK_FIXED, {}, 0});
        scene.add_at(rectangle(1, 1), {0, 0.6}, tilt, {HS_BLOCK_RIGID, {0, -1}, 0});
        const double before = scene.energy().kinetic;
        const std::int64_t steps = std::llround(0.4 / time_step);
        scene.step(steps);
        const double share = scene.energy().residual / before;
        const double ends = 0.5 * hardest(kind) / (density / 4) * square_of(time_step);
        std::printf(
            "energy, square tilted by %.3f, %s, step %.0e: residual %+.1e of the energy (bound %.1e)\n", tilt,
            name_of_stiffness(kind), time_step, share, ends);
        CHECK(std::abs(share) <= ends);
      }
    }
  }
}

}  // namespace
