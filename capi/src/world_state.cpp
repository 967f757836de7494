#include "strided_view.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

template <int D>
hs_block_state state_of(const World<D>& world, std::size_t slot) {
  const Blocks<D>& blocks = world.blocks();
  const auto hard = world.state().hard_contacts.load_on(slot);
  hs_block_state state{};
  state.kind = std::int32_t(blocks.kind[slot]);
  state.material = blocks.material[slot];
  write_pose(blocks.position[slot], blocks.rotation[slot], state.pose);
  if constexpr (D == 2) state.angle = blocks.angle[slot];
  write_vector(blocks.velocity[slot], state.velocity);
  write_angular(blocks.spin[slot], state.angular_velocity);
  write_vector(Vector<D>(blocks.force[slot] + hard.force), state.force);
  write_angular(Angular<D>(blocks.torque[slot] + hard.torque), state.torque);
  state.mass = blocks.is_part(slot) ? 0 : blocks.mass[slot];
  return state;
}

/// Refuses a view that has not an entry for each block.
template <int D>
void require_one_per_block(const Blocks<D>& blocks, const hs_view& view, const char* name) {
  if (view.count != blocks.count()) {
    refuse(HS_ERROR_ARGUMENT, "%s.count is %lld; the world has %lld blocks", name,
           static_cast<long long>(view.count), static_cast<long long>(blocks.count()));
  }
}

/// The same for vectors with angular ones beside them, which may be left out. @return are these given?
template <int D>
bool require_one_per_block(const Blocks<D>& blocks, const hs_view& vectors, const char* name,
                           const hs_view& angulars, const char* name_of_angulars) {
  require_view<D>(vectors, name);
  require_angular_view<D>(angulars, name_of_angulars);
  require_one_per_block(blocks, vectors, name);
  if (angulars.count > 0) require_one_per_block(blocks, angulars, name_of_angulars);
  return angulars.count > 0;
}

}  // namespace

hs_status hs_world_get_blocks(const hs_world* world, hs_block blocks[], int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(blocks, "blocks");
    const Blocks<D>& all = w.blocks();
    return write_blocks(all, capacity, count,
                        [&](std::int64_t i, std::size_t s) { blocks[i] = id_of(all, s); });
  });
}

hs_status hs_world_get_block_state(const hs_world* world, hs_block block, hs_block_state* state) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_pointer(state, "state");
    *state = state_of(w, std::size_t(slot_of(w.blocks(), block, "block")));
    return HS_OK;
  });
}

hs_status hs_world_get_block_states(const hs_world* world, hs_block_state states[], int64_t capacity,
                                    int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(states, "states");
    return write_blocks(w.blocks(), capacity, count,
                        [&](std::int64_t i, std::size_t s) { states[i] = state_of(w, s); });
  });
}

hs_status hs_world_get_block_vertices(const hs_world* world, hs_block block, hs_mutable_view vertices,
                                      int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_view<D>(vertices, "vertices");
    const Blocks<D>& all = w.blocks();
    const std::int32_t slot = slot_of(all, block, "block");
    const Outline<D> outline = all.outline(slot);
    if (count) *count = outline.vertex_count();
    return write_all(outline.vertex_count(), vertices.count, [&](int i) {
      write_point(vertices, i, outline.vertex(i) + all.position[std::size_t(slot)]);
    });
  });
}

hs_status hs_world_set_pose(hs_world* world, hs_block block, const hs_pose* pose) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const std::int32_t slot = slot_of(w.blocks(), block, "block");
    require_moved_by_itself(w.blocks(), slot, "block");
    const Pose<D> to = read_place<D>(pose, w.blocks().radius[std::size_t(slot)], "pose");
    w.set_pose(slot, to.position, to.rotation);
    return HS_OK;
  });
}

hs_status hs_world_set_velocity(hs_world* world, hs_block block, const double velocity[3],
                                const double angular_velocity[3]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::int32_t slot = slot_of(w.blocks(), block, "block");
    require_moved_by_itself(w.blocks(), slot, "block");
    const Vector<D> v = read_finite_vector<D>(velocity, "velocity");
    const Angular<D> spin = read_finite_angular<D>(angular_velocity, "angular_velocity");
    if (w.blocks().kind[std::size_t(slot)] == BlockKind::fixed) {
      refuse(HS_ERROR_STATE, "block %#llx is fixed; its velocity cannot be set",
             static_cast<unsigned long long>(block));
    }
    require_energy_of(w.blocks(), slot, v, spin);
    w.set_velocity(slot, v, spin);
    return HS_OK;
  });
}

