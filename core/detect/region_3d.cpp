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

/// An edge of each block, both seen from their own block's centroid.
struct MeetingEdges {
  PotentialPair<3> pair;
  SeenEdge a;
  SeenEdge b;
  Parallelogram across{a, b.along};

  MeetingEdges(const SeenOutline& block_a, const SeenOutline& block_b, const PotentialPair<3>& edges)
      : pair(edges), a(block_a, edges.a), b(block_b, edges.b) {}

  bool are_potential_pair() const { return is_edge_pair(a, b, across.normal); }

  /// Are they plainly a potential pair, whose plane no face at either edge is near to parallel with? By the
  /// four signs of edge and face normal (THEORY section 2), with a margin: at the edge of a, the sine of the
  /// angle between face and plane is left . along_b |along_a| / area. Edges that are all but parallel to each
  /// other have no plane to go by.
  bool cross_steeply(double parallel_angle) const {
    constexpr double flat = 1e-6;  // rad: far above rounding
    const double sense = across.area < 0 ? -1 : 1, area_square = across.area * across.area;
    const double least_of_a = std::min(sense * a.left.dot(b.along), -sense * a.right.dot(b.along));
    const double least_of_b = std::min(sense * b.left.dot(a.along), -sense * b.right.dot(a.along));
    const double a_square = a.along.squaredNorm(), b_square = b.along.squaredNorm();
    const double steep = 1.001 * std::max(parallel_angle * parallel_angle, flat * flat) * area_square;
    return least_of_a > 0 && least_of_b > 0 && least_of_a * least_of_a * a_square > steep &&
           least_of_b * least_of_b * b_square > steep && area_square > flat * flat * a_square * b_square;
  }
};

/// Of an edge of each block: the nearest points of their lines, and the middle between them. Returns the
/// pair, or the neighbouring one when one of these points lies beyond an end of its edge: then this is the
/// contact at the end.
PotentialPair<3> describe_edge_edge(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                    const MeetingEdges& edges, Contact<3>& contact) {
  const Vector<3>& normal = edges.across.normal;
  const Vector<3>&along_a = edges.a.along, &along_b = edges.b.along;
  const Vector<3> between = (edges.b.start - edges.a.start) + to_b;
  const double s = cross_product(between, along_b).dot(normal) / edges.across.area;
  const double t = cross_product(between, along_a).dot(normal) / edges.across.area;
  const Vector<3> on_a = edges.a.start + std::clamp(s, 0.0, 1.0) * along_a;
  const Vector<3> on_b = (edges.b.start + to_b) + std::clamp(t, 0.0, 1.0) * along_b;
  contact.normal = normal;
  contact.gap = normal.dot(between);
  describe_point(ContactType::edge_edge, 0.5 * (on_a + on_b), contact);

  const PotentialPair<3>& pair = edges.pair;
  const double share_beyond_a = std::max(-s, s - 1), share_beyond_b = std::max(-t, t - 1);
  if (std::max(share_beyond_a, share_beyond_b) <= 0) return pair;
  const double beyond_a = share_beyond_a * along_a.norm(), beyond_b = share_beyond_b * along_b.norm();
  const Topology &of_a = *a.topology, &of_b = *b.topology;
  const FacetSide side =
      beyond_a >= beyond_b
          ? side_at_end(b, 1, pair.b, a, pair.a, s < 0 ? of_a.edge_start[pair.a] : of_a.edge_end[pair.a])
          : side_at_end(a, 0, pair.a, b, pair.b, t < 0 ? of_b.edge_start[pair.b] : of_b.edge_end[pair.b]);
  return facet_across(a, b, side, normal).pair;
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
};

/// Which of the faces at two edges, in the order of FacesAtEdges, is nearest to parallel with the plane of
/// both, if it is within an angle of it; -1 else.
int face_parallel_to(const MeetingEdges& edges, double angle) {
  const Vector<3>& normal = edges.across.normal;
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

/// Two edges that cross nearly in the plane of a face, as they do where a face comes down on another one
/// askew, touch as the face does if it has a region. The pair becomes that of the face then; else false.
bool describe_edges_in_face(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                            const MeetingEdges& edges, const DetectOptions& options, PotentialPair<3>& pair,
                            Contact<3>& contact) {
  const int parallel = face_parallel_to(edges, options.parallel_angle);
  if (parallel < 0) return false;
  PotentialPair<3> face = FacesAtEdges(a, b, edges.pair).pair[parallel];
  refresh(a, b, to_b, face);
  const bool is_of_a = face.kind == PotentialPair<3>::face_vertex;
  if (!(is_of_a ? describe_face_region(a, b, to_b, face, options, contact)
                : describe_face_region(b, a, -to_b, swapped(face), options, contact)))
    return false;
  if (!is_of_a) turn_round(to_b, contact);
  pair = face;
  return true;
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

/// The same for any pair. Edges that have ceased to be a potential pair become the least deep of their faces.
PotentialPair<3> describe_at(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                             PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact) {
  if (pair.kind == PotentialPair<3>::edge_edge) {
    const MeetingEdges edges(a, b, pair);
    if (edges.cross_steeply(options.parallel_angle)) return describe_edge_edge(a, b, to_b, edges, contact);
    if (edges.are_potential_pair())
      return describe_edges_in_face(a, b, to_b, edges, options, pair, contact)
                 ? pair
                 : describe_edge_edge(a, b, to_b, edges, contact);
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
