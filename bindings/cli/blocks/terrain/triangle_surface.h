#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/vector.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// An open surface of triangles that face up: each is counter-clockwise seen from above.
struct TriangleSurface {
  std::vector<Point> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// Reads and checks the surface of a terrain: STL, OBJ, or a height map as CSV or PNG. Coincident vertices
/// are one.
/// @throws MeshFault if the file is faulty, has no triangles, or if triangles face down, have no area, occur
/// twice or overlap at an edge; std::runtime_error if the file cannot be read
TriangleSurface read_surface(const Terrain& terrain);

}  // namespace halfspace::cli
