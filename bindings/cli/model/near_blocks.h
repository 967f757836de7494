#pragma once

#include <cstddef>
#include <optional>

#include "model/layout.h"

namespace halfspace::cli {

/// A block near to a point, at the start.
struct NearBlock {
  std::size_t block = 0;
  double distance = 0;  ///< m; 0 inside of the block and on its border
};

/// The first block that contains the point, or the nearest one; empty for a layout without blocks. Blocks for
/// which `is_left_out` is true do not count.
template <class Condition>
std::optional<NearBlock> nearest_block(const Context& context, const Layout& layout, const Point& at,
                                       Condition is_left_out);

/// The distance of a point from a block at the start. At most `farthest` is of interest: beyond it the result
/// may be any larger number.
double distance_to(const Context& context, const LayoutBlock& block, const Point& at, double farthest);

template <class Condition>
std::optional<NearBlock> nearest_block(const Context& context, const Layout& layout, const Point& at,
                                       Condition is_left_out) {
  std::optional<NearBlock> nearest;
  for (std::size_t i = 0; i < layout.blocks.size(); ++i) {
    if (is_left_out(i)) continue;
    const double best = nearest ? nearest->distance : std::numeric_limits<double>::infinity();
    const double distance = distance_to(context, layout.blocks[i], at, best);
    if (distance < best) nearest = {i, distance};
    if (distance == 0) break;
  }
  return nearest;
}

/// The plane between two blocks at the start.
struct PairPlane {
  Point center{};
  Point normal{};  ///< unit length, from the first to the second block
  double gap = 0;  ///< m, along the normal; below 0 if they overlap
};

/// Empty if the blocks never meet when the second one approaches along the normal.
std::optional<PairPlane> plane_between(const Context& context, const LayoutBlock& a, const LayoutBlock& b);

}  // namespace halfspace::cli
