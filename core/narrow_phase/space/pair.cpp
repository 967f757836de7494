#include "narrow_phase/space/pair.h"

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/space/potential_pairs.h"
#include "narrow_phase/space/support.h"

namespace halfspace {
namespace {

/// Gap of a face of `owner`; updates the other's deepest vertex.
double refresh_face(const SeenOutline& owner, int face, const SeenOutline& other, const Vector<3>& to_other,
                    std::int32_t& vertex) {
  const Vector<3> normal = owner.normal(face);
  const Support support = other.deepest_near(normal, vertex);
  vertex = support.vertex;
  return (support.height + normal.dot(to_other)) - owner.offset[face];
}

/// Gap between the supports of both blocks along a direction.
double gap_along(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b, const Vector<3>& normal,
                 std::int32_t& vertex_of_a, std::int32_t& vertex_of_b) {
  const Support of_a = a.deepest_near(-normal, vertex_of_a), of_b = b.deepest_near(normal, vertex_of_b);
  vertex_of_a = of_a.vertex;
  vertex_of_b = of_b.vertex;
  return (of_b.height + of_a.height) + normal.dot(to_b);
}

double refresh_edges(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                     const PotentialPair<3>& pair) {
  const Vector<3> normal = edge_pair_normal(a, pair.a, b, pair.b);
  if (normal == Vector<3>::Zero()) return -HUGE_VAL;
  std::int32_t near_a = a.topology->edge_start[pair.a], near_b = b.topology->edge_start[pair.b];
  return gap_along(a, b, to_b, normal, near_a, near_b);
}

// A proof of separation needs no vertex: for few vertices, their least height is computed faster than the
// vertex with it. Otherwise the vertex is updated.
bool are_few(int vertices) {
  constexpr int too_few_to_walk = 48;  // bench_pairs_3d, stepped pairs
  return vertices <= too_few_to_walk;
}

double gap_at_face(const Outline<3>& owner, int face, const Outline<3>& other, const Vector<3>& to_other,
                   std::int32_t& vertex) {
  if (!are_few(other.vertex_count())) return refresh_face(owner, face, other, to_other, vertex);
  return with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    const Vector<3> normal = owner.normal(face);
    return (min_height<Four>(other, normal) + normal.dot(to_other)) - owner.offset[face];
  });
}

double gap_at_plane(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PairCache<3>& witness) {
  const Vector<3>& normal = witness.proof;
  if (are_few(std::max(a.vertex_count(), b.vertex_count()))) {
    return with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
      return (min_height<Four>(b, normal) + min_height<Four>(a, -normal)) + normal.dot(to_b);
    });
  }
  PotentialPair<3>& pair = witness.pair;
  if (pair.kind == PotentialPair<3>::vertex_vertex) return gap_along(a, b, to_b, normal, pair.a, pair.b);
  std::int32_t near_a = a.topology->edge_start[pair.a], near_b = b.topology->edge_start[pair.b];
  return gap_along(a, b, to_b, normal, near_a, near_b);
}

/// Facets of the Minkowski difference in one plane, as where a face is parallel to an edge or a face of the
/// other block, and their neighbour of smallest depth. Facets beyond the capacity are ignored, with their
/// neighbours.
class FacetsInOnePlane {
 public:
  FacetsInOnePlane(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b, const Facet& first)
      : a_(a), b_(b), to_b_(to_b), best_(first) {
    add(first);
    // The list grows during the iteration.
    for (int i = 0; i < count_; ++i) {
      for_each_side(a, b, facet_[i].pair, [&](const FacetSide& side) {
        const Facet facet = facet_across(a, b, side, facet_[i].normal);
        is_in_plane(facet) ? add(facet) : judge(facet);
      });
    }
  }

  const Facet& shallowest_neighbour() const { return best_; }
  double gap_of_neighbour() const { return best_gap_; }

