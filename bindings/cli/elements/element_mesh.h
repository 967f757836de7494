#pragma once

#include <string>
#include <vector>

#include "mesh/gmsh.h"
#include "scene.h"

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
  std::vector<std::string> notes = {};  ///< about elements of its file that are seldom meant so

  /// Null when no group has the name.
  const Group* group(const std::string& name) const;
  std::vector<Point> corners_of(const Cell& cell) const;
};

/// A face, in the plane an edge, that only one cell has.
struct OuterFace {
  int cell;
  std::vector<int> nodes;  ///< counter-clockwise seen from outside
};
std::vector<OuterFace> surface_of(const ElementMesh& mesh);

/// The area of a cell in the plane, the volume of one in space.
double size_of(const ElementMesh& mesh, const ElementMesh::Cell& cell);

/// A box cut evenly, with so many cells along each axis. A triangle's partner in its rectangle lies across a
/// diagonal that changes from rectangle to rectangle; a tetrahedron is one of six in its box. Its sides are
/// groups: left and right along x, bottom and top along the last axis, front and back along y in space.
ElementMesh mesh_of_box(const Point& low, const Point& high, const std::array<int, 3>& counts, int kind,
                        int dimension);

/// The cells of a file that have the dimension of the scene, of whose units each is so many m. Nodes without
/// a cell, of the centres of arcs, say, are left out. Cells in the plane that run clockwise are turned round.
/// @throws MeshFault
ElementMesh mesh_of_file(const GmshFile& file, double scale, int dimension);

}  // namespace halfspace::cli
