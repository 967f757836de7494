#pragma once

#include <box2d/b2_math.h>
#include <halfspace/view.h>

#include <cmath>

#include "vector.h"

namespace halfspace::box2d {

/// Box2D's rotation in double. Its cosine and sine are rounded to float, so that their norm differs from 1 by
/// at most 2^-23; one Newton iteration for 1 / sqrt(norm^2) reduces this error below rounding.
inline Turn turn_of(const b2Rot& q) {
  const double c = q.c, s = q.s;
  const double factor = 1.5 - 0.5 * (c * c + s * s);
  return {factor * c, factor * s};
}

/// Pose of polygon b in the frame of polygon a, relative to the centroids.
struct Placement {
  Turn turn;
  Vector shift;
};

/// The difference of positions is first, so that no digits are lost far from the origin of the world.
inline Placement placement_of(const Vector& centroid_a, const b2Transform& at_a, const Vector& centroid_b,
                              const b2Transform& at_b) {
  const Turn into_a = turn_of(at_a.q).inverse();
  const Turn turn = into_a * turn_of(at_b.q);
  const Vector to_b{double(at_b.p.x) - double(at_a.p.x), double(at_b.p.y) - double(at_a.p.y)};
  return {turn, into_a * to_b + (turn * centroid_b - centroid_a)};
}

/// The pose of a in the frame of b.
inline Placement inverse(const Placement& at) {
  const Turn back = at.turn.inverse();
  return {back, -(back * at.shift)};
}

/// The pose for the library. Its quaternion is the rotation by half the angle, the bisector of the rotation
/// and of the identity. For angles near half a turn a bisector without cancellation is used.
inline hs_pose pose_of(const Placement& at) {
  const auto& [c, s] = at.turn;
  const double w = c >= 0 ? 1 + c : s, z = c >= 0 ? s : 1 - c;
  const double to_unit = 1 / std::sqrt(w * w + z * z);
  return {{at.shift.x, at.shift.y, 0}, {0, 0, to_unit * z, to_unit * w}};
}

}  // namespace halfspace::box2d
