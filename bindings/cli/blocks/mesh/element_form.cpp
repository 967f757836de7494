#include "blocks/mesh/element_form.h"

#include <algorithm>

#include "halfspace/halfspace.h"

namespace halfspace::cli {
namespace {

/// Points, lines, triangles, quadrangles, tetrahedra, hexahedra, prisms and pyramids with straight sides.
const std::vector<ElementForm>& forms() {
  static const std::vector<ElementForm> all = {
      {15, ElementForm::no_cell, 0, 1, {}},
      {1, ElementForm::no_cell, 1, 2, {}},
      {2, HS_CELL_TRIANGLE, 2, 3, {{0, 1}, {1, 2}, {2, 0}}},
      {3, HS_CELL_QUAD, 2, 4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
      {4, HS_CELL_TETRAHEDRON, 3, 4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
      {5,
       HS_CELL_HEXAHEDRON,
       3,
       8,
       {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
      {6, HS_CELL_PRISM, 3, 6, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
      {7, ElementForm::no_cell, 3, 5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}};
  return all;
}

}  // namespace

const ElementForm* form_of_type(std::int64_t type) {
  const auto form = std::find_if(forms().begin(), forms().end(),
                                 [&](const ElementForm& known) { return known.type == type; });
  return form == forms().end() ? nullptr : &*form;
}

const ElementForm& form_of_cell(int cell_kind) {
  return *std::find_if(forms().begin(), forms().end(),
                       [&](const ElementForm& known) { return known.cell_kind == cell_kind; });
}

}  // namespace halfspace::cli
