#include <algorithm>
#include <cmath>

#include "narrow_phase/space/manifold_at_point.h"
#include "narrow_phase/space/manifold_edges.h"
#include "narrow_phase/space/manifold_faces.h"
#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/potential_pairs.h"

// The contact region of two polyhedra at a potential pair, usually the cached one:
//
//   a contact at a point, by far the most frequent, is described directly (manifold_at_point.h)
//   a face and a vertex: face on face, edge on face or vertex on face (manifold_faces.h)
//   two edges: the region of a face nearly in their plane, else the point where they cross
//   where the nearest points are beyond an end or a side: the neighbouring pair, from the start

namespace halfspace {
namespace {

PotentialPair<3> swapped(const PotentialPair<3>& pair) {
  using Pair = PotentialPair<3>;
  const Pair::Kind kind = pair.kind == Pair::face_vertex   ? Pair::vertex_face
                          : pair.kind == Pair::vertex_face ? Pair::face_vertex
                                                           : pair.kind;
  return {kind, pair.b, pair.a};
}

/// Converts a contact relative to b to one relative to a.
void turn_round(const Vector<3>& to_b, Contact<3>& contact) {
  contact.normal = -contact.normal;
  contact.center += to_b;
  for (int i = 0; i < contact.point_count; ++i) contact.points[i] += to_b;
  std::reverse(contact.points, contact.points + contact.point_count);
  std::reverse(contact.gaps, contact.gaps + contact.point_count);
}

/// Returns the pair, or the neighbouring one if a nearest point is beyond an end of its edge; then the
/// contact is the one at that end.
PotentialPair<3> describe_edges(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                const MeetingEdges& edges, const PotentialPair<3>& pair,
                                Contact<3>& contact) {
  const NearestPoints nearest(edges, to_b);
  describe_edge_edge(edges, nearest, to_b, contact);
  if (nearest.are_on_edges()) return pair;
  const double s = nearest.share_of_a, t = nearest.share_of_b;
  const double beyond_a = std::max(-s, s - 1) * edges.a.along.norm();
  const double beyond_b = std::max(-t, t - 1) * edges.b.along.norm();
  const Topology &of_a = *a.topology, &of_b = *b.topology;
  const FacetSide side =
      beyond_a >= beyond_b
          ? side_at_end(b, 1, pair.b, a, pair.a, s < 0 ? of_a.edge_start[pair.a] : of_a.edge_end[pair.a])
          : side_at_end(a, 0, pair.a, b, pair.b, t < 0 ? of_b.edge_start[pair.b] : of_b.edge_end[pair.b]);
  return facet_across(a, b, side, edges.parallelogram.normal()).pair;
}

/// The face at two edges, in the order of FacesAtEdges, most nearly parallel to the plane of both, within an
/// angle; -1 if there is none.
int face_parallel_to(const MeetingEdges& edges, double angle) {
  const Vector<3> normal = edges.parallelogram.normal();
  const Vector<3> faces[] = {edges.a.left, edges.a.right, -edges.b.left, -edges.b.right};
  int best = -1;
  double least = angle * angle;
  for (int i = 0; i < 4; ++i) {
    const double square = cross_product(faces[i], normal).squaredNorm();
    if (square >= least || faces[i].dot(normal) <= 0) continue;
    best = i;
    least = square;
  }
  return best;
}

/// Two edges that cross nearly in the plane of a face, as where a face lands obliquely on another, have that
/// face's contact if it has a region. Then `pair` becomes that of the face; else returns false.
bool describe_edges_in_face(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                            const MeetingEdges& edges, const DetectOptions& options, PotentialPair<3>& pair,
                            Contact<3>& contact) {
  const int parallel = face_parallel_to(edges, options.region_angle());
  if (parallel < 0) return false;
  PotentialPair<3> face = FacesAtEdges(a, b, pair).pair[parallel];
  refresh(a, b, to_b, face);
  const bool is_of_a = face.kind == PotentialPair<3>::face_vertex;
  if (!(is_of_a ? describe_face_region(a, b, to_b, face, options, contact)
                : describe_face_region(b, a, -to_b, swapped(face), options, contact)))
    return false;
  if (!is_of_a) turn_round(to_b, contact);
  pair = face;
  return true;
}

/// Returns the pair, or its neighbour that replaces it.
PotentialPair<3> describe_faces(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                const PotentialPair<3>& pair, const DetectOptions& options,
                                Contact<3>& contact) {
  if (pair.kind == PotentialPair<3>::face_vertex)
    return describe_face_vertex(a, b, to_b, pair, options, contact);
  const PotentialPair<3> next = swapped(describe_face_vertex(b, a, -to_b, swapped(pair), options, contact));
  turn_round(to_b, contact);
  return next;
}

/// The same for any pair. Edges that are no potential pair any more become their face of smallest depth.
PotentialPair<3> describe_at(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                             PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact) {
  if (pair.kind == PotentialPair<3>::edge_edge) {
    const MeetingEdges edges(a, b, pair);
    if (edges.are_potential_pair())
      return describe_edges_in_face(a, b, to_b, edges, options, pair, contact)
                 ? pair
                 : describe_edges(a, b, to_b, edges, pair, contact);
    pair = FacesAtEdges(a, b, pair).shallowest(a, b, to_b);
  }
  return describe_faces(a, b, to_b, pair, options, contact);
}

/// For contacts other than at a point, which the given pair has none of. Not inlined, as it is rare.
[[gnu::noinline]] void describe_and_move(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                         PotentialPair<3>& pair, const DetectOptions& options,
                                         Contact<3>& contact) {
  const PotentialPair<3> given = pair;
  if (pair.kind != PotentialPair<3>::edge_edge) refresh(a, b, to_b, pair);
  PotentialPair<3> last = pair;
  for (int moves = a.topology->edge_count + b.topology->edge_count;
       pair == given || describe_plain_contact(a, b, to_b, pair, options, contact) == Plain::no; --moves) {
    const PotentialPair<3> next = describe_at(a, b, to_b, pair, options, contact);
    // For a vertex of separated blocks beyond the edge between two facets, both refer to each other: it
    // stays.
    if (next == pair || next == last || moves == 0) break;
    last = pair;
    pair = next;
  }
}

}  // namespace

void describe_contact(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                      PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact) {
  if (describe_plain_contact(a, b, to_b, pair, options, contact) == Plain::no)
    describe_and_move(a, b, to_b, pair, options, contact);
  contact.pair = pair;
}

bool describe_plainly_touching(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                               const PairCache<3>& witness, const DetectOptions& options,
                               Contact<3>& contact) {
  if (witness.state != PairCache<3>::touching ||
      describe_plain_contact(a, b, to_b, witness.pair, options, contact) != Plain::and_touching)
    return false;
  contact.pair = witness.pair;
  return true;
}

}  // namespace halfspace
