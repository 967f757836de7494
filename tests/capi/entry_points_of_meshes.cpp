// The functions of halfspace/mesh.h as calls on a scene.

#include "capi/entry_points.h"

namespace halfspace_test {
namespace {

constexpr double aslant[3] = {1, 2, 0};
constexpr std::int32_t some_nodes[] = {0, 2, 3};
constexpr std::int32_t some_cells[] = {1};
constexpr double some_stress[9] = {-2e5, 1e5, 0, 1e5, -3e5, 0, 0, 0, -1e5};

hs_status put_bar(Scene& s, double x, hs_body* body) {
  const hs_body_def def = body_def(pose_at(x, 0));
  return hs_world_add_mesh(s.world.get(), s.bar.get(), &def, nullptr, body);
}

hs_status remove_body(Scene& s) {
  const hs_status status = hs_world_remove_body(s.world.get(), s.body);
  if (status == HS_OK) s.body = 0;
  return status;
}

hs_status set_node_velocities(Scene& s) {
  Points3 velocities = of_nodes(hs_world_get_node_velocities, s.world.get(), s.body);
  velocities.back() = {1, 2, 0};
  return hs_world_set_node_velocities(s.world.get(), s.body, view_of(velocities));
}

/// Bodies have come and gone, and with them blocks, so that some slots are free.
void make_gaps(Scene& s) {
  add_body(s);
  hs_body others[2];
  require_ok(put_bar(s, 6, &others[0]), s.context.get());
  require_ok(hs_world_step(s.world.get(), 2), s.context.get());
  require_ok(put_bar(s, 9, &others[1]), s.context.get());
  require_ok(hs_world_remove_body(s.world.get(), others[0]), s.context.get());
  require_ok(hs_world_remove_block(s.world.get(), s.upper), s.context.get());
}

void save_with_body(Scene& s) {
  make_gaps(s);
  bond_boxes(s);
  require_ok(hs_world_step(s.world.get(), 2), s.context.get());
  s.snapshot = saved(s.world.get());
}

}  // namespace

void add_body(Scene& s) {
  make_material_elastic(s);
  require_ok(put_bar(s, 3, &s.body), s.context.get());
}

std::vector<EntryPoint> entry_points_of_meshes() {
  using S = Scene&;
  return {
      {"hs_body_def_init", Allocates::never, [](S) { return fill<hs_body_def>(hs_body_def_init); }},
      {"hs_mesh_create", Allocates::always,
       [](S s) {
         return keep(s.made.mesh, [&](hs_mesh** mesh) {
           return create_mesh(s.context.get(), halfspace_test::bar(s.dimension), mesh);
         });
       }},
      {"hs_mesh_destroy", Allocates::never, [](S s) { return s.made.mesh.reset(), HS_OK; }},
      {"hs_mesh_get_properties", Allocates::never,
       [](S s) { return hs_mesh_get_properties(s.bar.get(), &s.written.mesh, sizeof s.written.mesh); }},
      {"hs_world_add_mesh", Allocates::always, [](S s) { return put_bar(s, 3, &s.written.body); },
       make_material_elastic},
      {"hs_world_remove_body", Allocates::never, remove_body, add_body},
      {"hs_world_remove_cells", Allocates::always,
       [](S s) { return hs_world_remove_cells(s.world.get(), s.body, some_cells, 1, room(s, 0)); }, add_body},
      {"hs_world_set_body_stress", Allocates::never,
       [](S s) { return hs_world_set_body_stress(s.world.get(), s.body, some_stress, nullptr); }, add_body},
      {"hs_world_get_body_state", Allocates::never,
       [](S s) {
         return hs_world_get_body_state(s.world.get(), s.body, &s.written.body_state,
                                        sizeof s.written.body_state);
       },
       add_body},
      {"hs_world_get_node_positions", Allocates::never,
       [](S s) {
         return hs_world_get_node_positions(s.world.get(), s.body, room(s, 0), &s.written.counts[0]);
       },
       add_body},
      {"hs_world_get_node_velocities", Allocates::never,
       [](S s) {
         return hs_world_get_node_velocities(s.world.get(), s.body, room(s, 0), &s.written.counts[0]);
       },
       add_body},
      {"hs_world_get_node_forces", Allocates::never,
       [](S s) { return hs_world_get_node_forces(s.world.get(), s.body, room(s, 0), &s.written.counts[0]); },
       add_body},
      {"hs_world_set_node_velocities", Allocates::never, set_node_velocities, add_body},
      {"hs_world_hold_nodes", Allocates::never,
       [](S s) { return hs_world_hold_nodes(s.world.get(), s.body, some_nodes, 3, HS_AXIS_Y, aslant); },
       add_body},
      {"hs_world_set_node_force", Allocates::never,
       [](S s) { return hs_world_set_node_force(s.world.get(), s.body, some_nodes, 3, aslant); }, add_body},
      {"hs_world_get_cells", Allocates::never,
       [](S s) {
         return hs_world_get_cells(s.world.get(), s.body, s.written.cells, 4, &s.written.counts[0]);
       },
       add_body},
      {"hs_world_get_body_of_block", Allocates::never,
       [](S s) {
         return hs_world_get_body_of_block(s.world.get(), s.upper, &s.written.body, &s.written.indices[0][0]);
       },
       add_body},
  };
}

std::vector<EntryPoint> calls_on_bodies_and_bonds() {
  using S = Scene&;
  return {
      {"a body in the slots of others", Allocates::always,
       [](S s) { return put_bar(s, 12, &s.written.body); }, make_gaps},
      {"the end of a body before others", Allocates::never, remove_body, make_gaps},
      {"a world with bodies and bonds restored", Allocates::always,
       [](S s) {
         return keep(s.made.world, [&](hs_world** world) {
           return hs_world_restore(s.context.get(), s.snapshot.data(), s.snapshot.size(), world);
         });
       },
       save_with_body},
      {"a step of a world with bodies and bonds", Allocates::always,
       [](S s) { return hs_world_step(s.world.get(), 1); },
       [](S s) {
         save_with_body(s);
         add_body(s);
       }},
  };
}

}  // namespace halfspace_test
