#pragma once

// Snapshots of small worlds that have something of everything, for tests that change single fields of them.

#include "capi/action_world.h"
#include "capi/snapshot_worlds.h"

namespace halfspace_test {

/// A compound of two boxes side by side.
inline hs_block add_compound(hs_context* context, hs_world* world, int dimension, std::int32_t kind,
                             double x) {
  const Shape shape = shape_of_box(context, dimension);
  const hs_shape* const shapes[2] = {shape.get(), shape.get()};
  const hs_pose poses[2] = {pose_at(x, 0), pose_at(x + 0.5, 0)};
  hs_block_def def;
  require_ok(hs_compound_def_init(&def, sizeof def, shapes, poses, 2), context);
  def.kind = kind;
  hs_block compound = 0;
  require_ok(hs_world_add_compound(world, shapes, poses, 2, &def, &compound), context);
  return compound;
}

/// An action of each kind, on each kind of block, and on nodes.
inline void add_actions(ActionWorld& scene, hs_block compound, hs_block pressed) {
  hs_action_def def = action_def(HS_ACTION_ACCELERATION);
  scene.act(0, def);
  for (const std::int32_t kind : {HS_ACTION_VELOCITY, HS_ACTION_ANGULAR_VELOCITY}) {
    def.kind = kind;
    scene.act(scene.prescribed, def);
  }
  def.kind = HS_ACTION_TORQUE;
  scene.act(scene.rigid, def);
  def.kind = HS_ACTION_FORCE;
  for (const std::int32_t place : {HS_PLACE_CENTROID, HS_PLACE_CARRIED, HS_PLACE_FIXED}) {
    def.place = place;
    scene.act(scene.rigid, def);
    scene.act(scene.affine, def);
    scene.act(compound, def);
  }
  scene.act_on_nodes(scene.body, {1, 4}, {{1, 1, 1}, {2, 0, 0}}, def);
  def.kind = HS_ACTION_VELOCITY;
  scene.act_on_nodes(scene.body, {2}, {{1, 0, 0}}, def);
  require_ok(hs_world_hold_block(scene.world.get(), scene.rigid, HS_AXIS_X), scene.context.get());
  def.scale[1] = def.scale[2] = 0;
  scene.act(scene.rigid, def);
  def.kind = HS_ACTION_SERVO;
  def.scale[0] = 0;
  def.scale[1] = -1;
  def.max_speed = 0.1;
  scene.act(pressed, def);
}

/// Blocks of all kinds with actions, a body, compounds, bonds, a bolt, water, impulses, springs, and keys.
inline std::vector<unsigned char> snapshot_of_full_world(int dimension, std::int32_t stiffness_kind) {
  ActionWorld scene(dimension);
  hs_context* const context = scene.context.get();
  hs_world* const world = scene.world.get();
  hs_law_def law = law_def(1e6, 0.5);
  law.stiffness_kind = stiffness_kind;
  law.normal_damping = law.shear_damping = 0.1;
  require_ok(hs_world_set_default_law(world, &law), context);
  std::int32_t smooth = -1;
  require_ok(hs_world_add_material(world, 1000, &smooth), context);
  law.stiffness_kind = stiffness_kind == HS_STIFFNESS_NONE ? HS_STIFFNESS_PER_AREA : HS_STIFFNESS_NONE;
  require_ok(hs_world_set_law(world, 0, smooth, &law), context);
  require_ok(hs_world_set_damping(world, 0.1, 0.1), context);
  require_ok(hs_world_set_time_step(world, 1e-5), context);
  const double down[3] = {0, -9.81, 0};
  require_ok(hs_world_set_gravity(world, down), context);
  const auto add_box = [&](std::int32_t kind, std::int32_t material, double x, double y) {
    hs_block_def def;
    require_ok(hs_block_def_init(&def, sizeof def, scene.shape.get()), context);
    def.kind = kind;
    def.material = material;
    def.pose = pose_at(x, y);
    hs_block id = 0;
    require_ok(hs_world_add_block(world, scene.shape.get(), &def, &id), context);
    return id;
  };
  add_box(HS_BLOCK_RIGID, 0, 0, 0.999);
  add_box(HS_BLOCK_RIGID, smooth, 0, -0.999);
  add_box(HS_BLOCK_FIXED, 0, 0, -1.998);
  const hs_block pressed = add_box(HS_BLOCK_PRESCRIBED, 0, 0, 1.998);
  const hs_block compound = add_compound(context, world, dimension, HS_BLOCK_RIGID, 12);
  add_compound(context, world, dimension, HS_BLOCK_FIXED, 12.999);
  add_bonded_row(context, world, dimension);
  add_bonded_ring(context, world, dimension);
  add_water_and_bolt(context, world, dimension);
  const double viscosity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::int32_t nodes[2] = {0, 3};
  require_ok(hs_world_set_node_viscosity(world, scene.body, nodes, 2, viscosity), context);
  require_ok(hs_world_hold_nodes(world, scene.body, nodes, 1, HS_AXIS_Y, down), context);
  add_actions(scene, compound, pressed);
  require_ok(hs_world_step(world, 3), context);
  std::int64_t count = 0;
  (void)hs_world_get_blocks(world, nullptr, 0, &count);
  std::vector<std::int64_t> keys(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = 10 * std::int64_t(i);
  require_ok(hs_world_set_keys(world, keys.data(), std::int64_t(keys.size())), context);
  return saved(world);
}

/// A share of a row of blocks: two are its own, one is a copy, and one is fixed. It has moved once.
inline std::vector<unsigned char> snapshot_of_share(int dimension) {
  const Context context = make_context();
  hs_world_def settings = world_def(dimension);
  settings.time_step = 1e-4;
  const World world = make_world(context.get(), settings);
  std::int32_t material = -1, table = -1;
  require_ok(hs_world_add_material(world.get(), 1000, &material), context.get());
  const hs_elasticity_def elasticity = elasticity_def(1e6);
  require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
  const hs_law_def law = law_def(1e6, 0.5);
  require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  const Shape shape = shape_of_box(context.get(), dimension);
  constexpr std::int32_t kinds[4] = {HS_BLOCK_FIXED, HS_BLOCK_RIGID, HS_BLOCK_AFFINE, HS_BLOCK_RIGID};
  hs_block row[4];
  for (int i = 0; i < 4; ++i)
    row[i] = add_block(context.get(), world.get(), shape, kinds[i], pose_at(0.499 * i, 0));
  const double start = 0;
  require_ok(hs_world_add_table(world.get(), &start, view_of(Points3{{1, 2, 3}}), &table), context.get());
  const hs_action_def force = action_def(HS_ACTION_FORCE);
  for (const int i : {1, 3}) require_ok(hs_world_add_action(world.get(), row[i], &force), context.get());
  require_ok(hs_world_begin(world.get()), context.get());
  require_ok(hs_world_end_begin(world.get()), context.get());
  const std::int64_t last = 3;
  std::size_t size = 0;
  std::vector<unsigned char> bytes(1 << 16);
  require_ok(hs_world_pack(world.get(), &last, 1, 1, bytes.data(), bytes.size(), nullptr, &size),
             context.get());
  const hs_packed blocks[4] = {{0, nullptr, 0, HS_ROLE_EVERYWHERE, 0},
                               {1, nullptr, 0, HS_ROLE_OWN, 0},
                               {2, nullptr, 0, HS_ROLE_OWN, 0},
                               {3, bytes.data(), size, HS_ROLE_NEIGHBOR, 0}};
  hs_world* made = nullptr;
  require_ok(hs_world_assemble(context.get(), world.get(), blocks, 4, &made), context.get());
  const World share(made);
  hs_share_plan plan;
  require_ok(hs_world_plan_motion(made, &plan), context.get());
  require_ok(hs_world_renew_list(made, &plan), context.get());
  require_ok(hs_world_move(made), context.get());
  require_ok(hs_world_end_step(made), context.get());
  return saved(made);
}

}  // namespace halfspace_test
