#include "impulses.h"

#include <algorithm>
#include <cmath>

#include "user_force.h"

namespace halfspace::box2d {
namespace {

hs_law_def law_without_springs() {
  hs_law_def law;
  require_current(hs_law_def_init(&law, sizeof law));
  law.stiffness_kind = HS_STIFFNESS_NONE;
  return law;
}

hs_world_def world_def_of(const b2World& world, const ImpulseOptions& options) {
  hs_world_def def = make_world_def(world.GetGravity());
  def.max_impulse_iterations = options.max_iterations;
  def.impulse_tolerance = options.tolerance;
  def.locate_impacts = options.locate_impacts;
  return def;
}

/// A rigid block has one shape, uniform density, and may rotate. Masses of polygons whose close vertices
/// Box2D welds differ by less than this fraction.
bool has_motion_of_block(const b2Body& body, const Polygon& polygon) {
  constexpr double tolerance = 0.01;
  int solid = 0;
  for (const b2Fixture* each = body.GetFixtureList(); each; each = each->GetNext())
    solid += !each->IsSensor();
  if (solid != 1 || body.IsFixedRotation() || !(body.GetMass() > 0)) return false;
  const hs_shape_properties properties = properties_of_polygon(*polygon.shape());
  const double square = (properties.second_moment[0] + properties.second_moment[1]) / properties.volume;
  const Vector center(body.GetLocalCenter()), off = center - polygon.centroid();
  const double square_of_body = inertia_of(body) / body.GetMass();
  return std::abs(square_of_body - square) <= tolerance * square &&
         dot(off, off) <= tolerance * tolerance * square;
}

/// The smaller one of two numbers of equal sign, else 0.
double common_part(double a, double b) {
  if (!(a * b > 0)) return 0;
  return std::abs(a) < std::abs(b) ? a : b;
}

/// Is a change of velocity more than rounding?
bool is_felt(const Rates& change, const Rates& by_forces) {
  constexpr double tolerance = 1e-6;
  const auto size = [](const Rates& rates) {
    return std::sqrt(dot(rates.linear, rates.linear)) + std::abs(rates.angular);
  };
  return size(change) > tolerance * size(by_forces);
}

/// Joints, circles and edges act on a body in Box2D's step, after that of the mirror, which expects what they
/// did in the last step, up to twice what they did in the one before: a load that lasts or grows is carried,
/// and an impact is not repeated.
Rates expected(const std::array<Rates, 2>& last) {
  const auto& [a, b] = last;
  return {{common_part(a.linear.x, 2 * b.linear.x), common_part(a.linear.y, 2 * b.linear.y)},
          common_part(a.angular, 2 * b.angular)};
}

/// Shortens a displacement to what joints of Box2D tolerate.
Rates within_slop(const Rates& displacement) {
  const double linear = std::sqrt(dot(displacement.linear, displacement.linear));
  const double excess = std::max(linear / b2_linearSlop, std::abs(displacement.angular) / b2_angularSlop);
  return excess > 1 ? 1 / excess * displacement : displacement;
}

}  // namespace

ImpulseMode::Impulses::Impulses(NarrowPhase::Installation& narrow_phase, const ImpulseOptions& options)
    : Mirror(narrow_phase, law_without_springs(), world_def_of(narrow_phase.world(), options)) {}

std::optional<Material> ImpulseMode::Impulses::material_for(const b2Fixture& fixture,
                                                            const Polygon& polygon) const {
  const b2Body& body = *fixture.GetBody();
  if (excluded_.contains(body)) return {};
  if (body.GetType() == b2_dynamicBody && !has_motion_of_block(body, polygon)) return {};
  Material material = material_of(fixture, polygon);
  material.restitution = fixture.GetRestitution();
  return material;
}

bool ImpulseMode::Impulses::has(const b2Contact& contact) const {
  return block_of(*contact.GetFixtureA()) != 0 && block_of(*contact.GetFixtureB()) != 0;
}

bool ImpulseMode::Impulses::keep(const b2Contact& contact) const {
  return has(contact) || !is_somewhere(*contact.GetFixtureA()->GetBody()) ||
         !is_somewhere(*contact.GetFixtureB()->GetBody());
}

double ImpulseMode::Impulses::unbalanced_velocity() const {
  hs_world_report report;
  world_.require_ok(hs_world_get_report(world_.get(), &report, sizeof report));
  return report.unbalanced_velocity;
}

void ImpulseMode::Impulses::advance(float time_step) {
  excluded_.find(narrow_phase_.world(), time_step);
  follow();
  courses_.assign(bodies_.size(), {});
  if (blocks_.empty()) return;
  place();
  const b2Vec2 pull = narrow_phase_.world().GetGravity();
  const double gravity[3] = {pull.x, pull.y, 0};
  world_.require_ok(hs_world_set_gravity(world_.get(), gravity));
  world_.require_ok(hs_world_set_time_step(world_.get(), time_step));
  for (std::size_t i = 0; i < blocks_.size(); ++i) load(i, time_step);
  is_within_step_ = true;
  world_.require_ok(hs_world_step(world_.get(), 1));
  is_within_step_ = false;
  world_.require_ok(hs_world_get_poses(world_.get(), poses_.data(), block_count(), nullptr));
  world_.require_ok(hs_world_get_velocities(world_.get(), view_of<hs_mutable_view>(&Motion::velocity),
                                            view_of<hs_mutable_view>(&Motion::spin)));
  for (std::size_t i = 0; i < blocks_.size(); ++i) direct(i, time_step);
}

/// Does nothing else than the mirror act on the body?
bool ImpulseMode::Impulses::is_free(const b2Body& body) const {
  if (body.GetJointList()) return false;
  for (const b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next) {
    const b2Contact& contact = *edge->contact;
    const bool is_sensor = contact.GetFixtureA()->IsSensor() || contact.GetFixtureB()->IsSensor();
    if (contact.IsTouching() && !is_sensor && !has(contact)) return false;
  }
  return true;
}

/// Gives a block the forces of its body, including those of damping and those expected of others.
void ImpulseMode::Impulses::load(std::size_t i, double h) {
  const Body& body = bodies_[blocks_[i].body];
  Course& course = courses_[blocks_[i].body];
  if (body.body->GetType() != b2_dynamicBody) return;
  const Vector gravity(narrow_phase_.world().GetGravity());
  const double mass = body.body->GetMass(), inertia = inertia_of(*body.body);
  const Rates force = user_force_of(*body.body), before = body.motion.rates();
  course.acceleration =
      pull_of(*body.body, gravity) + Rates{1 / mass * force.linear, force.angular / inertia};
  course.free = Damping(*body.body, h)(before + h * course.acceleration);
  const Rates added = 1 / h * (course.free + expected(body.disturbances) - before) - Rates{gravity};
  const double applied[3] = {mass * added.linear.x, mass * added.linear.y, 0};
  const double torque[3] = {0, 0, inertia * added.angular};
  world_.require_ok(hs_world_set_applied_force(world_.get(), ids_[i], applied, torque));
}

/// A free body makes the motion of its block. Another gets the impulses of its contacts, and if there are
/// any, the place that they give it.
void ImpulseMode::Impulses::direct(std::size_t i, double h) {
  const auto& [position, rotation] = poses_[i];
  const auto& [velocity, spins] = motions_[i];
  Body& body = bodies_[blocks_[i].body];
  Course& course = courses_[blocks_[i].body];
  if (body.body->GetType() != b2_dynamicBody) return;
  const double z = rotation[2], w = rotation[3], spin = spins[2];
  const Turn turn{w * w - z * z, 2 * z * w}, turned = turn * body.turn.inverse();
  const Vector arm = turn * blocks_[i].arm, center = Vector{position[0], position[1]} - arm;
  const Rates end{Vector{velocity[0], velocity[1]} - spin * Vector{-arm.y, arm.x}, spin};
  const Rates way{center - body.motion.center(), std::atan2(turned.sine, turned.cosine)};
  const Rates by_others = expected(body.disturbances), by_contacts = end - course.free - by_others;
  if (is_free(*body.body)) {
    course.mean = 1 / h * way;
    course.end = end;
  } else {
    course.mean = course.end = end - by_others;
    if (is_felt(by_contacts, h * course.acceleration)) course.shift = within_slop(way - h * end);
  }
  const Rates directed = Damping(*body.body, h).undo(course.mean) - h * course.acceleration;
  body.motion.set_rates(*body.body, directed);
}

void ImpulseMode::Impulses::complete(float time_step) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    const Course& course = courses_[i];
    if (body.body->GetType() == b2_staticBody) continue;
    body.motion.carry_on(*body.body, time_step, course.acceleration);
    if (body.body->GetType() != b2_dynamicBody) continue;
    const Rates by_others = body.motion.rates() - course.mean;
    body.disturbances = {by_others, body.disturbances[0]};
    body.motion.set_rates(*body.body, course.end + by_others);
    body.motion.shift(*body.body, course.shift);
  }
}

}  // namespace halfspace::box2d
