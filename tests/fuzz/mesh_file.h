#pragma once

// Files of blocks: whatever the bytes are, the reader names a fault or gives solids, of each of which the
// library makes a block or says why not.

#include <cmath>

#include "blocks/mesh/convex_solid.h"
#include "blocks/mesh/gmsh.h"
#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/surface.h"
#include "fuzz/bytes.h"
#include "fuzz/demand.h"

namespace halfspace_fuzz {

using namespace halfspace::cli;

inline void make_block(const Context& context, const Solid& solid) {
  for (const std::vector<int>& face : solid.faces)
    for (const int v : face)
      demand(v >= 0 && std::size_t(v) < solid.vertices.size(), "faces are of vertices that there are");
  try {
    const Shape shape = make_convex(context, solid, 1).shape;
    const double volume = properties_of(context, shape).volume;
    demand(volume > 0 && std::isfinite(volume), "a block has a volume");
  } catch (const MeshFault& fault) {
    demand(*fault.what() != 0, "a fault has a text");
  }
}

template <class Read>
void read_and_make(const std::uint8_t* data, std::size_t size, Read read) {
  static const Context context = make_context();
  try {
    for (const Solid& solid : read("file", Bytes(data, size).rest())) make_block(context, solid);
  } catch (const MeshFault& fault) {
    demand(std::string(fault.what()).starts_with("file"), "a fault names the file");
  }
}

}  // namespace halfspace_fuzz
