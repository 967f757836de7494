#include "blocks/mesh/solid.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "blocks/mesh/gmsh.h"
#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/surface.h"
#include "common/files.h"

namespace halfspace::cli {

namespace {

using ReadSolids = std::vector<Solid> (*)(const std::string& name, const std::string& content);

/// Null for an unknown extension.
ReadSolids reader_of(const std::string& extension) {
  if (extension == ".msh")
    return [](const auto& name, const auto& content) { return solids_of(read_gmsh(name, content)); };
  if (extension == ".obj")
    return [](const auto& name, const auto& content) { return solids_of(read_obj(name, content)); };
  if (extension == ".off")
    return [](const auto& name, const auto& content) { return solids_of(read_off(name, content)); };
  if (extension == ".stl")
    return [](const auto& name, const auto& content) { return solids_of(read_stl(name, content)); };
  return nullptr;
}

}  // namespace

std::vector<Solid> read_solids(const std::string& file) {
  const std::filesystem::path path(file);
  const std::string name = path.filename().string();
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));

  // Refused before the file is read, as it may be of any size or endless.
  const ReadSolids read = reader_of(extension);
  if (!read) throw MeshFault(name, "unknown file extension; allowed: .obj, .off, .stl, .msh");
  return read(name, content_of(file));
}

}  // namespace halfspace::cli
