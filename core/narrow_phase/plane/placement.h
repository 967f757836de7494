#pragma once

#include "geometry/rotation.h"
#include "geometry/vector.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// Two directions in the plane, side by side.
struct DirectionLanes {
  TwoLanes x;
  TwoLanes y;
};

/// Two turns, side by side.
using Turns = CosineAndSine<TwoLanes>;

/// Directions turned, each by the turn in its lane, and turned back.
inline DirectionLanes turned(const Turns& turns, const DirectionLanes& d) {
  return {turns.cosine * d.x - turns.sine * d.y, turns.sine * d.x + turns.cosine * d.y};
}
inline DirectionLanes turned_back(const Turns& turns, const DirectionLanes& d) {
  return {turns.cosine * d.x + turns.sine * d.y, turns.cosine * d.y - turns.sine * d.x};
}

/// One lane of several, in both.
inline DirectionLanes both(const DirectionLanes& d, int lane) { return {both(d.x[lane]), both(d.y[lane])}; }
inline Turns both(const Turns& turns, int lane) { return {both(turns.cosine[lane]), both(turns.sine[lane])}; }

/// One lane of several.
inline Vector<2> only(const DirectionLanes& d, int lane) { return {d.x[lane], d.y[lane]}; }
inline Rotation<2> only(const Turns& turns, int lane) { return {turns.cosine[lane], turns.sine[lane]}; }

/// The turns between frames of one orientation.
struct NoTurns {};
inline const DirectionLanes& turned(NoTurns, const DirectionLanes& d) { return d; }
inline NoTurns both(NoTurns, int) { return {}; }
struct NoRotation {};
inline const Vector<2>& operator*(NoRotation, const Vector<2>& v) { return v; }
inline NoRotation only(NoTurns, int) { return {}; }

/// How two blocks lie to each other, each in a frame of its own: in the first lane what a sees, in the second
/// what b does.
template <class Lanes>
struct Placement {
  Lanes into_other;         // turns from its own frame into that of the other
  DirectionLanes to_other;  // from its centroid to that of the other, in its own frame
};

/// The placement of two blocks in one orientation.
inline Placement<NoTurns> placement_unturned(const Vector<2>& to_b) {
  return {{}, {TwoLanes{to_b.x(), -to_b.x()}, TwoLanes{to_b.y(), -to_b.y()}}};
}

}  // namespace halfspace
