#include "blocks/mesh/solid.h"

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
  const std::string name = std::filesystem::path(file).filename().string();
  // Refused before the file is read, as it may be of any size or endless.
  const ReadSolids read = reader_of(extension_of(file));
  if (!read) throw MeshFault(name, "unknown file extension; allowed: .obj, .off, .stl, .msh");
  return read(name, content_of(file));
}

}  // namespace halfspace::cli