hs_status hs_world_set_applied_force(hs_world* world, hs_block block, const double force[3],
                                     const double torque[3]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::int32_t slot = slot_of(w.blocks(), block, "block");
    const Vector<D> f = read_finite_vector<D>(force, "force");
    const Angular<D> t = read_finite_angular<D>(torque, "torque");
    require_moved_by_itself(w.blocks(), slot, "block");
    if (!w.blocks().moves_freely(std::size_t(slot))) {
      refuse(HS_ERROR_STATE, "block %#llx is neither rigid nor affine; forces act on these kinds only",
             static_cast<unsigned long long>(block));
    }
    w.set_applied_force(slot, f, t);
    return HS_OK;
  });
}

hs_status hs_world_get_poses(const hs_world* world, hs_pose poses[], int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(poses, "poses");
    const Blocks<D>& all = w.blocks();
    return write_blocks(all, capacity, count, [&](std::int64_t i, std::size_t s) {
      write_pose(all.position[s], all.rotation[s], poses[i]);
    });
  });
}

hs_status hs_world_set_poses(hs_world* world, const hs_pose poses[], int64_t count) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    if (count != w.blocks().count()) {
      refuse(HS_ERROR_ARGUMENT, "count is %lld; the world has %lld blocks", static_cast<long long>(count),
             static_cast<long long>(w.blocks().count()));
    }
    if (count > 0) require_pointer(poses, "poses");
    const auto read = [&](std::int64_t i, std::int32_t slot) {
      return read_place<D>(&poses[i], w.blocks().radius[std::size_t(slot)], {"poses", i});
    };
    for_each_block(w.blocks(), read);  // validates all before any block moves
    for_each_block(w.blocks(), [&](std::int64_t i, std::int32_t slot) {
      const Pose<D> to = read(i, slot);
      const std::size_t s = std::size_t(slot);
      if (!w.blocks().is_of_mesh(s) && !w.blocks().is_part(s)) w.set_pose(slot, to.position, to.rotation);
    });
    return HS_OK;
  });
}

hs_status hs_world_get_velocities(const hs_world* world, hs_mutable_view velocities,
                                  hs_mutable_view angular_velocities) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_view<D>(velocities, "velocities");
    require_angular_view<D>(angular_velocities, "angular_velocities");
    return write_blocks(w.blocks(), w.blocks().velocity, velocities, w.blocks().spin, angular_velocities);
  });
}

hs_status hs_world_set_velocities(hs_world* world, hs_view velocities, hs_view angular_velocities) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const bool with_turns =
        require_one_per_block(w.blocks(), velocities, "velocities", angular_velocities, "angular_velocities");
    const auto for_each_velocity = [&](auto use) {
      for_each_block(w.blocks(), [&](std::int64_t i, std::int32_t slot) {
        const Vector<D> velocity = read_finite_point<D>(velocities, i, "velocities");
        const Angular<D> spin = with_turns
                                    ? read_finite_angular<D>(angular_velocities, i, "angular_velocities")
                                    : w.blocks().spin[std::size_t(slot)];
        const BlockKind kind = w.blocks().kind[std::size_t(slot)];
        const bool is_moved_by_others = kind == BlockKind::mesh || w.blocks().is_part(std::size_t(slot));
        if (kind != BlockKind::fixed && !is_moved_by_others) use(slot, velocity, spin);
      });
    };
    // All velocities are validated before any changes.
    for_each_velocity([&](std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin) {
      require_energy_of(w.blocks(), slot, velocity, spin);
    });
    for_each_velocity([&](std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin) {
      w.set_velocity(slot, velocity, spin);
    });
    return HS_OK;
  });
}

hs_status hs_world_set_applied_forces(hs_world* world, hs_view forces, hs_view torques) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const bool with_torques = require_one_per_block(w.blocks(), forces, "forces", torques, "torques");
    const auto for_each_force = [&](auto use) {
      for_each_block(w.blocks(), [&](std::int64_t i, std::int32_t slot) {
        const Vector<D> force = read_finite_point<D>(forces, i, "forces");
        Angular<D> torque = Angular<D>::Zero();
        if (with_torques) torque = read_finite_angular<D>(torques, i, "torques");
        use(slot, force, torque);
      });
    };
    // All forces are validated before any changes.
    for_each_force([](std::int32_t, const Vector<D>&, const Angular<D>&) {});
    for_each_force([&](std::int32_t slot, const Vector<D>& force, const Angular<D>& torque) {
      if (w.blocks().moves_by_itself(std::size_t(slot))) w.set_applied_force(slot, force, torque);
    });
    return HS_OK;
  });
}
