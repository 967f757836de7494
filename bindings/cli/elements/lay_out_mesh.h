#pragma once

#include <string>
#include <utility>
#include <vector>

#include "elements/element_mesh.h"
#include "faults.h"
#include "layout.h"
#include "library.h"
#include "scene.h"

namespace halfspace::cli {

/// A cell as it is drawn and told.
struct LaidOutCell {
  int number = 0;                       ///< in the order of the file
  Shape shape;                          ///< its hull
  std::vector<std::vector<int>> faces;  ///< loops of its nodes: in 2D itself, in 3D what is at the surface
  int material = 0;
};

struct LaidOutBody {
  LayoutBody body;
  std::vector<LaidOutCell> cells;
};

struct LaidOutMesh {
  std::vector<LaidOutBody> bodies;
  std::vector<std::pair<std::string, std::vector<int>>> groups;  ///< with the numbers of their cells
};

/// The bodies of a mesh of a scene; none where it has faults, which are told. In space cells show their faces
/// at the surface only, or all of them where some are excavated later.
LaidOutMesh lay_out_mesh(const Context& context, const Mesh& mesh, int dimension, bool is_excavated,
                         Faults& faults);

/// The same for a block that has been cut into these cells: it is one body. @throws LibraryError
LaidOutMesh lay_out_block(const Context& context, const Making& making, const ElementMesh& cells,
                          const Placing& placing, const Point& velocity, bool is_excavated, Faults& faults);

}  // namespace halfspace::cli
