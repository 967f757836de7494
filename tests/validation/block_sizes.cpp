// A block bounces on blocks of different height (Zheng et al. 2020, section 5.1): their sizes are no part of
// the law.

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double time_step = 1e-4;
constexpr double stiffness = 5e7;
constexpr double density = 2000;
constexpr double drop = 0.1;
constexpr int steps = 10000;  // 1 s: three bounces and a part of the fourth

/// One block above another.
struct Drop {
  double height;  // of the block below
  double x = 0;

  hs_block add_to(Scene& scene) const {
    scene.add(box(x - 1, -height, x + 1, 0), {HS_BLOCK_FIXED, {}, 0});
    return scene.add(box(x - 0.5, drop, x + 0.5, 1 + drop));
  }
};

/// At first touch, where potentials are hardest: each block's own pushes.
double hardest(int32_t stiffness_kind, double potential_length) {
  return stiffness_kind == HS_STIFFNESS_POTENTIAL ? 2 * stiffness / potential_length : stiffness;
}

/// A bounce turns an overlap that is off by 2e-16 m into a velocity off by omega times that; three bounces in
/// 1 s, and rounding of 1e4 steps besides.
double rounding_of_bounces(double omega) { return 3 * omega * 2 * rounding + steps * rounding; }

/// Neither a spring per contact nor one per area knows any block size, and potentials refer to one length:
/// the bounce is the same to rounding of the fixed block's outline, which is about its own centroid.
TEST_CASE("B5.1 the bounce does not depend on the height of the block below") {
  for (int32_t kind : all_stiffness_kinds) {
    hs_law_def law = spring_law(stiffness);
    law.stiffness_kind = kind;
    hs_world_def def = world_def(time_step);
    def.potential_length = 1;
    Scene low(def, law, density), high(def, law, density);
    const hs_block on_low = Drop{0.1}.add_to(low), on_high = Drop{1}.add_to(high);
    double difference = 0, highest = 0;
    for (int i = 0; i < steps; ++i) {
      low.step();
      high.step();
      const double y = low.position(on_low).y;
      difference = std::max(difference, std::abs(y - high.position(on_high).y));
      if (low.velocity(on_low).y > 0) highest = std::max(highest, y);
    }
    std::printf("B5.1 %s: 1 s of bounces on 0.1 m and on 1 m differ by %.1e m, rise to %.6f of the drop\n",
                name_of_stiffness(kind), difference, (highest - 0.5) / drop);
    const double omega = std::sqrt(hardest(kind, def.potential_length) / density);
    CHECK(difference <= rounding_of_bounces(omega));
    // (omega dt)^2 / 4 of the energy at each end of each of at most four contacts, seen in the height, and
    // sampled once a step.
    CHECK(std::abs((highest - 0.5) / drop - 1) <= 8 * square_of(omega * time_step) / 4);
  }
}

/// The length that nobody has given is one for the whole assembly, and the bounces are as equal as above. The
/// paper's other choice, each block's own inscribed circle, would be ten times shorter for the lower block:
/// as in a world of that length, where the overlap is less by the root of ten.
TEST_CASE("B5.1 blocks of one assembly share one potential length") {
  const hs_law_def law = potential_law(stiffness);
  Scene both(world_def(time_step), law, density);
  const hs_block on_low = Drop{0.1, -2}.add_to(both), on_high = Drop{1, 2}.add_to(both);
  hs_world_def def = world_def(time_step);
  def.potential_length = 0.05;
  Scene own(def, law, density);
  const hs_block on_own = Drop{0.1}.add_to(own);
  double difference = 0, to_own = 0;
  for (int i = 0; i < steps; ++i) {
    both.step();
    own.step();
    const double y = both.position(on_high).y;
    difference = std::max(difference, std::abs(both.position(on_low).y - y));
    to_own = std::max(to_own, std::abs(own.position(on_own).y - y));
  }
  const double length = both.report().potential_length;
  std::printf(
      "B5.1 potential, H = %.4f m unasked: 1 s of bounces on 0.1 m and on 1 m differ by %.1e m, with the "
      "lower block's own radius for H by %.4f m\n",
      length, difference, to_own);
  CHECK(length == Approx((2 * (2 + 0.1) + 2 * (2 + 1) + 8 * 1) / 16));
  CHECK(difference <= rounding_of_bounces(std::sqrt(hardest(HS_STIFFNESS_POTENTIAL, length) / density)));
  CHECK(to_own > 1e-3 * drop);
}

}  // namespace
