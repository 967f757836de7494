#include <algorithm>
#include <cmath>

#include "detect/pair_3d.h"
#include "detect/potential_pairs_3d.h"
#include "detect/region_3d_faces.h"
#include "detect/region_3d_shares.h"

namespace halfspace {
namespace {

PotentialPair<3> swapped(const PotentialPair<3>& pair) {
  using Pair = PotentialPair<3>;
  const Pair::Kind kind = pair.kind == Pair::face_vertex   ? Pair::vertex_face
                          : pair.kind == Pair::vertex_face ? Pair::face_vertex
                                                           : pair.kind;
  return {kind, pair.b, pair.a};
}

/// The contact seen from b becomes that seen from a.
void turn_round(const Vector<3>& to_b, Contact<3>& contact) {
  contact.normal = -contact.normal;
  contact.center += to_b;
  for (int i = 0; i < contact.point_count; ++i) contact.points[i] += to_b;
  std::reverse(contact.points, contact.points + contact.point_count);
  std::reverse(contact.gaps, contact.gaps + contact.point_count);
}

/// Of an edge of each block: the nearest points of their lines, and the middle between them. Returns the
/// pair, or the neighbouring one when one of these points lies beyond an end of its edge: then this is the
/// contact at the end.
PotentialPair<3> describe_edge_edge(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                    const PotentialPair<3>& pair, const Vector<3>& normal,
                                    Contact<3>& contact) {
  const int start_of_a = a.topology->edge_start[pair.a], start_of_b = b.topology->edge_start[pair.b];
  const Vector<3> along_a = edge_vector(a, pair.a), along_b = edge_vector(b, pair.b);
  const Vector<3> across = cross_product(along_a, along_b);
  const double length = across.norm();
  const Vector<3> unit = across / length;
  const Vector<3> between = (b.vertex(start_of_b) - a.vertex(start_of_a)) + to_b;
  const double s = cross_product(between, along_b).dot(unit) / length;
  const double t = cross_product(between, along_a).dot(unit) / length;
  const Vector<3> on_a = a.vertex(start_of_a) + std::clamp(s, 0.0, 1.0) * along_a;
  const Vector<3> on_b = (b.vertex(start_of_b) + to_b) + std::clamp(t, 0.0, 1.0) * along_b;
  contact.normal = normal;
  contact.gap = normal.dot(between);
  describe_point(ContactType::edge_edge, 0.5 * (on_a + on_b), contact);

  const double share_beyond_a = std::max(-s, s - 1), share_beyond_b = std::max(-t, t - 1);
  if (std::max(share_beyond_a, share_beyond_b) <= 0) return pair;
  const double beyond_a = share_beyond_a * along_a.norm(), beyond_b = share_beyond_b * along_b.norm();
  const FacetSide side =
      beyond_a >= beyond_b
          ? side_at_end(b, 1, pair.b, a, pair.a, s < 0 ? start_of_a : a.topology->edge_end[pair.a])
          : side_at_end(a, 0, pair.a, b, pair.b, t < 0 ? start_of_b : b.topology->edge_end[pair.b]);
  return facet_across(a, b, side, contact.normal).pair;
}

/// The faces at two edges. Their vertices are only where to look for the deepest ones.
struct FacesAtEdges {
  PotentialPair<3> pair[4];

  FacesAtEdges(const SeenOutline& a, const SeenOutline& b, const PotentialPair<3>& edges) {
    using Pair = PotentialPair<3>;
    const Topology &of_a = *a.topology, &of_b = *b.topology;
    pair[0] = {Pair::face_vertex, of_a.edge_left[edges.a], of_b.edge_start[edges.b]};
    pair[1] = {Pair::face_vertex, of_a.edge_right[edges.a], of_b.edge_start[edges.b]};
    pair[2] = {Pair::vertex_face, of_a.edge_start[edges.a], of_b.edge_left[edges.b]};
    pair[3] = {Pair::vertex_face, of_a.edge_start[edges.a], of_b.edge_right[edges.b]};
  }

