#include "fuzz/mesh_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halfspace_fuzz;
  read_and_make(data, size, [](const std::string& name, const std::string& content) {
    return solids_of(read_off(name, content));
  });
  return 0;
}
