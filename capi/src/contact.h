#pragma once

#include "check.h"
#include "detect/contact.h"
#include "halfspace/contact.h"

namespace halfspace::capi {

/// A contact in the host's terms, without ids and forces. `frame` turns and `origin` moves it from the frame of detection to the host's.
inline void write_contact(const Contact<2>& contact, const Rotation<2>& frame, const Vector<2>& origin,
                          hs_contact& out) {
  out.type = std::int32_t(contact.type);
  out.point_count = contact.point_count;
  out.edge_owner = contact.pair.owner;
  out.edge = contact.pair.edge;
  out.vertex = contact.pair.vertex;
  out.reserved = 0;
  write_vector(frame * contact.normal, out.normal);
  out.gap = contact.gap;
  out.area = contact.point_count == 2 ? contact.length : 0;
  for (int i = 0; i < contact.point_count; ++i) {
    write_vector(frame * contact.points[i] + origin, out.points[i]);
    out.gaps[i] = contact.gaps[i];
  }
}

}  // namespace halfspace::capi
