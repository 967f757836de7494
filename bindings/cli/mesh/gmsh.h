#pragma once

#include <string>
#include <vector>

#include "mesh/solid.h"

namespace halfspace::cli {

/// A Gmsh mesh, MSH 2.2 or 4.1 as text: a solid for each tetrahedron, hexahedron, prism and pyramid. Points,
/// lines and surface elements are the boundary of those and are skipped. @throws MeshFault
std::vector<Solid> read_gmsh(const std::string& name, const std::string& content);

}  // namespace halfspace::cli
