#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

#include "force/division_plan.h"
#include "geometry/vector.h"

namespace halfspace {

/// What a pair of blocks remembers of its plan.
class PlanMemory {
 public:
  bool knows() const { return state_ >= 0; }
  std::int32_t first() const { return state_ / 2; }
  void remember(std::int32_t first) { state_ = 2 * first; }
  void move_to(std::int32_t first) { state_ = 2 * first + state_ % 2; }

  /// A plan that could not be followed even once was not worth to be made: then some steps pass until the
  /// next one is.
  bool has_served() const { return knows() && state_ % 2 == 1; }
  void serve() { state_ |= 1; }
  void wait(std::int32_t steps) { state_ = -1 - steps; }
  bool waits() {
    if (state_ >= -1) return false;
    ++state_;
    return true;
  }

 private:
  std::int32_t state_ = -1;
};

/// The plans of all pairs of blocks, one behind the other, each with its length before it. One that is no
/// more used takes its room until the plans are tidied.
class DivisionPlans {
 public:
  explicit DivisionPlans(Memory* memory) : codes_(memory), kept_(memory) {}

  std::span<const PlanCode> operator[](const PlanMemory& memory) const {
    const PlanCode* const plan = codes_.data() + memory.first();
    return {plan + 1, std::size_t(plan[0])};
  }

  /// False when there is no room for it.
  bool add(std::span<const PlanCode> plan, PlanMemory& memory) {
    const std::size_t first = codes_.size();
    if (plan.size() > INT16_MAX || first + plan.size() > INT32_MAX / 2) return false;
    codes_.resize(first + 1 + plan.size());
    codes_[first] = PlanCode(plan.size());
    std::copy(plan.begin(), plan.end(), codes_.begin() + std::ptrdiff_t(first) + 1);
    memory.remember(std::int32_t(first));
    return true;
  }

  /// Keeps only what pairs know of, when most is not.
  template <class Pairs>
  void tidy(Pairs& pairs) noexcept {
    if (codes_.size() <= enough_) return;
    kept_.clear();
    try {
      kept_.reserve(codes_.size());
    } catch (const std::bad_alloc&) {
      return;
    }
    for (auto& pair : pairs) {
      if (!pair.plan.knows()) continue;
      const auto first = codes_.begin() + pair.plan.first();
      pair.plan.move_to(std::int32_t(kept_.size()));
      kept_.insert(kept_.end(), first, first + 1 + *first);
    }
    codes_.swap(kept_);
    enough_ = 2 * codes_.size() + 4096;
  }

  std::size_t size() const { return codes_.size(); }

  /// False for what no list can be, after reading a snapshot.
  bool has(const PlanMemory& memory) const {
    const std::size_t first = std::size_t(memory.first());
    return first < codes_.size() && codes_[first] > 0 && std::size_t(codes_[first]) < codes_.size() - first;
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(codes_, enough_);
  }

 private:
  Array<PlanCode> codes_;
  Array<PlanCode> kept_;  // what they are tidied into
  std::uint64_t enough_ = 0;
};

}  // namespace halfspace
