#pragma once

#include "check.h"
#include "detect/contact.h"
#include "halfspace/contact.h"

namespace halfspace::capi {

/// The part that is always set.
inline void write_pair(ContactType type, int point_count, const PotentialPair<2>& pair,
                       const Vector<2>& normal, double gap, hs_contact& out) {
  out.type = std::int32_t(type);
  out.point_count = point_count;
  out.edge_owner = pair.owner;
  out.edge = pair.edge;
  out.vertex = pair.vertex;
  out.reserved = 0;
  write_vector(normal, out.normal);
  out.gap = gap;
}

/// The proof that there is no contact. The pair is known by its edge: which vertex is deepest does not
/// matter.
inline void write_separation(const PotentialPair<2>& pair, const Vector<2>& normal, double gap,
                             hs_contact& out) {
  write_pair(ContactType::none, 0, {pair.owner, pair.edge, -1}, normal, gap, out);
}

/// A contact in the host's terms, without ids and forces. `frame` turns and `origin` moves it from the frame
/// of detection to the host's.
inline void write_contact(const Contact<2>& contact, const Rotation<2>& frame, const Vector<2>& origin,
                          hs_contact& out) {
  write_pair(contact.type, contact.point_count, contact.pair, frame * contact.normal, contact.gap, out);
  if (contact.point_count == 0) return;
  out.area = contact.point_count == 2 ? contact.length : 0;
  for (int i = 0; i < contact.point_count; ++i) {
    write_vector(frame * contact.points[i] + origin, out.points[i]);
    out.gaps[i] = contact.gaps[i];
  }
}

}  // namespace halfspace::capi
