#pragma once

#include <vector>

#include "scene.h"

namespace halfspace::cli {

using Triangle = std::array<Point, 3>;

/// Cuts a rectangle into exactly the wanted number of counter-clockwise triangles: a grid of nearly square
/// cells whose nodes are shifted at random, each cell cut by one of its diagonals at random, then single
/// triangles divided into three at their centroid until the number is reached.
std::vector<Triangle> triangulate(const Triangulated& region);

}  // namespace halfspace::cli
