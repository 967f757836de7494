#include <algorithm>
#include <array>

#include "blocks/elements/element_mesh.h"

namespace halfspace::cli {
namespace {

/// Nodes in a grid, x fastest.
class NodeGrid {
 public:
  NodeGrid(const std::array<int, 3>& counts) : counts_(counts) {}
  int node(int i, int j, int k) const { return (k * (counts_[1] + 1) + j) * (counts_[0] + 1) + i; }
  int count(std::size_t axis) const { return counts_[axis]; }

 private:
  std::array<int, 3> counts_;
};

/// The cells of a rectangle, whose four corners run counter-clockwise.
std::vector<std::vector<int>> cells_of_rectangle(int kind, bool is_odd) {
  if (kind == HS_CELL_QUAD) return {{0, 1, 2, 3}};
  if (is_odd) return {{0, 1, 3}, {1, 2, 3}};
  return {{0, 1, 2}, {0, 2, 3}};
}

/// The cells of a box, whose eight corners are numbered as those of a hexahedron. Its six tetrahedra share a
/// diagonal, so that neighbouring boxes conform.
const std::vector<std::vector<int>>& cells_of_box(int kind) {
  static const std::vector<std::vector<int>> whole = {{0, 1, 2, 3, 4, 5, 6, 7}},
                                             halves = {{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}},
                                             sixths = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                                       {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  if (kind == HS_CELL_HEXAHEDRON) return whole;
  return kind == HS_CELL_PRISM ? halves : sixths;
}

void add_cells(ElementMesh& mesh, const NodeGrid& grid, int kind) {
  const auto add = [&](const std::vector<int>& corners, const std::vector<std::vector<int>>& cells) {
    for (const std::vector<int>& cell : cells) {
      ElementMesh::Cell& added = mesh.cells.emplace_back(ElementMesh::Cell{.kind = kind, .nodes = {}});
      for (const int corner : cell) added.nodes.push_back(corners[static_cast<std::size_t>(corner)]);
    }
  };
  for (int k = 0; k < std::max(grid.count(2), 1); ++k) {
    for (int j = 0; j < grid.count(1); ++j) {
      for (int i = 0; i < grid.count(0); ++i) {
        std::vector<int> corners;
        for (int up = 0; up < mesh.dimension - 1; ++up) {
          corners.insert(corners.end(), {grid.node(i, j, k + up), grid.node(i + 1, j, k + up),
                                         grid.node(i + 1, j + 1, k + up), grid.node(i, j + 1, k + up)});
        }
        add(corners, mesh.dimension == 2 ? cells_of_rectangle(kind, (i + j) % 2 == 1) : cells_of_box(kind));
      }
    }
  }
}

/// Adds the sides of the box as groups of nodes and outer faces.
void add_sides(ElementMesh& mesh, const Point& low, const Point& high) {
  struct Side {
    const char* name;
    std::size_t axis;
    double at;
  };
  std::vector<Side> sides = {{"left", 0, low[0]}, {"right", 0, high[0]}};
  const std::size_t last = up_axis(mesh.dimension);
  sides.insert(sides.end(), {{"bottom", last, low[last]}, {"top", last, high[last]}});
  if (mesh.dimension == 3) sides.insert(sides.end(), {{"front", 1, low[1]}, {"back", 1, high[1]}});
  const std::vector<OuterFace> surface = surface_of(mesh);
  for (const Side& side : sides) {
    const auto is_in = [&](int node) {
      return mesh.nodes[static_cast<std::size_t>(node)][side.axis] == side.at;
    };
    ElementMesh::Group group{.name = side.name};
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
      if (is_in(static_cast<int>(node))) group.nodes.push_back(static_cast<int>(node));
    for (const OuterFace& face : surface)
      if (std::all_of(face.nodes.begin(), face.nodes.end(), is_in)) group.faces.push_back(face.nodes);
    mesh.groups.push_back(std::move(group));
  }
}

}  // namespace

ElementMesh mesh_of_box(const Point& low, const Point& high, const std::array<int, 3>& counts, int kind,
                        int dimension) {
  ElementMesh mesh{.dimension = dimension};
  const NodeGrid grid(counts);
  const auto along = [&](std::size_t axis, int i) {
    const int count = grid.count(axis);
    if (i == 0 || count == 0) return low[axis];
    return i == count ? high[axis] : low[axis] + (high[axis] - low[axis]) * i / count;
  };
  for (int k = 0; k <= grid.count(2); ++k) {
    for (int j = 0; j <= grid.count(1); ++j) {
      for (int i = 0; i <= grid.count(0); ++i) mesh.nodes.push_back({along(0, i), along(1, j), along(2, k)});
    }
  }
  add_cells(mesh, grid, kind);
  add_sides(mesh, low, high);
  return mesh;
}

}  // namespace halfspace::cli
