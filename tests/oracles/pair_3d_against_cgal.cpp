// Verdicts and depths of other people's engines against the exact verdict and the least depth by brute force,
// on random pairs of polyhedra family by family.
//
//   pair_3d_against_cgal [pairs] [seed]      default 10000 pairs, all families together
//
// Other engines' errors are counted, not judged. Fails when this library is wrong on a pair that is not
// within rounding of touching, or off in a depth; and when the oracle contradicts itself: the filtered
// verdict against the exact signs of all facets is part of the verdict; against CGAL's linear programming it
// is checked on some of the pairs.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>

#include "benchmarks/peers_3d.h"
#include "oracles/exact_pair_3d.h"
#include "oracles/random_pairs_3d.h"

namespace halfspace_test {
namespace {

using halfspace_benchmark::all_peers;
using halfspace_benchmark::Answer;
using halfspace_benchmark::NamedPeer;
using halfspace_benchmark::PairSet3;

constexpr double clear_share = 1e-9;       // of the extent: a gap or overlap that no rounding excuses
constexpr double measured_overlap = 1e-4;  // of the extent: depths from there on are compared
constexpr double depth_tolerance = 0.01;   // of the depth

/// How one engine did.
struct Score {
  long wrong = 0;
  long clearly_wrong = 0;  // among them, gap or overlap above clear_share
  long gave_up = 0;        // among the wrong, no verdict at all
  long deep = 0;           // overlaps from measured_overlap on that it found
  long depth_off = 0;      // among them, depth off by more than depth_tolerance
  double worst_depth = 0;  // largest error of the depth, share of the extent

  void add(const Score& s) {
    wrong += s.wrong;
    clearly_wrong += s.clearly_wrong;
    gave_up += s.gave_up;
    deep += s.deep;
    depth_off += s.depth_off;
    worst_depth = std::max(worst_depth, s.worst_depth);
  }
};

struct Tally {
  long pairs = 0;
  long touching = 0;
  long exact = 0;           // decided by exact arithmetic, the filter was not enough
  long checked = 0;         // pairs judged by linear programming and by all axes too
  long contradictions = 0;  // of the oracle with itself
  std::array<Score, std::size(all_peers)> peers;

