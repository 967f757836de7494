#pragma once

#include <box2d/b2_body.h>

#include "vector.h"

namespace halfspace::box2d {

/// A number that Box2D stores in float, in double precision.
class Followed {
 public:
  double exact() const { return exact_; }
  float seen() const { return seen_; }

  void take(float now) { exact_ = seen_ = now; }
  void see(float now) { seen_ = now; }

  /// Updates it after a change by Box2D. If the new value is the predicted one, to rounding, it is set to
  /// `target` in double. Otherwise there were other influences, and it is set to Box2D's value.
  void settle(float now, double predicted, double target);

 private:
  double exact_ = 0;
  float seen_ = 0;  // Box2D's value at the last update
};

/// Position of a body's center of mass, its angle and velocities, in double precision.
///
/// Box2D adds small changes to floats in each sub-step. At 10 m from the origin a displacement below 0.5e-6 m
/// is lost, and at 1 m/s a change of velocity below 6e-8 m/s, every time with the same sign. This class keeps
/// the lost part, as in compensated summation, and updates the floats of the body.
class ExactMotion {
 public:
  explicit ExactMotion(const b2Body& body);

  Vector center() const { return {x_.exact(), y_.exact()}; }
  double angle() const { return angle_.exact(); }
  Vector velocity() const { return {velocity_x_.exact(), velocity_y_.exact()}; }
  double spin() const { return spin_.exact(); }

  /// Adopts values that the host has changed.
  void follow(const b2Body& body);

  /// Applies an impulse at the center of mass and an angular impulse. A sleeping body stays asleep.
  void push(b2Body& body, const Vector& impulse, double angular_impulse);

  /// Updates the motion after a step of Box2D, and corrects the body if its error exceeds rounding.
  void carry_on(b2Body& body, double time_step, const Vector& gravity);

 private:
  bool is_off(const b2Body& body) const;
  void put(b2Body& body);

  Followed x_, y_, angle_;
  Followed velocity_x_, velocity_y_, spin_;
};

}  // namespace halfspace::box2d
