#pragma once

#include <cmath>

#include "geometry/outline.h"
#include "geometry/tolerances.h"
#include "geometry/vector.h"

namespace halfspace {

/// A segment from `origin` along a unit vector.
template <int D>
struct Ray {
  Vector<D> origin;
  Vector<D> direction;
  double length;
};

/// Where a ray meets a block: the distance from its origin, and the face there; -1 if it starts inside.
struct RayHit {
  double distance;
  int face = -1;
};

/// Clips a ray by the half-spaces of a block: it enters through the last plane that it crosses inwards,
/// unless it has left through another one before [Cyrus 1978]. The origin is relative to the
/// centroid. Rays that touch the block to rounding hit it, so that none passes between two blocks with a
/// common edge.
///
/// Returns false, and does not change the hit, if the block is not met before `hit.distance`.
template <int D>
bool meets(const Ray<D>& ray, const Outline<D>& block, RayHit& hit) {
  if (block.face_count() == 0) return false;
  const double reach = ray.origin.norm();
  // Bounds of the errors of both distances: those of the heights, divided by the speeds.
  double enters = -HUGE_VAL, leaves = HUGE_VAL, error_entering = 0, error_leaving = 0;
  int face = -1;
  for (int f = 0; f < block.face_count(); ++f) {
    const Vector<D> normal = block.normal(f);
    const double height = normal.dot(ray.origin) - block.offset[f], speed = normal.dot(ray.direction);
    const double rounding = 4 * machine_epsilon * (reach + std::abs(block.offset[f]));
    if (speed == 0) {
      if (height > rounding) return false;
      continue;
    }
    const double distance = -height / speed, error = rounding / std::abs(speed);
    if (speed < 0 && distance > enters) {
      enters = distance;
      error_entering = error;
      face = f;
    } else if (speed > 0 && distance < leaves) {
      leaves = distance;
      error_leaving = error;
    }
  }
  if (enters > leaves + error_entering + error_leaving || leaves < -error_leaving) return false;
  if (enters <= 0) {
    hit = {0, -1};
    return true;
  }
  if (enters >= hit.distance) return false;
  hit = {enters, face};
  return true;
}

}  // namespace halfspace
