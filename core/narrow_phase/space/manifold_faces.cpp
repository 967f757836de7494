#include "narrow_phase/space/manifold_faces.h"

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/space/contact_plane.h"
#include "narrow_phase/space/face_overlap.h"
#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/potential_pairs.h"

namespace halfspace {
namespace {

/// A face and a vertex in coordinates on the plane, with the foot of the vertex as origin.
struct FlatFaceVertex : FaceVertex<SeenOutline> {
  PlaneFrame plane = PlaneFrame(normal, foot);
  FlatFace polygon = FlatFace(plane, owner, face, Vector<3>::Zero());

  explicit FlatFaceVertex(const FaceVertex<SeenOutline>& f) : FaceVertex(f) {}
  FlatFaceVertex(const FlatFaceVertex&) = delete;  // the polygon refers to the plane
  FlatFaceVertex& operator=(const FlatFaceVertex&) = delete;

  /// Rounding error of points near the face in its plane: a few ulps of the subtracted coordinates.
  double rounding = rounding_of_points();

 private:
  double rounding_of_points() const {
    double reach = to_other.cwiseAbs().maxCoeff();
    for (int i = 0; i < polygon.count(); ++i)
      reach = std::max(reach, owner.vertex(polygon.vertex(i)).cwiseAbs().maxCoeff());
    return place_rounding * reach;
  }
};

/// An edge of the other block at the vertex, by its other end, and the sine of its angle to the plane.
struct FacingNeighbour {
  int far_vertex;
  double sine;
};

/// The edge most nearly parallel to the plane.
FacingNeighbour facing_edge(const FaceVertex<SeenOutline>& f) {
  const Topology& topology = *f.other.topology;
  FacingNeighbour best{topology.vertex_neighbour[topology.first_of_vertex[f.vertex]], HUGE_VAL};
  for (int k = topology.first_of_vertex[f.vertex]; k < topology.first_of_vertex[f.vertex + 1]; ++k) {
    const Vector<3> along = f.other.vertex(topology.vertex_neighbour[k]) - f.position;
    const double climb = f.normal.dot(along), square = climb * climb / along.squaredNorm();
    best = square < best.sine ? FacingNeighbour{topology.vertex_neighbour[k], square} : best;
  }
  return {best.far_vertex, std::sqrt(best.sine)};
}

/// A face of the other block at the vertex, and its overlap with the face.
struct FacingFace {
  int face = -1;
  double sine = 1;  // of its angle to the plane
  Vector<2> slope;  // of its height over the plane, which is linear and 0 at the origin
  FaceOverlap overlap;

