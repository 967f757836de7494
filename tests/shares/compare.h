#pragma once

// Comparison of a world that is cut into shares with the whole one.

#include <cmath>
#include <cstring>
#include <string>

#include "catch.h"
#include "shares/scenes.h"
#include "shares/split_world.h"

namespace halfspace_test {

/// The first free block whose record differs between two worlds of the same blocks.
inline std::string first_difference(hs_context* context_a, hs_world* a, hs_context* context_b, hs_world* b) {
  const std::vector<std::int64_t> keys = keys_with(b, HS_ROLE_OWN);
  if (keys_with(a, HS_ROLE_OWN) != keys) return "keys";
  const Records of_a = packed(context_a, a, keys, true), of_b = packed(context_b, b, keys, true);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::size_t begin_a = of_a.begin_of(i), begin_b = of_b.begin_of(i);
    const std::string name = "block " + std::to_string(keys[i]);
    if (of_a.ends[i] - begin_a != of_b.ends[i] - begin_b) return name + ": its length";
    for (std::size_t k = begin_a; k < of_a.ends[i]; ++k)
      if (of_a.bytes[k] != of_b.bytes[begin_b + k - begin_a])
        return name + ": byte " + std::to_string(k - begin_a);
  }
  return "none";
}

/// The blocks that are everywhere have the same loads, to the bit.
inline void check_loads_everywhere(const hs_world* joined, const hs_world* whole) {
  const std::vector<std::int32_t> roles = roles_of(whole);
  std::vector<hs_block> of_joined(roles.size()), of_whole(roles.size());
  const std::int64_t count = std::int64_t(roles.size());
  REQUIRE(hs_world_get_blocks(joined, of_joined.data(), count, nullptr) == HS_OK);
  REQUIRE(hs_world_get_blocks(whole, of_whole.data(), count, nullptr) == HS_OK);
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (roles[i] != HS_ROLE_EVERYWHERE) continue;
    const hs_block_state a = state_of(joined, of_joined[i]), b = state_of(whole, of_whole[i]);
    INFO("block " << i << ": force " << a.force[0] << " and " << b.force[0]);
    CHECK(std::memcmp(a.force, b.force, sizeof a.force) == 0);
    CHECK(std::memcmp(a.torque, b.torque, sizeof a.torque) == 0);
    CHECK(std::memcmp(&a.pose, &b.pose, sizeof a.pose) == 0);
    CHECK(std::memcmp(a.velocity, b.velocity, sizeof a.velocity) == 0);
  }
}

/// Energies, losses and momentum of shares add up to those of the whole world, to rounding.
inline void check_sums(const std::vector<double>& found, const hs_world* whole) {
  std::vector<double> expected(HS_SUM_COUNT);
  REQUIRE(hs_world_get_sums(whole, expected.data()) == HS_OK);
  const auto check = [&](std::size_t first, std::size_t last, double tolerance) {
    double largest = 0;
    for (std::size_t i = first; i < last; ++i) largest = std::max(largest, std::abs(expected[i]));
    for (std::size_t i = first; i < last; ++i) CHECK(std::abs(found[i] - expected[i]) <= tolerance * largest);
  };
  constexpr std::size_t powers = 16, momentum = 21, angular = 24;
  check(0, powers, 1e-12);
  check(powers, momentum, 1e-12);
  check(momentum, angular, 1e-13);
  check(angular, HS_SUM_COUNT, 1e-13);
}

/// The maxima so far are those of all shares.
inline void check_peaks(hs_world* joined, hs_world* whole) {
  const hs_world_report found = report_of(joined), expected = report_of(whole);
  CHECK(found.peak_speed == expected.peak_speed);
  CHECK(found.peak_overlap == expected.peak_overlap);
  CHECK(found.max_penetration_ratio == expected.max_penetration_ratio);
}

struct Seen {
  std::int64_t assemblies = 0;
  std::int64_t migrations = 0;
  std::int64_t entrances = 0;
};

/// Compares a world with its shares, which are joined several times on the way.
inline Seen compare(const std::vector<unsigned char>& start, std::size_t shares, std::int64_t steps,
                    std::int32_t threads = 1) {
  const Context context = make_context();
  const World whole = restored(context.get(), start);
  SplitWorld split(start, shares, threads);
  for (int part = 0; part < 4; ++part) {
    require_ok(hs_world_step(whole.get(), steps / 4), context.get());
    for (std::int64_t i = 0; i < steps / 4; ++i) split.step();
    CHECK(split.lost_pairs() == 0);
    const World joined = split.joined();
    INFO("after " << report_of(whole.get()).steps << " steps in " << shares << " shares");
    REQUIRE(first_difference(split.context(), joined.get(), context.get(), whole.get()) == "none");
    check_loads_everywhere(joined.get(), whole.get());
    CHECK(info_of(joined.get()).is_whole == 1);
    check_sums(split.sums(), whole.get());
    check_peaks(joined.get(), whole.get());
  }
  return {split.assemblies(), split.migrations(), split.entrances()};
}

}  // namespace halfspace_test
