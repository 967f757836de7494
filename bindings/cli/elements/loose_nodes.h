#pragma once

#include <string>
#include <vector>

#include "elements/element_mesh.h"

namespace halfspace::cli {

/// Says where cells of a mesh meet without being joined: nodes at one place, and nodes in the middle of
/// another cell's face. Nothing where there are none. The surface is that of surface_of().
std::vector<std::string> loose_nodes(const ElementMesh& mesh, const std::vector<OuterFace>& surface);

}  // namespace halfspace::cli
