#include "detect/pair_3d.h"
#include "detect/potential_pairs_3d.h"
#include "geometry/two_lanes.h"

// Proofs that blocks still touch: each shows a point that both have.

namespace halfspace {
namespace {

/// Does the line from the face that is parallel to that between the centroids meet the other's vertex behind
/// the face? Then the segments from these two points to the centroids of their blocks cross. In other words,
/// of the pyramid whose base is the facet of the Minkowski difference and whose apex is the difference of the
/// centroids, the origin is inside (THEORY section 3).
bool overlaps_at_face(const Outline<3>& owner, int face, const Outline<3>& other, int vertex,
                      const Vector<3>& to_other) {
  const Vector<3> normal = owner.normal(face), point = other.vertex(vertex) + to_other;
  const double depth = owner.offset[face] - normal.dot(point), rise = normal.dot(to_other);
  if (!(depth >= 0 && rise > 0)) return false;
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

/// The same of two edges.
bool overlap_at_edges(const Outline<3>& a, int edge_of_a, const Outline<3>& b, int edge_of_b,
                      const Vector<3>& to_b) {
  const Vector<3> along_a = edge_vector(a, edge_of_a), along_b = edge_vector(b, edge_of_b);
  const Vector<3> between =
      (b.vertex(b.topology->edge_start[edge_of_b]) - a.vertex(a.topology->edge_start[edge_of_a])) + to_b;
  // between + share_b along_b + depth to_b = share_a along_a, by Cramer's rule: all three times `whole`.
  const Vector<3> across = cross_product(along_a, along_b);
  const double sign = across.dot(to_b) < 0 ? -1 : 1;
  const double whole = sign * across.dot(to_b);
  const double depth = -sign * across.dot(between);
  const double share_a = sign * between.dot(cross_product(along_b, to_b));
  const double share_b = sign * between.dot(cross_product(along_a, to_b));
  return whole > 0 && depth >= 0 && share_a >= 0 && share_a <= whole && share_b >= 0 && share_b <= whole;
}

/// Is a point inside a block, or on its surface?
bool contains(const Outline<3>& block, const Vector<3>& p) {
  const TwoLanes x = both(p.x()), y = both(p.y()), z = both(p.z());
  auto is_behind = both(0) <= both(0);
  for (int f = 0; f < block.face_count(); f += 2) {
    const TwoLanes height = two_at(block.nx + f) * x + two_at(block.ny + f) * y + two_at(block.nz + f) * z;
    is_behind &= height <= two_at(block.offset + f);
  }
  return is_behind[0] && is_behind[1];
}

/// From a point of a block that lies behind the other's face, `depth` along `normal`, halfway out towards the
/// centroid of its own block: inside that, however slanted it stands.
Vector<3> half_as_deep(const Vector<3>& point, double depth, const Vector<3>& centroid,
                       const Vector<3>& normal) {
  const Vector<3> inward = centroid - point;
  return point + 0.5 * depth / normal.dot(inward) * inward;
}

}  // namespace

bool still_touching(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PairMemory<3>& memory) {
  if (memory.state != PairMemory<3>::touching) return false;
  PotentialPair<3>& pair = memory.pair;
  if (pair.kind == PotentialPair<3>::edge_edge) return overlap_at_edges(a, pair.a, b, pair.b, to_b);
  refresh(a, b, to_b, pair);
  const bool at_face = pair.kind == PotentialPair<3>::face_vertex
                           ? overlaps_at_face(a, pair.a, b, pair.b, to_b)
                           : overlaps_at_face(b, pair.b, a, pair.a, -to_b);
  return at_face || (contains(a, memory.proof) && contains(b, memory.proof - to_b));
}

void remember_proof(const Contact<3>& contact, const Vector<3>& to_b, PairMemory<3>& memory) {
  const Vector<3> to_other = contact.center_gap * contact.normal;
  if (contact.pair.kind == PotentialPair<3>::face_vertex)
    memory.proof = half_as_deep(contact.center + to_other, -contact.center_gap, to_b, contact.normal);
  if (contact.pair.kind == PotentialPair<3>::vertex_face)
    memory.proof =
        half_as_deep(contact.center - to_other, -contact.center_gap, Vector<3>::Zero(), -contact.normal);
}

}  // namespace halfspace
