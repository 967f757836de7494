// Each damping against its closed form.

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double mass = 2000;  // of a square of 1 m
constexpr double stiffness = 1e7;
const double omega = std::sqrt(stiffness / mass);

/// A spring and dashpot that never pull: the contact ends when the force does, and the restitution is
/// exp(-beta/w (pi - atan2(2 beta w, w^2 - beta^2))), beta = zeta omega, w^2 = omega^2 - beta^2 (Schwager and
/// Poeschel 2007).
double restitution(double zeta) {
  const double beta = zeta * omega, w = omega * std::sqrt(1 - zeta * zeta);
  return std::exp(-beta / w * (pi - std::atan2(2 * beta * w, w * w - beta * beta)));
}

double measured_restitution(double zeta, double time_step, int32_t kind, double* ledger_error) {
  hs_law_def law = spring_law(stiffness);
  law.stiffness_kind = kind;
  law.normal_damping = zeta;
  Scene scene(world_def(time_step, 0), law, mass);
  scene.add(box(-2, -1, 2, 0), {HS_BLOCK_FIXED, {}, 0});
  const hs_block block = scene.add(box(-0.5, 0.01000123, 0.5, 1.01000123), {HS_BLOCK_RIGID, {0, -1}, 0});
  scene.step(std::llround(0.15 / time_step));
  const hs_energy energy = scene.energy();
  *ledger_error = energy.residual / (0.5 * mass);
  return scene.velocity(block).y;
}

/// The dashpot acts at full strength from the first step that touches: up to one step of it, 2 zeta omega dt
/// of the velocity, is gained or lost there. It also reads the velocity of half a step before: a mass off by
/// zeta omega dt, which changes ln e by that share of itself, and e ln(1/e) < 0.37. At the end of the contact
/// the force is zero.
TEST_CASE("viscous contact damping gives the restitution of spring and dashpot") {
  for (int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    for (double zeta : {0.05, 0.1, 0.2, 0.5, 0.9}) {
      for (double time_step : {1e-4, 1e-5}) {
        double ledger_error = 0;
        const double e = measured_restitution(zeta, time_step, kind, &ledger_error);
        std::printf(
            "restitution, %s, damping ratio %.2f, step %.0e: %.6f, closed form %.6f, off by %+.1e; ledger "
            "residual %+.1e of the energy\n",
            kind == HS_STIFFNESS_PER_AREA ? "per area" : "per contact", zeta, time_step, e, restitution(zeta),
            e - restitution(zeta), ledger_error);
        const double share = zeta * omega * time_step;
        CHECK(std::abs(e - restitution(zeta)) <= 2.4 * share + square_of(omega * time_step));
        // The loss is the discrete one. What is left is the spring's: a force that begins within a step is
        // taken as a line over all of it, off by up to (omega dt)^2 / 4 of the energy.
        CHECK(std::abs(ledger_error) <= 0.25 * square_of(omega * time_step) + 1e-12);
      }
    }
  }
}

/// Blocks side by side, turned, touch or overlap by the rounding of their corners, with areas of next to
/// nothing.
TEST_CASE("dashpots hold still blocks that overlap by rounding") {
  for (int32_t kind : all_stiffness_kinds) {
    for (int degrees = 0; degrees < 90; ++degrees) {
      const double c = std::cos(degrees * degree), s = std::sin(degrees * degree);
      hs_law_def law = spring_law(1e7);
      law.stiffness_kind = kind;
      law.normal_damping = law.shear_damping = 0.3;
      Scene scene(world_def(1e-5, 0), law);
      for (int i = 0; i < 18; ++i) {
        Points corners = box(1.1 * (i % 6), 0.3 * (i / 6), 1.1 * (i % 6 + 1), 0.3 * (i / 6 + 1));
        for (Point& p : corners) p = {c * p.x - s * p.y, s * p.x + c * p.y};
        scene.add(corners);
      }
      scene.step(10);
      CHECK(std::abs(scene.energy().kinetic) <= 1e-12);
    }
  }
}

/// A square that rocks on the whole of a smooth base: springs of so much stiffness K and dashpots of
/// viscosity C spread over it with radius of gyration r turn it by K r^2 and brake it by C r^2. The weight,
/// whose line passes the base's middle at half the height times the tilt, takes away from the former. So the
/// tilt is that of a damped oscillator, whose amplitude falls as exp(-beta t), beta = C r^2 / (2 I).
TEST_CASE("normal damping brakes rocking on a whole base under every law") {
  constexpr double time_step = 1e-5, zeta = 0.2, first_spin = 1e-3, weight = mass * 10;
  for (const int32_t kind : all_stiffness_kinds) {
    hs_law_def law = spring_law(kind == HS_STIFFNESS_POTENTIAL ? 0.5 * stiffness : stiffness);
    law.stiffness_kind = kind;
    law.normal_damping = zeta;
    hs_world_def def = world_def(time_step, -10);
    def.potential_length = 1;
    Scene scene(def, law, mass);
    scene.add(box(-5, -1, 5, 0), {HS_BLOCK_FIXED, {}, 0});
    const double depth = weight / stiffness;
    const hs_block block = scene.add(box(-0.5, -depth, 0.5, 1 - depth), {HS_BLOCK_RIGID, {0, 0}, first_spin});
    // Two springs at the ends, or a bed.
    const double square_of_radius = kind == HS_STIFFNESS_PER_CONTACT ? 1.0 / 4 : 1.0 / 12;
    const double inertia = mass / 6;
    const double beta = 2 * zeta * std::sqrt(stiffness * mass) * square_of_radius / (2 * inertia);
    const double frequency_squared = (stiffness * square_of_radius - 0.5 * weight) / inertia - beta * beta;
    for (int round = 1; round <= 3; ++round) {
      constexpr double duration = 0.02;
      scene.step(std::llround(duration / time_step));
      const double time = round * duration;
      const double tilt = scene.state(block).angle, rate = scene.spin(block) + beta * tilt;
      const double amplitude = std::sqrt(rate * rate + frequency_squared * tilt * tilt) / first_spin;
      const double expected = std::exp(-beta * time);
      std::printf("rocking, %s, damping ratio %.1f, after %.2f s: amplitude %.6f, closed form %.6f\n",
                  name_of_stiffness(kind), zeta, time, amplitude, expected);
      // Potentials fall short of a bed by the depth over the width; the dashpot is read half a step late.
      const double softening = kind == HS_STIFFNESS_POTENTIAL ? 4 * depth : 0;
      CHECK(std::abs(amplitude / expected - 1) <= softening + 2 * beta * time_step * (1 + beta * time));
    }
  }
}

