#pragma once

// How right the answers of a narrow phase are, pair by pair, against long double.

#include <array>
#include <cstdint>
#include <halfspace/box2d.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "box2d/face_gaps.h"

namespace box2d_comparison {

/// Of one narrow phase, over all pairs of a run.
class PairQuality {
 public:
  /// The answer to a pair that `truth` is true of: its face of largest gap, and those as good to Box2D's
  /// tolerance, 0.5 mm. Two polygons touch within `radii`.
  void judge(const b2Manifold& manifold, const b2Transform& at_a, const b2Transform& at_b,
             const std::vector<halfspace_test::FaceGap>& truth, double radii);

  /// Points of the pair that have come or gone since its last answer, in which it hardly moved.
  void add_flicker(int points) { flicker_ += points; }
  void add_time(double seconds) { seconds_ += seconds; }
  void end_step(std::int64_t pairs);

  std::int64_t judged = 0;          ///< verdicts that long double is sure of
  std::int64_t wrong_verdicts = 0;  ///< of these
  /// m, the farthest that a gap was from the reach of the skins and was judged wrong
  double worst_wrong_verdict = 0;
  std::int64_t touching = 0;     ///< rightly found so: the following are over these
  double worst_depth_error = 0;  ///< m, of the least gap that the manifold states
  double mean_depth_error() const { return touching ? sum_of_depth_errors_ / double(touching) : 0; }
  double worst_normal_error = 0;  ///< rad, from the nearest normal that is as good as the best
  std::int64_t flicker() const { return flicker_; }
  /// Median over steps, for the other processes of the machine; none when there were no pairs.
  std::optional<double> ns_per_pair() const;

 private:
  double sum_of_depth_errors_ = 0;
  std::int64_t flicker_ = 0;
  double seconds_ = 0;               // of this step
  std::vector<double> ns_per_pair_;  // of each step
};

/// Hears both narrow phases on the same pairs at the same poses.
class PairRecorder {
 public:
  void hear(const halfspace::box2d::Comparison& pair);
  void end_step();

  PairQuality box2d, halfspace;
  std::int64_t quiet_pairs = 0;  ///< answers to pairs that have hardly moved since the one before

 private:
  /// The ids of a manifold's points, -1 where there is none.
  using Ids = std::array<std::int64_t, 2>;
  struct Answered {
    b2Vec2 shift;  // of b seen from a
    b2Rot turn;
    Ids box2d, halfspace;
  };
  static Ids ids_of(const b2Manifold& manifold);
  static int unlike(const Ids& one, const Ids& other);
  bool is_quiet(const Answered& before, const Answered& now) const;

  std::map<std::pair<const b2Fixture*, const b2Fixture*>, Answered> answered_;
  std::int64_t pairs_ = 0;  // of this step
};

/// A pair is quiet when the turn between its polygons has changed by less than this, in rad, and their shift
/// by less than this, in m: a fifth of Box2D's own tolerance for the choice of a face.
constexpr double quiet = 1e-4;

}  // namespace box2d_comparison
