#include "exact_motion.h"

#include <cmath>

namespace halfspace::box2d {
namespace {

void take_if_changed(Followed& number, float now) {
  if (number.seen() != now) number.take(now);
}

}  // namespace

double inertia_of(const b2Body& body) {
  const Vector center(body.GetLocalCenter());
  return body.IsFixedRotation() ? 0 : body.GetInertia() - body.GetMass() * dot(center, center);
}

Rates pull_of(const b2Body& body, const Vector& gravity) {
  const bool is_pulled = body.GetType() == b2_dynamicBody && body.GetMass() > 0;
  return {(is_pulled ? body.GetGravityScale() : 0) * gravity};
}

Damping::Damping(const b2Body& body, double time_step) {
  if (body.GetType() != b2_dynamicBody) return;
  linear = 1 / (1 + time_step * body.GetLinearDamping());
  angular = 1 / (1 + time_step * body.GetAngularDamping());
}

/// Allows for rounding of the sum, and of the added change, which is a few products in Box2D.
void Followed::settle(float now, double predicted, double target) {
  const double rounding =
      b2_epsilon * (0.5 * std::abs(double(now)) + 4 * std::abs(predicted - double(seen_)));
  exact_ = std::abs(now - predicted) <= rounding ? target : now;
  seen_ = now;
}

ExactMotion::ExactMotion(const b2Body& body) {
  x_.take(body.GetWorldCenter().x);
  y_.take(body.GetWorldCenter().y);
  angle_.take(body.GetAngle());
  velocity_x_.take(body.GetLinearVelocity().x);
  velocity_y_.take(body.GetLinearVelocity().y);
  spin_.take(body.GetAngularVelocity());
}

void ExactMotion::follow(const b2Body& body) {
  take_if_changed(x_, body.GetWorldCenter().x);
  take_if_changed(y_, body.GetWorldCenter().y);
  take_if_changed(angle_, body.GetAngle());
  take_if_changed(velocity_x_, body.GetLinearVelocity().x);
  take_if_changed(velocity_y_, body.GetLinearVelocity().y);
  take_if_changed(spin_, body.GetAngularVelocity());
}

/// Includes the rounding error accumulated so far.
void ExactMotion::push(b2Body& body, const Rates& impulse) {
  const double mass = body.GetMass(), inertia = inertia_of(body);
  if (!body.IsAwake() || !(mass > 0)) return;
  const Vector target = velocity() + (1 / mass) * impulse.linear;
  const Vector seen{velocity_x_.seen(), velocity_y_.seen()};
  body.ApplyLinearImpulseToCenter(rounded(mass * (target - seen)), false);
  velocity_x_.settle(body.GetLinearVelocity().x, target.x, target.x);
  velocity_y_.settle(body.GetLinearVelocity().y, target.y, target.y);
  if (!(inertia > 0)) return;
  const double target_spin = spin() + impulse.angular / inertia;
  body.ApplyAngularImpulse(float(inertia * (target_spin - spin_.seen())), false);
  spin_.settle(body.GetAngularVelocity(), target_spin, target_spin);
}

void ExactMotion::set_rates(b2Body& body, const Rates& rates) {
  velocity_x_.set(rates.linear.x);
  velocity_y_.set(rates.linear.y);
  spin_.set(rates.angular);
  body.SetLinearVelocity({velocity_x_.seen(), velocity_y_.seen()});
  body.SetAngularVelocity(spin_.seen());
}

void ExactMotion::shift(b2Body& body, const Rates& displacement) {
  x_.add(displacement.linear.x);
  y_.add(displacement.linear.y);
  angle_.add(displacement.angular);
  if (is_off(body)) put(body);
}

void ExactMotion::carry_on(b2Body& body, double h, const Rates& acceleration) {
  const Damping damping(body, h);
  const Rates seen{{velocity_x_.seen(), velocity_y_.seen()}, spin_.seen()};
  const Rates predicted = damping(seen + h * acceleration), target = damping(rates() + h * acceleration);
  const b2Vec2 velocity = body.GetLinearVelocity(), at = body.GetWorldCenter();
  const float spin = body.GetAngularVelocity();
  velocity_x_.settle(velocity.x, predicted.linear.x, target.linear.x);
  velocity_y_.settle(velocity.y, predicted.linear.y, target.linear.y);
  spin_.settle(spin, predicted.angular, target.angular);

  x_.settle(at.x, x_.seen() + h * velocity.x, x_.exact() + h * velocity_x_.exact());
  y_.settle(at.y, y_.seen() + h * velocity.y, y_.exact() + h * velocity_y_.exact());
  angle_.settle(body.GetAngle(), angle_.seen() + h * spin, angle_.exact() + h * spin_.exact());
  if (is_off(body)) put(body);
}

/// Is the error larger than the spacing of floats at the body's position?
bool ExactMotion::is_off(const b2Body& body) const {
  const Vector off = center() - Vector(body.GetWorldCenter());
  const double size = std::abs(x_.exact()) + std::abs(y_.exact()) + body.GetLocalCenter().Length();
  return std::abs(off.x) + std::abs(off.y) > 2 * b2_epsilon * size ||
         std::abs(angle() - body.GetAngle()) > 2 * b2_epsilon * std::abs(angle());
}

void ExactMotion::put(b2Body& body) {
  const Turn turn{std::cos(angle()), std::sin(angle())};
  body.SetTransform(rounded(center() - turn * Vector(body.GetLocalCenter())), float(angle()));
  x_.see(body.GetWorldCenter().x);
  y_.see(body.GetWorldCenter().y);
  angle_.see(body.GetAngle());
}

}  // namespace halfspace::box2d
