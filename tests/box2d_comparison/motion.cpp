#include "motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engines.h"

namespace box2d_comparison {
namespace {

/// In double: Box2D's own sums would lose what is asked for.
double dot(const b2Vec2& p, const b2Vec2& q) { return double(p.x) * q.x + double(p.y) * q.y; }

double kinetic_of(const b2Body& body) {
  const b2Vec2 v = body.GetLinearVelocity();
  const double w = body.GetAngularVelocity();
  // Box2D tells the inertia about the body's origin.
  const b2Vec2 centre = body.GetLocalCenter();
  const double inertia = body.GetInertia() - body.GetMass() * dot(centre, centre);
  return 0.5 * body.GetMass() * dot(v, v) + 0.5 * inertia * w * w;
}

}  // namespace

Motion::Motion(b2World& world, b2Vec2 drift_axis) : world_(world), drift_axis_(drift_axis) {
  for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext()) {
    if (body->GetType() == b2_dynamicBody)
      watched_.push_back({body, body->GetWorldCenter(), body->GetLinearVelocity()});
  }
}

void Motion::look(double step_seconds) {
  MotionRow row{};
  row.time = frame_seconds * double(rows_.size() + 1);
  double squared_changes = 0;
  std::vector<double> drifts;
  for (Watched& w : watched_) {
    const b2Vec2 moved = w.body->GetWorldCenter() - w.start, velocity = w.body->GetLinearVelocity();
    const b2Vec2 change = velocity - w.velocity;
    row.kinetic += kinetic_of(*w.body);
    row.potential -= w.body->GetMass() * dot(world_.GetGravity(), moved);
    drifts.push_back(std::abs(dot(drift_axis_, moved)));
    row.largest_speed = std::max(row.largest_speed, std::sqrt(dot(velocity, velocity)));
    squared_changes += dot(change, change);
    w.velocity = velocity;
  }
  std::sort(drifts.begin(), drifts.end());
  row.drift = drifts.back();
  row.median_drift = drifts[drifts.size() / 2];
  row.jitter = std::sqrt(squared_changes / double(watched_.size()));
  for (const b2Contact* c = world_.GetContactList(); c; c = c->GetNext())
    row.contact_points += c->GetManifold()->pointCount;
  row.seconds = step_seconds;
  rows_.push_back(row);
}

MotionSummary summary_of(const std::vector<MotionRow>& rows) {
  MotionSummary summary{};
  const MotionRow &last = rows.back(), &middle = rows[rows.size() / 2];
  const auto moving = std::find_if(rows.rbegin(), rows.rend(),
                                   [](const MotionRow& row) { return row.largest_speed > at_rest; });
  if (moving == rows.rend()) {
    summary.rest_time = 0;
  } else if (moving != rows.rbegin()) {
    summary.rest_time = moving->time;
  }
  summary.drift = last.drift;
  summary.median_drift = last.median_drift;
  summary.creep = std::abs(last.drift - middle.drift) / (last.time - middle.time);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double change =
        (rows[i].kinetic - rows[i - 1].kinetic) + (rows[i].potential - rows[i - 1].potential);
    summary.energy_gained += std::max(0., change);
  }
  const std::size_t last_second = std::min<std::size_t>(60, rows.size());
  for (std::size_t i = rows.size() - last_second; i < rows.size(); ++i)
    summary.jitter += rows[i].jitter / double(last_second);
  double seconds = 0;
  for (const MotionRow& row : rows) seconds += row.seconds;
  summary.frames_per_second = double(rows.size()) / seconds;
  return summary;
}

}  // namespace box2d_comparison
