#pragma once

#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// A point that a block or a cell carries along.
struct CarriedPoint {
  std::size_t block = 0;
  Point offset{};               ///< from the centroid, in the frame of the block's shape
  std::vector<double> weights;  ///< of the nodes, if the block is a cell
};

/// The weights by which the nodes of a cell interpolate a point: the shape functions of its element, as the
/// core interpolates displacements. Nodes are ordered as in hs_mesh_create(). A point outside of the cell is
/// extrapolated.
std::vector<double> weights_of_nodes(const std::vector<Point>& nodes, int dimension, const Point& at);

}  // namespace halfspace::cli
