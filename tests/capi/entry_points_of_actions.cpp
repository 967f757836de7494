// The functions of halfspace/action.h as calls on a scene.

#include "capi/action_world.h"
#include "capi/entry_points.h"

namespace halfspace_test {
namespace {

constexpr std::int32_t some_nodes[] = {0, 2, 3};
constexpr double some_times[] = {0, 1, 1};

hs_status put_table(Scene& s, std::int32_t* table) {
  const Points3 values = {{1, 2, 3}, {4, 5, 6}, {0, 0, 0}};
  return hs_world_add_table(s.world.get(), some_times, view_of(values), table);
}

hs_status act(Scene& s, hs_block block, std::int32_t kind) {
  const hs_action_def def = action_def(kind);
  return hs_world_add_action(s.world.get(), block, &def);
}

hs_status push_nodes(Scene& s) {
  const Points3 scales(3, {1, 0.5, 0});
  const hs_action_def def = action_def(HS_ACTION_FORCE);
  return hs_world_add_node_action(s.world.get(), s.body, some_nodes, view_of(scales), &def);
}

hs_block add_block_at(Scene& s, std::int32_t kind, double x) {
  hs_block_def def = block_def(s.context.get(), s.box, kind);
  def.pose.position[0] = x;
  return add_block(s.context.get(), s.world.get(), s.box, def);
}

/// A table, a prescribed block and a body that nothing acts on.
void add_table_and_targets(Scene& s) {
  add_body(s);
  std::int32_t table = -1;
  require_ok(put_table(s, &table), s.context.get());
  s.moved = add_block_at(s, HS_BLOCK_PRESCRIBED, -4);
}

/// Blocks, nodes and all move by the table, and a step is made.
void add_actions(Scene& s) {
  add_table_and_targets(s);
  require_ok(act(s, s.moved, HS_ACTION_VELOCITY), s.context.get());
  require_ok(act(s, s.upper, HS_ACTION_FORCE), s.context.get());
  require_ok(act(s, 0, HS_ACTION_ACCELERATION), s.context.get());
  require_ok(push_nodes(s), s.context.get());
  require_ok(hs_world_step(s.world.get(), 1), s.context.get());
}

/// Blocks and nodes for which the actions have no room yet.
void add_actions_and_more(Scene& s) {
  add_actions(s);
  for (int i = 0; i < 20; ++i) add_block_at(s, HS_BLOCK_FIXED, -7 - 2 * i);
  const hs_body_def def = body_def(pose_at(20, 0));
  hs_body other = 0;
  require_ok(hs_world_add_mesh(s.world.get(), s.bar.get(), &def, nullptr, &other), s.context.get());
}

/// The same without contacts, which a step would find before its last request for memory.
void add_actions_apart(Scene& s) {
  add_actions_and_more(s);
  const hs_pose above = pose_at(0, 9);
  require_ok(hs_world_set_pose(s.world.get(), s.upper, &above), s.context.get());
}

void save_with_actions(Scene& s) {
  add_actions_and_more(s);
  s.snapshot = saved(s.world.get());
}

hs_status remove_body(Scene& s) {
  const hs_status status = hs_world_remove_body(s.world.get(), s.body);
  if (status == HS_OK) s.body = 0;
  return status;
}

hs_status prescribe_velocities(Scene& s) {
  const Points3 velocities(1, {1, 2, 0}), spins(1, {0, 0, 3});
  return hs_world_prescribe_velocities(s.world.get(), &s.moved, view_of(velocities), view_of(spins));
}

hs_status set_viscosity(Scene& s) {
  const int32_t nodes[] = {1, 0, 1};
  const double viscosity[9] = {1e3, 0, 0, 0, 1e3, 0, 0, 0, 1e3};
  return hs_world_set_node_viscosity(s.world.get(), s.body, nodes, 3, viscosity);
}

}  // namespace

std::vector<EntryPoint> entry_points_of_actions() {
  using S = Scene&;
  return {
      {"hs_action_def_init", Allocates::never, [](S) { return fill<hs_action_def>(hs_action_def_init); }},
      {"hs_world_add_table", Allocates::always, [](S s) { return put_table(s, &s.written.indices[0][0]); }},
      {"hs_world_add_action", Allocates::always, [](S s) { return act(s, s.moved, HS_ACTION_ACCELERATION); },
       add_table_and_targets},
      {"hs_world_add_node_action", Allocates::always, push_nodes, add_table_and_targets},
      {"hs_world_end_actions", Allocates::never,
       [](S s) { return hs_world_end_actions(s.world.get(), s.upper); }, add_actions_and_more},
      {"hs_world_end_node_actions", Allocates::never,
       [](S s) { return hs_world_end_node_actions(s.world.get(), s.body); }, add_actions_and_more},
      {"hs_world_hold_block", Allocates::never,
       [](S s) { return hs_world_hold_block(s.world.get(), s.upper, HS_AXIS_X | HS_AXIS_ROTATION); }},
      {"hs_world_set_node_viscosity", Allocates::always, set_viscosity, add_table_and_targets},
      {"hs_world_prescribe_velocities", Allocates::never, prescribe_velocities, add_table_and_targets},
  };
}

std::vector<EntryPoint> calls_on_worlds_with_actions() {
  using S = Scene&;
  return {
      {"one more action", Allocates::always, [](S s) { return act(s, s.upper, HS_ACTION_TORQUE); },
       add_actions_and_more},
      {"one more action on nodes", Allocates::always, push_nodes, add_actions_and_more},
      {"the end of the acceleration of all blocks", Allocates::never,
       [](S s) { return hs_world_end_actions(s.world.get(), 0); }, add_actions_and_more},
      {"the end of a block that is acted on", Allocates::never,
       [](S s) { return hs_world_remove_block(s.world.get(), s.moved); }, add_actions_and_more},
      {"the end of a body that is acted on", Allocates::never, remove_body, add_actions_and_more},
      {"a world with actions restored", Allocates::always,
       [](S s) {
         return keep(s.made.world, [&](hs_world** world) {
           return hs_world_restore(s.context.get(), s.snapshot.data(), s.snapshot.size(), world);
         });
       },
       save_with_actions},
      {"a step of a world with actions", Allocates::always,
       [](S s) { return hs_world_step(s.world.get(), 1); }, add_actions_apart},
  };
}

}  // namespace halfspace_test
