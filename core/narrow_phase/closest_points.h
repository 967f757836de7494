#pragma once

#include "geometry/vector.h"
#include "narrow_phase/posed_pair.h"

namespace halfspace {

/// The points of two blocks that are closest to each other, relative to the centroid of a, in the host's
/// orientation.
template <int D>
struct ClosestPoints {
  double distance;  // 0 where the blocks touch or overlap
  Vector<D> on_a;   // where they overlap, a common point of both blocks
  Vector<D> on_b;
  Vector<D> normal;  // unit vector from a to b; 0 where the distance is 0
};

/// Finds them by GJK [Gilbert 1988]. The distance is 0 if and only if detection finds a contact. `room`
/// allocates the outline of a polygon of many vertices.
template <int D>
ClosestPoints<D> find_closest_points(const PosedPair<D>& posed, Memory* room);

}  // namespace halfspace
