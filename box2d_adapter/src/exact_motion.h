#pragma once

#include <box2d/b2_body.h>

#include "vector.h"

namespace halfspace::box2d {

/// A linear and an angular quantity of a body: velocity, acceleration, force or impulse.
struct Rates {
  Vector linear;
  double angular = 0;
};

inline Rates operator+(const Rates& a, const Rates& b) {
  return {a.linear + b.linear, a.angular + b.angular};
}
inline Rates operator-(const Rates& a, const Rates& b) {
  return {a.linear - b.linear, a.angular - b.angular};
}
inline Rates operator*(double s, const Rates& a) { return {s * a.linear, s * a.angular}; }

/// About the center of mass; 0 for fixed rotation.
double inertia_of(const b2Body& body);

/// The acceleration of a body by gravity alone.
Rates pull_of(const b2Body& body, const Vector& gravity);

/// Factors of a body's velocities by its damping in a step, as in b2Island::Solve().
struct Damping {
  Damping(const b2Body& body, double time_step);

  Rates operator()(const Rates& velocity) const {
    return {linear * velocity.linear, angular * velocity.angular};
  }
  Rates undo(const Rates& velocity) const {
    return {1 / linear * velocity.linear, velocity.angular / angular};
  }

  double linear = 1;
  double angular = 1;
};

/// A number that Box2D stores in float, in double precision.
class Followed {
 public:
  double exact() const { return exact_; }
  float seen() const { return seen_; }

  void take(float now) { exact_ = seen_ = now; }
  void set(double exact) { seen_ = float(exact_ = exact); }
  void see(float now) { seen_ = now; }
  void add(double change) { exact_ += change; }

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
  Rates rates() const { return {velocity(), spin()}; }

  /// Adopts values that the host has changed.
  void follow(const b2Body& body);

  /// Applies an impulse at the center of mass and an angular impulse. A sleeping body stays asleep.
  void push(b2Body& body, const Rates& impulse);

  void set_rates(b2Body& body, const Rates& rates);
  void shift(b2Body& body, const Rates& displacement);

  /// Updates the motion after a step of Box2D under an acceleration, and corrects the body if its error
  /// exceeds rounding.
  void carry_on(b2Body& body, double time_step, const Rates& acceleration);

 private:
  bool is_off(const b2Body& body) const;
  void put(b2Body& body);

  Followed x_, y_, angle_;
  Followed velocity_x_, velocity_y_, spin_;
};

}  // namespace halfspace::box2d