  /// That of least depth, with its vertex brought up to date.
  PotentialPair<3> least_deep(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b) {
    int best = 0;
    double best_gap = -HUGE_VAL;
    for (int i = 0; i < 4; ++i) {
      const double gap = refresh(a, b, to_b, pair[i]);
      if (gap <= best_gap) continue;
      best = i;
      best_gap = gap;
    }
    return pair[best];
  }

  /// That nearest to parallel with a plane, if it is within an angle of it; nullptr else.
  PotentialPair<3>* parallel_to(const Vector<3>& normal, double angle, const SeenOutline& a,
                                const SeenOutline& b) {
    PotentialPair<3>* best = nullptr;
    double least = angle * angle;
    for (PotentialPair<3>& face : pair) {
      const Vector<3> of_face = normal_of(a, b, face);
      const double square = cross_product(of_face, normal).squaredNorm();
      if (square >= least || of_face.dot(normal) <= 0) continue;
      best = &face;
      least = square;
    }
    return best;
  }
};

/// Two edges that cross nearly in the plane of a face, as they do where a face comes down on another one
/// askew, touch as the face does if it has a region. Returns its pair then, or that of the edges.
PotentialPair<3> describe_edges_in_face(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                        const PotentialPair<3>& edges, const Vector<3>& normal,
                                        const DetectOptions& options, Contact<3>& contact) {
  FacesAtEdges faces(a, b, edges);
  PotentialPair<3>* const found = faces.parallel_to(normal, options.parallel_angle, a, b);
  if (!found) return edges;
  PotentialPair<3>& face = *found;
  refresh(a, b, to_b, face);
  if (face.kind == PotentialPair<3>::face_vertex)
    return describe_face_region(a, b, to_b, face, options, contact) ? face : edges;
  if (!describe_face_region(b, a, -to_b, swapped(face), options, contact)) return edges;
  turn_round(to_b, contact);
  return face;
}

/// Returns the pair, or the one to move on to.
PotentialPair<3> describe_faces(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                const PotentialPair<3>& pair, const DetectOptions& options,
                                Contact<3>& contact) {
  if (pair.kind == PotentialPair<3>::face_vertex)
    return describe_face_vertex(a, b, to_b, pair, options, contact);
  const PotentialPair<3> next = swapped(describe_face_vertex(b, a, -to_b, swapped(pair), options, contact));
  turn_round(to_b, contact);
  return next;
}

PotentialPair<3> describe_edges(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                const PotentialPair<3>& pair, const Vector<3>& normal,
                                const DetectOptions& options, Contact<3>& contact) {
  const PotentialPair<3> face = describe_edges_in_face(a, b, to_b, pair, normal, options, contact);
  return face == pair ? describe_edge_edge(a, b, to_b, pair, normal, contact) : face;
}

/// The same for any pair. Edges that have ceased to be a potential pair become the least deep of their faces.
PotentialPair<3> describe_at(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                             PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact) {
  if (pair.kind == PotentialPair<3>::edge_edge) {
    const Vector<3> normal = edge_pair_normal(a, pair.a, b, pair.b);
    if (is_edge_pair(a, pair.a, b, pair.b, normal))
      return describe_edges(a, b, to_b, pair, normal, options, contact);
    pair = FacesAtEdges(a, b, pair).least_deep(a, b, to_b);
  }
  return describe_faces(a, b, to_b, pair, options, contact);
}

}  // namespace

void describe_contact(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                      PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact) {
  PotentialPair<3> last = pair;
  for (int moves = a.topology->edge_count + b.topology->edge_count;; --moves) {
    const PotentialPair<3> next = describe_at(a, b, to_b, pair, options, contact);
    // A vertex of separated blocks may lie beyond the edge between two facets on the way from either: it
    // stays.
    if (next == pair || next == last || moves == 0) break;
    last = pair;
    pair = next;
  }
  contact.pair = pair;
  share_stiffness(options, contact);
}

}  // namespace halfspace
