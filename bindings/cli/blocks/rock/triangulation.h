#pragma once

#include <vector>

#include "scene/scene.h"

namespace halfspace::cli {

using Triangle = std::array<Point, 3>;

/// Cuts a rectangle into exactly `count` counter-clockwise triangles: a grid of nearly square cells with
/// nodes shifted at random, each cell cut by one of its diagonals at random; then single triangles are
/// divided into three at their centroid until the number is reached.
std::vector<Triangle> triangulate(const Triangulated& region);

}  // namespace halfspace::cli
