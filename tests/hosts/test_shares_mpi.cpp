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

TEST_CASE("processes read shares and write them", "[hosts]") {
  struct Numbers {
    int shares, processes;
  };
  const Numbers numbers = GENERATE(Numbers{3, 1}, Numbers{3, 2}, Numbers{2, 3}, Numbers{3, 3});
  const bool is_plane = GENERATE(true, false);
  INFO(numbers.shares << " shares, " << numbers.processes << " processes"
                      << (is_plane ? ", plane" : ", space"));
  const Snapshot start = is_plane ? heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID)
                                  : heap_in_space(laws_of_stiffness[2], HS_BLOCK_AFFINE);
  const Folder folder("halfspace_share_files");
  split(start, numbers.shares, folder, "start");
  run_on(numbers.processes, HALFSPACE_HOST " " + folder.file("start") + " 1000 " + folder.file("middle"),
         folder);
  run_on(2, HALFSPACE_HOST " " + folder.file("middle") + " 500 " + folder.file("end"), folder);
  check_end(start, 1000, joined(folder, "middle"));
  check_end(start, 1500, joined(folder, "end"));
}

TEST_CASE("shares that are not all of a world are refused", "[hosts]") {
  const Snapshot start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const Folder folder("halfspace_lost_share");
  split(start, 4, folder, "start");
  std::filesystem::remove(folder.path / "start" / "share_3.hsw");
  const auto output = [&](const std::string& from, const std::string& to) {
    const Ended ended = ended_on(2, HALFSPACE_HOST " " + folder.file(from) + " 1 " + folder.file(to), folder);
    CHECK_FALSE(ended.is_success);
    return ended.output;
  };
  CHECK_THAT(output("start", "end"), Catch::Contains("the shares hold 63 of 83 blocks"));
  CHECK_THAT(output("none", "end"), Catch::Contains("cannot read"));
  CHECK_THAT(output("start", "start"), Catch::Contains("has shares already"));
}
