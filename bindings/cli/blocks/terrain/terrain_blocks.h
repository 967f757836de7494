#pragma once

#include <functional>
#include <vector>

#include "blocks/terrain/triangle_surface.h"
#include "model/library.h"

namespace halfspace::cli {

/// The block behind a triangle of a terrain.
struct TerrainBlock {
  Shape shape;           ///< relative to `place`
  Point place{};         ///< the centre of the triangle
  std::vector<int> top;  ///< the vertices of the triangle
};

/// Calls `add` for the convex block behind each triangle, in their order. Its face at the surface is the
/// triangle. Its other faces lie behind the surface: the flanks at the edges lean outwards below the
/// neighbours, at 60 degrees to their surfaces. The blocks extend `depth` behind the surface. @throws
/// LibraryError
void make_terrain_blocks(const Context& context, const TriangleSurface& surface, double depth,
                         const std::function<void(TerrainBlock)>& add);

}  // namespace halfspace::cli
