#pragma once

#include <string>
#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// A closed surface of a file, from which a block is made.
struct Solid {
  std::vector<Point> vertices;
  std::vector<std::vector<int>> faces;  ///< loops of vertices, consistently oriented
  std::string place;                    ///< in the file, e.g. "rocks.obj:12"
  double last_digit = 0;                ///< unit of the last digit of its coordinates
};

/// Reads the solids of a file by its extension: OBJ, OFF, STL (text and binary) or Gmsh (MSH 2.2 and 4.1,
/// text). A surface has a solid for each connected part, a Gmsh mesh for each element with a volume.
/// @throws MeshFault, or std::runtime_error if the file cannot be read
std::vector<Solid> read_solids(const std::string& file);

}  // namespace halfspace::cli
