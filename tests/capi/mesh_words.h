#pragma once

// Bodies of finite elements in plain words: nodes and cells, and the meshes that they are given to the
// library as.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "capi/handles.h"

namespace halfspace_test {

struct DestroyMesh {
  void operator()(hs_mesh* mesh) const { hs_mesh_destroy(mesh); }
};
using Mesh = std::unique_ptr<hs_mesh, DestroyMesh>;

using Node = Eigen::Vector3d;
using Nodes = std::vector<Node>;

/// Nodes and cells in plain words.
struct MeshWords {
  int dimension = 2;
  Nodes nodes;
  std::vector<int32_t> kinds;
  std::vector<int32_t> cell_nodes;

  void add_cell(int32_t kind, const std::vector<int32_t>& names) {
    kinds.push_back(kind);
    cell_nodes.insert(cell_nodes.end(), names.begin(), names.end());
  }
};

inline hs_view view_of(const Nodes& nodes) {
  return {&nodes[0].x(), &nodes[0].y(), &nodes[0].z(), sizeof(Node), std::int64_t(nodes.size())};
}

inline Mesh make_mesh(hs_context* context, const MeshWords& words) {
  hs_mesh* mesh = nullptr;
  require_ok(hs_mesh_create(context, words.dimension, view_of(words.nodes), words.kinds.data(),
                            std::int64_t(words.kinds.size()), words.cell_nodes.data(),
                            std::int64_t(words.cell_nodes.size()), &mesh),
             context);
  return Mesh(mesh);
}

/// A brick of equal cells from the origin, in the plane a rectangle: quads or hexahedra, or what these are
/// cut into: two triangles, two prisms, six tetrahedra. `cut` says into which kind for each of them.
inline MeshWords brick(int dimension, const std::array<double, 3>& size, const std::array<int, 3>& count,
                       const std::function<int32_t(int)>& cut) {
  MeshWords words;
  words.dimension = dimension;
  const int nx = count[0] + 1, ny = count[1] + 1, nz = dimension == 3 ? count[2] + 1 : 1;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i)
        words.nodes.emplace_back(size[0] * i / count[0], size[1] * j / count[1],
                                 dimension == 3 ? size[2] * k / count[2] : 0);
    }
  }
  int which = 0;
  for (int k = 0; k < std::max(nz - 1, 1); ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        const int a = i + nx * (j + ny * k), up = nx * ny;
        const std::array<int, 8> n{a,      a + 1,      a + 1 + nx,      a + nx,
                                   a + up, a + 1 + up, a + 1 + nx + up, a + nx + up};
        switch (const int32_t kind = cut(which++)) {
          case HS_CELL_TRIANGLE:
            words.add_cell(kind, {n[0], n[1], n[2]});
            words.add_cell(kind, {n[0], n[2], n[3]});
            break;
          case HS_CELL_QUAD:
            words.add_cell(kind, {n[0], n[1], n[2], n[3]});
            break;
          case HS_CELL_TETRAHEDRON:
            for (const auto& way : {std::array{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
              words.add_cell(kind, {n[0], n[std::size_t(way[0])], n[std::size_t(way[1])], n[6]});
            break;
          case HS_CELL_PRISM:
            words.add_cell(kind, {n[0], n[1], n[2], n[4], n[5], n[6]});
            words.add_cell(kind, {n[0], n[2], n[3], n[4], n[6], n[7]});
            break;
          default:
            words.add_cell(kind, {n.begin(), n.end()});
        }
      }
    }
  }
  return words;
}

constexpr int32_t all_cell_kinds[] = {HS_CELL_TRIANGLE, HS_CELL_QUAD, HS_CELL_TETRAHEDRON, HS_CELL_PRISM,
                                      HS_CELL_HEXAHEDRON};

inline int dimension_of(int32_t cell_kind) { return cell_kind <= HS_CELL_QUAD ? 2 : 3; }

inline const char* name_of_cell(int32_t kind) {
  static const char* const names[] = {"triangles", "quads", "tetrahedra", "prisms", "hexahedra"};
  return names[kind];
}

}  // namespace halfspace_test
