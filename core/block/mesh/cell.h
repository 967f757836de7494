#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>

namespace halfspace {

/// The kinds of cells of a mesh. The values are those of the C API.
enum class CellKind : std::int32_t { triangle = 0, quad = 1, tetrahedron = 2, prism = 3, hexahedron = 4 };

/// The nodes of a kind of cell, and its topology. The numbering is that of Gmsh and VTK: counter-clockwise in
/// polygons; in prisms and hexahedra first the bottom and then, in the same order, the top.
struct CellForm {
  int dimension;
  int nodes;
  int nodes_of_face[6];  // 0 for unused faces
  int faces[6][4];       // in 2D edges
  int simplex_count;
  int simplices[5][4];  // that fill the cell; those with a face at the surface are blocks
};

inline bool is_cell_kind(std::int32_t kind) {
  return kind >= 0 && kind <= std::int32_t(CellKind::hexahedron);
}

inline const CellForm& form_of(CellKind kind) {
  static constexpr CellForm forms[] = {
      {2, 3, {2, 2, 2}, {{0, 1}, {1, 2}, {2, 0}}, 1, {{0, 1, 2}}},
      {2, 4, {2, 2, 2, 2}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, 2, {{0, 1, 2}, {0, 2, 3}}},
      {3, 4, {3, 3, 3, 3}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, 1, {{0, 1, 2, 3}}},
      {3,
       6,
       {3, 3, 4, 4, 4},
       {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
       3,
       {{0, 1, 2, 5}, {0, 1, 5, 4}, {0, 4, 5, 3}}},
      {3,
       8,
       {4, 4, 4, 4, 4, 4},
       {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
       5,
       {{0, 1, 3, 4}, {1, 2, 3, 6}, {1, 4, 5, 6}, {3, 4, 6, 7}, {1, 3, 4, 6}}},
  };
  return forms[std::int32_t(kind)];
}

inline int face_count(const CellForm& form) {
  int count = 0;
  while (count < 6 && form.nodes_of_face[count] > 0) ++count;
  return count;
}

}  // namespace halfspace
