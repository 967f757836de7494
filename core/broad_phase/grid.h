#pragma once

#include <cstdint>
#include <span>

#include "geometry/box.h"

namespace halfspace {

/// Two blocks that may touch, a < b.
struct BlockPair {
  std::int32_t a;
  std::int32_t b;
};

/// Finds all pairs of overlapping boxes, at any ratio of sizes, in time linear in blocks and pairs.
///
/// A hierarchical grid, one level per power of two. The centre of a block lies in the grid with cells just
/// larger than the block. It searches this grid and all coarser ones, in at most 3^D cells each. One cell
/// size, that of the largest block as in the papers, would put all grains on a plate into one cell.
template <int D>
class Grid {
 public:
  explicit Grid(Memory* memory) : cells_(memory), first_of_bucket_(memory), levels_(memory) {}

  /// Calls `found(BlockPair)` once per pair among the given boxes, in an order fixed by the input.
  /// `is_member(i)` is false for entries that are not blocks.
  template <class IsMember, class Found>
  void search(std::span<const Box<D>> boxes, IsMember is_member, Found found);

 private:
  struct Cell {
    std::int64_t index[D];
    std::int32_t level;
    std::int32_t block;
    bool same_place(const Cell& other) const {
      if (level != other.level) return false;
      for (int k = 0; k < D; ++k) {
        if (index[k] != other.index[k]) return false;
      }
      return true;
    }
  };

  static std::int32_t level_of(const Box<D>& box);
  static Cell cell_of(const Box<D>& box, std::size_t block);
  static std::int64_t cell_index(double coordinate, double cell_size);
  std::size_t bucket_of(const Cell& cell) const;
  template <class IsMember>
  void sort_into_buckets(std::span<const Box<D>> boxes, IsMember is_member);

  Array<Cell> cells_;                     // of the blocks, sorted by bucket
  Array<std::uint32_t> first_of_bucket_;  // size: number of buckets + 1
  Array<std::int32_t> levels_;            // in use, ascending
};

}  // namespace halfspace

#include "broad_phase/grid_search.h"
