#include <algorithm>
#include <cmath>
#include <limits>

#include "detect/pair_3d.h"
#include "detect/potential_pairs_3d.h"
#include "detect/region_3d_overlap.h"
#include "detect/region_3d_plane.h"
#include "detect/region_3d_shares.h"

namespace halfspace {
namespace {

/// A face and a vertex behind or before it, seen from the block that owns the face. The plane's origin is the
/// foot of the vertex.
struct FaceVertex {
  const Outline<3>& owner;
  const Outline<3>& other;
  Vector<3> to_other;
  int face;
  int vertex;
  Vector<3> normal = owner.normal(face);
  double gap = (normal.dot(other.vertex(vertex)) + normal.dot(to_other)) - owner.offset[face];
  PlaneFrame plane = PlaneFrame(normal, (other.vertex(vertex) + to_other) - gap * normal);
  FlatFace polygon = FlatFace(plane, owner, face, Vector<3>::Zero());

  FaceVertex(const Outline<3>& owner_of_face, const Outline<3>& owner_of_vertex,
             const Vector<3>& to_vertex_owner, int f, int v)
      : owner(owner_of_face), other(owner_of_vertex), to_other(to_vertex_owner), face(f), vertex(v) {}
  FaceVertex(const FaceVertex&) = delete;  // the polygon refers to the plane
  FaceVertex& operator=(const FaceVertex&) = delete;

