#pragma once

#include <string>
#include <vector>

#include "blocks/elements/element_mesh.h"

namespace halfspace::cli {

/// Reports where a mesh does not conform: nodes that coincide, and hanging nodes in another cell's face.
/// Empty for a conforming mesh. `surface` is that of surface_of().
std::vector<std::string> loose_nodes(const ElementMesh& mesh, const std::vector<OuterFace>& surface);

}  // namespace halfspace::cli
