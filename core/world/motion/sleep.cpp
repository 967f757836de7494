#include "world/motion/sleep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/numbers.h"
#include "world/motion/islands.h"

namespace halfspace {
namespace {

constexpr double for_ever = std::numeric_limits<double>::max();

}  // namespace

/// Solves way(t) = `way`, in a form without cancellation. The time is 0 for a bound that is not finite.
double SpeedBound::time_for(double way) const {
  const double divisor = speed + std::sqrt(speed * speed + 2 * acceleration * way);
  if (!(divisor >= 0 && way > 0)) return 0;
  return std::min(2 * way / divisor, for_ever);
}

template <int D>
void Sleep<D>::reserve(std::size_t slots) {
  const auto each = [&](auto&... arrays) { (arrays.reserve(slots), ...); };
  each(rest_, error_used_, since_, until_, speed_bound_, island_, longest_);
}

template <int D>
void Sleep<D>::resize(std::size_t slots) {
  const auto each = [&](auto&... arrays) { (arrays.resize(slots), ...); };
  each(rest_, error_used_, since_, until_, speed_bound_, island_, longest_);
}

template <int D>
void Sleep<D>::begin_look(const Blocks<D>& blocks, std::size_t i) {
  const bool is_driven =
      blocks.kind[i] == BlockKind::prescribed && !(blocks.velocity[i].isZero(0) && blocks.spin[i].isZero(0));
  rest_[i] = blocks.moves_freely(i) || is_driven ? Rest::none : Rest::fixed;
  island_[i] = std::int32_t(i);
}

/// A sleep uses at most half of the remaining tolerance, so some always remains. The less remains, the longer
/// the minimum sleep: otherwise a block that is still settling would use it up in short sleeps. Prescribed
/// blocks and mesh blocks do not sleep.
template <int D>
double Sleep<D>::longest_sleep(const Model<D>& model, std::size_t i, double min_sleep) const {
  if (rest_[i] == Rest::fixed) return for_ever;
  if (!model.blocks.moves_freely(i) || model.blocks.is_of_mesh(i)) return 0;
  const double tolerance = model.settings.sleep_tolerance, left = tolerance - error_used_[i];
  const double longest = speed_bound_[i].time_for(0.5 * left);
  return longest * (left / tolerance) >= min_sleep ? longest : 0;
}

template <int D>
std::int32_t Sleep<D>::head_of(std::int32_t slot) {
  return head_of_island(island_, slot);
}

/// Fixed blocks do not connect islands. The smallest slot represents an island, so the order of contacts does
/// not matter.
template <int D>
void Sleep<D>::join(std::int32_t a, std::int32_t b) {
  if (rest_[std::size_t(a)] != Rest::none || rest_[std::size_t(b)] != Rest::none) return;
  const std::int32_t head_a = head_of(a), head_b = head_of(b);
  const auto [first, second] = std::minmax(head_a, head_b);
  double& longest = longest_[std::size_t(first)];
  longest = std::min(longest, longest_[std::size_t(second)]);
  island_[std::size_t(second)] = first;
}

template <int D>
void Sleep<D>::join_by_bonds(const Blocks<D>& blocks) {
  for (const Bond<D>& bond : blocks.bonds().all()) {
    if (bond.is_joint) join(bond.a, bond.b);
  }
}

template <int D>
void Sleep<D>::put_to_sleep(double time, double min_sleep) {
  const std::int64_t before = sleeping_;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (rest_[i] != Rest::none) continue;
    island_[i] = head_of(std::int32_t(i));
    const double longest = longest_[std::size_t(island_[i])];
    if (!(longest >= min_sleep)) continue;
    rest_[i] = Rest::asleep;
    since_[i] = time;
    until_[i] = time + longest;
    next_wake_ = any() ? std::min(next_wake_, until_[i]) : until_[i];
    ++sleeping_;
  }
  if (sleeping_ > before) ++changes_;
}

/// Wakes the islands for whose head `wakes(head)` is true.
template <int D>
template <class Wakes>
bool Sleep<D>::wake_islands(Wakes wakes, double time) {
  const std::int64_t before = sleeping_;
  next_wake_ = for_ever;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (rest_[i] != Rest::asleep) continue;
    if (!wakes(std::size_t(island_[i]))) {
      next_wake_ = std::min(next_wake_, until_[i]);
      continue;
    }
    rest_[i] = Rest::none;
    error_used_[i] += speed_bound_[i].way(time - since_[i]);
    --sleeping_;
  }
  if (sleeping_ == before) return false;
  ++changes_;
  return true;
}

template <int D>
void Sleep<D>::wake_in_time(double time, double duration) {
  if (!any() || next_wake_ > time + duration) return;
  wake_islands([&](std::size_t head) { return until_[head] <= time + duration; }, time);
}

/// Marks the head of a touched island by its until_, which is no longer needed.
template <int D>
bool Sleep<D>::mark_touched(std::int32_t mover, std::int32_t sleeper) {
  if (rest_[std::size_t(mover)] != Rest::none || rest_[std::size_t(sleeper)] != Rest::asleep) return false;
  until_[std::size_t(island_[std::size_t(sleeper)])] = -for_ever;
  return true;
}

template <int D>
bool Sleep<D>::wake_marked(double time) {
  return wake_islands([&](std::size_t head) { return until_[head] == -for_ever; }, time);
}

template <int D>
void Sleep<D>::forget(std::size_t slot) {
  if (slot < error_used_.size()) error_used_[slot] = 0;
}

template <int D>
void Sleep<D>::wake_island_of(std::size_t slot, double time) {
  if (!is_asleep(slot)) return;
  const std::size_t wanted = std::size_t(island_[slot]);
  wake_islands([&](std::size_t head) { return head == wanted; }, time);
}

template <int D>
void Sleep<D>::wake_all(double time) {
  if (any()) wake_islands([](std::size_t) { return true; }, time);
}

template <int D>
double Sleep<D>::max_error(double time) const {
  double most = 0;
  for (std::size_t i = 0; i < rest_.size(); ++i)
    most = std::max(most, error_used_[i] + (is_asleep(i) ? speed_bound_[i].way(time - since_[i]) : 0));
  return most;
}

template <int D>
bool Sleep<D>::is_consistent(std::size_t slots, bool knows_all) const {
  const std::size_t count = rest_.size();
  if (count > slots || error_used_.size() != count || since_.size() != count || until_.size() != count ||
      speed_bound_.size() != count || island_.size() != count)
    return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (rest_[i] > Rest::asleep || !is_nonnegative(error_used_[i])) return false;
    if (rest_[i] != Rest::asleep) continue;
    const bool has_head = island_[i] >= 0 && std::size_t(island_[i]) < count;
    const bool has_pace =
        is_nonnegative(speed_bound_[i].speed) && is_nonnegative(speed_bound_[i].acceleration);
    if (!has_head || !has_pace || !is_finite(since_[i]) || !is_finite(until_[i])) return false;
  }
  return ((sleeping_ == 0 && !knows_all) || count == slots) && is_finite(next_wake_) &&
         sleeping_ == std::count(rest_.begin(), rest_.end(), Rest::asleep);
}

template class Sleep<2>;
template class Sleep<3>;

}  // namespace halfspace
