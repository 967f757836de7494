#pragma once

#include <array>
#include <cstdint>

#include "block/mesh/mesh.h"
#include "geometry/polygon/check.h"
#include "geometry/polyhedron/check.h"
#include "geometry/shape.h"

namespace halfspace {

/// A face of exactly one cell.
struct SurfaceFace {
  std::int32_t cell;
  std::int32_t face;  // index in the form of the cell
};

/// A simplex of a cell, with a face at the surface.
template <int D>
struct SurfaceSimplex {
  std::int32_t cell;
  std::array<std::int32_t, D + 1> node;  // indices in the mesh
  std::int32_t outer_faces = 0;          // bit k: the face opposite to node k is at the surface
};

/// The surface of a mesh, in ascending order of cells.
template <int D>
Array<SurfaceFace> surface_of(const Mesh<D>& mesh, Memory* memory);

/// The first cell with a face that two other cells have already, or -1.
template <int D>
std::int64_t cell_too_many(const Mesh<D>& mesh, Memory* memory);

/// The simplices that make contact, in ascending order of cells. Their strain is uniform, so that they stay
/// convex and contact forces are distributed to their nodes exactly.
template <int D>
Array<SurfaceSimplex<D>> surface_simplices(const Mesh<D>& mesh, Memory* memory);

/// The fault of these corners as a block, and the shape.
FaultReport check_simplex(const std::array<Vector<2>, 3>& corners, Memory* memory);
PolyhedronFault check_simplex(const std::array<Vector<3>, 4>& corners, Memory* memory);
Shape<2> shape_of_simplex(const std::array<Vector<2>, 3>& corners, Memory* memory);
Shape<3> shape_of_simplex(const std::array<Vector<3>, 4>& corners, Memory* memory);

}  // namespace halfspace
