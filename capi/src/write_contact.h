#pragma once

#include "halfspace/contact.h"
#include "narrow_phase/contact.h"
#include "pose_and_vector.h"

namespace halfspace::capi {

static_assert(max_region_points == HS_CONTACT_POINTS);

/// A pair as in the C interface: in 2D the edge takes the place of the face.
using NamedPair = PotentialPair<3>;

inline NamedPair named(const PotentialPair<3>& pair) { return pair; }

// The owner of the edge or face is unpredictable, so arithmetic is cheaper than branches.

inline std::int32_t selected(bool second, std::int32_t one, std::int32_t other) {
  return one ^ ((one ^ other) & -std::int32_t(second));
}

inline NamedPair named(const PotentialPair<2>& pair) {
  const bool b_owns = pair.owner == 1;
  return {NamedPair::Kind(pair.owner), selected(b_owns, pair.edge, pair.vertex),
          selected(b_owns, pair.vertex, pair.edge)};
}

inline PotentialPair<2> in_plane(const NamedPair& pair) {
  const bool b_owns = pair.kind == NamedPair::vertex_face;
  return {pair.kind, selected(b_owns, pair.a, pair.b), selected(b_owns, pair.b, pair.a)};
}

/// A pair as separation proof: the face alone is the proof, so the vertex is -1 (all bits set).
inline NamedPair separating(const PotentialPair<2>& pair) {
  return {NamedPair::Kind(pair.owner), pair.edge | -pair.owner, pair.edge | (pair.owner - 1)};
}

inline NamedPair separating(const NamedPair& pair) {
  return {pair.kind, pair.a | -std::int32_t(pair.kind == NamedPair::vertex_face),
          pair.b | -std::int32_t(pair.kind == NamedPair::face_vertex)};
}

/// Writes the fields that are always set.
template <int D>
void write_pair(ContactType type, int point_count, const NamedPair& pair, const Vector<D>& normal, double gap,
                hs_contact& out) {
  out.type = std::int32_t(type);
  out.point_count = point_count;
  out.pair_kind = pair.kind;
  out.feature_a = pair.a;
  out.feature_b = pair.b;
  out.reserved = 0;
  write_vector(normal, out.normal);
  out.gap = gap;
}

inline double area_of(const Contact<2>& contact) { return contact.length; }  // times unit thickness
inline double area_of(const Contact<3>& contact) { return contact.area; }

/// Writes a contact without ids and forces. Fields of a missing region are not written.
template <int D>
[[gnu::always_inline]] inline void write_contact(const Contact<D>& contact, hs_contact& out) {
  const NamedPair pair = contact.type == ContactType::none ? separating(contact.pair) : named(contact.pair);
  write_pair(contact.type, contact.point_count, pair, contact.normal, contact.gap, out);
  if (contact.point_count == 0) return;
  out.area = area_of(contact);
  out.length = contact.length;
  write_vector(middle_of(contact), out.center);
  out.center_gap = gap_in_middle_of(contact);
  for (int i = 0; i < contact.point_count; ++i) {
    write_vector(contact.points[i], out.points[i]);
    out.gaps[i] = contact.gaps[i];
  }
}

}  // namespace halfspace::capi
