#pragma once

#include "block/inertia.h"

namespace halfspace {

/// How a block goes on that no torque acts on.
template <int D>
struct FreeTurn {
  Angular<D> spin;       // at first
  Rotation<D> rotation;  // after a while
};

/// In the plane it keeps its spin.
inline FreeTurn<2> turned_freely(const Rotation<2>& rotation, const Inertia<2>& inertia,
                                 const Angular<2>& momentum, double duration) {
  const Angular<2> spin = inertia.spin(momentum, rotation);
  return {spin, rotation.turned_by(duration * spin)};
}

/// In space its angular momentum stays and its spin does not. Turns about the principal axes one after the
/// other, each by what the momentum along that axis gives: there and back again, so that the error is of
/// second order in the duration and, being that of a symplectic map, does not add up in the energy
/// (Dullweber, Leimkuhler and McLachlan 1997).
inline FreeTurn<3> turned_freely(const Rotation<3>& rotation, const Inertia<3>& inertia,
                                 const Angular<3>& momentum, double duration) {
  Rotation<3> axes = rotation * inertia.axes;
  const auto turn = [&](int k, double time) {
    axes.turn_about_own_axis(k, time * momentum.dot(axes.axis(k)) / inertia.moments[k]);
  };
  turn(2, 0.5 * duration);
  turn(1, 0.5 * duration);
  turn(0, duration);
  turn(1, 0.5 * duration);
  turn(2, 0.5 * duration);
  return {inertia.spin(momentum, rotation), (axes * inertia.axes.inverse()).straightened()};
}

}  // namespace halfspace
