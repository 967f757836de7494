#pragma once

#include <string>
#include <vector>

#include "scene.h"

namespace halfspace::cli {

/// A closed surface that is to become a block, as its file describes it.
struct Solid {
  std::vector<Point> vertices;
  std::vector<std::vector<int>> faces;  ///< loops of vertices, all of them the same way round
  std::string place;                    ///< where it begins, e.g. "rocks.obj:12"
  double last_digit = 0;                ///< of its file's coordinates: the value of a unit
};

/// The solids of a file: OBJ, OFF, STL (text and binary), or Gmsh (MSH 2.2 and 4.1, text), told apart by the
/// extension. Of surfaces there is a solid for each connected part, of Gmsh's meshes for each element that
/// has a volume. @throws MeshFault, or std::runtime_error if the file cannot be read
std::vector<Solid> read_solids(const std::string& file);

}  // namespace halfspace::cli
