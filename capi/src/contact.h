#pragma once

#include "check.h"
#include "halfspace/contact.h"
#include "narrow_phase/contact.h"

namespace halfspace::capi {

static_assert(most_region_points == HS_CONTACT_POINTS);

/// A pair as the API names it: in the plane the edge stands for the face.
using NamedPair = PotentialPair<3>;

inline const NamedPair& named(const PotentialPair<3>& pair) { return pair; }

// Which block owns the edge or face is as good as random: arithmetic instead of branches.

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

/// A pair as the proof of separation: a face is all of it, which vertex is deepest does not matter. None is
/// -1, all bits set.
inline NamedPair separating(const PotentialPair<2>& pair) {
  return {NamedPair::Kind(pair.owner), pair.edge | -pair.owner, pair.edge | (pair.owner - 1)};
}

inline NamedPair separating(const NamedPair& pair) {
  return {pair.kind, pair.a | -std::int32_t(pair.kind == NamedPair::vertex_face),
          pair.b | -std::int32_t(pair.kind == NamedPair::face_vertex)};
}

/// The part that is always set.
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

/// The proof that there is no contact.
template <int D, class Pair>
void write_separation(const Pair& pair, const Vector<D>& normal, double gap, hs_contact& out) {
  write_pair<D>(ContactType::none, 0, separating(pair), normal, gap, out);
}

/// A contact in the host's terms, without ids and forces. `frame` turns and `origin` moves it from the frame
/// of detection to the host's. In the plane the region is a point or a part of an edge, of unit thickness.
inline void write_contact(const Contact<2>& contact, const Rotation<2>& frame, const Vector<2>& origin,
                          hs_contact& out) {
  write_pair<2>(contact.type, contact.point_count, named(contact.pair), frame * contact.normal, contact.gap,
                out);
  if (contact.point_count == 0) return;
  out.area = out.length = contact.length;
  const Vector<2> first = frame * contact.points[0] + origin;
  write_vector(first, out.points[0]);
  out.gaps[0] = contact.gaps[0];
  if (contact.point_count == 1) {
    write_vector(first, out.center);
    out.center_gap = contact.gaps[0];
    return;
  }
  const Vector<2> second = frame * contact.points[1] + origin;
  write_vector(second, out.points[1]);
  out.gaps[1] = contact.gaps[1];
  write_vector(0.5 * (first + second), out.center);
  out.center_gap = 0.5 * (contact.gaps[0] + contact.gaps[1]);
}

inline void write_contact(const Contact<3>& contact, const Rotation<3>& frame, const Vector<3>& origin,
                          hs_contact& out) {
  write_pair<3>(contact.type, contact.point_count, contact.pair, frame * contact.normal, contact.gap, out);
  if (contact.point_count == 0) return;
  out.area = contact.area;
  out.length = contact.length;
  write_vector(frame * contact.center + origin, out.center);
  out.center_gap = contact.center_gap;
  for (int i = 0; i < contact.point_count; ++i) {
    write_vector(frame * contact.points[i] + origin, out.points[i]);
    out.gaps[i] = contact.gaps[i];
  }
}

}  // namespace halfspace::capi
