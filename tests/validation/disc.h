#pragma once

// Half a disc of quads, for tests that press it.

#include "validation/mesh.h"

namespace halfspace_test {

/// The half above its diameter, which goes through the origin along x: a rectangle on the middle of the
/// diameter, as high as 0.45 of the radius, and rings around it. Nodes of the rings lie at angles from 0 to
/// pi, of which that at `corner` is pi / 4 and its mirror image 3 pi / 4, and at shares, from 0 to 1, of the
/// way from the rectangle to the circle.
inline MeshWords half_disc(double radius, const std::vector<double>& angles, int corner,
                           const std::vector<double>& shares) {
  MeshWords words;
  const int last = int(angles.size()) - 1, columns = last - 2 * corner, rings = int(shares.size()) - 1;
  const double height = 0.45 * radius;
  const auto on_rectangle = [&](int i) {
    const double along = (angles[std::size_t(i)] - pi / 2) / (pi / 4);  // from -2 to 2
    return Node(std::clamp(-along, -1., 1.) * height, std::min(2 - std::abs(along), 1.) * height, 0);
  };
  for (int k = 0; k <= rings; ++k) {
    for (int i = 0; i <= last; ++i) {
      const double angle = angles[std::size_t(i)], share = shares[std::size_t(k)];
      const Node on_circle(radius * std::cos(angle), radius * std::sin(angle), 0);
      words.nodes.push_back((1 - share) * on_rectangle(i) + share * on_circle);
    }
  }
  for (int k = 0; k < rings; ++k) {
    for (int i = 0; i < last; ++i) {
      const int node = i + k * (last + 1), out = node + last + 1;
      words.add_cell(HS_CELL_QUAD, {node, out, out + 1, node + 1});
    }
  }
  // The rectangle's nodes, from its right to its left: those at its edge belong to the first ring.
  const auto node_of_rectangle = [&](int column, int row) {
    if (column == 0) return row;
    if (column == columns) return last - row;
    if (row == corner) return corner + column;
    return (rings + 1) * (last + 1) + (column - 1) * corner + row;
  };
  for (int column = 1; column < columns; ++column) {
    for (int row = 0; row < corner; ++row)
      words.nodes.emplace_back(on_rectangle(corner + column).x(), on_rectangle(row).y(), 0);
  }
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < corner; ++row)
      words.add_cell(HS_CELL_QUAD,
                     {node_of_rectangle(column, row), node_of_rectangle(column, row + 1),
                      node_of_rectangle(column + 1, row + 1), node_of_rectangle(column + 1, row)});
  }
  return words;
}

}  // namespace halfspace_test