 private:
  bool is_in_plane(const Facet& facet) const {
    return cross_product(facet.normal, facet_[0].normal).norm() < strictly_parallel &&
           facet.normal.dot(facet_[0].normal) > 0;
  }

  void add(const Facet& facet) {
    const auto is_same = [&](const Facet& f) { return f.pair == facet.pair; };
    if (count_ == room || std::any_of(facet_, facet_ + count_, is_same)) return;
    facet_[count_++] = facet;
  }

  void judge(const Facet& facet) {
    Facet candidate = facet;
    const double gap = refresh(a_, b_, to_b_, candidate.pair);
    if (gap <= best_gap_) return;
    best_ = candidate;
    best_gap_ = gap;
  }

  static constexpr int room = 64;
  const SeenOutline& a_;
  const SeenOutline& b_;
  const Vector<3>& to_b_;
  int count_ = 0;
  Facet facet_[room];
  Facet best_;
  double best_gap_ = -HUGE_VAL;
};

}  // namespace

PotentialPair<3> descend(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                         const PotentialPair<3>& start) {
  Facet best{start, normal_of(a, b, start)};
  double best_gap = refresh(a, b, to_b, best.pair);
  for (int steps = a.topology->edge_count + b.topology->edge_count; steps > 0; --steps) {
    const FacetsInOnePlane plane(a, b, to_b, best);
    if (plane.gap_of_neighbour() <= best_gap) break;
    best = plane.shallowest_neighbour();
    best_gap = plane.gap_of_neighbour();
  }
  return best.pair;
}

double refresh(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b, PotentialPair<3>& pair) {
  switch (pair.kind) {
    case PotentialPair<3>::face_vertex:
      return refresh_face(a, pair.a, b, to_b, pair.b);
    case PotentialPair<3>::vertex_face:
      return refresh_face(b, pair.b, a, -to_b, pair.a);
    default:
      return refresh_edges(a, b, to_b, pair);
  }
}

double refresh(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PairCache<3>& witness) {
  using Pair = PotentialPair<3>;
  Pair& pair = witness.pair;
  if (pair.kind == Pair::face_vertex) return gap_at_face(a, pair.a, b, to_b, pair.b);
  if (pair.kind == Pair::vertex_face) return gap_at_face(b, pair.b, a, -to_b, pair.a);
  const double gap = gap_at_plane(a, b, to_b, witness);
  if (gap > 0 || pair.kind == Pair::vertex_vertex) return gap;
  // The edges may still separate the blocks with their present normal.
  witness.proof = edge_pair_normal(a, pair.a, b, pair.b);
  return gap_at_plane(a, b, to_b, witness);
}

PotentialPair<3> initial_pair(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                              const PairCache<3>& witness) {
  const PotentialPair<3>& pair = witness.pair;
  const bool are_edges = pair.kind == PotentialPair<3>::edge_edge;
  const bool has_a_normal = are_edges ? !are_all_but_parallel(edge_vector(a, pair.a), edge_vector(b, pair.b))
                                      : pair.kind != PotentialPair<3>::vertex_vertex;
  if (has_a_normal) return pair;
  const std::int32_t near_a = are_edges ? a.topology->edge_start[pair.a] : pair.a;
  const std::int32_t near_b = are_edges ? b.topology->edge_start[pair.b] : pair.b;
  const int deepest_of_a = a.deepest_near(-witness.proof, near_a).vertex;
  const int deepest_of_b = b.deepest_near(witness.proof, near_b).vertex;
  PotentialPair<3> of_a{PotentialPair<3>::face_vertex, face_along(a, deepest_of_a, witness.proof),
                        deepest_of_b};
  PotentialPair<3> of_b{PotentialPair<3>::vertex_face, deepest_of_a,
                        face_along(b, deepest_of_b, -witness.proof)};
  const double gap_of_a = refresh(a, b, to_b, of_a), gap_of_b = refresh(a, b, to_b, of_b);
  return gap_of_a >= gap_of_b ? of_a : of_b;
}

}  // namespace halfspace
