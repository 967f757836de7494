#pragma once

// Scenes that are cut into shares, as snapshots.

#include "capi/loads.h"
#include "golden/stage.h"

namespace halfspace_test {

/// Polygons that fall into a trough and slide along its inclined floor.
inline std::vector<unsigned char> heap_in_plane(const LawOfStiffness& of, std::int32_t kind, int count = 80) {
  hs_world_def def = world_def();
  def.local_damping = 0.05;
  def.time_step = 4e-5;
  def.gravity[0] = 3;
  Stage stage(def);
  stage.elastic_material(2500, elasticity_def(1e8, 1e-5));
  stage.law(law_of(of, 5e7, 0.4));
  const double half = 0.25 * count / 4 + 1;
  stage.add(stage.rectangle({-half - 1, -1}, {half + 1, 0}), HS_BLOCK_FIXED);
  stage.add(stage.rectangle({-half - 1, 0}, {-half, 4}), HS_BLOCK_FIXED);
  stage.add(stage.rectangle({half, 0}, {half + 1, 4}), HS_BLOCK_FIXED);
  Random random(42);
  for (int i = 0; i < count; ++i) {
    const Shape grain = stage.polygon(random_round_polygon(random, 3 + i % 6, 0.23));
    stage.add(grain, kind,
              turned_pose({-half + 0.5 + 0.5 * (i / 4), 0.25 + 0.5 * (i % 4)}, number_between(random, -2, 2)),
              {2, -4, 0});
  }
  return saved(stage.world());
}

/// Bonded bricks on a floor that goes off sideways.
inline std::vector<unsigned char> wall_in_plane() {
  hs_world_def def = world_def();
  def.time_step = 2e-5;
  Stage stage(def);
  stage.material(2000);
  hs_law_def law = law_of(laws_of_stiffness[0], 1e8, 0.5);
  law.cohesion = 3e4;
  law.tensile_strength = 1e4;
  stage.law(law);
  const Shape brick = stage.rectangle({-0.5, -0.25}, {0.5, 0.25}),
              floor = stage.rectangle({-12, -0.5}, {12, 0.5});
  stage.add(floor, HS_BLOCK_PRESCRIBED, turned_pose({0, -0.5}, 0), {1.5, 0, 0});
  for (int row = 0; row < 5; ++row)
    for (int i = 0; i < 12; ++i)
      stage.add(brick, HS_BLOCK_RIGID, turned_pose({i - 6 + 0.5 * (row % 2), 0.25 + 0.5 * row}, 0));
  return saved(stage.world());
}

/// A block on a long floor, and another that enters the floor's end just below its top, far from the first.
inline std::vector<unsigned char> ends_of_floor() {
  hs_world_def def = world_def();
  def.time_step = 4e-5;
  Stage stage(def, law_of(laws_of_stiffness[1], 5e7, 0.3));
  stage.add(stage.rectangle({-9, -1}, {9, 0}), HS_BLOCK_FIXED);
  const Shape brick = stage.rectangle({-0.5, -0.5}, {0.5, 0.5});
  stage.add(brick, HS_BLOCK_RIGID, turned_pose({-8, 0.5 - 1e-6}, 0));
  stage.add(brick, HS_BLOCK_RIGID, turned_pose({9.5 + 1e-4, 0.5 - 1e-4}, 0), {-1, 0, 0});
  return saved(stage.world());
}

/// The same wall in water that covers three of its rows.
inline std::vector<unsigned char> wall_in_water() {
  const Context context = make_context();
  const World world = restored(context.get(), wall_in_plane());
  set_water(context.get(), world.get(), {{-20, 1.4, 0}, {20, 1.4, 0}});
  return saved(world.get());
}

/// The same wall in an earthquake: its floor follows a velocity in time and turns, all blocks feel an
/// acceleration.
inline std::vector<unsigned char> wall_in_earthquake() {
  const Context context = make_context();
  const World world = restored(context.get(), wall_in_water());
  const std::vector<double> times = {0, 0.03, 0.07, 0.15};
  const Points3 values = {{0, 0, 0}, {3, 1, 0.2}, {-2, 0.5, -0.1}, {1, 0, 0}};
  std::int32_t table = -1;
  require_ok(hs_world_add_table(world.get(), times.data(), view_of(values), &table), context.get());
  hs_block floor = 0;
  if (hs_world_get_blocks(world.get(), &floor, 1, nullptr) < 0) throw std::runtime_error("no blocks");
  const auto act = [&](hs_block block, std::int32_t kind, const Point3& scale = {1, 1, 1}) {
    hs_action_def def;
    require_ok(hs_action_def_init(&def, sizeof def), context.get());
    def.kind = kind;
    def.scale[0] = scale.x;
    def.scale[1] = scale.y;
    def.scale[2] = scale.z;
    def.table = table;
    require_ok(hs_world_add_action(world.get(), block, &def), context.get());
  };
  act(floor, HS_ACTION_VELOCITY);
  act(floor, HS_ACTION_ANGULAR_VELOCITY);
  act(0, HS_ACTION_ACCELERATION);
  // Bricks are pushed, turned, and moved along a held axis.
  hs_block bricks[61] = {};
  require_ok(hs_world_get_blocks(world.get(), bricks, 61, nullptr), nullptr);
  act(bricks[8], HS_ACTION_FORCE, {2e3, 2e3, 0});
  act(bricks[31], HS_ACTION_TORQUE, {0, 0, 1e3});
  act(bricks[55], HS_ACTION_FORCE, {-5e3, 0, 0});
  require_ok(hs_world_hold_block(world.get(), bricks[60], 1), context.get());
  act(bricks[60], HS_ACTION_VELOCITY, {1, 0, 0});
  return saved(world.get());
}

/// Hulls that fall into a long box and slide along it.
inline std::vector<unsigned char> heap_in_space(const LawOfStiffness& of, std::int32_t kind, int count = 60) {
  hs_world_def def = world_def(3);
  def.local_damping = 0.05;
  def.time_step = 2e-5;
  def.gravity[0] = 3;
  Stage stage(def);
  stage.elastic_material(2500, elasticity_def(1e8, 1e-5));
  stage.law(law_of(of, 2e6, 0.4));
  const double length = 0.36 * count / 4 + 1, width = 0.75;
  stage.add(stage.cuboid({-length - 1, -width - 1, -0.5}, {length + 1, width + 1, 0}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({-length - 1, -width - 1, 0}, {-length, width + 1, 3}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({length, -width - 1, 0}, {length + 1, width + 1, 3}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({-length, -width - 1, 0}, {length, -width, 3}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({-length, width, 0}, {length, width + 1, 3}), HS_BLOCK_FIXED);
  Random random(42);
  for (int i = 0; i < count; ++i) {
    const Shape grain = make_hull(stage.context(), random_round_points(random, 5 + 2 * (i % 6), 0.3));
    const Point3 axis = {number_between(random, -1, 1), number_between(random, -1, 1),
                         number_between(random, -1, 1)};
    stage.add(grain, kind,
              turned_pose({-length + 0.5 + 0.72 * (i / 4), -0.36 + 0.72 * (i % 2), 0.42 + 0.72 * (i / 2 % 2)},
                          axis, 0.7),
              {2, 0, -4});
  }
  return saved(stage.world());
}

}  // namespace halfspace_test