  /// How far rounding may put points near the face off in its plane: a few units of what was subtracted.
  double rounding() const {
    double reach = to_other.cwiseAbs().maxCoeff();
    for (int i = 0; i < polygon.count(); ++i)
      reach = std::max(reach, owner.vertex(polygon.vertex(i)).cwiseAbs().maxCoeff());
    return 16 * std::numeric_limits<double>::epsilon() * reach;
  }
};

/// What of the other block, at the vertex, is nearest to parallel with the plane, and the sine of the angle
/// between.
struct Facing {
  int index;
  double sine;
};

Facing facing_face(const FaceVertex& f) {
  const Topology& topology = *f.other.topology;
  int best = topology.vertex_face[topology.first_of_vertex[f.vertex]];
  double most_opposed = HUGE_VAL;
  for (int k = topology.first_of_vertex[f.vertex]; k < topology.first_of_vertex[f.vertex + 1]; ++k) {
    const double cosine = f.other.normal(topology.vertex_face[k]).dot(f.normal);
    if (cosine >= most_opposed) continue;
    most_opposed = cosine;
    best = topology.vertex_face[k];
  }
  return {best, most_opposed < 0 ? cross_product(f.other.normal(best), f.normal).norm() : 1};
}

/// Of edges, by the neighbour at the far end.
Facing facing_edge(const FaceVertex& f) {
  const Topology& topology = *f.other.topology;
  Facing best{topology.vertex_neighbour[topology.first_of_vertex[f.vertex]], HUGE_VAL};
  for (int k = topology.first_of_vertex[f.vertex]; k < topology.first_of_vertex[f.vertex + 1]; ++k) {
    const Vector<3> along = f.other.vertex(topology.vertex_neighbour[k]) - f.other.vertex(f.vertex);
    const double sine = std::abs(f.normal.dot(along)) / along.norm();
    if (sine < best.sine) best = {topology.vertex_neighbour[k], sine};
  }
  return best;
}

void describe_point(ContactType type, const Vector<3>& point, Contact<3>& contact) {
  contact.type = type;
  contact.area = contact.length = 0;
  contact.point_count = 1;
  contact.center = contact.points[0] = point;
  contact.center_gap = contact.gaps[0] = contact.gap;
}

/// False when the faces do not overlap.
bool describe_face_face(const FaceVertex& f, int facing, Contact<3>& contact) {
  const Vector<3> normal = f.other.normal(facing);
  // Over the plane the facing face is linear, and it goes through the vertex before the origin.
  const Vector<2> slope = f.plane.in_plane(normal) / -normal.dot(f.normal);
  const FaceOverlap overlap =
      overlap_of(FlatFace(f.plane, f.other, facing, f.to_other), f.polygon, slope, f.rounding());
  if (overlap.area == 0) return false;
  contact.type = ContactType::face_face;
  contact.area = overlap.area;
  contact.length = 0;
  contact.gap = f.gap + overlap.lowest;
  contact.center = f.plane.at(overlap.centroid);
  contact.center_gap = f.gap + slope.dot(overlap.centroid);
  contact.point_count = overlap.count;
  for (int i = 0; i < overlap.count; ++i) {
    contact.points[i] = f.plane.at(overlap.corner[i]);
    contact.gaps[i] = f.gap + slope.dot(overlap.corner[i]);
  }
  return true;
}

/// False when the edge does not pass over the face.
bool describe_edge_face(const FaceVertex& f, int far_vertex, Contact<3>& contact) {
  const Vector<3> along = f.other.vertex(far_vertex) - f.other.vertex(f.vertex);
  const Vector<2> end = f.plane.in_plane(along);
  const SegmentPart part = part_over(f.polygon, Vector<2>::Zero(), end, f.rounding());
  if (part.from >= part.to) return false;
  const double climb = f.normal.dot(along);
  contact.type = ContactType::edge_face;
  contact.area = 0;
  contact.length = (part.to - part.from) * end.norm();
  contact.point_count = 2;
  const double shares[] = {part.from, part.to};
  for (int i = 0; i < 2; ++i) {
    contact.points[i] = f.plane.at(shares[i] * end);
    contact.gaps[i] = f.gap + shares[i] * climb;
  }
  contact.gap = std::min(contact.gaps[0], contact.gaps[1]);
  contact.center = 0.5 * (contact.points[0] + contact.points[1]);
  contact.center_gap = 0.5 * (contact.gaps[0] + contact.gaps[1]);
  return true;
}

/// Where the foot of the vertex lies by the edge of the face that it is nearest to, or farthest beyond.
struct Place {
  int corner = 0;             // the edge goes from this corner of the face
  double beyond = -HUGE_VAL;  // distance from the edge, outward
  double zone = 0;            // so near counts as on it
  double along = 0;           // from the corner
  double length = 0;          // of the edge
};

/// `facing_length` is that of the other block's edge that faces the face: on a long plate a share of the
/// plate's own length would swallow whole grains.
Place place_of_foot(const FaceVertex& f, double facing_length, const DetectOptions& options) {
  Place place;
  for (int i = 0; i < f.polygon.count(); ++i) {
    const Vector<2> start = f.polygon.corner(i), edge = f.polygon.corner(f.polygon.next(i)) - start;
    const double length = edge.norm();
    const double beyond = cross(edge, start) / length;  // of the origin
    const double zone = options.vertex_zone * std::min(length, facing_length);
    if (beyond - zone <= place.beyond - place.zone) continue;
    place = {i, beyond, zone, -edge.dot(start) / length, length};
  }
  return place;
}

/// A vertex of each block meet: the normal is that of the sum of the normals of all potential pairs whose
/// facets of the Minkowski difference come together there, `f` one of them (section 2.5).
void describe_vertex_vertex(const FaceVertex& f, int vertex_of_owner, Contact<3>& contact) {
  const Topology &of_owner = *f.owner.topology, &of_other = *f.other.topology;
  const auto is_deepest = [](const Outline<3>& block, int vertex, const Vector<3>& normal) {
    const Topology& t = *block.topology;
    return std::all_of(
        t.vertex_neighbour + t.first_of_vertex[vertex], t.vertex_neighbour + t.first_of_vertex[vertex + 1],
        [&](int neighbour) { return normal.dot(block.vertex(neighbour) - block.vertex(vertex)) >= 0; });
  };
  Vector<3> of_faces = f.normal;
  for (int k = of_owner.first_of_vertex[vertex_of_owner]; k < of_owner.first_of_vertex[vertex_of_owner + 1];
       ++k) {
    const int face = of_owner.vertex_face[k];
    if (face != f.face && is_deepest(f.other, f.vertex, f.owner.normal(face)))
      of_faces += f.owner.normal(face);
  }
  Vector<3> of_faces_of_other = Vector<3>::Zero();
  for (int k = of_other.first_of_vertex[f.vertex]; k < of_other.first_of_vertex[f.vertex + 1]; ++k) {
    const Vector<3> normal = f.other.normal(of_other.vertex_face[k]);
    if (is_deepest(f.owner, vertex_of_owner, normal)) of_faces_of_other -= normal;
  }
  Vector<3> of_edges = Vector<3>::Zero();
  for (int k = of_owner.first_of_vertex[vertex_of_owner]; k < of_owner.first_of_vertex[vertex_of_owner + 1];
       ++k) {
    for (int j = of_other.first_of_vertex[f.vertex]; j < of_other.first_of_vertex[f.vertex + 1]; ++j) {
      const int edge = of_owner.vertex_edge[k], edge_of_other = of_other.vertex_edge[j];
      if (is_edge_pair(f.owner, edge, f.other, edge_of_other))
        of_edges += edge_pair_normal(f.owner, edge, f.other, edge_of_other);
    }
  }
  const Vector<3> point = f.owner.vertex(vertex_of_owner);
  contact.normal = (of_faces + of_faces_of_other + of_edges).normalized();
  contact.gap = contact.normal.dot((f.other.vertex(f.vertex) - point) + f.to_other);
  describe_point(ContactType::vertex_vertex, point, contact);
}

/// The point of the face's border at a share of the length of the edge that the foot lies by.
Vector<3> point_of_border(const FaceVertex& f, const Place& place, double share) {
  const Vector<3> start = f.owner.vertex(f.polygon.vertex(place.corner));
  const Vector<3> end = f.owner.vertex(f.polygon.vertex(f.polygon.next(place.corner)));
  return start + share * (end - start);
}

/// A vertex meets an edge: the normal is that of the sum of both half-spaces' normals (section 2.5).
void describe_vertex_edge(const FaceVertex& f, const Vector<3>& normal_across, const Place& place,
                          Contact<3>& contact) {
  const Vector<3> point = point_of_border(f, place, place.along / place.length);
  contact.normal = (f.normal + normal_across).normalized();
  contact.gap = contact.normal.dot((f.other.vertex(f.vertex) - point) + f.to_other);
  describe_point(ContactType::vertex_edge, point, contact);
}

/// The foot of the vertex lies outside the face: the contact is at the border then, with the face's own
/// normal and gap. A normal between two faces would find a depth between points that lie apart.
void describe_border(const FaceVertex& f, const Place& place, Contact<3>& contact) {
  const double share = place.along / place.length;
  const bool at_corner = share <= 0 || share >= 1;
  describe_point(at_corner ? ContactType::vertex_vertex : ContactType::vertex_edge,
                 point_of_border(f, place, std::clamp(share, 0.0, 1.0)), contact);
}

/// The region of a face and what is parallel to it of the other block at the vertex: a face, or else an edge.
/// False when there is none.
bool describe_region(const FaceVertex& f, const Facing& edge, const DetectOptions& options,
                     Contact<3>& contact) {
  contact.normal = f.normal;
  contact.gap = f.gap;
  const Facing face = facing_face(f);
  return (face.sine < options.parallel_angle && describe_face_face(f, face.index, contact)) ||
         (edge.sine < options.parallel_angle && describe_edge_face(f, edge.index, contact));
}

/// Of a face of a and a vertex of b. Returns the pair, or the neighbouring one when the foot of the vertex
/// lies outside the face: then this is the contact at the edge or vertex of the face that it lies beyond.
PotentialPair<3> describe_face_vertex(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                      const PotentialPair<3>& pair, const DetectOptions& options,
                                      Contact<3>& contact) {
  const FaceVertex f(a, b, to_b, pair.a, pair.b);
  const Facing edge = facing_edge(f);
  if (describe_region(f, edge, options, contact)) return pair;

  const double facing_length = (b.vertex(edge.index) - b.vertex(f.vertex)).norm();
  const Place place = place_of_foot(f, facing_length, options);
  if (place.beyond < -place.zone) {
    describe_point(ContactType::vertex_face, f.plane.origin, contact);
    return pair;
  }
  const int edge_of_face = a.topology->face_edge[a.topology->first_of_face[f.face] + place.corner];
  const Facet across =
      facet_across(a, b, side_along(*a.topology, 0, f.face, edge_of_face, f.vertex), f.normal);
  if (place.beyond > place.zone) {
    // What stands in until the pair has moved, or where it cannot move on: between blocks that touch with
    // faces in one plane that only meet at their borders.
    describe_border(f, place, contact);
    return across.pair;
  }
  if (place.along <= place.zone) {
    describe_vertex_vertex(f, f.polygon.vertex(place.corner), contact);
  } else if (place.along >= place.length - place.zone) {
    describe_vertex_vertex(f, f.polygon.vertex(f.polygon.next(place.corner)), contact);
  } else {
    describe_vertex_edge(f, across.normal, place, contact);
  }
  return pair;
}

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
PotentialPair<3> describe_edge_edge(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
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

  const double beyond_a = std::max(-s, s - 1) * along_a.norm(),
               beyond_b = std::max(-t, t - 1) * along_b.norm();
  if (std::max(beyond_a, beyond_b) <= 0) return pair;
  const FacetSide side =
      beyond_a >= beyond_b
          ? side_at_end(b, 1, pair.b, a, pair.a, s < 0 ? start_of_a : a.topology->edge_end[pair.a])
          : side_at_end(a, 0, pair.a, b, pair.b, t < 0 ? start_of_b : b.topology->edge_end[pair.b]);
  return facet_across(a, b, side, contact.normal).pair;
}

/// The faces at two edges. Their vertices are only where to look for the deepest ones.
struct FacesAtEdges {
  PotentialPair<3> pair[4];

