#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace halfspace::cli {

/// A type of element: its numbers in Gmsh's format and in the C API, its nodes, and its faces.
struct ElementForm {
  int type;       ///< in the format
  int cell_kind;  ///< HS_CELL_..., or no_cell
  int dimension;
  std::size_t node_count;
  std::vector<std::vector<int>> faces;  ///< counter-clockwise seen from outside; edges in the plane

  static constexpr int no_cell = -1;
};

/// Null for an unknown type.
const ElementForm* form_of_type(std::int64_t type);
const ElementForm& form_of_cell(int cell_kind);

}  // namespace halfspace::cli
