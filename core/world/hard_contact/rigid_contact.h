#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "world/hard_contact/manifold.h"

namespace halfspace {

/// A contact of two rigid blocks by a law without springs, as it is kept from step to step, listed and saved.
template <int D>
struct RigidContact {
  std::int32_t a = -1;
  std::int32_t b = -1;  // a < b
  Manifold<D> manifold;
  std::array<double, max_manifold_points<D>> gap{};      // m, > 0 apart
  std::array<double, max_manifold_points<D>> impulse{};  // N s, normal, of half a step
  Vector<D> friction = Vector<D>::Zero();                // N s, on b along the plane
  Vector<D> normal = Vector<D>::Zero();                  // unit, from a to b
  double couple = 0;                                     // N m s, of friction about the normal, in space
  double touched_at = 0;                                 // time
  double stored_work = 0;                                // J: see RigidContacts::book()

  std::pair<std::int32_t, std::int32_t> blocks() const { return {a, b}; }
  double normal_impulse() const {
    double sum = 0;
    for (int i = 0; i < manifold.count; ++i) sum += impulse[std::size_t(i)];
    return sum;
  }
};

}  // namespace halfspace
