#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// The corners of a polygon in boxes, each with two halves, to find one of them in a triangle. Corners are
/// removed as ears are clipped.
class CornerTree {
 public:
  /// The corners must remain.
  explicit CornerTree(const std::vector<Point>& corners);

  void remove(std::size_t corner);
  /// A corner that is in a counter-clockwise triangle or on its outline, but is none of its corners.
  std::optional<std::size_t> corner_in(const std::array<std::size_t, 3>& triangle) const;

 private:
  struct Node {
    Point low{}, high{};
    std::size_t begin = 0, end = 0;  ///< in order_
    std::size_t left = 0;            ///< corners that have not been removed
  };

  static constexpr std::size_t corners_per_leaf = 8;

  void divide(std::size_t place, std::size_t begin, std::size_t end);
  bool is_inside(const std::array<std::size_t, 3>& triangle, const Point& place) const;
  bool is_beyond(const std::array<std::size_t, 3>& triangle, const Node& node) const;
  std::optional<std::size_t> search(std::size_t place, const std::array<std::size_t, 3>& triangle) const;

  const std::vector<Point>& corners_;
  std::vector<std::size_t> order_;    ///< corners, those of a node one after the other
  std::vector<std::size_t> leaf_of_;  ///< of each corner
  std::vector<bool> is_removed_;
  std::vector<Node> nodes_;  ///< the halves of node i are 2 i + 1 and 2 i + 2
};

}  // namespace halfspace::cli
