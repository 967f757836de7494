#pragma once

// What a world does from step to step, and what that comes to.

#include <box2d/box2d.h>

#include <optional>
#include <vector>

namespace box2d_comparison {

/// Of all dynamic bodies, after a step.
struct MotionRow {
  double time;           // s
  double kinetic;        // J
  double potential;      // J, 0 at the start
  double drift;          // m, the farthest that a body is along the drift axis from where it began
  double median_drift;   // m, that of the usual body
  double largest_speed;  // m/s
  double jitter;         // m/s, root mean square over bodies of the change of velocity in this step
  int contact_points;
  double seconds;  // that the step took
};

/// Watches a world. Bodies that are made later are not seen.
class Motion {
 public:
  Motion(b2World& world, b2Vec2 drift_axis);

  /// To be called after each step.
  void look(double step_seconds);

  const std::vector<MotionRow>& rows() const { return rows_; }

 private:
  struct Watched {
    const b2Body* body;
    b2Vec2 start;
    b2Vec2 velocity;  // after the step before
  };

  b2World& world_;
  b2Vec2 drift_axis_;
  std::vector<Watched> watched_;
  std::vector<MotionRow> rows_;
};

/// Of a whole run.
struct MotionSummary {
  std::optional<double> rest_time;  // s, from when on no body is faster than `at_rest`; none: it never rests
  double drift;                     // m, at the end, of the farthest body
  double median_drift;              // m, at the end, of the usual one
  double creep;                     // m/s, of the drift over the second half
  double energy_gained;      // J, the sum over all steps that end with more energy than they began with
  double jitter;             // m/s, mean over the last second
  double frames_per_second;  // that the processor could do, over all steps
};
/// Of two steps or more.
MotionSummary summary_of(const std::vector<MotionRow>& rows);

constexpr double at_rest = 0.01;  // m/s: Box2D's own threshold for sleep

}  // namespace box2d_comparison
