// Verdict and depth of one pair of polyhedra by the engines of peers_3d.h. README.md says what is timed and
// how to read the figures.

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "benchmarks/convex_pairs_3d.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

constexpr int passes = 7;

/// One engine on a set: its verdicts judged once, its time taken pass by pass.
class Contestant {
 public:
  Contestant(const NamedPeer& peer, const PairSet3& set, bool truth)
      : peer_(peer.make(set)), pairs_(set.pairs.size()) {
    for (std::size_t i = 0; i < pairs_; ++i) {
      const bool verdict = peer_->answer(i).touches;
      touching_ += verdict;
      wrong_ += verdict != truth;
    }
  }

  void time_pass(Random& random) {
    peer_->shuffle(random);
    int touching = 0;
    passes_.add(seconds_of([&] { touching = peer_->count_touching(); }));
    if (touching != touching_)
      throw std::runtime_error("the same pairs gave another answer when they were asked again");
  }

  double minimum_ns() const { return 1e9 * passes_.minimum() / double(pairs_); }
  double median_ns() const { return 1e9 * passes_.median() / double(pairs_); }
  int wrong() const { return wrong_; }

 private:
  std::unique_ptr<Peer> peer_;
  std::size_t pairs_;
  Passes passes_;
  int touching_ = 0;
  int wrong_ = 0;
};

struct Sizes {
  int pairs;
  int shapes;
};

void run(int vertices, const GapSet3& gap, const Sizes& sizes, Random& random) {
  const PairSet3 set = draw_pairs_3d(sizes.pairs, sizes.shapes, vertices, gap, random);
  std::vector<Contestant> contestants;
  for (const NamedPeer& peer : all_peers) contestants.emplace_back(peer, set, gap.separation <= 0);
  for (int pass = 0; pass < passes; ++pass) {
    for (Contestant& contestant : contestants) contestant.time_pass(random);
  }
  std::printf("%8d %-6s", vertices, gap.name);
  for (const Contestant& c : contestants)
    std::printf("%8.0f %7.0f %5d", c.minimum_ns(), c.median_ns(), c.wrong());
  std::printf("\n");
  std::fflush(stdout);
}

void run_all(const Sizes& sizes) {
  Random random(1);
  std::printf("%15s", "ns");
  for (const NamedPeer& peer : all_peers) std::printf("%16s %5s", peer.name, "");
  std::printf("\n%8s %-6s", "vertices", "set");
  for (std::size_t i = 0; i < std::size(all_peers); ++i) std::printf("%8s %7s %5s", "min", "median", "wrong");
  std::printf("\n");
  for (const int vertices : {4, 8, 12, 32, 128}) {
    for (const GapSet3& gap : gap_sets_3d) run(vertices, gap, sizes, random);
  }
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const int shapes = std::atoi(option_value(argc, argv, "--shapes", "64").data());
  if (shapes < 1) {
    std::fprintf(stderr, "bench_pairs_3d: --shapes must be followed by a number of shapes, 1 or more\n");
    return 2;
  }
  const Sizes sizes{has_option(argc, argv, "--quick") ? 128 : 4096, shapes};
  std::printf("libhalfspace %s; %d pairs of %d shapes a set, %d passes, core %d\n", hs_version(), sizes.pairs,
              sizes.shapes, passes, pin_to_this_core());
  try {
    run_all(sizes);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_pairs_3d: %s\n", error.what());
    return 1;
  }
}
