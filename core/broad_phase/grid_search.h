#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "broad_phase/grid.h"

// The search of the hierarchical grid (see grid.h):
//
//   put each block into the bucket of its centre's cell, by the hash of the cell
//   for each block, each grid at least as coarse as its own, and each cell there that its box reaches:
//     for each block in the bucket of that cell: report the pair once if the boxes overlap

namespace halfspace {

template <int D>
std::int32_t Grid<D>::level_of(const Box<D>& box) {
  int exponent;
  std::frexp(box.extent(), &exponent);  // extent < 2^exponent
  return exponent;
}

template <int D>
std::int64_t Grid<D>::cell_index(double coordinate, double cell_size) {
  // Cells beyond this merge into one: far blocks cost more, but no pair is lost.
  constexpr double farthest = 0x1p60;
  // This order of min and max also maps NaN, possible in a damaged snapshot, to a far cell.
  return std::int64_t(std::floor(std::max(std::min(farthest, coordinate / cell_size), -farthest)));
}

template <int D>
std::size_t Grid<D>::bucket_of(const Cell& cell) const {
  std::uint64_t hash = std::uint64_t(cell.level) * 0x9E3779B97F4A7C15u;
  for (int k = 0; k < D; ++k) {
    hash = (hash ^ std::uint64_t(cell.index[k])) * 0xBF58476D1CE4E5B9u;
    hash ^= hash >> 29;
  }
  return std::size_t(hash) & (first_of_bucket_.size() - 2);
}

template <int D>
typename Grid<D>::Cell Grid<D>::cell_of(const Box<D>& box, std::size_t block) {
  Cell cell;
  cell.level = level_of(box);
  cell.block = std::int32_t(block);
  const double size = std::ldexp(1.0, cell.level);
  const Vector<D> center = box.center();
  for (int k = 0; k < D; ++k) cell.index[k] = cell_index(center[k], size);
  return cell;
}

/// A counting sort, stable within each bucket.
template <int D>
template <class IsMember>
void Grid<D>::sort_into_buckets(std::span<const Box<D>> boxes, IsMember is_member) {
  std::size_t members = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) members += is_member(i);
  const std::size_t buckets = std::bit_ceil(std::max<std::size_t>(members, 1));
  first_of_bucket_.assign(buckets + 1, 0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (is_member(i)) ++first_of_bucket_[bucket_of(cell_of(boxes[i], i)) + 1];
  }
  for (std::size_t k = 0; k < buckets; ++k) first_of_bucket_[k + 1] += first_of_bucket_[k];
  cells_.resize(members);
  for (std::size_t i = boxes.size(); i-- > 0;) {
    if (!is_member(i)) continue;
    // Filled backwards: the end of each bucket moves down to its start.
    const Cell cell = cell_of(boxes[i], i);
    cells_[--first_of_bucket_[bucket_of(cell) + 1]] = cell;
  }
  std::rotate(first_of_bucket_.begin(), first_of_bucket_.begin() + 1, first_of_bucket_.end());
  first_of_bucket_.back() = std::uint32_t(members);
}

template <int D>
template <class IsMember, class Found>
void Grid<D>::search(std::span<const Box<D>> boxes, IsMember is_member, Found found) {
  sort_into_buckets(boxes, is_member);
  levels_.clear();
  for (const Cell& cell : cells_) {
    if (std::find(levels_.begin(), levels_.end(), cell.level) == levels_.end()) levels_.push_back(cell.level);
  }
  std::sort(levels_.begin(), levels_.end());

  for (const Cell& own : cells_) {
    const Box<D>& box = boxes[std::size_t(own.block)];
    for (auto level = std::lower_bound(levels_.begin(), levels_.end(), own.level); level != levels_.end();
         ++level) {
      // Centres of blocks in that grid are within half a cell of their boxes.
      const double size = std::ldexp(1.0, *level);
      Cell wanted;
      wanted.level = *level;
      std::int64_t first[D], last[D];
      for (int k = 0; k < D; ++k) {
        first[k] = cell_index(box.lower[k] - 0.5 * size, size);
        // At most 3 cells, even for a damaged snapshot.
        last[k] = std::min(cell_index(box.upper[k] + 0.5 * size, size), first[k] + 2);
        wanted.index[k] = first[k];
      }
      for (bool more = true; more;) {
        const std::size_t bucket = bucket_of(wanted);
        for (std::size_t e = first_of_bucket_[bucket]; e < first_of_bucket_[bucket + 1]; ++e) {
          const Cell& other = cells_[e];
          const bool once = *level > own.level || other.block > own.block;
          if (once && other.same_place(wanted) && box.overlaps(boxes[std::size_t(other.block)])) {
            found(BlockPair{std::min(own.block, other.block), std::max(own.block, other.block)});
          }
        }
        more = false;
        for (int k = 0; k < D && !more; ++k) {
          more = wanted.index[k] < last[k];
          wanted.index[k] = more ? wanted.index[k] + 1 : first[k];
        }
      }
    }
  }
}

}  // namespace halfspace
