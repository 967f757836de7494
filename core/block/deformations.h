#pragma once

#include "block/deformation.h"

namespace halfspace {

/// The deformations of a world's deformable blocks, in one array. Empty in worlds without any.
template <int D>
class Deformations {
 public:
  explicit Deformations(Memory* memory) : of_slot_(memory), all_(memory) {}

  bool empty() const { return all_.empty(); }
  Array<Deformation<D>>& all() { return all_; }
  const Array<Deformation<D>>& all() const { return all_; }

  /// Allocates for the next block, whichever slot below `slots` it gets.
  void make_room(std::size_t slots) {
    make_room_for_one(all_);
    if (of_slot_.capacity() < slots) of_slot_.reserve(2 * slots);  // blocks are added one by one
  }
  void add(const Deformation<D>& deformation) {
    const std::size_t slot = std::size_t(deformation.slot);
    if (of_slot_.size() <= slot) of_slot_.resize(slot + 1, -1);
    of_slot_[slot] = std::int32_t(all_.size());
    all_.push_back(deformation);
  }
  /// The last deformation moves into the gap.
  void remove(std::int32_t slot) {
    const std::int32_t here = of_slot_[std::size_t(slot)];
    all_[std::size_t(here)] = all_.back();
    of_slot_[std::size_t(all_.back().slot)] = here;
    of_slot_[std::size_t(slot)] = -1;
    while (!of_slot_.empty() && of_slot_.back() < 0) of_slot_.pop_back();
    all_.pop_back();
  }
  Deformation<D>& operator[](std::size_t slot) { return all_[std::size_t(of_slot_[slot])]; }
  const Deformation<D>& operator[](std::size_t slot) const { return all_[std::size_t(of_slot_[slot])]; }

  /// False for data of a damaged snapshot. The deformable blocks are those with `is_deformable(slot)`.
  template <class IsDeformable>
  bool is_consistent(std::size_t slots, IsDeformable is_deformable) const {
    if (of_slot_.size() > slots) return false;
    std::size_t deformable = 0;
    for (std::size_t slot = 0; slot < slots; ++slot) {
      if (!is_deformable(slot)) continue;
      ++deformable;
      if (slot >= of_slot_.size()) return false;
      const std::int32_t here = of_slot_[slot];
      if (here < 0 || std::size_t(here) >= all_.size() || all_[std::size_t(here)].slot != std::int32_t(slot))
        return false;
    }
    return deformable == all_.size();
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(of_slot_, all_);
  }

 private:
  Array<std::int32_t> of_slot_;  // index in all_; ends at the last deformable block
  Array<Deformation<D>> all_;
};

}  // namespace halfspace
