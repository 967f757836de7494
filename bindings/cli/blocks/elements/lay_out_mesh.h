#pragma once

#include <string>
#include <utility>
#include <vector>

#include "blocks/elements/element_mesh.h"
#include "model/layout.h"
#include "model/library.h"
#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// A cell with its hull and its faces, for output.
struct LaidOutCell {
  int number = 0;                       ///< in the order of the file
  Shape shape;                          ///< its hull
  std::vector<std::vector<int>> faces;  ///< loops of its nodes: 2D its outline, 3D its faces at the surface
  int material = 0;
};

struct LaidOutBody {
  LayoutBody body;
  std::vector<LaidOutCell> cells;
};

struct LaidOutMesh {
  std::vector<LaidOutBody> bodies;
  std::vector<std::pair<std::string, std::vector<int>>> groups;  ///< names, and numbers of their cells
};

/// The bodies of a mesh of a scene; empty after faults. In 3D cells have their faces at the surface only, or
/// all faces if the scene excavates.
LaidOutMesh lay_out_mesh(const Context& context, const Mesh& mesh, int dimension, bool is_excavated,
                         Faults& faults);

/// The same for a block meshed with these cells, as one body. @throws LibraryError
LaidOutMesh lay_out_block(const Context& context, const Making& making, const ElementMesh& cells,
                          const Placing& placing, const Point& velocity, bool is_excavated, Faults& faults);

}  // namespace halfspace::cli