  void add(const Tally& t) {
    pairs += t.pairs;
    touching += t.touching;
    exact += t.exact;
    checked += t.checked;
    contradictions += t.contradictions;
    for (std::size_t i = 0; i < peers.size(); ++i) peers[i].add(t.peers[i]);
  }
};

void judge(const Answer& answer, const ExactVerdict3& truth, double extent, Score& score) {
  if (answer.gave_up || answer.touches != truth.touches) {
    ++score.wrong;
    score.clearly_wrong += std::abs(truth.gap) > clear_share * extent;
    score.gave_up += answer.gave_up;
  } else if (truth.touches && -truth.gap >= measured_overlap * extent) {
    const double error = std::abs(answer.depth + truth.gap);
    ++score.deep;
    score.depth_off += !(error <= depth_tolerance * -truth.gap);
    score.worst_depth = std::max(score.worst_depth, error / extent);
  }
}

void print_polyhedron(const char* name, const PlacedPolyhedron& p) {
  std::printf("  %s vertices", name);
  for (const Point3& v : p.polyhedron->vertices) std::printf(" (%a, %a, %a)", v.x, v.y, v.z);
  const auto& [x, y, z] = p.pose.position;
  const auto& [qx, qy, qz, qw] = p.pose.rotation;
  std::printf("\n  %s pose (%a, %a, %a) (%a, %a, %a, %a)\n", name, x, y, z, qx, qy, qz, qw);
}

void check_the_oracle(const PlacedPolyhedron& a, const PlacedPolyhedron& b, const ExactVerdict3& verdict,
                      Tally& tally) {
  ++tally.checked;
  const bool is_least_depth =
      !verdict.touches || std::abs(largest_gap_of_all_axes(a, b) - verdict.gap) <= verdict.accuracy;
  if (have_a_common_point(a, b) == verdict.touches && is_least_depth) return;
  if (++tally.contradictions > 2) return;
  std::printf("CONTRADICTION: touches %d, gap %.17g\n", verdict.touches, verdict.gap);
  print_polyhedron("a", a);
  print_polyhedron("b", b);
}

Tally run(Family3 family, long pairs, std::uint64_t seed) {
  constexpr int placements_of_a_pair = 4;
  constexpr long check_one_in = 50;
  Random3 random(seed + std::uint64_t(family));
  Tally tally;
  while (tally.pairs < pairs) {
    const PolyhedronPair drawn = draw_polyhedra(family, random);
    PairSet3 set{{drawn.a, drawn.b}, {}};
    const long wanted =
        is_placed_by_vertices(family) ? 1 : std::min<long>(placements_of_a_pair, pairs - tally.pairs);
    for (long i = 0; i < wanted; ++i) {
      const PosePair3 poses = draw_poses(family, drawn, random);
      set.pairs.push_back({0, 1, poses.a, poses.b});
    }

    std::vector<ExactVerdict3> truths;
    std::vector<double> extents;
    for (const auto& pair : set.pairs) {
      const PlacedPolyhedron a{&set.polyhedra[0], pair.at_a}, b{&set.polyhedra[1], pair.at_b};
      const MinkowskiFacets facets(a, b);
      truths.push_back(exact_verdict(a, b, facets));
      extents.push_back(extent(facets, apart(a, b)));
      ++tally.pairs;
      tally.touching += truths.back().touches;
      tally.exact += !truths.back().filter_was_enough;
      if (tally.pairs % check_one_in == 0) check_the_oracle(a, b, truths.back(), tally);
    }
    for (std::size_t p = 0; p < tally.peers.size(); ++p) {
      const auto peer = all_peers[p].make(set);
      for (std::size_t i = 0; i < truths.size(); ++i)
        judge(peer->answer(i), truths[i], extents[i], tally.peers[p]);
    }
  }
  return tally;
}

void print_names() {
  std::printf("%-16s %8s %8s %8s %8s", "family", "pairs", "touching", "exact", "checked");
  for (const NamedPeer& peer : all_peers) std::printf(" %15s", peer.name);
  std::printf("\n");
}

void print_row(const char* name, const Tally& t) {
  std::printf("%-16s %8ld %8ld %8ld %8ld", name, t.pairs, t.touching, t.exact, t.checked);
  for (const Score& s : t.peers)
    std::printf(" %15s", (std::to_string(s.wrong) + " / " + std::to_string(s.clearly_wrong)).c_str());
  std::printf("\n");
  std::fflush(stdout);
}

template <class Figure>
void print_figure(const char* name, const Tally& t, const char* format, Figure figure) {
  std::printf("%-52s", name);
  for (const Score& s : t.peers) std::printf(format, figure(s));
  std::printf("\n");
}

int main(long pairs, std::uint64_t seed) {
  std::printf(
      "wrong verdicts: all / those with a gap or overlap above %g of the extent: radius a + radius b + "
      "distance\n",
      clear_share);
  print_names();
  Tally total;
  const long families = long(std::size(all_families_3d));
  for (const NamedFamily3& family : all_families_3d) {
    const Tally tally = run(family.family, (pairs + families - 1) / families, seed);
    print_row(family.name, tally);
    total.add(tally);
  }
  print_row("all", total);
  print_figure("gave up instead of a verdict", total, " %15ld", [](const Score& s) { return s.gave_up; });
  print_figure("overlaps of 1e-4 of the extent or more, found", total, " %15ld",
               [](const Score& s) { return s.deep; });
  print_figure("among them, depth off by more than 1 %", total, " %15ld",
               [](const Score& s) { return s.depth_off; });
  print_figure("worst error of depth, share of the extent", total, " %15.1e",
               [](const Score& s) { return s.worst_depth; });
  if (total.contradictions > 0)
    std::printf("the oracle contradicts itself: %ld times\n", total.contradictions);
  const Score& ours = total.peers[0];
  if (ours.clearly_wrong + ours.depth_off > 0)
    std::printf("%s: %ld clearly wrong verdicts, %ld depths off\n", all_peers[0].name, ours.clearly_wrong,
                ours.depth_off);
  return total.contradictions + ours.clearly_wrong + ours.depth_off == 0 ? 0 : 1;
}

}  // namespace
}  // namespace halfspace_test

int main(int argc, char** argv) {
  const long pairs = argc > 1 ? std::atol(argv[1]) : 10000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  return halfspace_test::main(pairs, seed);
}
