#pragma once

#include "scene.h"

namespace halfspace_trade {

/// A slab on its edge, as [Housner 1963] has it: angle of the slab, tilt at which it is let go, both rad.
class RockingSlab {
 public:
  RockingSlab(double width, double height, double tilt);

  /// The time from rest at the tilt until the base is flat, s.
  double time_to_impact() const;
  /// The largest tilt on the other side, rad: of the spin a share of 1 - 1.5 sin^2 is left.
  double tilt_after_impact() const;
  double tilt() const { return tilt_; }

 private:
  double spin_at(double tilt) const;

  double slenderness_;   // rad, from the corner's upright to the diagonal
  double rate_squared_;  // 1/s^2: 3 g / 4 R
  double tilt_;
};

/// The turn of a body without load after a time, by Euler's equations in small steps.
Quaternion turned_freely(const Body& body, double time);

/// The angle between two turns, rad.
double angle_between(const Quaternion& p, const Quaternion& q);

}  // namespace halfspace_trade
