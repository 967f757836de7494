#pragma once

#include <algorithm>
#include <cmath>

#include "capi/polyhedra.h"
#include "capi/world_fixture.h"

namespace halfspace_test {

constexpr double g = 9.81, density = 2000;

/// Rigid blocks by one law without springs, in units whose metre is `metre` long.
struct RigidWorld {
  Context context = make_context();
  World world;
  double metre;

  RigidWorld(double friction, double weight, double time_step, int dimension = 3, double of_metre = 1,
             std::int32_t max_impulse_iterations = 200)
      : metre(of_metre) {
    hs_world_def def = world_def(dimension);
    std::fill(def.gravity, def.gravity + 3, 0.0);
    def.gravity[dimension - 1] = -weight * metre;
    def.time_step = time_step;
    def.max_impulse_iterations = max_impulse_iterations;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    const double per_volume = density / std::pow(metre, dimension);
    require_ok(hs_world_add_material(world.get(), per_volume, &material), context.get());
    hs_law_def law = law_def(1, std::atan(friction));
    law.stiffness_kind = HS_STIFFNESS_NONE;
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  }

  hs_block add(const Points3& corners, std::int32_t kind = HS_BLOCK_RIGID,
               const Point3& velocity = {0, 0, 0}) {
    Points3 scaled;
    for (const Point3& p : corners) scaled.push_back({p.x * metre, p.y * metre, p.z * metre});
    const Shape shape = make_hull(context.get(), scaled);
    hs_block_def def = block_def(context.get(), shape, kind);
    def.velocity[0] = velocity.x * metre;
    def.velocity[1] = velocity.y * metre;
    def.velocity[2] = velocity.z * metre;
    return add_block(context.get(), world.get(), shape, def);
  }
  hs_block add_plane_box(double left, double right, std::int32_t kind = HS_BLOCK_RIGID) {
    return add_block(context.get(), world.get(), box(left, 0, right, 1), kind);
  }
  void step(int count) { require_ok(hs_world_step(world.get(), count), context.get()); }
  hs_block_state state(hs_block block) const { return state_of(world.get(), block); }
};

/// Of a box turned about the vertical.
inline Points3 corners_of_box(const Point3& low, const Point3& high, double turn = 0) {
  Points3 corners;
  for (const double x : {low.x, high.x})
    for (const double y : {low.y, high.y})
      for (const double z : {low.z, high.z})
        corners.push_back(
            {std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y, z});
  return corners;
}

}  // namespace halfspace_test
