#include "geometry/polyhedron/support_tree.h"

#include <numeric>

#include "geometry/polyhedron/check.h"

namespace halfspace {

SupportTree::SupportTree(std::span<const Vector<3>> points, Memory* memory)
    : points_(points), order_(memory), boxes_(memory) {
  if (points.size() <= points_per_box) return;
  rounding_ = flatness_tolerance(largest_coordinate(points));
  order_.resize(points.size());
  std::iota(order_.begin(), order_.end(), std::int64_t(0));
  divide(0, 0, points.size());
}

void SupportTree::divide(std::size_t place, std::size_t begin, std::size_t end) {
  if (boxes_.size() <= place) boxes_.resize(place + 1);
  Box<3> box;
  for (std::size_t i = begin; i < end; ++i) box.include(points_[std::size_t(order_[i])]);
  boxes_[place] = box;
  if (end - begin <= points_per_box) return;
  Eigen::Index axis = 0;
  (box.upper - box.lower).maxCoeff(&axis);
  const std::size_t middle = (begin + end) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + std::ptrdiff_t(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::int64_t p, std::int64_t q) {
    const double a = points_[std::size_t(p)][axis], b = points_[std::size_t(q)][axis];
    return a < b || (a == b && p < q);
  });
  divide(2 * place + 1, begin, middle);
  divide(2 * place + 2, middle, end);
}

}  // namespace halfspace
