#pragma once

#include <vector>

#include "elements/element_mesh.h"

namespace halfspace::cli {

/// A block may have so many cells; none are made of one that would have more.
inline constexpr double most_cells_of_block = 1e6;

/// A convex polygon in quads about as large as the cell size, or in triangles, two to a quad: each corner
/// gets a quad from the middles of its edges and the centroid, and all of these are cut alike.
ElementMesh mesh_of_polygon(const std::vector<Point>& corners, double cell_size, int cell_kind);

/// A convex polyhedron in hexahedra in the same way. Where more than three faces meet at a corner, there is
/// no hexahedron for it: then all of it is in tetrahedra, from the middles of edges and faces and the
/// centroid.
ElementMesh mesh_of_polyhedron(const std::vector<Point>& corners, const std::vector<std::vector<int>>& faces,
                               double cell_size);

}  // namespace halfspace::cli
