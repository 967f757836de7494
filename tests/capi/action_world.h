#pragma once

// A small world with a block of each kind, a body and a table, for tests of halfspace/action.h. No test
// logic.

#include "capi/meshes.h"

namespace halfspace_test {

inline hs_action_def action_def(std::int32_t kind, std::int32_t table = 0) {
  hs_action_def def;
  if (hs_action_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no action definition");
  def.kind = kind;
  def.table = table;
  return def;
}

/// Apart from each other, without gravity; the table is a constant vector.
struct ActionWorld {
  explicit ActionWorld(int dimension) : dimension(dimension) {
    hs_world_def def = world_def(dimension);
    for (double& component : def.gravity) component = 0;
    def.time_step = 1e-3;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 1000, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e6);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    shape = dimension == 2 ? make_shape(context.get(), box(-0.5, -0.5, 0.5, 0.5))
                           : make_polyhedron(context.get(), cube(1));
    fixed = add(HS_BLOCK_FIXED, 0);
    prescribed = add(HS_BLOCK_PRESCRIBED, 2);
    rigid = add(HS_BLOCK_RIGID, 4);
    affine = add(HS_BLOCK_AFFINE, 6);
    gone = add(HS_BLOCK_RIGID, 8);
    body = add_bar(0);
    gone_body = add_bar(4);
    require_ok(hs_world_remove_block(world.get(), gone), context.get());
    require_ok(hs_world_remove_body(world.get(), gone_body), context.get());
    table = add_table({0}, {{3, -2, 1}});
  }

  hs_block add(std::int32_t kind, double x) {
    return add_block(context.get(), world.get(), shape, kind, pose_at(x, 0));
  }
  hs_body add_bar(double x) {
    return add_body(context.get(), world.get(), bar(dimension), body_def(pose_at(x, 4)));
  }
  std::int32_t add_table(const std::vector<double>& times, const Points3& values) {
    std::int32_t made = -1;
    require_ok(hs_world_add_table(world.get(), times.data(), view_of(values), &made), context.get());
    return made;
  }
  void act(hs_block block, const hs_action_def& def) {
    require_ok(hs_world_add_action(world.get(), block, &def), context.get());
  }
  void act_on_nodes(hs_body of, const std::vector<std::int32_t>& nodes, const Points3& scales,
                    const hs_action_def& def) {
    require_ok(hs_world_add_node_action(world.get(), of, nodes.data(), view_of(scales), &def), context.get());
  }
  void step(std::int64_t steps = 1) { require_ok(hs_world_step(world.get(), steps), context.get()); }
  double velocity_of(hs_block block, int component = 0) const {
    return state_of(world.get(), block).velocity[component];
  }

  int dimension;
  Context context = make_context();
  World world;
  Shape shape;
  hs_block fixed = 0, prescribed = 0, rigid = 0, affine = 0, gone = 0;
  hs_body body = 0, gone_body = 0;
  std::int32_t table = -1;
};

}  // namespace halfspace_test
