#include "blocks/rock/triangulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/random.h"

namespace halfspace::cli {
namespace {

/// The number of cells along each direction.
struct Grid {
  std::int64_t columns;
  std::int64_t rows;
};

/// The max number of cells, as square as possible, for at most `count` triangles.
Grid grid_for(std::int64_t count, double width, double height) {
  const std::int64_t cells = count / 2;
  const double even = std::sqrt(static_cast<double>(cells) * width / height);
  const auto columns = std::clamp<std::int64_t>(std::llround(even), 1, cells);
  return {columns, cells / columns};
}

/// The grid's nodes, row by row from below. With a jitter below a quarter every cell stays convex: each
/// corner stays on its side of the diagonal between its neighbours.
std::vector<Point> shifted_nodes(const Triangulated& region, Grid grid, Random& random) {
  std::vector<Point> nodes;
  const auto place = [&](int axis, std::int64_t index, std::int64_t cells) {
    const double low = region.lower_left[axis];
    const double high = region.upper_right[axis];
    const double shift = region.jitter * (2 * random.uniform() - 1);
    if (index == 0) return low;
    if (index == cells) return high;
    return low + (high - low) * (static_cast<double>(index) + shift) / static_cast<double>(cells);
  };
  for (std::int64_t row = 0; row <= grid.rows; ++row) {
    for (std::int64_t column = 0; column <= grid.columns; ++column) {
      const double x = place(0, column, grid.columns);
      const double y = place(1, row, grid.rows);
      nodes.push_back({x, y});
    }
  }
  return nodes;
}

void divide_at_centroid(std::vector<Triangle>& triangles, std::size_t index) {
  const auto [a, b, c] = triangles[index];
  const Point middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
  triangles[index] = {a, b, middle};
  triangles.push_back({b, c, middle});
  triangles.push_back({c, a, middle});
}

}  // namespace

std::vector<Triangle> triangulate(const Triangulated& region) {
  Random random(region.seed);
  const Grid grid = grid_for(region.count, region.upper_right[0] - region.lower_left[0],
                             region.upper_right[1] - region.lower_left[1]);
  const std::vector<Point> nodes = shifted_nodes(region, grid, random);
  std::vector<Triangle> triangles;
  for (std::int64_t row = 0; row < grid.rows; ++row) {
    for (std::int64_t column = 0; column < grid.columns; ++column) {
      const Point* below = &nodes[static_cast<std::size_t>(row * (grid.columns + 1) + column)];
      const Point* above = below + grid.columns + 1;
      const Point corners[] = {below[0], below[1], above[1], above[0]};  // counter-clockwise
      const std::uint64_t first = random.below(2);                       // where the diagonal starts
      const auto corner = [&](std::uint64_t i) { return corners[(first + i) % 4]; };
      triangles.push_back({corner(0), corner(1), corner(2)});
      triangles.push_back({corner(0), corner(2), corner(3)});
    }
  }
  const std::size_t whole = triangles.size();
  std::vector<bool> divided(whole);
  while (static_cast<std::int64_t>(triangles.size()) < region.count) {
    const std::size_t index = random.below(whole);
    if (divided[index]) continue;
    divided[index] = true;
    divide_at_centroid(triangles, index);
  }
  return triangles;
}

}  // namespace halfspace::cli
