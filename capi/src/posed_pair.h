#pragma once

#include "check.h"
#include "detect/separation.h"
#include "detect/two_lanes.h"
#include "guard.h"
#include "halfspace/view.h"
#include "shape.h"

namespace halfspace::capi {

/// Two shapes and where they are, as the host gave them.
struct PosedPair {
  const hs_shape& a;
  const hs_pose& at_a;
  const hs_shape& b;
  const hs_pose& at_b;
};

/// Where block b is, seen from a: detection works in the frame of a, so that only b has to be turned and the
/// distance from the origin costs no digits. And the way back out of that frame.
struct Placement {
  Rotation<2> b_in_a;
  Vector<2> to_b;       // in the frame of a
  Vector<2> to_b_in_b;  // in that of b
  Rotation<2> rotation_of_a;
  Vector<2> position_of_a;
};

/// Says what is wrong with poses that read_placement() does not take.
[[noreturn, gnu::cold]] inline void refuse_poses(const hs_pose& a, const hs_pose& b) {
  read_pose(&a, "pose_a");
  read_pose(&b, "pose_b");
  refuse(HS_ERROR_ARGUMENT,
         "pose_a->position (%g, %g) and pose_b->position (%g, %g) are too far off together", a.position[0],
         a.position[1], b.position[0], b.position[1]);
}

/// A direction in the frames of both poses.
inline DirectionLanes inverse_turned(const CosineAndSine<TwoLanes>& turn, const DirectionLanes& d) {
  return {turn.cosine * d.x + turn.sine * d.y, turn.cosine * d.y - turn.sine * d.x};
}

inline Placement read_placement(const hs_pose& a, const hs_pose& b) {
  const TurnAboutZ<TwoLanes> about_z = turns_about_z(a, b);
  const TwoLanes xy_a = two_at(a.rotation), xy_b = two_at(b.rotation);
  const TwoLanes off_axis = sums(xy_a * xy_a, xy_b * xy_b);
  const TwoLanes apart = two_at(b.position) - two_at(a.position);
  const TwoLanes far_off =
      both(weight_far_off) * (magnitude(two_at(a.position)) + magnitude(two_at(b.position)));
  if (!is_tolerable((about_z.fault + both(weight_off_axis) * off_axis) + far_off)) refuse_poses(a, b);
  const auto& [cosine, sine] = about_z.turn;
  const Rotation<2> rotation_of_a(cosine[0], sine[0]), rotation_of_b(cosine[1], sine[1]);
  const DirectionLanes to_b = inverse_turned(about_z.turn, {both(apart[0]), both(apart[1])});
  return {rotation_of_a.inverse() * rotation_of_b, Vector<2>(to_b.x[0], to_b.y[0]),
          Vector<2>(to_b.x[1], to_b.y[1]), rotation_of_a, Vector<2>(a.position[0], a.position[1])};
}

}  // namespace halfspace::capi
