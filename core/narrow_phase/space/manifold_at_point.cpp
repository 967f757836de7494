#include "narrow_phase/space/manifold_at_point.h"

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/space/manifold_edges.h"
#include "narrow_phase/space/manifold_faces.h"
#include "narrow_phase/space/witness.h"

// Most of a step's time is spent here. Separated from rare cases, so that all data stays in registers.

namespace halfspace {
namespace {

// Block is an Outline<3>, whose frame is that of the contact, or a SeenOutline.

const Outline<3>& in_itself(const Outline<3>& block) { return block; }
const Outline<3>& in_itself(const SeenOutline& block) { return block.unturned(); }
const Vector<3>& in_frame_of(const Outline<3>&, const Vector<3>& v) { return v; }
Vector<3> in_frame_of(const SeenOutline& block, const Vector<3>& v) { return block.in_own_frame(v); }

/// How far the part of a block that can have a region reaches behind a plane with a given normal, from a
/// vertex at a given gap; squared. 0 where all edges at the vertex are steeper than the region angle, as then
/// the faces between them are. Beyond the parallel angle edges and faces leave the plane before their region
/// has more overlapping points than the vertex, unless their other ends overlap, too: then, and along the
/// plane, HUGE_VAL. With margins far above rounding.
template <class Block>
double squared_reach(const Block& block, int vertex, const Vector<3>& normal, double gap,
                     const DetectOptions& options) {
  const Outline<3>& own = in_itself(block);
  const Topology& topology = *own.topology;
  const Vector<3>& upward = in_frame_of(block, normal);
  const Vector<3> from = own.vertex(vertex);
  const double steep = proof_margin * options.region_angle() * options.region_angle();
  const double tilted = proof_margin * options.parallel_angle * options.parallel_angle;
  const double depth = proof_margin * std::max(-gap, 0.0);
  double reach = 0;
  for (int k = topology.first_of_vertex[vertex]; k < topology.first_of_vertex[vertex + 1]; ++k) {
    const Vector<3> along = own.vertex(topology.vertex_neighbour[k]) - from;
    const double climb = upward.dot(along), square = climb * std::abs(climb), length = along.squaredNorm();
    if (square > steep * length) continue;
    if (square <= tilted * length || climb <= depth) return HUGE_VAL;
    reach = std::max(reach, depth * depth * length / square);
  }
  return reach;
}

/// The places of two points in a face's plane.
struct PlacesOnFace {
  bool is_well_inside;
  bool is_other_on_face;
};

/// Is `point` inside the face by more than the zone of its border, with a margin, and by more than a
/// distance, given squared? Is `other` on the face?
template <class Block>
PlacesOnFace places_on_face(const Block& block, int face, const Vector<3>& point, const Vector<3>& other,
                            double vertex_zone, double reach) {
  const Outline<3>& own = in_itself(block);
  const Topology& topology = *own.topology;
  const Vector<3> normal = own.normal(face);
  const Vector<3>&p = in_frame_of(block, point), &q = in_frame_of(block, other);
  const int first = topology.first_of_face[face], end = topology.first_of_face[face + 1];
  bool is_other_on_face = true;
  Vector<3> from = own.vertex(topology.face_vertex[end - 1]);
  for (int k = first; k < end; ++k) {
    const Vector<3> to = own.vertex(topology.face_vertex[k]), along = to - from;
    const Vector<3> inward = cross_product(normal, along);  // its length is that of the edge
    const double inside = inward.dot(p - from), square = along.squaredNorm();
    if (inside <= 2 * vertex_zone * square || inside * inside < reach * square) return {false, false};
    is_other_on_face &= inward.dot(q - from) >= 0;
    from = to;
  }
  return {true, is_other_on_face};
}

template <class Block>
Plain describe_vertex_inside_face(const Block& a, const Block& b, const Vector<3>& to_b,
                                  const PotentialPair<3>& pair, const DetectOptions& options,
                                  Contact<3>& contact) {
  const bool is_of_a = pair.kind == PotentialPair<3>::face_vertex;
  const Block &owner = is_of_a ? a : b, &other = is_of_a ? b : a;
  const int face = is_of_a ? pair.a : pair.b, vertex = is_of_a ? pair.b : pair.a;
  const double sense = is_of_a ? 1 : -1;
  const FaceVertex<Block> f{owner, other, sense * to_b, face, vertex};
  const double reach = squared_reach(other, vertex, f.normal, f.gap, options);
  if (reach == HUGE_VAL) return Plain::no;
  // The line from the vertex parallel to that between the centroids: see edges_cross().
  const double rise = f.normal.dot(f.to_other);
  const double back = rise > 0 ? f.gap / rise : 0;
  const Vector<3> pierced = (f.position + f.to_other) - back * f.to_other;
  const PlacesOnFace places = places_on_face(owner, face, f.foot, pierced, options.vertex_zone, reach);
  if (!places.is_well_inside) return Plain::no;
  contact.normal = sense * f.normal;
  contact.gap = f.gap;
  describe_point(ContactType::vertex_face, f.foot + (is_of_a ? 0.0 : 1.0) * to_b, contact);
  return f.gap <= 0 && rise > 0 && places.is_other_on_face ? Plain::and_touching : Plain::yes;
}

template <class Block>
Plain describe_crossing_edges(const Block& a, const Block& b, const Vector<3>& to_b,
                              const PotentialPair<3>& pair, const DetectOptions& options,
                              Contact<3>& contact) {
  const MeetingEdges edges(a, b, pair);
  if (!edges.cross_steeply(options.region_angle())) return Plain::no;
  const NearestPoints nearest(edges, to_b);
  if (!nearest.are_on_edges()) return Plain::no;
  describe_edge_edge(edges, nearest, to_b, contact);
  return edges_cross(edges.a.along, edges.b.along, edges.parallelogram.across, nearest.between, to_b)
             ? Plain::and_touching
             : Plain::yes;
}

template <class Block>
Plain describe(const Block& a, const Block& b, const Vector<3>& to_b, const PotentialPair<3>& pair,
               const DetectOptions& options, Contact<3>& contact) {
  return pair.kind == PotentialPair<3>::edge_edge
             ? describe_crossing_edges(a, b, to_b, pair, options, contact)
             : describe_vertex_inside_face(a, b, to_b, pair, options, contact);
}

}  // namespace

Plain describe_plain_contact(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                             const PotentialPair<3>& pair, const DetectOptions& options,
                             Contact<3>& contact) {
  return a.is_turned() || b.is_turned() ? describe(a, b, to_b, pair, options, contact)
                                        : describe(a.unturned(), b.unturned(), to_b, pair, options, contact);
}

}  // namespace halfspace
