#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "world/hard_contact/impulse_work.h"
#include "world/hard_contact/manifold.h"
#include "world/hard_contact/rebound_fraction.h"

namespace halfspace {

/// A contact of two rigid blocks by a law without springs, as it is kept from step to step, listed and saved.
/// There is no gap between members.
template <int D>
struct RigidContact {
  Manifold<D> manifold;
  Vector<D> friction = Vector<D>::Zero();                // N s, on b along the plane
  Vector<D> normal = Vector<D>::Zero();                  // unit, from a to b
  std::array<double, max_manifold_points<D>> gap{};      // m, > 0 apart
  std::array<double, max_manifold_points<D>> impulse{};  // N s, normal, of half a step
  Vector<D> found_to_b = Vector<D>::Zero();  // of b in the frame of a, where the manifold was found
  Rotation<D> found_turn;                    // likewise
  double couple = 0;       // N m s, of friction about the normal through the middle of the points, in space
  double touched_at = 0;   // time
  double impact_loss = 0;  // J, in the last motion
  std::int32_t a = -1;
  std::int32_t b = -1;  // a < b

  std::pair<std::int32_t, std::int32_t> blocks() const { return {a, b}; }
  double min_gap() const { return *std::min_element(gap.begin(), gap.begin() + manifold.count); }
  double normal_impulse() const {
    double sum = 0;
    for (int i = 0; i < manifold.count; ++i) sum += impulse[std::size_t(i)];
    return sum;
  }
  /// The couple of friction about the normal through a point, given from the middle of the points.
  double couple_about(const Vector<D>& point) const {
    if constexpr (D == 2)
      return 0;
    else
      return couple - normal.dot(cross_product(point, friction));
  }
};

static_assert(sizeof(RigidContact<2>) == 176 && sizeof(RigidContact<3>) == 520,
              "saved contacts hold stray bytes");

/// A contact of the present motion.
template <int D>
struct PredictedContact : RigidContact<D> {
  std::array<double, max_manifold_points<D>> rebound{};      // m/s, of opening by restitution
  std::array<double, max_manifold_points<D>> gained{};       // m/s, of opening from the impact to the end
  std::array<double, max_manifold_points<D>> rebound_gap{};  // m, at the motion's end, above where it touched
  std::array<bool, max_manifold_points<D>> was_loaded{};     // in the last motion
  Vector<D> center = Vector<D>::Zero();                      // of friction, from the centroid of a
  double impact_at = 0.5;  // fraction of the motion before the impact; half of it where none is
  std::array<double, D - 1> friction_at{};  // likewise, of each row of its friction
  bool is_new = true;
  bool is_kept = false;   // the manifold is that of the last motion
  bool is_apart = false;  // at the motion's end
  ImpulseWork work;       // in the half steps that are booked
  ReboundFraction fraction;

  bool rebounds() const {
    return std::any_of(rebound.begin(), rebound.end(), [](double v) { return v > 0; });
  }
};

template <int D>
bool is_before(const RigidContact<D>& one, const RigidContact<D>& other) {
  return one.blocks() < other.blocks();
}

}  // namespace halfspace
