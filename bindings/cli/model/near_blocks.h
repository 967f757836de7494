#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "model/layout.h"

namespace halfspace::cli {

/// A block near to a point, at the start.
struct NearBlock {
  std::size_t block = 0;
  double distance = 0;  ///< m; 0 inside of the block and on its border
};

/// The first block that contains the point, or the nearest one; empty for a layout without blocks.
std::optional<NearBlock> nearest_block(const Context& context, const Layout& layout, const Point& at);

/// The same among the blocks that count.
std::optional<NearBlock> nearest_block_where(const Context& context, const Layout& layout, const Point& at,
                                             const std::function<bool(std::size_t)>& counts);

/// True if two blocks can ever be in contact.
bool can_touch(const Layout& layout, std::size_t a, std::size_t b);

/// The block nearest to a point and the next one that can touch it, in their order; empty if there is none.
std::optional<std::pair<std::size_t, std::size_t>> blocks_that_touch_at(const Context& context,
                                                                        const Layout& layout,
                                                                        const Point& at);

/// The plane between two blocks at the start.
struct PairPlane {
  Point center{};
  Point normal{};  ///< unit length, from the first to the second block
  double gap = 0;  ///< m, along the normal; below 0 if they overlap
};

/// Empty if the blocks never meet when the second one approaches along the normal.
std::optional<PairPlane> plane_between(const Context& context, const LayoutBlock& a, const LayoutBlock& b);

}  // namespace halfspace::cli
