#include "forces.h"

#include <cmath>

#include "contact.h"

namespace halfspace::box2d {
namespace {

double cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

bool is_active(const b2Body& body) { return body.IsAwake() && body.GetType() != b2_staticBody; }

/// Faster than Box2D's sleep tolerances.
bool is_moving(const b2Body& body) {
  constexpr float linear = b2_linearSleepTolerance, angular = b2_angularSleepTolerance;
  return is_active(body) && (body.GetLinearVelocity().LengthSquared() > linear * linear ||
                             std::abs(body.GetAngularVelocity()) > angular);
}

/// A moving body wakes the bodies that it touches, as in an island of Box2D.
void wake_each_other(b2Body& a, b2Body& b) {
  const bool wakes_b = is_moving(a) && !b.IsAwake(), wakes_a = is_moving(b) && !a.IsAwake();
  if (wakes_b) b.SetAwake(true);
  if (wakes_a) a.SetAwake(true);
}

/// The pair of two fixtures, or NULL: Box2D or the narrow phase excludes it by filters, joints, a common
/// body, or as left to Box2D. Both bodies list the contact, so the search ends with the shorter list.
JudgedPair* judged_pair_between(b2Fixture& a, b2Fixture& b) {
  const auto is_of_both = [&](b2Contact& contact) {
    return (contact.GetFixtureA() == &a && contact.GetFixtureB() == &b) ||
           (contact.GetFixtureA() == &b && contact.GetFixtureB() == &a);
  };
  const b2ContactEdge* of_a = a.GetBody()->GetContactList();
  const b2ContactEdge* of_b = b.GetBody()->GetContactList();
  for (; of_a && of_b; of_a = of_a->next, of_b = of_b->next) {
    if (is_of_both(*of_a->contact)) return judged_pair_of(*of_a->contact);
    if (is_of_both(*of_b->contact)) return judged_pair_of(*of_b->contact);
  }
  return nullptr;
}

}  // namespace

bool ForceMode::Forces::is_awake() const {
  for (const Body& body : bodies_) {
    if (is_active(*body.body)) return true;
  }
  return false;
}

void ForceMode::Forces::follow() {
  Mirror::follow();
  keep_shear_of_renewed();
}

/// A block with changed friction keeps the shear forces of its contacts, up to the limit of the new friction;
/// otherwise a body at rest would move again. The forces are those of the last evaluation, including the
/// dashpots.
void ForceMode::Forces::keep_shear_of_renewed() {
  const auto now = [&](hs_block block) {
    const auto found = renewed_.find(block);
    return found == renewed_.end() ? block : found->second;
  };
  for (const hs_contact& contact : contacts_) {
    const hs_block a = now(contact.block_a), b = now(contact.block_b);
    if (a == contact.block_a && b == contact.block_b) continue;
    const double* shear = contact.shear_force;
    kept_shear_.push_back({a, b, {shear[0], shear[1], shear[2]}});
  }
}

void ForceMode::Forces::evaluate() {
  if (!are_all_somewhere()) follow();  // has changed since the last sub-step
  contacts_.clear();
  place();
  if (blocks_.empty()) return;
  std::int64_t touching = 0;
  world_.require_ok(hs_world_detect(world_.get(), &touching));
  contacts_.resize(std::size_t(touching));
  give_back_kept_shear();
  find_forces(elapsed_);
  elapsed_ = 0;
  if (begin_shear_of_new_pairs()) find_forces(0);
  pairs_begun_ = narrow_phase_.pairs_begun();  // last: after an exception they are still new
}

/// Only if the blocks still touch and their law has a shear spring.
void ForceMode::Forces::give_back_kept_shear() {
  for (const KeptShear& kept : kept_shear_) {
    const hs_status status = hs_world_set_shear_force(world_.get(), kept.a, kept.b, kept.force);
    if (status != HS_ERROR_STALE_ID && status != HS_ERROR_STATE) world_.require_ok(status);
  }
  kept_shear_.clear();
}

void ForceMode::Forces::find_forces(double elapsed) {
  world_.require_ok(hs_world_forces(world_.get(), elapsed, {}, {}));
  world_.require_ok(
      hs_world_get_contacts(world_.get(), contacts_.data(), std::int64_t(contacts_.size()), nullptr));
}

/// Sets the shear of new pairs that overlap in their first sub-step: the host has placed them, by the start
/// of force mode, a new body (possibly with the block of an old one), or a new pose. Pairs that approach by
/// motion begin before they touch. True if there are any.
bool ForceMode::Forces::begin_shear_of_new_pairs() {
  if (pairs_begun_ == narrow_phase_.pairs_begun()) return false;
  bool any = false;
  for (const hs_contact& contact : contacts_) {
    const JudgedPair* pair =
        judged_pair_between(*block(contact.block_a).fixture, *block(contact.block_b).fixture);
    if (!pair || pair->order <= pairs_begun_) continue;
    begin_shear(contact);
    any = true;
  }
  return any;
}

/// The force of a placed pair is vertical, within the limit of friction; otherwise the block would accelerate
/// along the face until its shear spring has extended. On faces steeper than 60 degrees the shear is 0.
void ForceMode::Forces::begin_shear(const hs_contact& contact) {
  const Vector gravity(narrow_phase_.world().GetGravity());
  const Vector normal{contact.normal[0], contact.normal[1]}, force{contact.force[0], contact.force[1]};
  const double push = dot(force, normal), share = dot(gravity, normal);
  const bool bears = share * share > 0.25 * dot(gravity, gravity);
  const Vector shear = bears ? push * (1 / share * gravity - normal) : Vector{};
  const double shear_on_b[3] = {shear.x, shear.y, 0};
  const hs_status status =
      hs_world_set_shear_force(world_.get(), contact.block_a, contact.block_b, shear_on_b);
  if (status != HS_ERROR_STATE) world_.require_ok(status);  // which means that there is no shear spring
}

/// Moving bodies wake the bodies that they touch before forces are applied, so that a woken body has its
/// support.
void ForceMode::Forces::push(float sub_step) {
  for (Body& body : bodies_) body.change = {};
  for (const hs_contact& contact : contacts_) {
    if (const JudgedPair* pair = pair_of(contact); pair && !pair->let_through)
      wake_each_other(*block(contact.block_a).fixture->GetBody(), *block(contact.block_b).fixture->GetBody());
  }
  for (const hs_contact& contact : contacts_) load(contact);
  for (Body& body : bodies_) body.motion.push(*body.body, double(sub_step) * body.change);
}

/// NULL also if neither body is active.
JudgedPair* ForceMode::Forces::pair_of(const hs_contact& contact) const {
  b2Fixture &a = *block(contact.block_a).fixture, &b = *block(contact.block_b).fixture;
  return is_active(*a.GetBody()) || is_active(*b.GetBody()) ? judged_pair_between(a, b) : nullptr;
}

void ForceMode::Forces::load(const hs_contact& contact) {
  const JudgedPair* pair = pair_of(contact);
  if (!pair || pair->let_through) return;
  load(block(contact.block_a), contact, -1);
  load(block(contact.block_b), contact, 1);
}

void ForceMode::Forces::load(const Block& block, const hs_contact& contact, double sign) {
  Body& body = bodies_[block.body];
  const Vector force{contact.force[0], contact.force[1]};
  const Vector arm = Vector{contact.force_point[0], contact.force_point[1]} - body.motion.center();
  body.change = body.change + sign * Rates{force, cross(arm, force) + contact.torque[2]};
}

void ForceMode::Forces::carry_on(float sub_step) {
  const Vector gravity(narrow_phase_.world().GetGravity());
  for (Body& body : bodies_) {
    if (body.body->GetType() == b2_staticBody) continue;
    body.motion.carry_on(*body.body, sub_step, pull_of(*body.body, gravity));
  }
  elapsed_ = sub_step;
}

double ForceMode::Forces::stable_sub_step() const {
  hs_world_report report;
  world_.require_ok(hs_world_get_report(world_.get(), &report, sizeof report));
  return report.stable_time_step;
}

}  // namespace halfspace::box2d
