#include "pair_quality.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "stage.h"

namespace box2d_comparison {
namespace {

using halfspace_test::Direction;
using halfspace_test::FaceGap;

/// Far above the rounding of the truth, far below that of floats.
constexpr long double sure = 1e-13L;
/// Box2D's tolerance when it chooses between the faces of a and b.
constexpr long double same_gap = 0.1f * b2_linearSlop;

long double angle_between(const Direction& p, const Direction& q) {
  return std::abs(std::atan2(p.x * q.y - p.y * q.x, p.x * q.x + p.y * q.y));
}

Points polygon_of(const b2Fixture& fixture) {
  const TruePolygon* truth = true_polygon_of(fixture);
  if (truth) return truth->vertices;
  return halfspace_test::vertices_of(static_cast<const b2PolygonShape&>(*fixture.GetShape()));
}

/// What reading the clock adds to each measured time: the least of many.
double clock_seconds() {
  using Clock = std::chrono::steady_clock;
  Clock::duration least = Clock::duration::max();
  for (int i = 0; i < 1000; ++i) {
    const Clock::time_point start = Clock::now();
    least = std::min(least, Clock::now() - start);
  }
  return std::chrono::duration<double>(least).count();
}

}  // namespace

void PairQuality::judge(const b2Manifold& manifold, const b2Transform& at_a, const b2Transform& at_b,
                        const std::vector<FaceGap>& truth, double radii) {
  const FaceGap best = halfspace_test::largest(truth);
  // Past the end of its face the manifold may be empty though no gap is.
  if (std::abs(best.gap - radii) < sure || best.beyond > 0) return;
  const bool is_touching = best.gap <= radii, said_touching = manifold.pointCount > 0;
  ++judged;
  if (is_touching != said_touching) {
    ++wrong_verdicts;
    worst_wrong_verdict = std::max(worst_wrong_verdict, double(std::abs(best.gap - radii)));
  }
  if (!is_touching || !said_touching) return;
  const halfspace_test::StatedContact stated = halfspace_test::stated_by(manifold, at_a, at_b);
  const double depth_error = double(std::abs(stated.gap - best.gap));
  long double normal_error = INFINITY;
  for (const FaceGap& face : truth) {
    if (face.gap >= best.gap - same_gap)
      normal_error = std::min(normal_error, angle_between(face.normal, stated.normal));
  }
  ++touching;
  worst_depth_error = std::max(worst_depth_error, depth_error);
  sum_of_depth_errors_ += depth_error;
  worst_normal_error = std::max(worst_normal_error, double(normal_error));
}

void PairQuality::end_step(std::int64_t pairs) {
  static const double clock = clock_seconds();
  if (pairs > 0) ns_per_pair_.push_back(1e9 * (seconds_ / double(pairs) - clock));
  seconds_ = 0;
}

std::optional<double> PairQuality::ns_per_pair() const {
  if (ns_per_pair_.empty()) return std::nullopt;
  std::vector<double> sorted = ns_per_pair_;
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

PairRecorder::Ids PairRecorder::ids_of(const b2Manifold& manifold) {
  Ids ids = {-1, -1};
  for (int i = 0; i < manifold.pointCount; ++i) ids[std::size_t(i)] = manifold.points[i].id.key;
  return ids;
}

/// Points of either that the other has not.
int PairRecorder::unlike(const Ids& one, const Ids& other) {
  const auto missing = [](const Ids& from, const Ids& in) {
    return std::count_if(from.begin(), from.end(), [&](std::int64_t id) {
      return id >= 0 && std::find(in.begin(), in.end(), id) == in.end();
    });
  };
  return int(missing(one, other) + missing(other, one));
}

bool PairRecorder::is_quiet(const Answered& before, const Answered& now) const {
  return b2Distance(before.shift, now.shift) < quiet &&
         std::hypot(before.turn.c - now.turn.c, before.turn.s - now.turn.s) < quiet;
}

void PairRecorder::hear(const halfspace::box2d::Comparison& pair) {
  const auto truth = halfspace_test::face_gaps(polygon_of(pair.a), pair.at_a, polygon_of(pair.b), pair.at_b);
  const double radii = pair.a.GetShape()->m_radius + pair.b.GetShape()->m_radius;
  box2d.judge(pair.box2d, pair.at_a, pair.at_b, truth, radii);
  halfspace.judge(pair.halfspace, pair.at_a, pair.at_b, truth, radii);

  const Answered now{b2MulT(pair.at_a.q, pair.at_b.p - pair.at_a.p), b2MulT(pair.at_a.q, pair.at_b.q),
                     ids_of(pair.box2d), ids_of(pair.halfspace)};
  const auto [known, is_new] = answered_.try_emplace({&pair.a, &pair.b}, now);
  if (!is_new && is_quiet(known->second, now)) {
    ++quiet_pairs;
    box2d.add_flicker(unlike(known->second.box2d, now.box2d));
    halfspace.add_flicker(unlike(known->second.halfspace, now.halfspace));
  }
  known->second = now;

  box2d.add_time(pair.box2d_seconds);
  halfspace.add_time(pair.seconds);
  ++pairs_;
}

void PairRecorder::end_step() {
  box2d.end_step(pairs_);
  halfspace.end_step(pairs_);
  pairs_ = 0;
}

}  // namespace box2d_comparison
