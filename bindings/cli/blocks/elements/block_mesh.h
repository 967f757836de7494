#pragma once

#include <vector>

#include "blocks/elements/element_mesh.h"

namespace halfspace::cli {

/// Max number of cells of a block; a block that would exceed it gets none.
inline constexpr double max_cells_of_block = 1e6;

/// Meshes a convex polygon with quads of about the cell size, or with two triangles per quad. Each corner
/// forms a quad with the midpoints of its edges and the centroid; all quads are divided alike.
ElementMesh mesh_of_polygon(const std::vector<Point>& corners, double cell_size, int cell_kind);

/// Meshes a convex polyhedron with hexahedra in the same way. If more than three faces meet at any corner, it
/// is meshed with tetrahedra instead, from its edges, the face centres and the centroid.
ElementMesh mesh_of_polyhedron(const std::vector<Point>& corners, const std::vector<std::vector<int>>& faces,
                               double cell_size);

}  // namespace halfspace::cli
