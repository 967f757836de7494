#pragma once

#include <cstdint>
#include <span>

#include "block/block_state.h"
#include "force/potential/space/division_plan.h"
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
  std::int32_t plan_length = 0;  // of the division plan, if any
  std::int32_t reserved = 0;
  ShearSpring<D> shear;
  ContactForce<D> force;
};

/// A block and all that a world keeps of it, in the machine's format of numbers.
template <int D>
struct BlockRecord {
  explicit BlockRecord(Memory* memory) : outline(memory), pairs(memory), plans(memory) {}

  std::int64_t key = 0;
  std::int32_t has_outline = 0;
  std::int32_t is_new = 0;  // until its first step
  BlockState<D> state;
  Vector<D> acceleration = Vector<D>::Zero();
  Angular<D> momentum_rate = Angular<D>::Zero();
  ListEntry<D> entry;
  OutlineCopy<D> outline;
  Array<PairRecord<D>> pairs;  // in ascending order of partners
  Array<PlanCode> plans;       // of the pairs, one after the other

  /// False for a record that was damaged on its way, as far as lengths tell.
  bool is_complete() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(key, has_outline, is_new, state, acceleration, momentum_rate, entry, pairs, plans);
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
    std::size_t first_code;  // of its division plan, in `codes`
  };

  CarriedPairs(std::size_t blocks, Memory* memory) : all(memory), codes(memory), missing(blocks, 0, memory) {}

  std::span<const PlanCode> plan_of(const Pair& pair) const {
    return {codes.data() + pair.first_code, std::size_t(pair.memory.plan_length)};
  }

  Array<Pair> all;  // in ascending order of a, then b
  Array<PlanCode> codes;
  Array<std::int32_t> missing;  // per block, the number of its pairs with blocks that are not here
};

}  // namespace halfspace
