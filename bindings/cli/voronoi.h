#pragma once

#include <vector>

#include "library.h"
#include "scene.h"

namespace halfspace::cli {

/// Divides a convex region of space among random sites. Each block is the region cut by the planes half way
/// between its site and the neighbouring ones; two neighbours are cut by the same plane, so they share their
/// vertices, to rounding.
std::vector<Shape> voronoi_blocks(const Context& context, const Voronoi& voronoi, const Shape& region);

/// Random points inside a convex shape, evenly over its volume.
std::vector<Point> random_sites(const Context& context, const Shape& region, std::int64_t count,
                                std::uint64_t seed);

/// For each site, in ascending order, the others whose Voronoi cells have a face in common with its own,
/// within the box around points, which have to lie around all sites.
std::vector<std::vector<int>> neighbouring_sites(const std::vector<Point>& sites,
                                                 const std::vector<Point>& around);

}  // namespace halfspace::cli
