// The cache makes an answer faster and keeps the side a pair met through; it never changes the verdict.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "extremes/contact_invariants.h"
#include "extremes/scenes.h"

namespace halfspace_test {
namespace {

constexpr double unit_roundoff = 0x1p-53;

/// What holds of an answer with a cache, next to the one without at the same poses.
void check_against_cold(const Scene& s, const hs_contact& warm, const hs_contact& cold) {
  const ExactVerdict exact = exact_verdict(s.placed_a(), s.placed_b());
  const double bound = 2 * rounding_bound * unit_roundoff * s.extent();
  INFO(name_of(s.family) << ": exact " << double(exact.largest_gap) << " warm " << warm.gap << " cold "
                         << cold.gap);
  if (std::abs(exact.largest_gap) > bound) CHECK(touches(warm) == touches(cold));
  if (!touches(warm)) {
    // Along any direction the blocks are at most as far apart as their distance. A proof's direction need not
    // be an edge's normal any more, so that its gap may be larger than any edge's.
    CHECK(warm.gap > 0);
    CHECK(warm.gap <= distance(s) + bound);
  } else if (gap_is_of_the_pair(warm)) {
    // No pair has a larger gap than the largest: a cached one overlaps by more.
    CHECK(warm.gap <= exact.largest_gap + bound);
  }
}

}  // namespace

TEST_CASE("a warm cache gives the cold verdict") {
  for_each_scene(300, 1000, [](const Scene& s, Random&) {
    const hs_contact cold = detect(s);
    hs_pair_cache cache{};
    CHECK(same_bytes(detect(s, &cache), cold));  // an empty cache is no cache
    const hs_contact warm = detect(s, &cache);
    check_against_cold(s, warm, cold);
    check_invariants(s, warm);
  });
}

TEST_CASE("no cache content, however stale, changes the verdict") {
  for_each_scene(300, 1100, [](const Scene& s, Random& random) {
    hs_pair_cache cache{};
    cache.state = 1 + std::int32_t(random() % 2);
    cache.pair_kind = std::int32_t(random() % 2);
    cache.feature_a = std::int32_t(random() % s.polygons.a.size());
    cache.feature_b = std::int32_t(random() % s.polygons.b.size());
    const hs_contact warm = detect(s, &cache);
    check_against_cold(s, warm, detect(s));
  });
}

TEST_CASE("a pair that moves in small steps is judged as if it had no past") {
  long steps = 0, touching = 0, changes = 0;
  for_each_scene(12, 1200, [&](Scene& s, Random& random) {
    // b passes through a, or through its boundary if a is much larger, and turns meanwhile, in steps of a
    // hundredth of the smaller block.
    const double reach =
        2 * std::min(properties_of(s.a.get()).bounding_radius, properties_of(s.b.get()).bounding_radius);
    const double heading = std::uniform_real_distribution<double>(0, 6.28)(random);
    const double turn = std::uniform_real_distribution<double>(-1, 1)(random);
    const hs_pose middle = s.poses.b;
    hs_pair_cache cache{};
    bool touched = false;
    constexpr int half = 200;
    for (int i = -half; i <= half; ++i) {
      const double along = reach * i / half;
      const double z = std::sin(turn * i / half), w = std::cos(turn * i / half);
      s.poses.b = pose_at(
          middle.position[0] + along * std::cos(heading), middle.position[1] + along * std::sin(heading),
          z * middle.rotation[3] + w * middle.rotation[2], w * middle.rotation[3] - z * middle.rotation[2]);
      const hs_contact warm = detect(s, &cache);
      check_against_cold(s, warm, detect(s));
      check_invariants(s, warm);
      ++steps;
      touching += touches(warm);
      changes += touches(warm) != touched;
      touched = touches(warm);
    }
  });
  std::printf("coherent steps %ld, touching %ld, changes of verdict %ld\n", steps, touching, changes);
  CHECK(touching > steps / 10);
}

}  // namespace halfspace_test
