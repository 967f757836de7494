#include "hosts/host_run.h"

// The same for more processes than there are processors, with each law.

using namespace halfspace_test;

TEST_CASE("3 and 8 processes keep the bits", "[hosts]") {
  const LawOfStiffness& of = laws_of_stiffness[GENERATE(0, 1, 2)];
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  const bool is_plane = GENERATE(true, false);
  INFO(of.name << ", kind " << kind << (is_plane ? ", plane" : ", space"));
  const Snapshot start = is_plane ? heap_in_plane(of, kind) : heap_in_space(of, kind);
  const Snapshot middle = run_shares(start, 8, 4000), end = run_shares(middle, 3, 4000);
  check_end(start, 4000, middle);
  check_end(start, 8000, end);
}

TEST_CASE("bonds by laws break on 3 processes as on one", "[hosts]") {
  const Snapshot start = wall_in_plane();
  check_end(start, 8000, run_shares(start, 3, 8000));
}
