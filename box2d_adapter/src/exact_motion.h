#pragma once

#include <box2d/b2_body.h>

#include "vector.h"

namespace halfspace::box2d {

/// A number that Box2D keeps in float, with the digits that rounding takes.
class Followed {
 public:
  double exact() const { return exact_; }
  float seen() const { return seen_; }

  void take(float now) { exact_ = seen_ = now; }
  void see(float now) { seen_ = now; }

  /// After Box2D has changed it: where that is what was predicted, but for rounding, it is `target` in
  /// double. Otherwise more was at work than is known here, and it is what Box2D says.
  void settle(float now, double predicted, double target);

 private:
  double exact_ = 0;
  float seen_ = 0;  // in Box2D, when last looked at
};

/// Motion of a body's centre of mass and its turn, in double.
///
/// Box2D adds small changes to floats, in each sub-step: 10 m from the origin a motion of less than 0.5e-6 m
/// is lost, and at 1 m/s a change of velocity of less than 6e-8 m/s, each time with the same sign. Here what
/// was lost is kept, as in compensated summation, and the body follows in floats.
class ExactMotion {
 public:
  explicit ExactMotion(const b2Body& body);

  Vector center() const { return {x_.exact(), y_.exact()}; }
  double angle() const { return angle_.exact(); }
  Vector velocity() const { return {velocity_x_.exact(), velocity_y_.exact()}; }
  double spin() const { return spin_.exact(); }

  /// What a host has changed since is as Box2D has it.
  void follow(const b2Body& body);

  /// Lets an impulse act at the centre of mass, and an angular one. Who sleeps goes on to sleep.
  void push(b2Body& body, const Vector& impulse, double angular_impulse);

  /// After a step of Box2D. A body that is off by more than rounding is put where it is.
  void carry_on(b2Body& body, double time_step, const Vector& gravity);

 private:
  bool is_off(const b2Body& body) const;
  void put(b2Body& body);

  Followed x_, y_, angle_;
  Followed velocity_x_, velocity_y_, spin_;
};

}  // namespace halfspace::box2d
