#include "fuzz/mesh_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  halfspace_fuzz::read_and_make(data, size, [](const std::string& name, const std::string& content) {
    return halfspace::cli::solids_of(halfspace::cli::read_gmsh(name, content));
  });
  return 0;
}
