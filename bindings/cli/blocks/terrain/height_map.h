#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace halfspace::cli {

/// Heights at the nodes of a regular grid, row by row from the north, each from the west.
struct HeightMap {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> heights;
};

/// Numbers between commas, semicolons, blanks or tabs; each line is a row. @throws MeshFault
HeightMap read_csv_heights(const std::string& name, const std::string& content);

/// The brightness of a grey image of 8 or 16 bits, from 0 (black) to 1 (white). @throws MeshFault
HeightMap read_png_heights(const std::string& name, const std::string& content);

}  // namespace halfspace::cli