  FacesAtEdges(const Outline<3>& a, const Outline<3>& b, const PotentialPair<3>& edges) {
    using Pair = PotentialPair<3>;
    const Topology &of_a = *a.topology, &of_b = *b.topology;
    pair[0] = {Pair::face_vertex, of_a.edge_left[edges.a], of_b.edge_start[edges.b]};
    pair[1] = {Pair::face_vertex, of_a.edge_right[edges.a], of_b.edge_start[edges.b]};
    pair[2] = {Pair::vertex_face, of_a.edge_start[edges.a], of_b.edge_left[edges.b]};
    pair[3] = {Pair::vertex_face, of_a.edge_start[edges.a], of_b.edge_right[edges.b]};
  }

  /// That of least depth, with its vertex brought up to date.
  PotentialPair<3> least_deep(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b) {
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
  PotentialPair<3>* parallel_to(const Vector<3>& normal, double angle, const Outline<3>& a,
                                const Outline<3>& b) {
    PotentialPair<3>* best = nullptr;
    for (PotentialPair<3>& face : pair) {
      const Vector<3> of_face = normal_of(a, b, face);
      const double sine = cross_product(of_face, normal).norm();
      if (sine >= angle || of_face.dot(normal) <= 0) continue;
      best = &face;
      angle = sine;
    }
    return best;
  }
};

/// Two edges that cross nearly in the plane of a face, as they do where a face comes down on another one
/// askew, touch as the face does if it has a region. Returns its pair then, or that of the edges.
PotentialPair<3> describe_edges_in_face(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                        const PotentialPair<3>& edges, const Vector<3>& normal,
                                        const DetectOptions& options, Contact<3>& contact) {
  FacesAtEdges faces(a, b, edges);
  PotentialPair<3>* const found = faces.parallel_to(normal, options.parallel_angle, a, b);
  if (!found) return edges;
  PotentialPair<3>& face = *found;
  refresh(a, b, to_b, face);
  const auto is_region = [&](const FaceVertex& f) {
    return describe_region(f, facing_edge(f), options, contact);
  };
  if (face.kind == PotentialPair<3>::face_vertex)
    return is_region(FaceVertex(a, b, to_b, face.a, face.b)) ? face : edges;
  if (!is_region(FaceVertex(b, a, -to_b, face.b, face.a))) return edges;
  turn_round(to_b, contact);
  return face;
}

/// Returns the pair, or the one to move on to.
PotentialPair<3> describe_at(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const PotentialPair<3>& pair, const DetectOptions& options,
                             Contact<3>& contact) {
  switch (pair.kind) {
    case PotentialPair<3>::face_vertex:
      return describe_face_vertex(a, b, to_b, pair, options, contact);
    case PotentialPair<3>::vertex_face: {
      const PotentialPair<3> next =
          swapped(describe_face_vertex(b, a, -to_b, swapped(pair), options, contact));
      turn_round(to_b, contact);
      return next;
    }
    default: {
      const Vector<3> normal = edge_pair_normal(a, pair.a, b, pair.b);
      const PotentialPair<3> face = describe_edges_in_face(a, b, to_b, pair, normal, options, contact);
      return face == pair ? describe_edge_edge(a, b, to_b, pair, normal, contact) : face;
    }
  }
}

}  // namespace

void describe_contact(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PotentialPair<3>& pair,
                      const DetectOptions& options, Contact<3>& contact) {
  PotentialPair<3> last = pair;
  for (int moves = a.topology->edge_count + b.topology->edge_count;; --moves) {
    if (pair.kind == PotentialPair<3>::edge_edge && !is_edge_pair(a, pair.a, b, pair.b))
      pair = FacesAtEdges(a, b, pair).least_deep(a, b, to_b);
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