/// Velocity Verlet with the force read half a step late multiplies the velocity by 1 - c dt each step,
/// exactly, which is exp(-c t) (1 - c^2 dt t / 2 + ...).
TEST_CASE("mass-proportional damping lets a free block's motion decay as exp(-c t)") {
  constexpr double c = 2, time_step = 1e-4, time = 1;
  hs_world_def def = world_def(time_step, 0);
  def.mass_damping = c;
  Scene scene(def, spring_law(stiffness), mass);
  const hs_block block = scene.add(rectangle(1, 1), {HS_BLOCK_RIGID, {3, 0}, 2});
  const double before = scene.energy().kinetic;
  scene.step(std::llround(time / time_step));
  const double v = scene.velocity(block).x / 3, w = scene.spin(block) / 2;
  const hs_energy energy = scene.energy();
  std::printf(
      "mass damping: velocity and spin after 1 s %.8f, %.8f of the first, exp(-2) = %.8f, off by %.1e; "
      "residual %.1e of the energy\n",
      v, w, std::exp(-c * time), v / std::exp(-c * time) - 1, energy.residual / before);
  const double bound = c * c * time_step * time / 2;
  CHECK(std::abs(v / std::exp(-c * time) - 1) <= bound * 1.01);
  CHECK(std::abs(w / std::exp(-c * time) - 1) <= bound * 1.01);
  // The loss is a sum of power over steps, taken at their ends: off the integral by half a step of the
  // power's whole change, dt/2 times 2 c of the energy.
  CHECK(std::abs(energy.residual) <= c * time_step * before * 1.01);
}

/// Local damping on a mass and spring: the force is (1 - a) K x while it speeds the mass up and (1 + a) K x
/// while it slows it down, so that each half swing multiplies the amplitude by sqrt((1 - a) / (1 + a)). The
/// block hangs in its own weight: the spring never opens. Around the turning points the sign of the velocity
/// is up to one step late: work of a K A over the way omega^2 A dt^2, (omega dt)^2 a of the amplitude, up to
/// twice a half swing; the largest of the steps' places is (omega dt)^2 / 8 short.
TEST_CASE("local damping takes its share of a swing") {
  constexpr double share = 0.3, time_step = 2e-5;
  hs_world_def def = world_def(time_step, -10);
  def.local_damping = share;
  Scene scene(def, spring_law(stiffness), mass);
  scene.add(box(-2, -1, 2, 0), {HS_BLOCK_FIXED, {}, 0});
  const double rest = 0.5 - mass * 10 / stiffness, first = 1e-3;
  const hs_block block = scene.add(box(-0.5, rest - first - 0.5, 0.5, rest - first + 0.5));
  // Of the force that local damping sees, the weight is part: at rest the sum is zero.
  double amplitude = first, extreme = 0, before = -first;
  const double expected = std::sqrt((1 - share) / (1 + share));
  int half_swings = 0;
  for (int i = 0; i < 20000 && half_swings < 8; ++i) {
    scene.step();
    const double x = scene.position(block).y - rest;
    if (std::abs(x) >= std::abs(extreme) && x * before < 0) extreme = x;
    if (extreme != 0 && std::abs(x) < std::abs(extreme)) {
      ++half_swings;
      const double ratio = std::abs(extreme) / amplitude;
      std::printf(
          "local damping 0.3: half swing %d keeps %.8f of the amplitude, closed form %.8f, off by %+.1e\n",
          half_swings, ratio, expected, ratio / expected - 1);
      CHECK(std::abs(ratio / expected - 1) <= (2 * share + 0.25) * square_of(omega * time_step));
      amplitude = std::abs(extreme);
      before = extreme;
      extreme = 0;
    }
  }
  CHECK(half_swings == 8);
  const hs_energy energy = scene.energy();
  std::printf("local damping 0.3: residual %.1e of the first swing's energy\n",
              energy.residual / (0.5 * stiffness * first * first));
  // Each half swing begins and ends at rest, where the power is zero: the sum over steps is good to the order
  // dt^2, and the turning points' late sign counts as above, twice in the energy. The squares of the
  // amplitudes are a geometric series.
  CHECK(std::abs(energy.residual) <= 2 * (2 * share + 0.25) * square_of(omega * time_step) /
                                         (1 - expected * expected) * 0.5 * stiffness * first * first);
}

}  // namespace
