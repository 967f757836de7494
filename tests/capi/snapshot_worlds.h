#pragma once

// Snapshots of small worlds, kind by kind, and how a changed one gets a right checksum again.

#include <cstring>

#include "capi/loads.h"

namespace halfspace_test {

/// The parts that a world is made of; HS_BLOCK_MESH stands for bodies and bonds.
struct WorldKind {
  int dimension;
  std::int32_t law;
  std::int32_t block;
};

inline Shape shape_of(hs_context* context, int dimension, int corners, Random& random) {
  Points3 points = round_points(random, corners, 0.5);
  hs_shape* shape = nullptr;
  require_ok(dimension == 2 ? hs_polygon_create_hull(context, view_of(points), &shape)
                            : hs_polyhedron_create_hull(context, view_of(points), &shape),
             context);
  return Shape(shape);
}

/// Half a unit wide.
inline Shape shape_of_box(hs_context* context, int dimension) {
  return dimension == 2 ? make_shape(context, box(-0.25, -0.25, 0.25, 0.25))
                        : make_polyhedron(context, cube(0.5));
}

/// A row of three boxes, far off: one bond holds, one has failed at once, and one loses its strength slowly.
inline void add_bonded_row(hs_context* context, hs_world* world, int dimension) {
  const Shape shape = shape_of_box(context, dimension);
  hs_block row[4];
  for (int i = 0; i < 4; ++i)
    row[i] =
        add_block(context, world, shape, i == 0 ? HS_BLOCK_FIXED : HS_BLOCK_RIGID, pose_at(20 + 0.5 * i, 0));
  hs_bond_def fading = bond_def(1e9, 1);
  fading.tensile_fracture_energy = fading.shear_fracture_energy = 10;
  const hs_bond_def bonds[3] = {bond_def(1e9, 1e8), fading, bond_def(1e9, 0)};
  for (int i = 0; i < 3; ++i) require_ok(hs_world_bond_blocks(world, row[i], row[i + 1], &bonds[i]), context);
}

/// Four boxes around a corner, far off, each bonded to its neighbours: a ring of bonds.
inline void add_bonded_ring(hs_context* context, hs_world* world, int dimension) {
  const Shape shape = shape_of_box(context, dimension);
  hs_block ring[4];
  for (int i = 0; i < 4; ++i)
    ring[i] = add_block(context, world, shape, i == 0 ? HS_BLOCK_FIXED : HS_BLOCK_RIGID,
                        pose_at(30 + 0.5 * (i % 2), 0.5 * (i / 2)));
  const hs_bond_def bond = bond_def(1e9, 1e8);
  constexpr int neighbors[][2] = {{0, 1}, {0, 2}, {1, 3}, {2, 3}};
  for (const auto& [a, b] : neighbors)
    require_ok(hs_world_bond_blocks(world, ring[a], ring[b], &bond), context);
}

/// A yielding bolt between two boxes in water, far off.
inline void add_water_and_bolt(hs_context* context, hs_world* world, int dimension) {
  const Shape shape = shape_of_box(context, dimension);
  hs_block pair[2];
  for (int i = 0; i < 2; ++i) pair[i] = add_block(context, world, shape, HS_BLOCK_RIGID, pose_at(40 + i, 0));
  hs_bolt_def bolt = bolt_def(pair[0], {40, 0, 0}, pair[1], {41, 0, 0}, 1e6);
  bolt.pretension = bolt.yield_force = 1e3;
  bolt.rupture_elongation = 1;
  add_bolt(context, world, bolt);
  set_water(context, world, dimension == 2 ? Points3{{-1, 0, 0}, {45, 0.1, 0}} : Points3{{0, 0, 0.1}});
}

/// Two compounds of two boxes each, far off and in touch; one that was between their slots is gone.
inline void add_compounds(hs_context* context, hs_world* world, int dimension) {
  const Shape shape = shape_of_box(context, dimension);
  const hs_shape* const shapes[2] = {shape.get(), shape.get()};
  hs_block compounds[3];
  for (int i = 0; i < 3; ++i) {
    const double height = i == 1 ? 9 : 0.249 * i;
    const hs_pose poses[2] = {pose_at(40, height), pose_at(40.5, height)};
    hs_block_def def;
    require_ok(hs_compound_def_init(&def, sizeof def, shapes, poses, 2), context);
    def.kind = i == 0 ? HS_BLOCK_PRESCRIBED : HS_BLOCK_RIGID;
    require_ok(hs_world_add_compound(world, shapes, poses, 2, &def, &compounds[i]), context);
  }
  require_ok(hs_world_remove_block(world, compounds[1]), context);
}

/// Five blocks that lie on a plate and on each other, after some steps; one has been removed. By springs per
/// area they have fallen asleep. Rigid ones have compounds beside them. Where the kind is that of meshes, the
/// blocks are rigid, and there are a body that touches the plate and has lost a cell, the gap of another one,
/// and bonds.
inline std::vector<unsigned char> snapshot_of(hs_context* context, const WorldKind& kind) {
  Random random(7);
  hs_world_def def = world_def();
  def.dimension = kind.dimension;
  const bool sleeps = kind.law == HS_STIFFNESS_PER_AREA;
  if (sleeps) def.sleep_tolerance = 10;
  if (kind.law == HS_STIFFNESS_NONE) def.time_step = 1e-4;  // rigid blocks tell none
  const World world = make_world(context, def);
  std::int32_t materials[2];
  for (std::int32_t& material : materials) {
    require_ok(hs_world_add_material(world.get(), 2000, &material), context);
    const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-4);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context);
  }
  hs_law_def law = law_def(1e6, 0.5);
  law.stiffness_kind = kind.law;
  law.normal_damping = law.shear_damping = 0.1;
  if (kind.law == HS_STIFFNESS_PER_CONTACT) law.cohesion = law.tensile_strength = 1e3;
  require_ok(hs_world_set_default_law(world.get(), &law), context);
  require_ok(hs_world_set_law(world.get(), materials[0], materials[1], &law), context);
  hs_block removed = 0;
  for (int i = 0; i < 7; ++i) {
    const Shape shape = shape_of(context, kind.dimension, i == 0 ? 30 : 6 + 4 * (i % 3), random);
    hs_block_def block;
    require_ok(hs_block_def_init(&block, sizeof block, shape.get()), context);
    const std::int32_t common = kind.block == HS_BLOCK_MESH ? HS_BLOCK_RIGID : kind.block;
    block.kind = i == 0 ? HS_BLOCK_FIXED : i == 1 ? HS_BLOCK_PRESCRIBED : common;
    block.material = materials[i % 2];
    block.pose = pose_at({0.2 * (i % 3), 0.2 * i, 0.1 * (i % 2)}, {0, 0, 1}, 0.3 * i);
    hs_block id = 0;
    require_ok(hs_world_add_block(world.get(), shape.get(), &block, &id), context);
    if (i == 2) removed = id;
  }
  if (kind.block == HS_BLOCK_RIGID) add_compounds(context, world.get(), kind.dimension);
  hs_body gone = 0, dug = 0;
  if (kind.block == HS_BLOCK_MESH) {
    gone = add_body(context, world.get(), bar(kind.dimension, 0.5), body_def(pose_at(-9, 0)));
    hs_body_def def = body_def(pose_at({0.48, -0.25, -0.25}, {0, 0, 1}, 0.1));
    def.material = materials[1];
    const hs_body body = dug = add_body(context, world.get(), bar(kind.dimension, 0.5), def);
    const std::int32_t held[] = {2, 5};
    const double still[3] = {0, 0, 0}, force[3] = {0, -50, 0};
    require_ok(hs_world_hold_nodes(world.get(), body, held, 2, HS_AXIS_X, still), context);
    require_ok(hs_world_set_node_force(world.get(), body, held, 1, force), context);
    add_bonded_row(context, world.get(), kind.dimension);
    add_bonded_ring(context, world.get(), kind.dimension);
    add_water_and_bolt(context, world.get(), kind.dimension);
  }
  require_ok(hs_world_step(world.get(), 3), context);
  if (gone != 0) require_ok(hs_world_remove_body(world.get(), gone), context);
  if (dug != 0) {
    const std::int32_t last_cell = std::int32_t(state_of_body(world.get(), dug).cell_count) - 1;
    Points3 released(std::size_t(state_of_body(world.get(), dug).node_count));
    require_ok(hs_world_remove_cells(world.get(), dug, &last_cell, 1, mutable_view_of(released)), context);
  }
  require_ok(hs_world_remove_block(world.get(), removed), context);
  require_ok(hs_world_step(world.get(), sleeps ? 64 : 3), context);
  return saved(world.get());
}

constexpr std::size_t snapshot_header = 32;

template <class T>
void put(std::vector<unsigned char>& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}
template <class T>
T at(const std::vector<unsigned char>& bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

/// The size of what follows the header and its checksum, FNV-1a, where the header has them.
inline void mend_header(std::vector<unsigned char>& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::size_t i = snapshot_header; i < bytes.size(); ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
  put(bytes, 16, std::uint64_t(bytes.size() - snapshot_header));
  put(bytes, 24, hash);
}

}  // namespace halfspace_test
