#include "fuzz/mesh_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  halfspace_fuzz::read_and_make(data, size, halfspace::cli::read_gmsh);
  return 0;
}
