#include "force_scenes.h"

#include <cmath>

namespace halfspace_test {

hs_law_def law_of(double stiffness, double damping) {
  hs_law_def law;
  require_ok(hs_law_def_init(&law, sizeof law), nullptr);
  law.normal_stiffness = law.shear_stiffness = stiffness;
  law.normal_damping = law.shear_damping = damping;
  return law;
}

void ForceWorld::step(int times) {
  for (int i = 0; i < times; ++i) {
    if (forces) {
      forces->step(1 / 60.f, sub_steps(), 8, 3);
    } else {
      halfspace_test::step(world);
    }
  }
}

Slide slide_down(const std::optional<hs_law_def>& law, double slope, double friction) {
  ForceWorld arena(law);
  arena.world.SetAllowSleeping(false);
  const b2Rot turn(-float(slope));
  // Mixed with that of the block it is the friction that is asked for.
  add_polygon(arena.world, box_shape(50, 1), {0, 0}, -float(slope), b2_staticBody)
      .SetFriction(2 * float(friction));
  const float above = 1.5f + arena.rest_gap();
  b2Fixture& block = add_polygon(arena.world, box_shape(0.5f, 0.5f), above * turn.GetYAxis(), -float(slope));
  block.SetFriction(float(friction) / 2);
  const b2Body& body = *block.GetBody();
  arena.step(30);
  const b2Vec2 from = body.GetPosition(), velocity = body.GetLinearVelocity();
  const int steps = 60 * arena.sub_steps();
  arena.step(60);
  const double acceleration = gravity * (std::sin(slope) - friction * std::cos(slope));
  return {b2Dot(body.GetPosition() - from, turn.GetXAxis()),
          b2Dot(velocity, turn.GetXAxis()) + 0.5 * acceleration * (1 + 1. / steps)};
}

SlopedStack::SlopedStack(const std::optional<hs_law_def>& law, int height, float slope, float friction)
    : arena_(law), turn_(-slope) {
  arena_.world.SetAllowSleeping(false);
  add_polygon(arena_.world, box_shape(50, 1), {0, 0}, -slope, b2_staticBody);
  for (int i = 0; i < height; ++i) {
    const float above = 1.25f + arena_.rest_gap() + float(i) * (0.5f + arena_.rest_gap());
    top_ = add_polygon(arena_.world, box_shape(1, 0.25f), above * turn_.GetYAxis(), -slope).GetBody();
  }
  set_friction(friction);
}

void SlopedStack::set_friction(float friction) {
  for (b2Body* body = arena_.world.GetBodyList(); body; body = body->GetNext())
    body->GetFixtureList()->SetFriction(friction);
  for (b2Contact* contact : contacts_of(arena_.world)) contact->ResetFriction();
}

double SlopedStack::slide(int steps) {
  const b2Vec2 from = top_->GetPosition();
  arena_.step(steps);
  return b2Dot(top_->GetPosition() - from, turn_.GetXAxis());
}

double creep_let_go(const std::optional<hs_law_def>& law, int height, float slope, float friction) {
  SlopedStack stack(law, height, slope, friction);
  stack.slide(30);
  return stack.slide(300);
}

double creep_settled(const std::optional<hs_law_def>& law, int height, float slope, float friction) {
  SlopedStack stack(law, height, slope, 4 * friction);
  stack.slide(300);
  stack.set_friction(friction);
  return stack.slide(300);
}

Bounce bounce_head_on(double stiffness, int sub_steps_over_needed, bool are_bullets) {
  ForceWorld arena(law_of(stiffness, 0), {0, 0});
  b2Body& a = *add_polygon(arena.world, box_shape(0.5f, 0.5f), {-1, 0}).GetBody();
  b2Body& b = *add_polygon(arena.world, box_shape(0.5f, 0.5f), {1, 0}).GetBody();
  a.SetBullet(are_bullets);
  b.SetBullet(are_bullets);
  a.SetLinearVelocity({1, 0});
  b.SetLinearVelocity({-1, 0});
  const int sub_steps = sub_steps_over_needed * arena.sub_steps();
  for (int i = 0; i < 60; ++i) arena.forces->step(1 / 60.f, sub_steps, 8, 3);
  const double reduced_mass = 0.5;
  return {0.5 * (double(b.GetLinearVelocity().x) - a.GetLinearVelocity().x),
          std::sqrt(stiffness / reduced_mass) / (60 * sub_steps)};
}

}  // namespace halfspace_test
