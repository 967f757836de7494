#include <algorithm>

#include "halfspace/action.h"
#include "mesh_nodes.h"
#include "sized_struct.h"
#include "strided_view.h"
#include "tensor.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_action_def default_definition() {
  hs_action_def def{};
  def.kind = HS_ACTION_FORCE;
  for (double& factor : def.scale) factor = 1;
  return def;
}

namespace {

/// Point i of a view, whose z may be missing.
Vector<3> read_row(const hs_view& view, std::int64_t i, const char* name) {
  if (view.z) return read_finite_point<3>(view, i, name);
  const Vector<2> row = read_finite_point<2>(view, i, name);
  return {row.x(), row.y(), 0};
}

/// Reads and checks the fields that blocks and nodes have in common.
template <int D>
hs_action_def read_action(const World<D>& world, const hs_action_def* given) {
  const hs_action_def def = read_definition(given, "def");
  if (def.kind < HS_ACTION_VELOCITY || ActionKind(def.kind) > ActionKind::last)
    refuse(HS_ERROR_ARGUMENT, "def.kind is %d; it must be an HS_ACTION_ value", def.kind);
  if (def.table < 0 || def.table >= world.model().actions.tables().count())
    refuse(HS_ERROR_STALE_ID, "def.table is %d; the world has %d tables", def.table,
           world.model().actions.tables().count());
  require(is_within_limits(def.start), def.start, "def.start", "finite and at most 1e75");
  return def;
}

/// True if a block can follow the motion: it is prescribed, or held along its axes.
template <int D>
bool can_follow(const Blocks<D>& blocks, std::size_t slot, const Action<D>& action) {
  if (blocks.kind[slot] == BlockKind::prescribed) return true;
  if (blocks.kind[slot] != BlockKind::rigid || is_angular(action.kind)) return false;
  for (int k = 0; k < D; ++k) {
    if (action.scale[k] != 0 && !blocks.is_held(slot, k)) return false;
  }
  return true;
}

template <int D>
void require_target(const Blocks<D>& blocks, hs_block block, std::size_t slot, const Action<D>& action) {
  require_moved_by_itself(blocks, std::int32_t(slot), "block");
  const auto id = static_cast<unsigned long long>(block);
  if (is_load(action.kind)) {
    if (!blocks.moves_freely(slot))
      refuse(HS_ERROR_STATE, "block %#llx is neither rigid nor affine; loads act on these kinds only", id);
  } else if (!can_follow(blocks, slot, action)) {
    refuse(HS_ERROR_STATE,
           "block %#llx is not prescribed, and not held along all axes of the motion; call "
           "hs_world_hold_block() first",
           id);
  }
}

/// The point of a force, for the block where it is now.
template <int D>
Vector<3> place_of_force(const hs_action_def& def, const Blocks<D>& blocks, std::size_t slot) {
  if (def.place < HS_PLACE_CENTROID || def.place > HS_PLACE_FIXED)
    refuse(HS_ERROR_ARGUMENT, "def.place is %d; it must be an HS_PLACE_ value", def.place);
  Vector<3> point = Vector<3>::Zero();
  if (def.place == HS_PLACE_CENTROID) return point;
  const Vector<D> place = read_finite_vector<D>(def.point, "def.point");
  point.template head<D>() = def.place == HS_PLACE_CARRIED ? blocks.in_frame_of(slot, place) : place;
  return point;
}

template <int D>
Action<D> read_block_action(const World<D>& world, const hs_action_def& def) {
  Action<D> action;
  action.kind = ActionKind(def.kind);
  action.table = def.table;
  action.start = def.start;
  action.scale = read_finite_vector<3>(def.scale, "def.scale");
  if (action.kind == ActionKind::servo) {
    if (!world.model().materials.laws().any([](const ContactLaw& law) { return !law.has_no_spring(); }))
      refuse(HS_ERROR_STATE, "def.kind is HS_ACTION_SERVO; no law of the world has springs");
    action.max_speed = require_above_zero(def.max_speed, "def.max_speed");
    const double length = action.scale.template head<D>().norm();
    require(length > 0, length, "the length of def.scale", "above 0 for a servo");
  }
  if (action.kind == ActionKind::force) action.place = ForcePlace(def.place);
  return action;
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_action_def_init(hs_action_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_world_add_table(hs_world* world, const double times[], hs_view values, int32_t* table) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require_view(values, "values");
    require_pointer(table, "table");
    if (values.count == 0) refuse(HS_ERROR_ARGUMENT, "values.count is 0; a table has at least one row");
    require_pointer(times, "times");
    Array<Vector<3>> rows(&world->context->memory);
    rows.reserve(std::size_t(values.count));
    for (std::int64_t i = 0; i < values.count; ++i) rows.push_back(read_row(values, i, "values"));
    const std::span<const double> all(times, std::size_t(values.count));
    const auto beyond = std::find_if_not(all.begin(), all.end(), is_within_limits);
    const std::size_t bad = std::min(std::size_t(beyond - all.begin()), first_out_of_order(all));
    if (bad < all.size()) {
      refuse(HS_ERROR_ARGUMENT,
             "times[%zu] is %g; times must be finite and ascend, and no more than two may be equal", bad,
             all[bad]);
    }
    *table = w.add_table(all, rows);
    return HS_OK;
  });
}

