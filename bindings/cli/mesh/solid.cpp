#include "mesh/solid.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "files.h"
#include "mesh/gmsh.h"
#include "mesh/mesh_fault.h"
#include "mesh/surface.h"

namespace halfspace::cli {

std::vector<Solid> read_solids(const std::string& file) {
  const std::filesystem::path path(file);
  const std::string name = path.filename().string();
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));

  const std::string content = content_of(file);
  if (extension == ".msh") return read_gmsh(name, content);
  if (extension == ".obj") return solids_of(read_obj(name, content));
  if (extension == ".off") return solids_of(read_off(name, content));
  if (extension == ".stl") return solids_of(read_stl(name, content));
  throw MeshFault(name, "not a kind of file that is known; allowed: .obj, .off, .stl, .msh");
}

}  // namespace halfspace::cli
