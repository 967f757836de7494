#pragma once

#include "check.h"
#include "geometry/rotation.h"
#include "halfspace/view.h"
#include "narrow_phase/plane/separation.h"
#include "shape.h"
#include "simd/two_lanes.h"

namespace halfspace::capi {

/// Two shapes of one dimension and where they are, as the host gave them.
template <int D>
struct PosedPair {
  const ShapeHandle<D>& a;
  const hs_pose& at_a;
  const ShapeHandle<D>& b;
  const hs_pose& at_b;
};

/// Of shapes whose dimension is D.
template <int D>
PosedPair<D> posed_as(const hs_shape& a, const hs_pose& at_a, const hs_shape& b, const hs_pose& at_b) {
  return {as<D>(a), at_a, as<D>(b), at_b};
}

inline bool are_polyhedra(const hs_shape& a, const hs_shape& b) {
  return a.dimension() == 3 && b.dimension() == 3;
}

inline void require_one_dimension(const hs_shape& a, const ArgumentName& name_a, const hs_shape& b,
                                  const ArgumentName& name_b) {
  if (a.dimension() != b.dimension()) {
    refuse(HS_ERROR_ARGUMENT, "%s has dimension %d and %s %d; a pair must have one",
           NameText(name_a).characters, a.dimension(), NameText(name_b).characters, b.dimension());
  }
}

/// Calls use(posed) with shapes of one dimension as what they are.
template <class Use>
auto visit(const hs_shape& a, const hs_pose& at_a, const hs_shape& b, const hs_pose& at_b, Use&& use) {
  return a.dimension() == 2 ? use(posed_as<2>(a, at_a, b, at_b)) : use(posed_as<3>(a, at_a, b, at_b));
}

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
    read_pose<2>(&a, "pose_a");
    read_pose<2>(&b, "pose_b");
  }
  return about_z.turn;
}

/// The same in space, seen from the frame of a.
struct PlacementInSpace {
  Rotation<3> frame_of_a;  // as it is turned
  Rotation<3> b_in_a;      // turns from the frame of b into that of a
  Vector<3> to_b;          // from the centroid of a
};

/// Refuses poses that are wrong.
inline PlacementInSpace read_placement(const hs_pose& a, const hs_pose& b) {
  const Pose<3> at_a = read_pose<3>(&a, "pose_a"), at_b = read_pose<3>(&b, "pose_b");
  const Rotation<3> into_a = at_a.rotation.inverse();
  return {at_a.rotation, into_a * at_b.rotation, into_a * Vector<3>(at_b.position - at_a.position)};
}

/// Normal of a pair's half-space, from a to b.
inline Vector<2> normal_from_a_to_b(const PotentialPair<2>& pair, const PosedPair<2>& posed,
                                    const Turns& turns) {
  const Owner owner(posed.a.shape.outline(), posed.b.shape.outline(), pair);
  return owner.sign * (only(turns, pair.owner) * owner.block.normal(pair.edge));
}

}  // namespace halfspace::capi
