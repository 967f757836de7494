#pragma once

#include <box2d/b2_body.h>

#include "exact_motion.h"

namespace halfspace::box2d {

// Box2D has no function that returns the forces that a host has applied to a body. An explicit instantiation
// may name private members.

template <b2Vec2 b2Body::*force, float b2Body::*torque>
struct UserForce {
  friend Rates user_force_of(const b2Body& body) { return {Vector(body.*force), body.*torque}; }
};
template struct UserForce<&b2Body::m_force, &b2Body::m_torque>;

/// Force and torque about the center of mass, until Box2D clears them.
Rates user_force_of(const b2Body& body);

}  // namespace halfspace::box2d
