#include "blocks/rock/corner_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "blocks/rock/outline.h"

namespace halfspace::cli {

CornerTree::CornerTree(const std::vector<Point>& corners)
    : corners_(corners),
      order_(corners.size()),
      leaf_of_(corners.size()),
      is_removed_(corners.size(), false) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  divide(0, 0, order_.size());
}

void CornerTree::divide(std::size_t place, std::size_t begin, std::size_t end) {
  if (nodes_.size() <= place) nodes_.resize(place + 1);
  Node node{.low = corners_[order_[begin]], .high = corners_[order_[begin]], .begin = begin, .end = end};
  node.left = end - begin;
  for (std::size_t i = begin; i < end; ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      node.low[axis] = std::min(node.low[axis], corners_[order_[i]][axis]);
      node.high[axis] = std::max(node.high[axis], corners_[order_[i]][axis]);
    }
  }
  nodes_[place] = node;
  if (node.left <= corners_per_leaf) {
    for (std::size_t i = begin; i < end; ++i) leaf_of_[order_[i]] = place;
    return;
  }
  const std::size_t axis = node.high[0] - node.low[0] > node.high[1] - node.low[1] ? 0 : 1;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t middle = (begin + end) / 2;
  std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
    return corners_[a][axis] < corners_[b][axis] || (corners_[a][axis] == corners_[b][axis] && a < b);
  });
  divide(2 * place + 1, begin, middle);
  divide(2 * place + 2, middle, end);
}

void CornerTree::remove(std::size_t corner) {
  is_removed_[corner] = true;
  for (std::size_t place = leaf_of_[corner];; place = (place - 1) / 2) {
    --nodes_[place].left;
    if (place == 0) return;
  }
}

std::optional<std::size_t> CornerTree::corner_in(const std::array<std::size_t, 3>& triangle) const {
  return search(0, triangle);
}

bool CornerTree::is_inside(const std::array<std::size_t, 3>& triangle, const Point& place) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point edge = minus(corners_[triangle[(k + 1) % 3]], corners_[triangle[k]]);
    const Point to_place = minus(place, corners_[triangle[k]]);
    if (cross(edge, to_place)[2] < -straight * length(edge) * length(to_place)) return false;
  }
  return true;
}

/// True if all places of the box are beyond one side of the triangle.
bool CornerTree::is_beyond(const std::array<std::size_t, 3>& triangle, const Node& node) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& begin = corners_[triangle[k]];
    const Point edge = minus(corners_[triangle[(k + 1) % 3]], begin);
    double innermost = -INFINITY, farthest = 0;
    for (const double x : {node.low[0], node.high[0]}) {
      for (const double y : {node.low[1], node.high[1]}) {
        const Point to_place = minus({x, y, 0}, begin);
        innermost = std::max(innermost, cross(edge, to_place)[2]);
        farthest = std::max(farthest, length(to_place));
      }
    }
    if (innermost < -2 * straight * length(edge) * farthest) return true;
  }
  return false;
}

std::optional<std::size_t> CornerTree::search(std::size_t place,
                                              const std::array<std::size_t, 3>& triangle) const {
  const Node& node = nodes_[place];
  if (node.left == 0 || is_beyond(triangle, node)) return std::nullopt;
  if (node.end - node.begin > corners_per_leaf) {
    const std::optional<std::size_t> found = search(2 * place + 1, triangle);
    return found ? found : search(2 * place + 2, triangle);
  }
  for (std::size_t i = node.begin; i < node.end; ++i) {
    const std::size_t corner = order_[i];
    const bool is_own = std::find(triangle.begin(), triangle.end(), corner) != triangle.end();
    if (!is_removed_[corner] && !is_own && is_inside(triangle, corners_[corner])) return corner;
  }
  return std::nullopt;
}

}  // namespace halfspace::cli
