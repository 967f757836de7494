#pragma once

// Scenes that come to rest under gravity, in any size: a heap, walls and a packing.

#include <cstdint>
#include <string>
#include <vector>

#include "capi/handles.h"
#include "random_polyhedron.h"

namespace halfspace_benchmark {

struct Block {
  std::int32_t kind;
  Corners corners;
};

/// Blocks where they are before gravity acts.
struct Scene {
  std::string name;
  int dimension;
  double size;  ///< of a block, m
  std::vector<Block> blocks;

  void add(std::int32_t kind, const Corners& corners) { blocks.push_back({kind, corners}); }
};

/// In the plane a rectangle.
Corners box_of(int dimension, const Triple& lower, const Triple& upper);

/// Polygons of 3 to 8 vertices in a bin.
Scene polygons(int columns, int rows);

/// Bricks in the plane, courses of them on a floor, every other one shifted by this share of a block. By half
/// a block, the last ones of a course are about to tip over, and do in the long run.
Scene bricks(int columns, int courses, double shift);

/// The same of cubes in space.
Scene cubes(int columns, int courses, double shift);

/// Polyhedra of 12 to 20 vertices in a box without a lid.
Scene polyhedra(int side, int layers);

/// Damped, with friction.
hs_law_def law_of(std::int32_t stiffness_kind, double stiffness);

/// A world without blocks. Arguments that another release of the library may have other defaults for are
/// given.
halfspace_test::World make_world(hs_context* context, int dimension, double time_step, const hs_law_def& law);

/// At a pose of its centroid, or with NULL where its corners are.
hs_block add_block(hs_context* context, hs_world* world, int dimension, const Block& block,
                   const hs_pose* pose);

}  // namespace halfspace_benchmark
