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
  edge_face = 4,  // this and what follows in space only
  face_face = 5,
  vertex_face = 6
};

/// Settings of detection that trade nothing but what a contact is called.
struct DetectOptions {
  double parallel_angle = 0.01;  // rad: edges (in space, faces) closer to parallel than this share a region
  double vertex_zone =
      1e-6;  // share of the shorter edge's length that an end of an edge counts as its vertex

  /// Beyond the parallel angle, and up to this one, features share a region as long as they overlap at more
  /// of its points than a simpler contact would have: so no spring is lost that bears.
  double region_angle() const { return std::max(parallel_angle, std::min(15 * parallel_angle, 0.3)); }
  /// A region so long and so deep has come down to one point before it is tilted by that angle.
  bool outlasts(double length, double depth) const { return depth <= length * region_angle(); }
};

/// A facet of the Minkowski difference of two blocks is a potential contact pair (Wang et al. 2021, eqs. 9,
/// 17 and 23).
template <int D>
struct PotentialPair;

/// In the plane it is known by its edge alone: the vertex is the other block's deepest one behind it.
template <>
struct PotentialPair<2> {
  std::int32_t owner = 0;   // whose edge: 0 block a, 1 block b
  std::int32_t edge = 0;    // of the owner
  std::int32_t vertex = 0;  // of the other block
  friend bool operator==(const PotentialPair&, const PotentialPair&) = default;
};

/// In space it is a face of one block and the other's deepest vertex behind it, or an edge of each. Of
/// separated blocks it may also be a vertex of each, deepest along the normal of some plane between the
/// blocks.
template <>
struct PotentialPair<3> {
  enum Kind : std::int32_t { face_vertex = 0, vertex_face = 1, edge_edge = 2, vertex_vertex = 3 };
  Kind kind = face_vertex;  // which features: first of block a, second of block b
  std::int32_t a = 0;       // index of that of block a
  std::int32_t b = 0;       // index of that of block b
  friend bool operator==(const PotentialPair&, const PotentialPair&) = default;
};

/// Two vertices may keep blocks apart, but no contact is described by them.
inline bool has_a_plane(const PotentialPair<2>&) { return true; }
inline bool has_a_plane(const PotentialPair<3>& pair) { return pair.kind != PotentialPair<3>::vertex_vertex; }

/// A violated potential pair, or the pair of least depth when none is violated, and its gap.
template <int D>
struct Separation;

/// The pair is known by its edge; its vertex is only where to look for the deepest one first, unless a
/// function says more.
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
  /// Overlapping, in space: the blocks touch, and nobody has asked through which pair.
  enum State : std::int32_t { unknown = 0, separated = 1, touching = 2, overlapping = 3 };
};

/// The proof of the verdict on a pair of blocks, which is tried first in the next step.
template <int D>
struct PairCache;

template <>
struct PairCache<2> {
  using State = PairState::State;
  using enum PairState::State;
  State state = unknown;
  /// Separated: the last violated pair, tried first. Touching: the pair through which the blocks met.
  PotentialPair<2> pair;
};

/// In space a search costs more, so that its proof is remembered as well: what is asked first is whether it
/// still holds. Separated blocks may have a plane between them that no feature of theirs tells; then the pair
/// is of two vertices, and says where to look first for what is deepest along the plane's normal.
template <>
struct PairCache<3> {
  using State = PairState::State;
  using enum PairState::State;
  State state = unknown;
  PotentialPair<3> pair;  // as in the plane; overlapping: one that means nothing any more
  /// In the orientation of the outlines. Separated: the unit normal, from a to b, of a plane between the
  /// blocks. Else a point of both, seen from the centroid of a. Checked before it is believed:
  /// any value will do.
  Vector<3> proof = Vector<3>::Zero();
};

template <int D>
bool touching(const PairCache<D>& witness) {
  return witness.state >= PairCache<D>::touching;
}

/// A contact between blocks a and b, relative to the centroid of a, or the proof that there is none.
template <int D>
struct Contact;

/// Without initial values: detection writes one for each pair, and what a separated pair leaves unset costs
/// nothing.
template <>
struct Contact<2> {
  ContactType type;
  PotentialPair<2> pair;     // the contact plane; of a separated pair, the violated pair
  std::int32_t point_count;  // 0 when separated, and then only normal and gap follow
  std::int32_t reserved;  // fills the gap before the next member, so that saved contacts hold no stray bytes
  double gap;           // of the pair, or of the deeper end of an edge-edge region; > 0 proves the separation
  Vector<2> normal;     // unit, from a to b
  Vector<2> points[2];  // of the region, on the contact plane
  double gaps[2];       // at the points
  double length;        // of the contact region: 0 unless edge-edge
};

/// The most points of a contact region that are kept. The overlap of two faces seldom has more corners; where
/// it has, those are kept that lie farthest in as many directions spread evenly round the contact plane.
constexpr int max_region_points = 8;

/// The contact plane is that of the face of `pair`; where edges or vertices meet it goes through the point
/// given, which between two edges is the middle of their nearest points. Without initial values, as in the
/// plane; what lies past point_count is left unset.
template <>
struct Contact<3> {
  ContactType type;
  PotentialPair<3> pair;     // the contact plane; of a separated pair, the violated pair
  std::int32_t point_count;  // 0 when separated, and then only normal and gap follow
  double gap;                // of the pair, or of the deepest point of the region; > 0 proves the separation
  Vector<3> normal;          // unit, from a to b
  double area;               // of the contact region: 0 unless face-face
  double length;             // of the contact region: 0 unless edge-face
  Vector<3> center;          // centroid of the contact region, on the contact plane
  double center_gap;         // there
  Vector<3> points[max_region_points];  // corners of the region, counter-clockwise about the normal
  double gaps[max_region_points];       // at the points
};

/// The middle of a contact's region, or of where the features of a separated pair are nearest.
inline Vector<2> middle_of(const Contact<2>& contact) {
  return contact.point_count == 2 ? 0.5 * (contact.points[0] + contact.points[1]) : contact.points[0];
}
inline Vector<3> middle_of(const Contact<3>& contact) { return contact.center; }
inline double gap_in_middle_of(const Contact<2>& contact) {
  return contact.point_count == 2 ? 0.5 * (contact.gaps[0] + contact.gaps[1]) : contact.gaps[0];
}
inline double gap_in_middle_of(const Contact<3>& contact) { return contact.center_gap; }

/// A contact that is its pair alone or, of type none, the proof that there is none.
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

/// Moves a contact into the host's frame: `rotation` turns into it, and the old origin lies at `origin`
/// there.
template <int D>
void place(Contact<D>& contact, const Rotation<D>& rotation, const Vector<D>& origin) {
  contact.normal = rotation * contact.normal;
  if (contact.point_count == 0) return;
  if constexpr (D == 3) contact.center = rotation * contact.center + origin;
  for (int i = 0; i < contact.point_count; ++i) contact.points[i] = rotation * contact.points[i] + origin;
}

}  // namespace halfspace
