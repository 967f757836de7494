// The functions of halfspace/bond.h, relax.h and strength.h as calls on a scene.

#include "capi/entry_points.h"

namespace halfspace_test {
namespace {

constexpr double aslant[3] = {1, 2, 0};

hs_status bond(Scene& s) {
  const hs_bond_def def = bond_def(1e8, 1e5);
  return hs_world_bond_blocks(s.world.get(), s.lower, s.beside, &def);
}

/// One step, and at rest whatever comes of it.
hs_status relax(Scene& s) {
  const hs_relaxation_def def = relaxation_def(1, 1e9);
  return hs_world_relax(s.world.get(), &def, &s.written.balance, sizeof s.written.balance);
}

/// One trial of one step, by which the world has fallen.
hs_status find_strength(Scene& s) {
  hs_strength_def def;
  require_ok(hs_strength_def_init(&def, sizeof def), s.context.get());
  def.max_steps = 1;
  def.ratio = 1e-30;
  return keep(s.made.world, [&](hs_world** fallen) {
    return hs_world_find_strength_factor(s.world.get(), &def, &s.written.strength, sizeof s.written.strength,
                                         fallen);
  });
}

}  // namespace

void add_box_beside(Scene& s) {
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, s.box.get()), s.context.get());
  def.pose.position[0] = -1;
  require_ok(hs_world_add_block(s.world.get(), s.box.get(), &def, &s.beside), s.context.get());
}

void bond_boxes(Scene& s) {
  add_box_beside(s);
  require_ok(bond(s), s.context.get());
}

std::vector<EntryPoint> entry_points_of_bonds() {
  using S = Scene&;
  return {
      {"hs_bond_def_init", Allocates::never, [](S) { return fill<hs_bond_def>(hs_bond_def_init); }},
      {"hs_world_bond_blocks", Allocates::always, bond, add_box_beside},
      {"hs_world_bond_materials", Allocates::always,
       [](S s) {
         const hs_bond_def def = bond_def(1e8, 1e5);
         return hs_world_bond_materials(s.world.get(), 0, 0, &def, &s.written.counts[0]);
       },
       add_box_beside},
      {"hs_world_hold_bonds", Allocates::never, [](S s) { return hs_world_hold_bonds(s.world.get(), 1); },
       bond_boxes},
      {"hs_world_get_bonds", Allocates::never,
       [](S s) { return hs_world_get_bonds(s.world.get(), s.written.bonds, 2, &s.written.counts[0]); },
       bond_boxes},
      {"hs_world_get_bond_events", Allocates::never,
       [](S s) {
         return hs_world_get_bond_events(s.world.get(), 0, s.written.events, 2, &s.written.counts[0]);
       },
       bond_boxes},
      {"hs_world_get_bond_report", Allocates::never,
       [](S s) {
         return hs_world_get_bond_report(s.world.get(), &s.written.bond_report, sizeof s.written.bond_report);
       },
       bond_boxes},
  };
}

std::vector<EntryPoint> entry_points_of_rest() {
  using S = Scene&;
  return {
      {"hs_relaxation_def_init", Allocates::never,
       [](S) { return fill<hs_relaxation_def>(hs_relaxation_def_init); }},
      {"hs_strength_def_init", Allocates::never,
       [](S) { return fill<hs_strength_def>(hs_strength_def_init); }},
      {"hs_world_relax", Allocates::always, relax, bond_boxes},
      {"hs_world_get_balance", Allocates::always,
       [](S s) { return hs_world_get_balance(s.world.get(), &s.written.balance, sizeof s.written.balance); }},
      {"hs_world_set_gravity", Allocates::never,
       [](S s) { return hs_world_set_gravity(s.world.get(), aslant); }},
      {"hs_world_set_damping", Allocates::never,
       [](S s) { return hs_world_set_damping(s.world.get(), 0.5, 2); }},
      {"hs_world_set_time_step", Allocates::never,
       [](S s) { return hs_world_set_time_step(s.world.get(), 1e-4); }},
      {"hs_world_set_strength_factor", Allocates::never,
       [](S s) { return hs_world_set_strength_factor(s.world.get(), 1.5); }, bond_boxes},
      {"hs_world_find_strength_factor", Allocates::always, find_strength, bond_boxes},
  };
}

}  // namespace halfspace_test
