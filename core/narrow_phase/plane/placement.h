#pragma once

#include "geometry/rotation.h"
#include "geometry/vector.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// Two directions in 2D, one per lane.
struct DirectionLanes {
  TwoLanes x;
  TwoLanes y;
};

/// Two rotations in 2D, one per lane.
using Turns = CosineAndSine<TwoLanes>;

/// Each direction rotated by the rotation in its lane, and rotated back.
inline DirectionLanes turned(const Turns& turns, const DirectionLanes& d) {
  return {turns.cosine * d.x - turns.sine * d.y, turns.sine * d.x + turns.cosine * d.y};
}
inline DirectionLanes turned_back(const Turns& turns, const DirectionLanes& d) {
  return {turns.cosine * d.x + turns.sine * d.y, turns.cosine * d.y - turns.sine * d.x};
}

/// Copies one lane to both.
inline DirectionLanes both(const DirectionLanes& d, int lane) { return {both(d.x[lane]), both(d.y[lane])}; }
inline Turns both(const Turns& turns, int lane) { return {both(turns.cosine[lane]), both(turns.sine[lane])}; }

/// Extracts one lane.
inline Vector<2> only(const DirectionLanes& d, int lane) { return {d.x[lane], d.y[lane]}; }
inline Rotation<2> only(const Turns& turns, int lane) { return {turns.cosine[lane], turns.sine[lane]}; }

/// The identity, for frames of one orientation.
struct NoTurns {};
inline const DirectionLanes& turned(NoTurns, const DirectionLanes& d) { return d; }
inline NoTurns both(NoTurns, int) { return {}; }
struct NoRotation {};
inline const Vector<2>& operator*(NoRotation, const Vector<2>& v) { return v; }
inline NoRotation only(NoTurns, int) { return {}; }

/// The relative placement of two blocks, each in its own frame: in the first lane b relative to a, in the
/// second a relative to b.
template <class Lanes>
struct Placement {
  Lanes into_other;         // rotation from its own frame to that of the other
  DirectionLanes to_other;  // from its centroid to that of the other, in its own frame
};

/// The placement of two blocks in one orientation.
inline Placement<NoTurns> placement_unturned(const Vector<2>& to_b) {
  return {{}, {TwoLanes{to_b.x(), -to_b.x()}, TwoLanes{to_b.y(), -to_b.y()}}};
}

}  // namespace halfspace
