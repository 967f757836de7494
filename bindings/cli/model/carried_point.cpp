#include "model/carried_point.h"

#include <cmath>

namespace halfspace::cli {
namespace {

/// Natural coordinates of a point in a cell: those of the unit triangle or tetrahedron, or of a unit cube.
/// Shape functions are linear along each of them, so that differences over a unit length are derivatives.
std::vector<double> shape_functions(std::size_t nodes, int dimension, const Point& natural) {
  const auto [r, s, t] = natural;
  if (nodes == 3) return {1 - r - s, r, s};
  if (nodes == 4 && dimension == 3) return {1 - r - s - t, r, s, t};
  const std::vector<double> base = nodes == 6
                                       ? std::vector{1 - r - s, r, s}
                                       : std::vector{(1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s};
  if (dimension == 2) return base;
  std::vector<double> all;
  for (const double height : {1 - t, t})
    for (const double weight : base) all.push_back(height * weight);
  return all;
}

Point weighted(const std::vector<double>& weights, const std::vector<Point>& nodes) {
  Point sum{};
  for (std::size_t i = 0; i < nodes.size(); ++i) sum = plus(sum, times(weights[i], nodes[i]));
  return sum;
}

/// The solution of columns * x = right, by Cramer's rule.
Point solved(const std::array<Point, 3>& columns, const Point& right) {
  const double determinant = dot(columns[0], cross(columns[1], columns[2]));
  return times(1 / determinant,
               {dot(right, cross(columns[1], columns[2])), dot(columns[0], cross(right, columns[2])),
                dot(columns[0], cross(columns[1], right))});
}

}  // namespace

std::vector<double> weights_of_nodes(const std::vector<Point>& nodes, int dimension, const Point& at) {
  constexpr int max_iterations = 50;
  constexpr double converged = 1e-14;
  Point natural{0.3, 0.3, dimension == 3 ? 0.3 : 0};
  for (int i = 0; i < max_iterations; ++i) {
    std::array<Point, 3> columns{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      Point next = natural;
      next[axis] += 1;
      columns[axis] = minus(weighted(shape_functions(nodes.size(), dimension, next), nodes),
                            weighted(shape_functions(nodes.size(), dimension, natural), nodes));
    }
    const Point here = weighted(shape_functions(nodes.size(), dimension, natural), nodes);
    const Point change = solved(columns, minus(at, here));
    natural = plus(natural, change);
    if (length(change) < converged) break;
  }
  return shape_functions(nodes.size(), dimension, natural);
}

}  // namespace halfspace::cli
