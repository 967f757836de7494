#pragma once

// Random pairs of convex polyhedra, family by family, from a seed.

#include "oracles/random_polyhedra.h"

namespace halfspace_test {

enum class Family3 {
  tetrahedra,
  boxes,
  hulls_12,
  hulls_32,
  hulls_128,
  slivers,
  short_edges,
  nearly_parallel_faces,
  stacked_boxes,
  stacked_far_away,
  shared_face,
  vertex_on_face,
  edge_on_edge,
  vertex_on_vertex,
  far_from_origin,
  size_ratio,
};
struct NamedFamily3 {
  Family3 family;
  const char* name;
};
inline constexpr NamedFamily3 all_families_3d[] = {
    {Family3::tetrahedra, "tetrahedra"},       {Family3::boxes, "boxes"},
    {Family3::hulls_12, "12 vertices"},        {Family3::hulls_32, "32 vertices"},
    {Family3::hulls_128, "128 vertices"},      {Family3::slivers, "slivers 1e6"},
    {Family3::short_edges, "edges of 1e-8"},   {Family3::nearly_parallel_faces, "faces 1e-10 rad"},
    {Family3::stacked_boxes, "stacked boxes"}, {Family3::stacked_far_away, "stacked 1e8 away"},
    {Family3::shared_face, "shared face"},     {Family3::vertex_on_face, "vertex on face"},
    {Family3::edge_on_edge, "edge on edge"},   {Family3::vertex_on_vertex, "vertex on vertex"},
    {Family3::far_from_origin, "1e8 away"},    {Family3::size_ratio, "size ratio 1e6"},
};

struct PolyhedronPair {
  Polyhedron a;
  Polyhedron b;
};

/// About 1 in size, but for the small one of a size ratio.
PolyhedronPair draw_polyhedra(Family3 family, Random3& random);

struct PosePair3 {
  hs_pose a;
  hs_pose b;
};

/// Where to put a pair: families that are about a special position are left where their vertices say; the
/// others are laid at a gap that is far, near, grazing (a few roundings), of any smallness, touching or deep,
/// in a random direction and, but for the nearly parallel faces, orientation. Called again, it gives another
/// place.
PosePair3 draw_poses(Family3 family, const PolyhedronPair& pair, Random3& random);

/// Is it the vertices that say where the polyhedra lie, rather than a pose drawn for them?
bool is_placed_by_vertices(Family3 family);

}  // namespace halfspace_test
