#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>

#include "block/block_state.h"
#include "force/spring/spring.h"
#include "narrow_phase/contact.h"
#include "world/contacts/neighbor_list.h"

namespace halfspace {

/// The memory of a pair, as both of its blocks carry it from share to share.
template <int D>
struct PairRecord {
  std::int64_t partner = 0;  // key of the other block
  PairCache<D> witness;
  std::int32_t bonded = 0;
  std::int32_t is_in_contact = 0;
  std::int32_t reserved[D == 2 ? 4 : 2] = {};  // explicit padding, so that all bytes are defined
  ShearSpring<D> shear;
  ContactForce<D> force;
};
template <int D>
constexpr std::size_t size_of_pair_members = sizeof(std::int64_t) + sizeof(PairCache<D>) +
                                             2 * sizeof(std::int32_t) + sizeof(PairRecord<D>::reserved) +
                                             sizeof(ShearSpring<D>) + sizeof(ContactForce<D>);
static_assert(sizeof(PairRecord<2>) == size_of_pair_members<2> &&
              sizeof(PairRecord<3>) == size_of_pair_members<3>);

/// The maxima of a world's report so far.
struct Peaks {
  double speed = 0;
  double overlap = 0;
  double penetration_ratio = 0;
};

/// A block and all that a world keeps of it, in the machine's format of numbers.
template <int D>
struct BlockRecord {
  explicit BlockRecord(Memory* memory) : outline(memory), pairs(memory) {}

  std::int64_t key = 0;
  std::int64_t step = 0;     // of the world that it comes from
  std::int32_t version = 0;  // of snapshots, whose states it holds
  std::int32_t has_outline = 0;
  std::int32_t is_new = 0;  // until its first step
  BlockState<D> state;
  Vector<D> acceleration = Vector<D>::Zero();
  Angular<D> momentum_rate = Angular<D>::Zero();
  ListEntry<D> entry;
  OutlineCopy<D> outline;
  Peaks peaks;  // of the world that it comes from, so that the whole world has those of all shares
  Array<PairRecord<D>> pairs;  // in ascending order of partners

  /// False for a record that was damaged on its way, as far as lengths tell.
  bool is_complete() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(key, step, version, has_outline, is_new, state, acceleration, momentum_rate, entry, peaks, pairs);
    if (has_outline) archive(outline);
  }
};

/// The pairs of a world to be assembled, from the records of its blocks.
template <int D>
struct CarriedPairs {
  struct Pair {
    std::int32_t a;
    std::int32_t b;
    PairRecord<D> memory;
  };

  CarriedPairs(std::size_t blocks, Memory* memory)
      : missing(blocks, 0, memory), all_(memory), order_(memory), late_(memory) {}

  void reserve(std::size_t count) {
    all_.reserve(count);
    order_.reserve(count);
  }
  /// Adds a pair that follows those added before.
  void add(const Pair& pair) {
    order_.push_back(std::uint32_t(all_.size()));
    all_.push_back(pair);
  }
  /// Adds any other pair.
  void add_late(const Pair& pair) {
    late_.push_back(std::uint32_t(all_.size()));
    all_.push_back(pair);
  }
  /// Pairs are long, and stay where they are.
  void put_in_order() {
    const auto precedes = [&](std::uint32_t i, std::uint32_t j) {
      return std::tie(all_[i].a, all_[i].b) < std::tie(all_[j].a, all_[j].b);
    };
    std::sort(late_.begin(), late_.end(), precedes);
    Array<std::uint32_t> merged(all_.size(), 0, order_.get_allocator());
    std::merge(order_.begin(), order_.end(), late_.begin(), late_.end(), merged.begin(), precedes);
    order_.swap(merged);
  }

  std::size_t size() const { return order_.size(); }
  /// In ascending order of a, then b.
  const Pair& operator[](std::size_t k) const { return all_[order_[k]]; }

  Array<std::int32_t> missing;  // per block, the number of its pairs with blocks that are not here

 private:
  Array<Pair> all_;
  Array<std::uint32_t> order_;
  Array<std::uint32_t> late_;
};

}  // namespace halfspace
