#pragma once

// Numbers at the ends of what is allowed, and what must hold of a world that has taken them in.

#include <cmath>
#include <iterator>

#include "capi/meshes.h"
#include "catch.h"

namespace halfspace_test {

/// Evenly in its exponent.
inline double any_size(Random& random, double least_exponent, double most_exponent) {
  return std::pow(10, uniform_between(random, least_exponent, most_exponent));
}

/// One above 0 that may be as small or as large as numbers from outside: often at an end.
inline double any_number(Random& random) {
  constexpr double ends[] = {5e-324, 1e-310, 2.3e-308, 1e-299, 1e-150, 1e-75, 1, 1e74, 1e75};
  const double end = ends[random() % std::size(ends)];
  return random() % 3 == 0 ? end : random() % 2 == 0 ? any_size(random, -307, 74) : any_size(random, -9, 12);
}
inline double any_number_or_zero(Random& random) { return random() % 3 == 0 ? 0 : any_number(random); }

inline bool is_end_of_step(hs_status status) {
  return status == HS_OK || status == HS_ERROR_STATE || status == HS_ERROR_UNSTABLE ||
         status == HS_ERROR_TOO_FAST || status == HS_ERROR_INVERTED;
}

/// The library reads what it saves, and a world that is restored goes on as the one that was saved.
inline void check_goes_on(hs_context* context, hs_world* world, int steps) {
  const std::vector<unsigned char> bytes = saved(world);
  hs_world* made = nullptr;
  REQUIRE(hs_world_restore(context, bytes.data(), bytes.size(), &made) == HS_OK);
  const World twin(made);
  const bool is_the_same = saved(made) == bytes;
  CHECK(is_the_same);
  const hs_status status = hs_world_step(world, steps);
  INFO(hs_status_string(status));
  CHECK(is_end_of_step(status));
  CHECK(hs_world_step(made, steps) == status);
  const bool goes_on_the_same = saved(made) == saved(world);
  CHECK(goes_on_the_same);
}

/// Where blocks are and how they move.
inline void check_finite(const hs_world* world) {
  hs_block blocks[32];
  std::int64_t count = 0;
  REQUIRE(hs_world_get_blocks(world, blocks, 32, &count) == HS_OK);
  for (std::int64_t i = 0; i < count; ++i) {
    const hs_block_state state = state_of(world, blocks[i]);
    for (int k = 0; k < 3; ++k) {
      CHECK(std::isfinite(state.pose.position[k]));
      CHECK(std::isfinite(state.velocity[k]));
      CHECK(std::isfinite(state.angular_velocity[k]));
    }
  }
}

/// Relaxes a copy, and looks for its factor of safety.
inline void check_rest(hs_context* context, const hs_world* world) {
  const World copy = restored(context, saved(world));
  const hs_relaxation_def def = relaxation_def(12, 1e-9);
  const hs_status status = hs_world_relax(copy.get(), &def, nullptr, 0);
  CHECK((status == HS_NOTE_NOT_AT_REST || is_end_of_step(status)));
  hs_balance balance;
  CHECK(hs_world_get_balance(copy.get(), &balance, sizeof balance) == HS_OK);
  check_finite(copy.get());
  check_goes_on(context, copy.get(), 2);
}

}  // namespace halfspace_test