  bool is_there() const { return overlap.area > 0; }
};

/// The deepest of all overlapping faces within an angle of the plane. If several have the deepest point, the
/// one most nearly parallel. The angle alone could select a face of far smaller depth.
FacingFace facing_face(const FlatFaceVertex& f, double angle) {
  const Topology& topology = *f.other.topology;
  FacingFace best;
  for (int k = topology.first_of_vertex[f.vertex]; k < topology.first_of_vertex[f.vertex + 1]; ++k) {
    const int face = topology.vertex_face[k];
    const Vector<3> normal = f.other.normal(face);
    const double cosine = -normal.dot(f.normal);
    if (cosine <= 0) continue;
    FacingFace found;
    found.face = face;
    found.sine = cross_product(normal, f.normal).norm();
    if (found.sine >= angle) continue;
    found.slope = f.plane.in_plane(normal) / cosine;
    found.overlap =
        overlap_of(FlatFace(f.plane, f.other, face, f.to_other), f.polygon, found.slope, f.rounding);
    if (!found.is_there()) continue;
    const double deeper = best.overlap.lowest - found.overlap.lowest;
    if (!best.is_there() || deeper > f.rounding || (deeper >= -f.rounding && found.sine < best.sine))
      best = found;
  }
  return best;
}

void describe_face_face(const FlatFaceVertex& f, const FacingFace& facing, Contact<3>& contact) {
  const FaceOverlap& overlap = facing.overlap;
  contact.type = ContactType::face_face;
  contact.area = overlap.area;
  contact.length = 0;
  contact.gap = f.gap + overlap.lowest;
  contact.center = f.plane.at(overlap.centroid);
  contact.center_gap = f.gap + facing.slope.dot(overlap.centroid);
  contact.point_count = overlap.count;
  for (int i = 0; i < overlap.count; ++i) {
    contact.points[i] = f.plane.at(overlap.corner[i]);
    contact.gaps[i] = f.gap + facing.slope.dot(overlap.corner[i]);
  }
}

/// The pair, or that of the facing face if its depth is smaller, so that the plane does not depend on the
/// face through which the blocks met. The facing face is the deeper one if a corner of the face is clearly
/// farther behind it than the vertex is behind the face.
PotentialPair<3> less_deep(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                           const FlatFaceVertex& f, const FacingFace& facing, const PotentialPair<3>& pair) {
  const double clear = -std::abs(f.gap) * facing.slope.squaredNorm();
  for (int i = 0; i < f.polygon.count(); ++i)
    if (facing.slope.dot(f.polygon.corner(i)) <= clear) return pair;
  PotentialPair<3> own = pair, other{PotentialPair<3>::vertex_face, f.polygon.vertex(0), facing.face};
  return refresh(a, b, to_b, other) > refresh(a, b, to_b, own) ? other : pair;
}

/// False when the edge does not pass over the face.
bool describe_edge_face(const FlatFaceVertex& f, int far_vertex, Contact<3>& contact) {
  const Vector<3> along = f.other.vertex(far_vertex) - f.position;
  const Vector<2> end = f.plane.in_plane(along);
  const SegmentPart part = part_over(f.polygon, Vector<2>::Zero(), end, f.rounding);
  if (part.from >= part.to) return false;
  const double climb = f.normal.dot(along);
  contact.type = ContactType::edge_face;
  contact.area = 0;
  contact.length = (part.to - part.from) * end.norm();
  contact.point_count = 2;
  const double places[] = {part.from, part.to};
  for (int i = 0; i < 2; ++i) {
    contact.points[i] = f.plane.at(places[i] * end);
    contact.gaps[i] = f.gap + places[i] * climb;
  }
  contact.gap = std::min(contact.gaps[0], contact.gaps[1]);
  contact.center = 0.5 * (contact.points[0] + contact.points[1]);
  contact.center_gap = 0.5 * (contact.gaps[0] + contact.gaps[1]);
  return true;
}

/// The place of the vertex's foot relative to the nearest edge of the face, or to the one farthest exceeded.
struct Place {
  int corner = 0;             // of the face, start of the edge
  double beyond = -HUGE_VAL;  // distance from the edge, outward
  double zone = 0;            // distance that counts as on the edge
  double along = 0;           // from the corner
  double length = 0;          // of the edge
};

/// `facing_length` is the length of the other block's edge: a fraction of a long plate's own length could
/// exceed small grains.
Place place_of_foot(const FlatFaceVertex& f, double facing_length, const DetectOptions& options) {
  Place place;
  for (int i = 0; i < f.polygon.count(); ++i) {
    const Vector<2> start = f.polygon.corner(i), edge = f.polygon.corner(f.polygon.next(i)) - start;
    const double length = edge.norm();
    if (length == 0) continue;                          // vanishes in rounding, far from the foot
    const double beyond = cross(edge, start) / length;  // of the origin
    const double zone = options.vertex_zone * std::min(length, facing_length);
    if (beyond - zone <= place.beyond - place.zone) continue;
    place = {i, beyond, zone, -edge.dot(start) / length, length};
  }
  return place;
}

/// Two vertices meet: the normal is that of the sum of the normals of all potential pairs whose facets of the
/// Minkowski difference meet there, including `f` (section 2.5).
void describe_vertex_vertex(const FaceVertex<SeenOutline>& f, int vertex_of_owner, Contact<3>& contact) {
  const Topology &of_owner = *f.owner.topology, &of_other = *f.other.topology;
  const auto is_deepest = [](const SeenOutline& block, int vertex, const Vector<3>& normal) {
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
    const SeenEdge edge(f.owner, of_owner.vertex_edge[k]);
    for (int j = of_other.first_of_vertex[f.vertex]; j < of_other.first_of_vertex[f.vertex + 1]; ++j) {
      const SeenEdge edge_of_other(f.other, of_other.vertex_edge[j]);
      const Vector<3> normal = Parallelogram(edge, edge_of_other.along).normal();
      if (is_edge_pair(edge, edge_of_other, normal)) of_edges += normal;
    }
  }
  const Vector<3> point = f.owner.vertex(vertex_of_owner);
  contact.normal = (of_faces + of_faces_of_other + of_edges).normalized();
  contact.gap = contact.normal.dot((f.position - point) + f.to_other);
  describe_point(ContactType::vertex_vertex, point, contact);
}

/// The point at a fraction of the length of the edge nearest to the foot.
Vector<3> point_of_border(const FlatFaceVertex& f, const Place& place, double share) {
  const Vector<3> start = f.owner.vertex(f.polygon.vertex(place.corner));
  const Vector<3> end = f.owner.vertex(f.polygon.vertex(f.polygon.next(place.corner)));
  return start + share * (end - start);
}

/// A vertex meets an edge: the normal is that of the sum of both half-spaces' normals (section 2.5).
void describe_vertex_edge(const FlatFaceVertex& f, const Vector<3>& normal_across, const Place& place,
                          Contact<3>& contact) {
  const Vector<3> point = point_of_border(f, place, place.along / place.length);
  contact.normal = (f.normal + normal_across).normalized();
  contact.gap = contact.normal.dot((f.position - point) + f.to_other);
  describe_point(ContactType::vertex_edge, point, contact);
}

/// The foot of the vertex is outside the face: the contact is at the border, with the face's normal and gap.
/// A normal between two faces would give a depth between points that are apart.
void describe_border(const FlatFaceVertex& f, const Place& place, Contact<3>& contact) {
  const double share = place.along / place.length;
  const bool at_corner = share <= 0 || share >= 1;
  describe_point(at_corner ? ContactType::vertex_vertex : ContactType::vertex_edge,
                 point_of_border(f, place, std::clamp(share, 0.0, 1.0)), contact);
}

/// The number of points of the region behind the contact plane.
int overlapping_point_count(const Contact<3>& contact) {
  return int(
      std::count_if(contact.gaps, contact.gaps + contact.point_count, [](double gap) { return gap < 0; }));
}

/// The largest distance of a point from the deepest one.
double reach_from_deepest(const Contact<3>& contact) {
  const auto deepest = std::min_element(contact.gaps, contact.gaps + contact.point_count) - contact.gaps;
  double reach = 0;
  for (int i = 0; i < contact.point_count; ++i)
    reach = std::max(reach, (contact.points[i] - contact.points[deepest]).squaredNorm());
  return std::sqrt(reach);
}

/// Has a tilted region more overlapping points than a simpler contact, and does it end before region_angle()?
bool bears_tilted(const Contact<3>& contact, int points, const DetectOptions& options) {
  return overlapping_point_count(contact) > points &&
         options.outlasts(reach_from_deepest(contact), -contact.gap);
}

/// Describes the region of a face with a nearly parallel face of the other block at the vertex. Beyond the
/// parallel angle it needs more overlapping points than an edge has. False if there is none.
bool describe_region_of_face(const FlatFaceVertex& f, const FacingFace& face, const DetectOptions& options,
                             Contact<3>& contact) {
  contact.normal = f.normal;
  contact.gap = f.gap;
  if (!face.is_there()) return false;
  describe_face_face(f, face, contact);
  return face.sine < options.parallel_angle || bears_tilted(contact, 2, options);
}

/// The same for an edge, which needs more overlapping points than a vertex has.
bool describe_region_of_edge(const FlatFaceVertex& f, const FacingNeighbour& edge,
                             const DetectOptions& options, Contact<3>& contact) {
  if (edge.sine < options.region_angle() && describe_edge_face(f, edge.far_vertex, contact)) {
    if (edge.sine < options.parallel_angle || bears_tilted(contact, 1, options)) return true;
  }
  contact.gap = f.gap;
  return false;
}

}  // namespace

bool describe_face_region(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                          const PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact) {
  const FlatFaceVertex f({a, b, to_b, pair.a, pair.b});
  return describe_region_of_face(f, facing_face(f, options.region_angle()), options, contact) ||
         describe_region_of_edge(f, facing_edge(f), options, contact);
}

PotentialPair<3> describe_face_vertex(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                      const PotentialPair<3>& pair, const DetectOptions& options,
                                      Contact<3>& contact) {
  const FlatFaceVertex f({a, b, to_b, pair.a, pair.b});
  const FacingFace facing = facing_face(f, options.region_angle());
  if (describe_region_of_face(f, facing, options, contact)) return less_deep(a, b, to_b, f, facing, pair);
  const FacingNeighbour edge = facing_edge(f);
  if (describe_region_of_edge(f, edge, options, contact)) return pair;

  const double facing_length = (b.vertex(edge.far_vertex) - f.position).norm();
  const Place place = place_of_foot(f, facing_length, options);
  if (place.beyond < -place.zone) {
    describe_point(ContactType::vertex_face, f.foot, contact);
    return pair;
  }
  const int edge_of_face = a.topology->face_edge[a.topology->first_of_face[f.face] + place.corner];
  const Facet across =
      facet_across(a, b, side_along(*a.topology, 0, f.face, edge_of_face, f.vertex), f.normal);
  if (place.beyond > place.zone) {
    // A temporary contact until the pair has moved. It remains if the pair cannot move: between blocks with
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

}  // namespace halfspace