hs_status hs_world_add_action(hs_world* world, hs_block block, const hs_action_def* def) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const hs_action_def known = read_action(w, def);
    Action<D> action = read_block_action(w, known);
    if (block == 0) {
      if (action.kind != ActionKind::acceleration) {
        refuse(HS_ERROR_ARGUMENT, "def.kind is %d; only HS_ACTION_ACCELERATION acts on all blocks",
               known.kind);
      }
    } else {
      action.slot = slot_of(w.blocks(), block, "block");
      const std::size_t slot = std::size_t(action.slot);
      require_target(w.blocks(), block, slot, action);
      if (action.kind == ActionKind::force) action.point = place_of_force(known, w.blocks(), slot);
    }
    w.add_action(action);
    return HS_OK;
  });
}

hs_status hs_world_end_actions(hs_world* world, hs_block block) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    w.end_actions(block == 0 ? -1 : slot_of(w.blocks(), block, "block"));
    return HS_OK;
  });
}

hs_status hs_world_add_node_action(hs_world* world, hs_body body, const int32_t nodes[], hs_view scales,
                                   const hs_action_def* def) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const hs_action_def known = read_action(w, def);
    if (known.kind != HS_ACTION_FORCE && known.kind != HS_ACTION_VELOCITY &&
        known.kind != HS_ACTION_ACCELERATION) {
      refuse(HS_ERROR_ARGUMENT,
             "def.kind is %d; nodes take HS_ACTION_FORCE, HS_ACTION_VELOCITY or HS_ACTION_ACCELERATION",
             known.kind);
    }
    NodeAction action;
    action.body = body_of(w.blocks().meshes(), body, "body");
    action.kind = ActionKind(known.kind);
    action.table = known.table;
    action.start = known.start;
    const Array<Vector<D>> factors = read_finite_points<D>(world->context, scales, "scales");
    require_nodes(w.blocks().meshes().body(action.body), nodes, scales.count);
    w.add_node_action(action, {nodes, std::size_t(scales.count)}, factors);
    return HS_OK;
  });
}

hs_status hs_world_end_node_actions(hs_world* world, hs_body body) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    w.end_node_actions(body_of(w.blocks().meshes(), body, "body"));
    return HS_OK;
  });
}

hs_status hs_world_set_node_viscosity(hs_world* world, hs_body body, const int32_t nodes[], int64_t count,
                                      const double viscosity[9]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::int32_t which = body_of(w.blocks().meshes(), body, "body");
    const Tensor<D> wanted = read_symmetric_tensor<D>(viscosity, "viscosity");
    require_nodes(w.blocks().meshes().body(which), nodes, count);
    for (int i = 0; i < D; ++i) {
      for (int k = 0; k < D; ++k) {
        const bool is_dissipative =
            wanted(i, i) >= 0 && wanted(i, k) * wanted(i, k) <= wanted(i, i) * wanted(k, k);
        require(is_dissipative, wanted(i, k), "a component of viscosity",
                "such that the dashpots lose energy");
      }
    }
    w.set_node_viscosity(which, {nodes, std::size_t(count)}, wanted);
    return HS_OK;
  });
}

hs_status hs_world_hold_block(hs_world* world, hs_block block, int32_t axes) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::int32_t slot = slot_of(w.blocks(), block, "block");
    constexpr std::int32_t all_axes = (1 << D) - 1;
    if ((axes & ~(all_axes | HS_AXIS_ROTATION)) != 0)
      refuse(HS_ERROR_ARGUMENT, "axes is %d; it must be a sum of HS_AXIS_ values of the dimension", axes);
    require_moved_by_itself(w.blocks(), slot, "block");
    if (w.blocks().kind[std::size_t(slot)] != BlockKind::rigid) {
      refuse(HS_ERROR_STATE, "block %#llx is not rigid; only rigid blocks can be held",
             static_cast<unsigned long long>(block));
    }
    const bool holds_rotation = (axes & HS_AXIS_ROTATION) != 0;
    w.hold_block(slot, std::uint8_t((axes & all_axes) | (holds_rotation ? 1 << D : 0)));
    return HS_OK;
  });
}

hs_status hs_world_prescribe_velocities(hs_world* world, const hs_block blocks[], hs_view velocities,
                                        hs_view angular_velocities) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require_view<D>(velocities, "velocities");
    require_angular_view<D>(angular_velocities, "angular_velocities");
    if (angular_velocities.count != 0 && angular_velocities.count != velocities.count) {
      refuse(HS_ERROR_ARGUMENT, "angular_velocities.count is %lld; velocities.count is %lld",
             static_cast<long long>(angular_velocities.count), static_cast<long long>(velocities.count));
    }
    if (velocities.count > 0) require_pointer(blocks, "blocks");
    const auto for_each = [&](auto use) {
      for (std::int64_t i = 0; i < velocities.count; ++i) {
        const std::int32_t slot = slot_of(w.blocks(), blocks[i], "blocks");
        require_moved_by_itself(w.blocks(), slot, "blocks");
        if (w.blocks().kind[std::size_t(slot)] != BlockKind::prescribed) {
          refuse(HS_ERROR_STATE, "blocks[%lld] is %#llx, which is not prescribed", static_cast<long long>(i),
                 static_cast<unsigned long long>(blocks[i]));
        }
        Angular<D> spin = w.blocks().spin[std::size_t(slot)];
        if (angular_velocities.count > 0)
          spin = read_finite_angular<D>(angular_velocities, i, "angular_velocities");
        use(slot, read_finite_point<D>(velocities, i, "velocities"), spin);
      }
    };
    // All velocities are validated before any changes.
    for_each([&](std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin) {
      require_energy_of(w.blocks(), slot, velocity, spin);
    });
    for_each([&](std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin) {
      w.prescribe_velocity(slot, velocity, spin);
    });
    return HS_OK;
  });
}
