#pragma once

#include <vector>

#include "faults.h"
#include "layout.h"
#include "library.h"
#include "scene.h"

namespace halfspace::cli {

/// What is drawn and told of a cell.
struct LaidOutCell {
  Shape shape;                          ///< its hull
  std::vector<std::vector<int>> faces;  ///< loops of its nodes: in 2D itself, in 3D what is at the surface
  int material = 0;
};

struct LaidOutBody {
  LayoutBody body;
  std::vector<LaidOutCell> cells;
};

/// The bodies of a mesh of a scene; none where it has faults, which are told.
std::vector<LaidOutBody> lay_out_mesh(const Context& context, const Mesh& mesh, int dimension,
                                      Faults& faults);

}  // namespace halfspace::cli
