// Two bonded blocks: torn at sigma_t A, sheared off at F_n tan(phi) + c A (Wang et al. 2021, eqs. 38-40).

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double mass = 2000;  // of a square of 1 m
constexpr double stiffness = 1e9;
constexpr double time_step = 1e-5;
constexpr double strength = 1e5;
constexpr double cohesion = 2e5;
const double omega = std::sqrt(stiffness / mass);

struct Bonded {
  Scene scene;
  hs_block lower;
  hs_block upper;
  Bonded(const hs_law_def& law, double width) : scene(world_def(time_step, 0), law, mass / width) {
    lower = scene.add(box(-2, -1, 2, 0), {HS_BLOCK_FIXED, {}, 0});
    upper = scene.add(box(-width / 2, 0, width / 2, 1));
  }
  hs_contact contact() const {
    const std::vector<hs_contact> all = scene.contacts();
    return all.empty() ? hs_contact{} : all[0];
  }
};

/// Under a load that grows as r t from rest, the spring's force is r (t - sin(omega t) / omega): within r /
/// omega of the load, and never beyond it by more. Half a cosine of the discrete motion and the step's growth
/// add (omega dt)^2 r / omega and r dt.
TEST_CASE("a bond is torn at its tensile strength times its area") {
  constexpr double rate = 1e5;
  for (int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    for (double width : {0.5, 1.0}) {
      hs_law_def law = spring_law(stiffness);
      law.stiffness_kind = kind;
      law.tensile_strength = strength;
      law.cohesion = 10 * strength;
      Bonded b(law, width);
      double held = 0;
      std::int64_t steps = 0;
      for (; steps < 200000 && (steps < 2 || b.contact().type != HS_CONTACT_NONE); ++steps) {
        b.scene.apply(b.upper, {0, rate * double(steps) * time_step});
        b.scene.step();
        held = std::max(held, -b.contact().normal_force);
      }
      const double load = rate * double(steps) * time_step, expected = strength * width;
      const double slowest = kind == HS_STIFFNESS_PER_AREA ? omega * std::sqrt(width) : omega;
      const double resolution = rate * (1 / slowest + 3 * time_step);
      std::printf(
          "tension, %s, face of %.1f m: torn at a load of %.2f N, strength times area %.0f N, the bond held "
          "%.2f N\n",
          kind == HS_STIFFNESS_PER_AREA ? "per area" : "per contact", width, load, expected, held);
      CHECK(std::abs(load - expected) <= resolution);
      CHECK(held <= expected);
      CHECK(held >= expected - 3 * rate * time_step);  // r (1 - cos) <= 2 r a second
      b.scene.step(100);
      CHECK(b.contact().type == HS_CONTACT_NONE);
      CHECK(b.scene.velocity(b.upper).y > 0);
    }
  }
}

/// Pressed by F_n in equilibrium, sheared by a load that grows as above in the line of the contact plane
/// (force and torque at the centroid), so that nothing turns.
TEST_CASE(
    "a bond is sheared off at the friction of its load and its cohesion times its area, and friction "
    "remains") {
  constexpr double rate = 2e5, load = 1e5, friction = 30 * degree;
  for (double width : {0.5, 1.0}) {
    hs_law_def law = spring_law(stiffness, friction);
    law.cohesion = cohesion;
    law.tensile_strength = cohesion;
    Bonded b(law, width);
    // Settled under the load: the load grows over 0.2 s, its shake is the slope over omega (700 N), damped
    // out by nothing but counted below.
    const double settle = 0.2;
    const std::int64_t settle_steps = std::llround(settle / time_step);
    for (std::int64_t i = 0; i < settle_steps; ++i) {
      b.scene.apply(b.upper, {0, -load * double(i) / double(settle_steps)});
      b.scene.step();
    }
    const double shake = 2 * load / settle / omega;
    const double arm = 0.5 - load / stiffness;
    double held = 0, pushed = 0;
    bool broken = false;
    double before = 0;
    std::int64_t steps = 0;
    for (; steps < 300000 && !broken; ++steps) {
      pushed = rate * double(steps) * time_step;
      b.scene.apply(b.upper, {pushed, -load}, pushed * arm);
      b.scene.step();
      const double now = std::abs(shear_along_tangent(b.contact()));
      broken = now < 0.9 * before;
      held = std::max(held, now);
      before = now;
    }
    const double expected = load * std::tan(friction) + cohesion * width;
    // Shear: the load's growth over omega, and its step. Normal force: the shake, as friction.
    const double resolution = rate * (1 / omega + 3 * time_step) + shake * std::tan(friction);
    const hs_contact after = b.contact();
    const double shear_after = std::abs(shear_along_tangent(after));
    std::printf(
        "shear, face of %.1f m: broken at a push of %.1f N, F_n tan(phi) + c A = %.1f N, held %.1f N; then "
        "friction %.6f of the normal force, tan(phi) %.6f\n",
        width, pushed, expected, held, shear_after / after.normal_force, std::tan(friction));
    CHECK(std::abs(pushed - expected) <= resolution);
    CHECK(held <= expected + shake * std::tan(friction));
    CHECK(std::abs(shear_after - after.normal_force * std::tan(friction)) <=
          4 * rounding * after.normal_force);
  }
}

}  // namespace
