#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/rotation.h"
#include "geometry/vector.h"

namespace halfspace {

/// Contact types (Wang et al. 2021, section 2.5). The values are those of the C API.
enum class ContactType : std::int32_t {
  none = 0,
  vertex_vertex = 1,
  vertex_edge = 2,
  edge_edge = 3,
  edge_face = 4,  // from here on in 3D only
  face_face = 5,
  vertex_face = 6
};

/// Settings of detection that affect only the type and region of a contact.
struct DetectOptions {
  double parallel_angle = 0.01;  // rad: edges (in 3D faces) at a smaller angle share a region
  double vertex_zone = 1e-6;     // fraction of the shorter edge's length at its end that counts as its vertex

  /// Up to this angle, above the parallel angle, features share a region while more of its points overlap
  /// than a simpler contact has: so no loaded spring is lost.
  double region_angle() const { return std::max(parallel_angle, std::min(15 * parallel_angle, 0.3)); }
  /// Does a tilted region of this length and depth end before it exceeds that angle?
  bool outlasts(double length, double depth) const { return depth <= length * region_angle(); }
};

/// A potential contact pair, which is a facet of the Minkowski difference of two blocks (Wang et al. 2021,
/// eqs. 9, 19 and 23).
template <int D>
struct PotentialPair;

/// In 2D identified by its edge alone: the vertex is the other block's deepest one behind it.
template <>
struct PotentialPair<2> {
  std::int32_t owner = 0;   // of the edge: 0 block a, 1 block b
  std::int32_t edge = 0;    // of the owner
  std::int32_t vertex = 0;  // of the other block
  friend bool operator==(const PotentialPair&, const PotentialPair&) = default;
};

/// In 3D a face of one block and the other's deepest vertex behind it, or an edge of each. For separated
/// blocks also a vertex of each, the deepest along the normal of a separating plane.
template <>
struct PotentialPair<3> {
  enum Kind : std::int32_t { face_vertex = 0, vertex_face = 1, edge_edge = 2, vertex_vertex = 3 };
  Kind kind = face_vertex;  // the features: first of block a, second of block b
  std::int32_t a = 0;       // index of the feature of block a
  std::int32_t b = 0;       // index of the feature of block b
  friend bool operator==(const PotentialPair&, const PotentialPair&) = default;
};

/// Does the pair define a contact plane? Two vertices only prove separation.
inline bool has_a_plane(const PotentialPair<2>&) { return true; }
inline bool has_a_plane(const PotentialPair<3>& pair) { return pair.kind != PotentialPair<3>::vertex_vertex; }

/// A violated potential pair, or the pair of minimum depth if none is violated, and its gap.
template <int D>
struct Separation;

/// The pair is identified by its edge; its vertex is only a start for the search of the deepest one, unless a
/// function documents more.
template <>
struct Separation<2> {
  double gap;
  PotentialPair<2> pair;
};

template <>
struct Separation<3> {
  double gap;
  PotentialPair<3> pair;
  Vector<3> normal;  // unit, from a to b
};

struct PairState {
  /// overlapping, in 3D: the blocks touch, but their pair has not been computed.
  enum State : std::int32_t { unknown = 0, separated = 1, touching = 2, overlapping = 3 };
};

/// The cached proof of the last result for a pair of blocks, tested first in the next step.
template <int D>
struct PairCache;

template <>
struct PairCache<2> {
  using State = PairState::State;
  using enum PairState::State;
  State state = unknown;
  /// Separated: the last violated pair, tested first. Touching: the pair of the contact plane.
  PotentialPair<2> pair;
};

/// In 3D a search costs more, so its proof is cached, too, and tested first. The plane between separated
/// blocks may not belong to any feature; then the pair is two vertices, the start of the search along the
/// plane's normal.
template <>
struct PairCache<3> {
  using State = PairState::State;
  using enum PairState::State;
  State state = unknown;
  PotentialPair<3> pair;  // as in 2D; overlapping: undefined
  /// In the orientation of the outlines. Separated: the unit normal, from a to b, of a plane between the
  /// blocks. Else a point in both, relative to the centroid of a. Verified before use, so any value is valid.
  Vector<3> proof = Vector<3>::Zero();
};

template <int D>
bool touching(const PairCache<D>& witness) {
  return witness.state >= PairCache<D>::touching;
}

/// A contact between blocks a and b, relative to the centroid of a, or the proof of their separation.
template <int D>
struct Contact;

/// Without initial values, which would cost time for each separated pair.
template <>
struct Contact<2> {
  ContactType type;
  PotentialPair<2> pair;     // the contact plane; of a separated pair, the violated pair
  std::int32_t point_count;  // 0 when separated; then only normal and gap are set
  std::int32_t reserved;     // explicit padding, so that all saved bytes are defined
  double gap;           // of the pair, or of the deeper end of an edge-edge region; > 0 proves the separation
  Vector<2> normal;     // unit, from a to b
  Vector<2> points[2];  // of the region, on the contact plane
  double gaps[2];       // at the points
  double length;        // of the contact region: 0 unless edge-edge
};

/// The maximum number of points of a contact region. An overlap of two faces seldom has more corners; then
/// those farthest in as many evenly spread directions are kept.
constexpr int max_region_points = 8;

/// The contact plane is that of the face of `pair`. For edges or vertices it goes through the given point,
/// between two edges the midpoint of their nearest points. Without initial values, as in 2D.
template <>
struct Contact<3> {
  ContactType type;
  PotentialPair<3> pair;     // the contact plane; of a separated pair, the violated pair
  std::int32_t point_count;  // 0 when separated; then only normal and gap are set
  double gap;                // of the pair, or of the deepest point of the region; > 0 proves the separation
  Vector<3> normal;          // unit, from a to b
  double area;               // of the contact region: 0 unless face-face
  double length;             // of the contact region: 0 unless edge-face
  Vector<3> center;          // centroid of the contact region, on the contact plane
  double center_gap;         // at `center`
  Vector<3> points[max_region_points];  // corners of the region, counter-clockwise about the normal
  double gaps[max_region_points];       // at the points
};

/// The centre of a contact's region, or of the nearest points of a separated pair.
inline Vector<2> middle_of(const Contact<2>& contact) {
  return contact.point_count == 2 ? 0.5 * (contact.points[0] + contact.points[1]) : contact.points[0];
}
inline Vector<3> middle_of(const Contact<3>& contact) { return contact.center; }
inline double gap_in_middle_of(const Contact<2>& contact) {
  return contact.point_count == 2 ? 0.5 * (contact.gaps[0] + contact.gaps[1]) : contact.gaps[0];
}
inline double gap_in_middle_of(const Contact<3>& contact) { return contact.center_gap; }

/// A contact described by its pair alone or, with type none, the proof of separation.
template <int D>
[[gnu::always_inline]] inline Contact<D> contact_without_region(ContactType type,
                                                                const PotentialPair<D>& pair,
                                                                const Vector<D>& normal, double gap) {
  Contact<D> contact;
  contact.type = type;
  contact.pair = pair;
  contact.point_count = 0;
  contact.gap = gap;
  contact.normal = normal;
  return contact;
}

/// Transforms a contact to the host's frame, by `rotation`; the old origin is at `origin`.
template <int D>
void place(Contact<D>& contact, const Rotation<D>& rotation, const Vector<D>& origin) {
  contact.normal = rotation * contact.normal;
  if (contact.point_count == 0) return;
  if constexpr (D == 3) contact.center = rotation * contact.center + origin;
  for (int i = 0; i < contact.point_count; ++i) contact.points[i] = rotation * contact.points[i] + origin;
}

}  // namespace halfspace
