#pragma once

#include "block/inertia.h"

namespace halfspace {

/// The motion of a block without torque.
template <int D>
struct FreeTurn {
  Angular<D> spin;       // at the start
  Rotation<D> rotation;  // at the end
};

/// In 2D the spin is constant.
inline FreeTurn<2> turned_freely(const Rotation<2>& rotation, const Inertia<2>& inertia,
                                 const Angular<2>& momentum, double duration) {
  const Angular<2> spin = inertia.spin(momentum, rotation);
  return {spin, rotation.turned_by(duration * spin)};
}

/// In 3D angular momentum is constant, the spin only where all moments are the same. Else the rotation is
/// split into rotations about the principal axes, each by the momentum along that axis, in a symmetric
/// sequence. The error is of second order in the duration, and the energy error does not accumulate, as the
/// map is symplectic (Dullweber, Leimkuhler and McLachlan 1997).
inline FreeTurn<3> turned_freely(const Rotation<3>& rotation, const Inertia<3>& inertia,
                                 const Angular<3>& momentum, double duration) {
  const Angular<3> spin = inertia.spin(momentum, rotation);
  if (inertia.is_spherical()) return {spin, rotation.turned_by(duration * spin)};
  Rotation<3> axes = rotation * inertia.axes;
  const auto turn = [&](int k, double time) __attribute__((always_inline)) {
    axes.turn_about_own_axis(k, time * momentum.dot(axes.axis(k)) / inertia.moments[k]);
  };
  turn(2, 0.5 * duration);
  turn(1, 0.5 * duration);
  turn(0, duration);
  turn(1, 0.5 * duration);
  turn(2, 0.5 * duration);
  return {spin, (axes * inertia.axes.inverse()).straightened()};
}

}  // namespace halfspace
