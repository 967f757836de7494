#pragma once

#include "check.h"
#include "detect/separation.h"
#include "geometry/rotation.h"
#include "geometry/two_lanes.h"
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

/// False also for some poses that are tolerable each by itself.
inline bool are_tolerable(const TurnAboutZ<TwoLanes>& about_z, const hs_pose& a, const hs_pose& b) {
  const TwoLanes far_off = magnitude(two_at(a.position)) + magnitude(two_at(b.position));
  const TwoLanes fault = about_z.fault + both(weight_far_off) * far_off;
  return fault[0] + fault[1] <= largest_fault && turn_exactly_about_z(a, b);
}

/// Detection takes the poses relative to each other: the distance from the origin, which both share, costs no
/// digits.
inline Placement<Turns> placement_of(const Turns& turns, const hs_pose& a, const hs_pose& b) {
  const TwoLanes position_a = two_at(a.position), position_b = two_at(b.position);
  const TwoLanes to_b = position_b - position_a, to_a = position_a - position_b;
  const auto& [c, s] = turns;
  const TwoLanes crossed = c * exchanged(s);
  return {{c * exchanged(c) + s * exchanged(s), exchanged(crossed) - crossed},
          turned_back(turns, {firsts(to_b, to_a), seconds(to_b, to_a)})};
}

/// Refuses poses that are wrong.
inline Turns read_turns(const hs_pose& a, const hs_pose& b) {
  const TurnAboutZ<TwoLanes> about_z = turns_about_z(a, b);
  if (!are_tolerable(about_z, a, b)) {
    read_pose(&a, "pose_a");
    read_pose(&b, "pose_b");
  }
  return about_z.turn;
}

/// Normal of a pair's half-space, from a to b.
inline Vector<2> normal_from_a_to_b(const PotentialPair<2>& pair, const PosedPair& posed,
                                    const Turns& turns) {
  const Owner owner(posed.a.shape.outline(), posed.b.shape.outline(), pair);
  return owner.sign * (only(turns, pair.owner) * owner.block.normal(pair.edge));
}

}  // namespace halfspace::capi
