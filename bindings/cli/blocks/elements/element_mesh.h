#pragma once

#include <string>
#include <vector>

#include "blocks/mesh/gmsh.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Nodes, and cells that share them; named groups of cells, of faces or edges, and of nodes.
struct ElementMesh {
  struct Cell {
    int kind;                ///< HS_CELL_...
    std::vector<int> nodes;  ///< indices
  };
  struct Group {
    std::string name;
    std::vector<int> cells = {};
    std::vector<std::vector<int>> faces = {};  ///< by their nodes
    std::vector<int> nodes = {};  ///< of its cells and faces, and single ones; each once, ascending
  };
  int dimension = 2;
  std::vector<Point> nodes = {};
  std::vector<Cell> cells = {};
  std::vector<Group> groups = {};
  std::vector<std::string> notes = {};  ///< about unusual elements of its file

  /// Null when no group has the name.
  const Group* group(const std::string& name) const;
  std::vector<Point> corners_of(const Cell& cell) const;
};

/// A face (in 2D an edge) of only one cell.
struct OuterFace {
  int cell;
  std::vector<int> nodes;  ///< counter-clockwise seen from outside
};
std::vector<OuterFace> surface_of(const ElementMesh& mesh);

/// The area of a cell in 2D, its volume in 3D.
double size_of(const ElementMesh& mesh, const ElementMesh::Cell& cell);

/// A box with a regular mesh of `counts` cells along each axis. A rectangle has two triangles, with
/// alternating diagonals; a box has six tetrahedra. The sides are groups: left and right along x, bottom and
/// top along the last axis, in 3D front and back along y.
ElementMesh mesh_of_box(const Point& low, const Point& high, const std::array<int, 3>& counts, int kind,
                        int dimension);

/// The cells of a file that have the dimension of the scene; `scale` is its unit in m. Nodes without a cell,
/// such as centres of arcs, are left out. Clockwise cells in 2D are reversed. @throws MeshFault
ElementMesh mesh_of_file(const GmshFile& file, double scale, int dimension);

}  // namespace halfspace::cli
