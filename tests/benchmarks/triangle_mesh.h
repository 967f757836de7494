#pragma once

#include <utility>
#include <vector>

#include "random_polygon.h"

namespace halfspace_benchmark {

/// A rectangle from (0, 0) cut into triangles that fill it without gaps: cells with shifted corners, each
/// halved along a random diagonal, but `quartered` cells cut into four through their middle. 2 columns rows +
/// 2 quartered triangles in all.
inline std::vector<Points> mesh_rectangle(double width, double height, int columns, int rows, int quartered,
                                          Random& random) {
  // Inner corners move by at most 0.15 of a cell: twice a half's area is then at least (1 - 0.3)^2 - 0.3 (1 +
  // 0.3) = 0.1 cells.
  const auto shift = [&](int i, int last) {
    return i == 0 || i == last ? 0.0 : uniform(random, -0.15, 0.15);
  };
  Points corners;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      corners.push_back({width * (i + shift(i, columns)) / columns, height * (j + shift(j, rows)) / rows});
    }
  }
  std::vector<Points> triangles;
  for (int cell = 0; cell < columns * rows; ++cell) {
    const int first = cell / columns * (columns + 1) + cell % columns;
    const auto corner = [&](int along, int up) {
      return corners[std::size_t(first + along + up * (columns + 1))];
    };
    const Point a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
    if (cell < quartered) {
      const Point m{(a.x + b.x + c.x + d.x) / 4, (a.y + b.y + c.y + d.y) / 4};
      for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) triangles.push_back({p, q, m});
    } else if (random() % 2) {
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    } else {
      triangles.push_back({a, b, d});
      triangles.push_back({b, c, d});
    }
  }
  return triangles;
}

}  // namespace halfspace_benchmark
