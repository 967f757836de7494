#include "narrow_phase/space/sat_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "narrow_phase/space/potential_pairs.h"
#include "narrow_phase/space/support.h"

// SAT over edges: two edges are a potential contact pair where their arcs on the Gauss map cross.
//
//   for each face of a block: the other's edges that descend along its normal (a set of 64 bits)
//   for each edge: those that descend on one of its sides and climb on the other cross it
//   the gap of each pair of edges that cross each other in the same sense is computed along a x b
//
// Two pairs at a time, one per lane: the gap is (start of b - start of a) . (a x b) / |a x b|.

namespace halfspace {
namespace {

using EdgeSet = std::uint64_t;

/// Directions of a block's edges, from start to end, read two at a time.
struct EdgeDirections {
  double x[max_edges_in_set];
  double y[max_edges_in_set];
  double z[max_edges_in_set];

  explicit EdgeDirections(const Outline<3>& block) {
    const int count = block.topology->edge_count;
    for (int e = 0; e < count; ++e) {
      const Vector<3> direction = edge_vector(block, e);
      x[e] = direction.x();
      y[e] = direction.y();
      z[e] = direction.z();
    }
    if (count % 2 == 1) x[count] = y[count] = z[count] = 0;
  }

  Vector<3> operator[](int e) const { return {x[e], y[e], z[e]}; }
};

/// For each edge of a block, the other block's edges that cross between its two faces in the sense of
/// docs/theory.md: `falling` ones descend along the outer normal of the left face and climb along that of the
/// right one, `rising` ones vice versa.
struct CrossingEdges {
  EdgeSet falling[max_edges_in_set];
  EdgeSet rising[max_edges_in_set];

  /// The sign of each (edge, face) is computed once.
  CrossingEdges(const Outline<3>& block, const EdgeDirections& others, int other_count) {
    constexpr int max_faces = 2 * max_edges_in_set / 3;  // each has at least three edges, each edge two faces
    EdgeSet descending[max_faces];                       // the other's edges, along each face's normal
    const Topology& topology = *block.topology;
    for (int f = 0; f < topology.face_count; ++f) {
      const TwoLanes nx = both(block.nx[f]), ny = both(block.ny[f]), nz = both(block.nz[f]);
      EdgeSet set = 0;
      for (int e = 0; e < other_count; e += 2) {
        const TwoLanes climb =
            load_two(others.x + e) * nx + load_two(others.y + e) * ny + load_two(others.z + e) * nz;
        set |= EdgeSet(signs(climb)) << e;
      }
      descending[f] = set;
    }
    for (int e = 0; e < topology.edge_count; ++e) {
      const EdgeSet left = descending[topology.edge_left[e]], right = descending[topology.edge_right[e]];
      falling[e] = left & ~right;
      rising[e] = right & ~left;
    }
  }
};

struct EdgePair {
  std::int16_t a;
  std::int16_t b;
};

/// Lists the pairs of edges that cross each other. Returns their number.
int list_pairs(const EdgeSet* across_a, int count_a, const EdgeSet* across_b, EdgePair* pairs) {
  int count = 0;
  for (int i = 0; i < count_a; ++i) {
    for (EdgeSet left = across_a[i]; left != 0; left &= left - 1) {
      const int j = std::countr_zero(left);
      pairs[count] = {std::int16_t(i), std::int16_t(j)};
      count += int(across_b[j] >> i & 1);  // without an unpredictable branch
    }
  }
  return count;
}

/// The edge-edge pairs of two blocks and their gaps: the distance of b's edge in front of a's.
class JudgedPairs {
 public:
  JudgedPairs(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b)
      : a_(a), b_(b), to_b_(to_b), edges_of_a_(a), edges_of_b_(b) {
    const int count_a = a.topology->edge_count, count_b = b.topology->edge_count;
    const CrossingEdges across_a(a, edges_of_b_, count_b), across_b(b, edges_of_a_, count_a);
    rising_ = list_pairs(across_a.rising, count_a, across_b.rising, pairs_);
    count_ = rising_ + list_pairs(across_a.falling, count_a, across_b.falling, pairs_ + rising_);
    for (int k = 0; k < count_; k += 2) judge_two(k, std::min(k + 1, count_ - 1));
  }

