#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "world/share/block_record.h"
#include "world/world.h"

namespace halfspace {

/// A block of a world to be assembled.
struct PackedBlock {
  std::int64_t key = 0;
  ShareRole role = ShareRole::own;
  /// Its record; empty: as the world has it from which the share is assembled.
  std::span<const std::byte> bytes;
};

/// Why a world cannot be assembled, and at which of its blocks.
struct AssemblyFault {
  enum Kind {
    none,
    unknown_block,    // without a record, and not one of the other world's own blocks
    unknown_outline,  // the record has no outline, and the other world has no such block
    damaged_record,
    other_step,  // the record is of another step than the world
    wrong_role,  // own and copied blocks move freely, others are everywhere
    inconsistent_state
  };
  Kind kind = none;
  std::size_t block = 0;
};

/// The record of a block, from which assemble() makes it in another world.
template <int D>
void write_record(State<D>& from, std::size_t slot, bool with_outline, BlockRecord<D>& out);

/// Makes the new and empty world `to` one of the given blocks, in ascending order of keys.
template <int D>
AssemblyFault assemble(World<D>& to, World<D>& from, std::span<const PackedBlock> blocks);

}  // namespace halfspace
