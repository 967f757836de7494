#pragma once

// Random pairs of convex polygons, family by family, from a seed. Shared by the oracles and the metamorphic
// tests.

#include <halfspace/halfspace.h>

#include <random>
#include <string>

#include "capi/handles.h"

namespace halfspace_test {

using Random = std::mt19937_64;

enum class Family {
  triangles,
  boxes,
  regular,
  random_hulls,
  slivers,
  short_edges,
  stacked_boxes,
  stacked_far_away,
  shared_edge,
  vertex_on_edge,
  vertex_on_vertex,
  far_from_origin,
  size_ratio,
};
inline constexpr Family all_families[] = {
    Family::triangles,   Family::boxes,          Family::regular,          Family::random_hulls,
    Family::slivers,     Family::short_edges,    Family::stacked_boxes,    Family::stacked_far_away,
    Family::shared_edge, Family::vertex_on_edge, Family::vertex_on_vertex, Family::far_from_origin,
    Family::size_ratio,
};
const char* name_of(Family family);

/// Is it the vertices that say where the polygons lie, rather than a pose drawn for them?
bool is_placed_by_vertices(Family family);

/// Counter-clockwise, strictly convex in exact arithmetic.
struct PolygonPair {
  Points a;
  Points b;
};
PolygonPair draw_polygons(Family family, Random& random);

struct PosePair {
  hs_pose a;
  hs_pose b;
};

/// Where to put a pair: families that are about a special position give that; the others are laid at a gap
/// that is far, near, grazing (a few roundings), of any smallness, touching or deep, in a random direction
/// and orientation.
/// @param polygons as drawn, @param a, b shapes made of them
PosePair draw_poses(Family family, const PolygonPair& polygons, const hs_shape* a, const hs_shape* b,
                    Random& random);

}  // namespace halfspace_test
