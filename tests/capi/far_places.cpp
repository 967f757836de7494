// A block is not put where rounding would move it by too large a part of its size.

#include <cmath>

#include "capi/polyhedra.h"
#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {
namespace {

const double farthest = std::ldexp(std::sqrt(0.5), 32);  // 2^32 bounding radii of a unit square

hs_status add_at(const World& world, const Shape& shape, double x, hs_block& block) {
  hs_block_def def;
  if (hs_block_def_init(&def, sizeof def, shape.get()) != HS_OK) return HS_ERROR_INTERNAL;
  def.pose = pose_at({x, 0, 0}, {0, 0, 1}, 0);
  return hs_world_add_block(world.get(), shape.get(), &def, &block);
}

}  // namespace

TEST_CASE("a block is put no farther off than its size lets its place be told") {
  const Context context = make_context();
  const World world = make_world(context.get(), world_def());
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
  const Shape square = make_shape(context.get(), {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
  hs_block block = 0, other = 0;
  CHECK(add_at(world, square, 1.001 * farthest, block) == HS_ERROR_ARGUMENT);
  CHECK_THAT(hs_context_last_error(context.get()),
             Catch::Contains("position[0] is 3.04") && Catch::Contains("radius 0.707107"));
  CHECK(add_at(world, square, -1.001 * farthest, block) == HS_ERROR_ARGUMENT);
  CHECK(add_at(world, square, 0.999 * farthest, block) == HS_OK);
  CHECK(add_at(world, square, 0, other) == HS_OK);

  const hs_pose far = pose_at({0, 1e12, 0}, {0, 0, 1}, 0), near = pose_at({0, 5, 0}, {0, 0, 1}, 0);
  CHECK(hs_world_set_pose(world.get(), block, &far) == HS_ERROR_ARGUMENT);
  const hs_pose both[] = {near, far};
  CHECK(hs_world_set_poses(world.get(), both, 2) == HS_ERROR_ARGUMENT);
  hs_block_state state;
  require_ok(hs_world_get_block_state(world.get(), block, &state), context.get());
  CHECK(state.pose.position[1] == 0);  // nothing has moved
  CHECK(hs_world_set_pose(world.get(), block, &near) == HS_OK);
}

}  // namespace halfspace_test
