// Verdict and depth of one pair of polyhedra by the engines of peers_3d.h, what a cache saves when the
// library is called about pairs that stay apart, and what a pair's memory saves from step to step. README.md
// says what is timed and how to read the figures.

#include <cstdio>
#include <stdexcept>

#include "benchmarks/called_pairs_3d.h"
#include "benchmarks/convex_pairs_3d.h"
#include "benchmarks/stepped_pairs_3d.h"
#include "benchmarks/timing.h"

namespace halfspace_benchmark {
namespace {

/// All of them, and libhalfspace once more with the contact described.
constexpr NamedPeer timed_peers[] = {
    {"halfspace", make_halfspace}, {"with contact", make_halfspace_contact},
    {"ccd MPR", make_ccd_mpr},     {"ccd GJK", make_ccd_gjk},
    {"FCL ccd", make_fcl_ccd},     {"FCL own", make_fcl_own},
    {"Bullet", make_bullet},       {"ODE", make_ode},
};

constexpr int all_vertex_counts[] = {4, 8, 12, 32, 128};

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

/// Each of the peers on one set, in turn in every pass.
template <std::size_t count>
std::vector<Contestant> contest(const NamedPeer (&peers)[count], int vertices, const GapSet& gap,
                                const Sizes& sizes, Random& random) {
  const PairSet3 set = draw_pairs_3d(sizes.pairs, sizes.shapes, vertices, gap, random);
  std::vector<Contestant> contestants;
  for (const NamedPeer& peer : peers) contestants.emplace_back(peer, set, gap.separation <= 0);
  for (int pass = 0; pass < passes; ++pass) {
    for (Contestant& contestant : contestants) contestant.time_pass(random);
  }
  return contestants;
}

void print_row(int vertices, const GapSet& gap, const std::vector<Contestant>& contestants) {
  std::printf("%8d %-6s", vertices, gap.name);
  for (const Contestant& c : contestants)
    std::printf("%8.1f %7.1f %5d", c.minimum_ns(), c.median_ns(), c.wrong());
}

void run_all_peers(const Sizes& sizes) {
  Random random(1);
  std::printf("%15s", "ns");
  for (const NamedPeer& peer : timed_peers) std::printf("%16s %5s", peer.name, "");
  std::printf("\n%8s %-6s", "vertices", "set");
  for (std::size_t i = 0; i < std::size(timed_peers); ++i)
    std::printf("%8s %7s %5s", "min", "median", "wrong");
  std::printf("\n");
  for (const int vertices : all_vertex_counts) {
    for (const GapSet& gap : gap_sets) {
      print_row(vertices, gap, contest(timed_peers, vertices, gap, sizes, random));
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}

void run_all_calls(const Sizes& sizes) {
  constexpr NamedPeer called[] = {{"cold", make_called_cold}, {"warm", make_called_warm}};
  Random random(1);
  std::printf("\npairs apart, through the C API, ns\n");
  std::printf("%15s%8s %7s %5s%8s %7s %5s %7s\n", "", "cold", "", "", "warm", "", "", "");
  std::printf("%8s %-6s%8s %7s %5s%8s %7s %5s %7s\n", "vertices", "set", "min", "median", "wrong", "min",
              "median", "wrong", "ratio");
  for (const int vertices : all_vertex_counts) {
    for (const GapSet& gap : {gap_sets[0], gap_sets[1]}) {
      const std::vector<Contestant> contestants = contest(called, vertices, gap, sizes, random);
      print_row(vertices, gap, contestants);
      std::printf(" %7.1f\n", contestants[0].minimum_ns() / contestants[1].minimum_ns());
      std::fflush(stdout);
    }
  }
}

void run_all_steps(int steps) {
  constexpr int pairs = 256, shapes = 64;
  constexpr double motion = 1e-4 * size_3d, turn = 1e-4;
  Random random(1);
  std::printf("\n%d pairs, half of them near and half touching at the start, %d steps of %g and %g rad: ns\n",
              pairs, steps, motion, turn);
  std::printf("%18s%9s%16s%18s%16s\n", "", "judged", "", "with contact", "");
  std::printf("%8s %9s %9s %9s %6s %9s %9s %6s %12s\n", "vertices", "touching", "no memory", "memory",
              "ratio", "no memory", "memory", "ratio", "differences");
  for (const int vertices : all_vertex_counts) {
    PairSet3 set = draw_pairs_3d(pairs / 2, shapes, vertices, gap_sets[1], random);
    const PairSet3 touching = draw_pairs_3d(pairs / 2, shapes, vertices, gap_sets[2], random);
    for (PolyhedraAt at : touching.pairs) {
      at.a += int(set.polyhedra.size());
      at.b += int(set.polyhedra.size());
      set.pairs.push_back(at);
    }
    set.polyhedra.insert(set.polyhedra.end(), touching.polyhedra.begin(), touching.polyhedra.end());
    const StepTimes t = time_steps(set, steps, motion, turn, random);
    std::printf("%8d %9.2f %9.0f %9.0f %6.1f %9.0f %9.0f %6.1f %12ld\n", vertices, t.touching,
                t.judged_without_memory, t.judged, t.judged_without_memory / t.judged, t.found_without_memory,
                t.found, t.found_without_memory / t.found, t.differences);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const Sizes sizes = read_sizes(argc, argv, "bench_pairs_3d");
  if (sizes.shapes < 1) return 2;
  std::printf("libhalfspace %s; %d pairs of %d shapes a set, %d passes, core %d\n", hs_version(), sizes.pairs,
              sizes.shapes, passes, pin_to_this_core());
  try {
    run_all_peers(sizes);
    run_all_calls(sizes);
    run_all_steps(has_option(argc, argv, "--quick") ? 5 : 100);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_pairs_3d: %s\n", error.what());
    return 1;
  }
}
