#pragma once

// Promises that every world keeps, whatever has been done to it.

#include <vector>

#include "capi/meshes.h"
#include "fuzz/geometry.h"

namespace halfspace_fuzz {

using halfspace_test::saved;

/// The bytes of its snapshot; none within a step in pieces.
inline std::vector<unsigned char> saved_between_steps(const hs_world* world) {
  std::size_t size = 0;
  return hs_world_save(world, nullptr, 0, &size) == HS_ERROR_STATE ? std::vector<unsigned char>()
                                                                   : saved(world);
}

template <std::size_t N>
bool all_finite(const double (&numbers)[N]) {
  for (const double x : numbers)
    if (!std::isfinite(x)) return false;
  return true;
}

inline std::vector<hs_block> blocks_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_blocks(world, nullptr, 0, &count);
  std::vector<hs_block> blocks(static_cast<std::size_t>(count));
  demand(hs_world_get_blocks(world, blocks.data(), count, nullptr) == HS_OK, "blocks are told");
  return blocks;
}

inline void check_motion(const hs_world* world) {
  for (const hs_block block : blocks_of(world)) {
    const hs_block_state state = halfspace_test::state_of(world, block);
    demand(all_finite(state.pose.position) && all_finite(state.pose.rotation), "a block is somewhere");
    demand(all_finite(state.velocity) && all_finite(state.angular_velocity), "a block has a velocity");
  }
}

inline void check_forces(const hs_world* world) {
  for (const hs_block block : blocks_of(world)) {
    const hs_block_state state = halfspace_test::state_of(world, block);
    demand(all_finite(state.force) && all_finite(state.torque), "a block has a force");
    const hs_deformation d = halfspace_test::deformation_of(world, block);
    demand(all_finite(d.gradient) && all_finite(d.rate) && all_finite(d.stress), "a block has a stress");
  }
}

/// Nodes are somewhere and have a velocity; bonds and what has failed of them can be read.
inline void check_bodies(const hs_world* world, const std::vector<hs_body>& bodies) {
  for (const hs_body body : bodies) {
    for (const auto get : {hs_world_get_node_positions, hs_world_get_node_velocities}) {
      for (const Point3& p : halfspace_test::of_nodes(get, world, body))
        demand(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "nodes are of numbers");
    }
    hs_cell_state cells[8];
    demand(hs_world_get_cells(world, body, cells, 8, nullptr) == HS_OK, "cells are told");
  }
  for (const hs_bond& bond : halfspace_test::bonds_of(world)) {
    demand(bond.area > 0, "a bond has an area");
    demand(bond.damage >= 0 && bond.damage <= 1 + 1e-12, "a bond's damage is a share");
  }
  const auto events = halfspace_test::bond_events_of(world);
  for (const hs_bond_event& event : events)
    demand(event.failure == HS_BOND_TENSION || event.failure == HS_BOND_SHEAR, "what fails opens or slides");
  hs_bond_report report;
  demand(hs_world_get_bond_report(world, &report, sizeof report) == HS_OK, "bonds are reported");
  demand(report.event_count == std::int64_t(events.size()), "events are counted");
}

/// A step may end without having done what was asked for.
inline bool step(hs_world* world, std::int64_t steps) {
  const hs_status status = hs_world_step(world, steps);
  return succeeds_or(
      status, {HS_ERROR_ARGUMENT, HS_ERROR_STATE, HS_ERROR_UNSTABLE, HS_ERROR_TOO_FAST, HS_ERROR_INVERTED},
      "step");
}

/// Nor may relaxation have done it.
inline bool relax(hs_world* world, const hs_relaxation_def& def) {
  hs_balance balance{};
  const hs_status status = hs_world_relax(world, &def, &balance, sizeof balance);
  if (status == HS_NOTE_NOT_AT_REST) return true;
  return succeeds_or(
      status, {HS_ERROR_ARGUMENT, HS_ERROR_STATE, HS_ERROR_UNSTABLE, HS_ERROR_TOO_FAST, HS_ERROR_INVERTED},
      "relax");
}

inline void check_balance(hs_world* world) {
  hs_balance balance{};
  if (!succeeds_or(hs_world_get_balance(world, &balance, sizeof balance), {HS_ERROR_STATE}, "get_balance"))
    return;
  demand(!(balance.mean < 0) && !(balance.largest < 0), "a balance is a share");
}

inline void check_report(hs_world* world) {
  hs_world_report r{};
  if (!succeeds_or(hs_world_get_report(world, &r, sizeof r), {}, "get_report")) return;
  const hs_energy& e = r.energy;
  const double numbers[] = {r.time,
                            r.time_step,
                            r.stable_time_step,
                            r.largest_overlap,
                            r.largest_speed,
                            e.kinetic,
                            e.gravity,
                            e.strain,
                            e.friction_loss,
                            e.contact_damping_loss,
                            e.local_damping_loss,
                            e.mass_damping_loss,
                            e.outer_work,
                            e.residual,
                            r.block_strain_energy,
                            r.block_damping_loss};
  demand(all_finite(numbers), "a report is of numbers");
}

/// All that reads a world leaves it as it is.
inline void check_queries(hs_world* world) {
  const std::vector<unsigned char> before = saved_between_steps(world);
  check_report(world);
  check_balance(world);
  hs_share_info info;
  demand(hs_world_get_share_info(world, &info, sizeof info) == HS_OK, "a world is described as a share");
  hs_world_plan plan;
  demand(hs_world_get_plan(world, 0, &plan, sizeof plan) == HS_OK, "steps are planned");
  double sums[HS_SUM_COUNT];
  demand(hs_world_get_sums(world, sums) == HS_OK, "sums are told");
  demand(hs_world_get_contacts(world, nullptr, 0, nullptr) >= HS_OK, "contacts are counted");
  demand(saved_between_steps(world) == before, "queries change nothing");
}

}  // namespace halfspace_fuzz
