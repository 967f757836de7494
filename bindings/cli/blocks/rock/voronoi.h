#pragma once

#include <vector>

#include "model/library.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Divides a convex region of space into the Voronoi cells of random sites. Each cell is the region cut by
/// the planes half way between its site and the neighbouring ones; two neighbours are cut by the same plane,
/// so that they share their vertices, to rounding.
std::vector<Shape> voronoi_blocks(const Context& context, const Voronoi& voronoi, const Shape& region);

/// Random points inside a convex shape, uniform over its volume.
std::vector<Point> random_sites(const Context& context, const Shape& region, std::int64_t count,
                                std::uint64_t seed);

/// For each site, in ascending order, the sites whose Voronoi cells share a face with its own, within the
/// bounding box of points that enclose all sites.
std::vector<std::vector<int>> neighbouring_sites(const std::vector<Point>& sites,
                                                 const std::vector<Point>& around);

}  // namespace halfspace::cli
