#pragma once

// Worlds of compounds made of boxes, in the plane and in space, where gravity acts along -y.

#include <array>
#include <cmath>
#include <vector>

#include "capi/polyhedra.h"
#include "capi/world_fixture.h"

namespace halfspace_test {

constexpr double pi = 3.14159265358979323846, degree = pi / 180, gravity = 9.81;

/// In space it is 1 deep, about z = 0.
struct Brick {
  Point lower;
  Point upper;
};
using Bricks = std::vector<Brick>;

/// One edge of 3 along x, from which another rises.
inline Bricks l_shape() { return {{{0, 0}, {3, 1}}, {{0, 1}, {1, 2}}}; }

inline hs_law_def area_law(double stiffness, double friction_angle = 0) {
  hs_law_def law = law_def(stiffness, friction_angle);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  law.normal_damping = law.shear_damping = 0;
  return law;
}
inline hs_law_def damped(hs_law_def law) {
  law.normal_damping = law.shear_damping = 0.3;
  return law;
}
inline hs_law_def no_spring(double friction_angle) {
  hs_law_def law = law_def(1, friction_angle);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  return law;
}

struct CompoundScene {
  CompoundScene(int dimension, const hs_law_def& law, hs_world_def def)
      : context(make_context()), world(make_world(context.get(), def)), dimension(dimension) {
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), density, &material), context.get());
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  }
  CompoundScene(int dimension, const hs_law_def& law, double time_step, double along_y = -gravity)
      : CompoundScene(dimension, law, definition(dimension, time_step, along_y)) {}

  static hs_world_def definition(int dimension, double time_step, double along_y = -gravity) {
    hs_world_def def = world_def(dimension);
    def.gravity[1] = along_y;
    def.gravity[2] = 0;
    def.time_step = time_step;
    return def;
  }

  Shape shape(const Brick& brick) const {
    const auto [x0, y0] = brick.lower;
    const auto [x1, y1] = brick.upper;
    if (dimension == 2) return make_shape(context.get(), box(x0, y0, x1, y1));
    Points3 corners;
    for (const double z : {-0.5, 0.5})
      for (const Point& p : box(x0, y0, x1, y1)) corners.push_back({p.x, p.y, z});
    hs_shape* shape = nullptr;
    require_ok(hs_polyhedron_create_hull(context.get(), view_of(corners), &shape), context.get());
    return Shape(shape);
  }

  /// A compound of the bricks where they are, then moved along.
  hs_block add(const Bricks& bricks, Point moved = {}, Point velocity = {}, std::array<double, 3> spin = {},
               std::int32_t kind = HS_BLOCK_RIGID) {
    std::vector<Shape> owners;
    std::vector<const hs_shape*> shapes;
    for (const Brick& brick : bricks) shapes.push_back(owners.emplace_back(shape(brick)).get());
    const std::int64_t count = std::int64_t(shapes.size());
    hs_block_def def;
    require_ok(hs_compound_def_init(&def, sizeof def, shapes.data(), nullptr, count), context.get());
    set_start(def, moved, velocity, spin, kind);
    hs_block block = 0;
    require_ok(hs_world_add_compound(world.get(), shapes.data(), nullptr, count, &def, &block),
               context.get());
    return block;
  }
  /// One convex block.
  hs_block add_one(const Brick& brick, Point moved = {}, Point velocity = {}, std::array<double, 3> spin = {},
                   std::int32_t kind = HS_BLOCK_RIGID) {
    const Shape owner = shape(brick);
    hs_block_def def = block_def(context.get(), owner, kind);
    set_start(def, moved, velocity, spin, kind);
    return add_block(context.get(), world.get(), owner, def);
  }
  hs_block add_floor() { return add_one({{-20, -1}, {20, 0}}, {}, {}, {}, HS_BLOCK_FIXED); }

  void step(std::int64_t steps) { require_ok(hs_world_step(world.get(), steps), context.get()); }
  hs_block_state state(hs_block block) const { return state_of(world.get(), block); }
  hs_world_report report() { return report_of(world.get()); }
  std::vector<hs_block> parts(hs_block block) const {
    std::int64_t count = 0;
    (void)hs_world_get_compound_parts(world.get(), block, nullptr, 0, &count);
    std::vector<hs_block> parts(static_cast<std::size_t>(count));
    require_ok(hs_world_get_compound_parts(world.get(), block, parts.data(), count, nullptr), context.get());
    return parts;
  }
  /// The upward force of the contacts of a block.
  double bearing(hs_block block) const { return state(block).force[1]; }

  static constexpr double density = 2000;
  Context context;
  World world;
  int dimension;

 private:
  void set_start(hs_block_def& def, Point moved, Point velocity, std::array<double, 3> spin,
                 std::int32_t kind) const {
    def.kind = kind;
    def.pose.position[0] += moved.x;
    def.pose.position[1] += moved.y;
    def.velocity[0] = velocity.x;
    def.velocity[1] = velocity.y;
    for (int k = dimension == 2 ? 2 : 0; k < 3; ++k) def.angular_velocity[k] = spin[std::size_t(k)];
  }
};

/// The largest difference of the motions of two blocks, positions and velocities alike.
inline double apart(const hs_block_state& one, const hs_block_state& other) {
  double most = 0;
  for (int k = 0; k < 3; ++k) {
    most = std::max(most, std::abs(one.pose.position[k] - other.pose.position[k]));
    most = std::max(most, std::abs(one.velocity[k] - other.velocity[k]));
    most = std::max(most, std::abs(one.angular_velocity[k] - other.angular_velocity[k]));
  }
  for (int k = 0; k < 4; ++k) most = std::max(most, std::abs(one.pose.rotation[k] - other.pose.rotation[k]));
  return most;
}

}  // namespace halfspace_test
