#include "narrow_phase/space/witness.h"

#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/potential_pairs.h"
#include "simd/four_lanes.h"

// Proofs that blocks still touch: each is a point of both.

namespace halfspace {
namespace {

/// Is a height along a unit normal above rounding? A quotient by a smaller height is meaningless or
/// overflows.
bool is_told_from_0(double height, const Vector<3>& way) {
  return height > machine_epsilon * way.cwiseAbs().maxCoeff();
}

/// Does the line through the other's vertex, parallel to that between the centroids, meet the face in front
/// of the vertex? Then the segments from these two points to the centroids of their blocks cross.
/// Equivalently, the origin is inside the pyramid over the facet of the Minkowski difference with the
/// difference of the centroids as its apex (docs/theory.md).
bool overlaps_at_face(const Outline<3>& owner, int face, const Outline<3>& other, int vertex,
                      const Vector<3>& to_other) {
  const Vector<3> normal = owner.normal(face), point = other.vertex(vertex) + to_other;
  const double depth = owner.offset[face] - normal.dot(point), rise = normal.dot(to_other);
  if (!(depth >= 0 && is_told_from_0(rise, to_other))) return false;
  const Vector<3> on_face = point + depth / rise * to_other;
  const Topology& topology = *owner.topology;
  const int first = topology.first_of_face[face], end = topology.first_of_face[face + 1];
  for (int k = first; k < end; ++k) {
    const Vector<3> from = owner.vertex(topology.face_vertex[k]);
    const Vector<3> to = owner.vertex(topology.face_vertex[k + 1 == end ? first : k + 1]);
    if (!(cross_product(to - from, on_face - from).dot(normal) >= 0)) return false;
  }
  return true;
}

/// The same for two edges.
bool overlap_at_edges(const Outline<3>& a, int edge_of_a, const Outline<3>& b, int edge_of_b,
                      const Vector<3>& to_b) {
  const Vector<3> along_a = edge_vector(a, edge_of_a), along_b = edge_vector(b, edge_of_b);
  const Vector<3> between =
      (b.vertex(b.topology->edge_start[edge_of_b]) - a.vertex(a.topology->edge_start[edge_of_a])) + to_b;
  return edges_cross(along_a, along_b, cross_product(along_a, along_b), between, to_b);
}

/// Is a point inside a block, or on its surface?
template <class Four>
[[gnu::always_inline]] inline bool contains(const Outline<3>& block, const Vector<3>& p) {
  const Four x = all_four<Four>(p.x()), y = all_four<Four>(p.y()), z = all_four<Four>(p.z()),
             none = all_four<Four>(0);
  // A sum, so that NaN propagates.
  Four outside = none;
  for (int f = 0; f < block.face_count(); f += 4) {
    const Four height = load_four<Four>(block.nx + f) * x + load_four<Four>(block.ny + f) * y +
                        load_four<Four>(block.nz + f) * z - load_four<Four>(block.offset + f);
    outside = outside + select_less(height, none, none, height);
  }
  const TwoLanes two = low_half(outside) + high_half(outside);
  return two[0] + two[1] == 0;
}

bool both_contain(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, const Vector<3>& p) {
  return with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    return contains<Four>(a, p) && contains<Four>(b, p - to_b);
  });
}

/// Do the blocks overlap at the cached pair? Updates the vertex of a face.
bool overlap_at_pair(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                     PotentialPair<3>& pair) {
  if (pair.kind == PotentialPair<3>::edge_edge) return overlap_at_edges(a, pair.a, b, pair.b, to_b);
  refresh(a, b, to_b, pair);
  return pair.kind == PotentialPair<3>::face_vertex ? overlaps_at_face(a, pair.a, b, pair.b, to_b)
                                                    : overlaps_at_face(b, pair.b, a, pair.a, -to_b);
}

}  // namespace

bool still_touching(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PairCache<3>& witness) {
  if (!touching(witness)) return false;
  if (witness.state == PairCache<3>::overlapping) return both_contain(a, b, to_b, witness.proof);
  // The faster test first (bench_pairs_3d, stepped pairs).
  constexpr int few_faces = 32;
  const bool point_first =
      witness.pair.kind != PotentialPair<3>::edge_edge && a.face_count() + b.face_count() <= few_faces;
  if (point_first && both_contain(a, b, to_b, witness.proof)) return true;
  return overlap_at_pair(a, b, to_b, witness.pair) ||
         (!point_first && both_contain(a, b, to_b, witness.proof));
}

void remember_proof(const Contact<3>& contact, const Vector<3>& to_b, PairCache<3>& witness) {
  if (contact.pair.kind == PotentialPair<3>::edge_edge) {
    witness.proof = contact.center;
    return;
  }
  // The point behind the face, moved half the depth towards the centroid of its own block, is inside both
  // blocks at any inclination.
  const bool is_of_a = contact.pair.kind == PotentialPair<3>::face_vertex;
  const double to_point = is_of_a ? contact.center_gap : -contact.center_gap;
  const Vector<3> point = contact.center + to_point * contact.normal;
  const Vector<3> inward = (is_of_a ? 1.0 : 0.0) * to_b - point;
  const double rise = (is_of_a ? 1 : -1) * contact.normal.dot(inward);
  const bool has_inside = is_told_from_0(rise, inward);          // not for a block below the other's rounding
  const double above_zero = rise + (has_inside ? 0 : HUGE_VAL);  // as compilers divide before the selection
  witness.proof = point - 0.5 * contact.center_gap / above_zero * inward;
}

}  // namespace halfspace
