#include "hosts/host_run.h"

// The example of MPI and Zoltan moves worlds with the bits of one process.

using namespace halfspace_test;

TEST_CASE("processes divided by Zoltan keep the bits", "[hosts]") {
  const bool is_plane = GENERATE(true, false);
  const Snapshot start = is_plane ? heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID)
                                  : heap_in_space(laws_of_stiffness[0], HS_BLOCK_RIGID);
  INFO((is_plane ? "plane" : "space"));
  const Snapshot middle = run_shares(start, 1, 1000), end = run_shares(middle, 2, 2000);
  check_end(start, 1000, middle);
  check_end(start, 3000, end);
}
