#pragma once

#include "geometry/pose.h"
#include "narrow_phase/plane/placement.h"

namespace halfspace {

/// The frames in which two posed blocks are compared. Detection uses relative poses, so that the distance
/// from the origin costs no accuracy.
template <int D>
struct Frames;

/// In 2D each block has the other in its own frame.
template <>
struct Frames<2> {
  Turns turns;            // of both
  Placement<Turns> seen;  // in each block's frame

  Rotation<2> of_a() const { return only(turns, 0); }
  Rotation<2> b_in_a() const { return only(seen.into_other, 1); }
  Vector<2> to_b() const { return only(seen.to_other, 0); }
};

/// In 3D both blocks are in the frame of a.
template <>
struct Frames<3> {
  Rotation<3> of_a;
  Rotation<3> b_in_a;  // from the frame of b to that of a
  Vector<3> to_b;      // from the centroid of a
};

/// The frames of two poses, which must be tolerable.
template <int D>
Frames<D> frames_of(const GivenPose& a, const GivenPose& b);

template <>
[[gnu::always_inline]] inline Frames<2> frames_of(const GivenPose& a, const GivenPose& b) {
  const Turns turns = turns_about_z(a, b).turn;
  const TwoLanes position_a = load_two(a.position), position_b = load_two(b.position);
  const TwoLanes to_b = position_b - position_a, to_a = position_a - position_b;
  const auto& [c, s] = turns;
  const TwoLanes crossed = c * exchanged(s);
  return {turns,
          {{c * exchanged(c) + s * exchanged(s), exchanged(crossed) - crossed},
           turned_back(turns, {firsts(to_b, to_a), seconds(to_b, to_a)})}};
}

template <>
inline Frames<3> frames_of(const GivenPose& a, const GivenPose& b) {
  const Pose<3> at_a = pose_of<3>(a), at_b = pose_of<3>(b);
  const Rotation<3> into_a = at_a.rotation.inverse();
  return {at_a.rotation, into_a * at_b.rotation, into_a * Vector<3>(at_b.position - at_a.position)};
}

}  // namespace halfspace