  /// The remaining pair of largest gap; -1 if there is none.
  int largest() const {
    int best = -1;
    double gap = -HUGE_VAL;
    for (int k = 0; k < count_; ++k) {
      best = gaps_[k] > gap ? k : best;
      gap = std::max(gap, gaps_[k]);
    }
    return best;
  }
  double gap(int k) const { return gaps_[k]; }
  bool are_all_but_parallel(int k) const {
    return halfspace::are_all_but_parallel(edges_of_a_[pairs_[k].a], edges_of_b_[pairs_[k].b]);
  }
  void drop(int k) { gaps_[k] = -HUGE_VAL; }

  /// The normal of nearly parallel edges is inaccurate. The gap between both blocks' supports along it is a
  /// proof all the same.
  Separation<3> proven(int k) const {
    const EdgePair pair = pairs_[k];
    const Vector<3> unit = sense(k) * cross_product(edges_of_a_[pair.a], edges_of_b_[pair.b]).normalized();
    const double gap =
        (deepest_among_all(b_, unit).height + deepest_among_all(a_, -unit).height) + unit.dot(to_b_);
    return {gap, {PotentialPair<3>::edge_edge, pair.a, pair.b}, unit};
  }

 private:
  /// The outward normal of a is a x b where both rise, b x a where both fall.
  double sense(int k) const { return k < rising_ ? 1 : -1; }

  void judge_two(int k, int l) {
    const EdgePair p = pairs_[k], q = pairs_[l];
    const EdgeDirections &of_a = edges_of_a_, &of_b = edges_of_b_;
    const int p_a = a_.topology->edge_start[p.a], q_a = a_.topology->edge_start[q.a];
    const int p_b = b_.topology->edge_start[p.b], q_b = b_.topology->edge_start[q.b];
    const TwoLanes ax = {of_a.x[p.a], of_a.x[q.a]}, ay = {of_a.y[p.a], of_a.y[q.a]},
                   az = {of_a.z[p.a], of_a.z[q.a]};
    const TwoLanes bx = {of_b.x[p.b], of_b.x[q.b]}, by = {of_b.y[p.b], of_b.y[q.b]},
                   bz = {of_b.z[p.b], of_b.z[q.b]};
    const TwoLanes nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
    const TwoLanes from_a_to_b =
        nx * ((TwoLanes{b_.x[p_b], b_.x[q_b]} + both(to_b_.x())) - TwoLanes{a_.x[p_a], a_.x[q_a]}) +
        ny * ((TwoLanes{b_.y[p_b], b_.y[q_b]} + both(to_b_.y())) - TwoLanes{a_.y[p_a], a_.y[q_a]}) +
        nz * ((TwoLanes{b_.z[p_b], b_.z[q_b]} + both(to_b_.z())) - TwoLanes{a_.z[p_a], a_.z[q_a]});
    const TwoLanes square = nx * nx + ny * ny + nz * nz;
    const TwoLanes above_zero = square + (square > both(0) ? both(0) : both(1));  // 0 / 0 would trap
    const TwoLanes length = {std::sqrt(above_zero[0]), std::sqrt(above_zero[1])};
    const TwoLanes gap =
        square > both(0) ? TwoLanes{sense(k), sense(l)} * from_a_to_b / length : both(-HUGE_VAL);
    gaps_[k] = gap[0];
    gaps_[l] = gap[1];
  }

  static constexpr int max_pairs = max_edges_in_set * max_edges_in_set;
  const Outline<3>& a_;
  const Outline<3>& b_;
  const Vector<3>& to_b_;
  EdgeDirections edges_of_a_;
  EdgeDirections edges_of_b_;
  int rising_ = 0;
  int count_ = 0;
  EdgePair pairs_[max_pairs + 1];
  double gaps_[max_pairs];
};

}  // namespace

/// By four signs of edge direction and face normal (docs/theory.md): edges a and b make a facet of the
/// Minkowski difference when b crosses between the faces of a and a between those of b, in the same sense.
/// Nearly parallel edges only prove separation: where they touch, a face has the same depth, and a normal
/// that does not depend on rounding.
void judge_edge_pairs(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, Separation<3>& best) {
  JudgedPairs pairs(a, b, to_b);
  for (int k = pairs.largest(); k >= 0 && pairs.gap(k) > best.gap; k = pairs.largest()) {
    const Separation<3> proven = pairs.proven(k);
    if (proven.gap > best.gap && (proven.gap > 0 || !pairs.are_all_but_parallel(k))) best = proven;
    pairs.drop(k);
  }
}

}  // namespace halfspace
