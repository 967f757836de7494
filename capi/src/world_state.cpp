#include <algorithm>

#include "view.h"
#include "world.h"

using namespace halfspace;
using namespace halfspace::capi;

hs_status hs_world_get_blocks(const hs_world* world, hs_block* blocks, int64_t capacity, int64_t* count) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(blocks, "blocks");
    const Blocks<2>& all = world->world.blocks();
    for_each_block(all, [&](std::int64_t i, std::int32_t slot) {
      if (i < capacity) blocks[i] = id_of(all, std::size_t(slot));
    });
    if (count) *count = all.count();
    return fits(all.count(), capacity);
  });
}

hs_status hs_world_get_block_state(const hs_world* world, hs_block block, hs_block_state* state) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    require_pointer(state, "state");
    const Blocks<2>& all = world->world.blocks();
    const std::size_t s = std::size_t(slot_of(all, block, "block"));
    hs_block_state out{};
    out.kind = std::int32_t(all.kind[s]);
    out.material = all.material[s];
    write_pose(all.position[s], all.rotation[s], out.pose);
    out.angle = all.angle[s];
    write_vector(all.velocity[s], out.velocity);
    out.angular_velocity[2] = all.spin[s][0];
    write_vector(all.force[s], out.force);
    out.torque[2] = all.torque[s][0];
    out.mass = all.mass[s];
    *state = out;
    return HS_OK;
  });
}

hs_status hs_world_get_block_vertices(const hs_world* world, hs_block block, hs_mutable_view vertices,
                                      int64_t* count) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    require_view(vertices, "vertices");
    const Blocks<2>& all = world->world.blocks();
    const std::int32_t slot = slot_of(all, block, "block");
    const Outline<2> outline = all.outline(slot);
    const std::int64_t written = std::min<std::int64_t>(outline.count, vertices.count);
    for (std::int64_t i = 0; i < written; ++i) {
      write_point(vertices, i, outline.vertex(int(i)) + all.position[std::size_t(slot)]);
    }
    if (count) *count = outline.count;
    return fits(outline.count, vertices.count);
  });
}

hs_status hs_world_set_pose(hs_world* world, hs_block block, const hs_pose* pose) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    const std::int32_t slot = slot_of(world->world.blocks(), block, "block");
    const Pose2 to = read_pose(pose, "pose");
    world->world.set_pose(slot, to.position, to.rotation);
    return HS_OK;
  });
}

hs_status hs_world_set_velocity(hs_world* world, hs_block block, const double velocity[3],
                                const double angular_velocity[3]) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    const std::int32_t slot = slot_of(world->world.blocks(), block, "block");
    const Vector<2> v = read_finite_vector(velocity, "velocity");
    const Angular<2> spin = read_finite_turn(angular_velocity, "angular_velocity");
    if (world->world.blocks().kind[std::size_t(slot)] == BlockKind::fixed) {
      refuse(HS_ERROR_STATE, "block %#llx is fixed and takes no velocity",
             static_cast<unsigned long long>(block));
    }
    world->world.set_velocity(slot, v, spin);
    return HS_OK;
  });
}

hs_status hs_world_set_applied_force(hs_world* world, hs_block block, const double force[3],
                                     const double torque[3]) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    const std::int32_t slot = slot_of(world->world.blocks(), block, "block");
    const Vector<2> f = read_finite_vector(force, "force");
    const Angular<2> t = read_finite_turn(torque, "torque");
    if (world->world.blocks().kind[std::size_t(slot)] != BlockKind::rigid) {
      refuse(HS_ERROR_STATE, "block %#llx is not rigid: no force moves it",
             static_cast<unsigned long long>(block));
    }
    world->world.set_applied_force(slot, f, t);
    return HS_OK;
  });
}

hs_status hs_world_get_poses(const hs_world* world, hs_pose* poses, int64_t capacity, int64_t* count) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(poses, "poses");
    const Blocks<2>& all = world->world.blocks();
    for_each_block(all, [&](std::int64_t i, std::int32_t slot) {
      if (i < capacity)
        write_pose(all.position[std::size_t(slot)], all.rotation[std::size_t(slot)], poses[i]);
    });
    if (count) *count = all.count();
    return fits(all.count(), capacity);
  });
}

hs_status hs_world_set_poses(hs_world* world, const hs_pose* poses, int64_t count) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    World<2>& w = world->world;
    if (count != w.blocks().count()) {
      refuse(HS_ERROR_ARGUMENT, "count is %lld; the world has %lld blocks", static_cast<long long>(count),
             static_cast<long long>(w.blocks().count()));
    }
    if (count > 0) require_pointer(poses, "poses");
    const auto read = [&](std::int64_t i) {
      char name[48];
      std::snprintf(name, sizeof name, "poses[%lld]", static_cast<long long>(i));
      return read_pose(&poses[i], name);
    };
    for (std::int64_t i = 0; i < count; ++i) read(i);  // all are judged before any block moves
    for_each_block(w.blocks(), [&](std::int64_t i, std::int32_t slot) {
      const Pose2 to = read(i);
      w.set_pose(slot, to.position, to.rotation);
    });
    return HS_OK;
  });
}

hs_status hs_world_get_velocities(const hs_world* world, hs_mutable_view velocities,
                                  hs_mutable_view angular_velocities) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    require_view(velocities, "velocities");
    require_turn_view(angular_velocities, "angular_velocities");
    const Blocks<2>& all = world->world.blocks();
    for_each_block(all, [&](std::int64_t i, std::int32_t slot) {
      if (i < velocities.count) write_point(velocities, i, all.velocity[std::size_t(slot)]);
      if (i < angular_velocities.count) write_turn(angular_velocities, i, all.spin[std::size_t(slot)]);
    });
    const bool all_turns = angular_velocities.count == 0 || angular_velocities.count >= all.count();
    return all_turns ? fits(all.count(), velocities.count) : HS_NOTE_TRUNCATED;
  });
}

hs_status hs_world_set_velocities(hs_world* world, hs_view velocities, hs_view angular_velocities) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    require_view(velocities, "velocities");
    require_turn_view(angular_velocities, "angular_velocities");
    World<2>& w = world->world;
    const std::int64_t count = w.blocks().count();
    const auto require_all = [&](const hs_view& view, const char* name) {
      if (view.count != count) {
        refuse(HS_ERROR_ARGUMENT, "%s.count is %lld; the world has %lld blocks", name,
               static_cast<long long>(view.count), static_cast<long long>(count));
      }
    };
    require_all(velocities, "velocities");
    const bool with_turns = angular_velocities.count > 0;
    if (with_turns) require_all(angular_velocities, "angular_velocities");
    for (std::int64_t i = 0; i < count; ++i) {  // all are judged before any velocity changes
      read_finite_point(velocities, i, "velocities");
      if (with_turns) read_finite_turn(angular_velocities, i, "angular_velocities");
    }
    for_each_block(w.blocks(), [&](std::int64_t i, std::int32_t slot) {
      if (w.blocks().kind[std::size_t(slot)] == BlockKind::fixed) return;
      const Angular<2> spin = with_turns ? read_finite_turn(angular_velocities, i, "angular_velocities")
                                     : w.blocks().spin[std::size_t(slot)];
      w.set_velocity(slot, read_point(velocities, i), spin);
    });
    return HS_OK;
  });
}
