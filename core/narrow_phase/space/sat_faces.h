#pragma once

#include "geometry/outline.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/space/support.h"

namespace halfspace {

/// A face and the gap of its vertex-face potential contact pair.
struct FaceGap {
  double gap;
  int face;
};

/// The largest gap among the faces of `owner`, over all vertices of the other block (Wang et al. 2021, eqs.
/// 19 and 25). Both are in one orientation; `to_other` leads from the owner's centroid to the other's.
inline FaceGap largest_face_gap(const Outline<3>& owner, const Outline<3>& other, const Vector<3>& to_other) {
  const TwoLanes to_x = both(to_other.x()), to_y = both(to_other.y()), to_z = both(to_other.z());
  struct Normals {
    TwoLanes x, y, z;
    TwoLanes along(TwoLanes px, TwoLanes py, TwoLanes pz) const { return x * px + y * py + z * pz; }
  };
  const auto normals_at = [&](int f) {
    return Normals{load_two(owner.nx + f), load_two(owner.ny + f), load_two(owner.nz + f)};
  };
  const int vertices = other.vertex_count();
  IndexedLanes largest = {both(-HUGE_VAL), both(0)};
  // Each vertex is loaded once for four faces.
  for (int f = 0; f < owner.face_count(); f += 4) {
    const Normals first = normals_at(f), second = normals_at(f + 2);
    TwoLanes deepest_first = both(HUGE_VAL), deepest_second = both(HUGE_VAL);
    for (int v = 0; v < vertices; ++v) {
      const TwoLanes x = both(other.x[v]), y = both(other.y[v]), z = both(other.z[v]);
      deepest_first = min(deepest_first, first.along(x, y, z));
      deepest_second = min(deepest_second, second.along(x, y, z));
    }
    const double index = f;
    const TwoLanes gap_first = (deepest_first + first.along(to_x, to_y, to_z)) - load_two(owner.offset + f);
    const TwoLanes gap_second =
        (deepest_second + second.along(to_x, to_y, to_z)) - load_two(owner.offset + f + 2);
    largest = max(largest, {gap_first, TwoLanes{index, index + 1}});
    largest = max(largest, {gap_second, TwoLanes{index + 2, index + 3}});
  }
  const IndexedLanes best = max(largest, {exchanged(largest.value), exchanged(largest.index)});
  return {best.value[0], std::min(int(best.index[0]), owner.face_count() - 1)};  // padding repeats the last
}

}  // namespace halfspace
