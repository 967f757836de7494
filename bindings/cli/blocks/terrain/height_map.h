#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// Heights at the nodes of a regular grid, row by row from the north, each from the west.
struct HeightMap {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> heights = {};    ///< NaN at nodes without data
  std::optional<double> spacing = {};  ///< m, of files with coordinates
  Point south_west{};                  ///< m: the place of this node, without its height

  double height(std::size_t column, std::size_t row) const { return heights[row * columns + column]; }
  /// The node on the ground of the map. @param step the spacing, m
  Point node(std::size_t column, std::size_t row, double step) const {
    return plus(south_west, {step * static_cast<double>(column), step * static_cast<double>(rows - 1 - row),
                             height(column, row)});
  }
};

/// A grid whose lines are rows of heights, a list of x, y and height of the nodes of a grid in any order, or
/// an ASCII grid of ArcInfo, which begins with `ncols`. @throws MeshFault
HeightMap read_heights(const std::string& name, const std::string& content);

/// The spacing of a map, its own one or the given one, which must not differ. @throws MeshFault
double spacing_of(const HeightMap& map, const std::string& name, double given);

/// The brightness of a grey image of 8 or 16 bits, from 0 (black) to 1 (white). @throws MeshFault
HeightMap read_png_heights(const std::string& name, const std::string& content);

}  // namespace halfspace::cli
