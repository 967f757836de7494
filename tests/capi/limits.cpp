// How large numbers may be that go into a world.

#include "capi/refusals.h"
#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {

TEST_CASE("numbers so large that their products are infinite are refused, by name and value") {
  TwoBoxes s;
  hs_context* c = s.context.get();
  hs_world* w = s.world.get();
  const hs_block block = s.box_away;
  const double large[3] = {0, 1e76, 0}, large_turn[3] = {0, 0, 1e76}, zero[3] = {};
  const hs_pose far_away = pose_at(1.5e75, 0);
  const auto add = [&](auto spoil) {
    return [&, spoil] {
      const Shape shape = make_shape(c, box(0, 0, 1, 1));
      hs_block_def def;
      hs_block_def_init(&def, sizeof def, shape.get());
      spoil(def);
      hs_block made = 0;
      return hs_world_add_block(w, shape.get(), &def, &made);
    };
  };
  const auto law = [&](auto spoil) {
    return [&, spoil] {
      hs_law_def def = law_def(1e8, 0.5);
      spoil(def);
      return hs_world_set_default_law(w, &def);
    };
  };
  std::int32_t material = 0;
  const std::vector<unsigned char> before = saved(w);
  check_refusals(c, "hs_world_set_pose",
                 {{"position[0]", "1.5e+75", [&] { return hs_world_set_pose(w, block, &far_away); }}});
  check_refusals(
      c, "hs_world_set_velocity",
      {{"velocity[1]", "1e+76", [&] { return hs_world_set_velocity(w, block, large, zero); }},
       {"angular_velocity[2]", "1e+76", [&] { return hs_world_set_velocity(w, block, zero, large_turn); }}});
  check_refusals(
      c, "hs_world_set_applied_force",
      {{"force[1]", "1e+76", [&] { return hs_world_set_applied_force(w, block, large, zero); }},
       {"torque[2]", "1e+76", [&] { return hs_world_set_applied_force(w, block, zero, large_turn); }}});
  check_refusals(c, "hs_world_add_material",
                 {{"density", "1e+76", [&] { return hs_world_add_material(w, 1e76, &material); }}});
  check_refusals(
      c, "hs_world_add_block",
      {{"velocity[0]", "1e+300", add([](hs_block_def& d) { d.velocity[0] = 1e300; })},
       {"angular_velocity[2]", "1e+300", add([](hs_block_def& d) { d.angular_velocity[2] = 1e300; })},
       {"position[1]", "1.1e+75", add([](hs_block_def& d) { d.pose.position[1] = 1.1e75; })}});
  check_refusals(c, "hs_world_set_default_law",
                 {{"normal_stiffness", "1e+300", law([](hs_law_def& d) { d.normal_stiffness = 1e300; })},
                  {"shear_stiffness", "1e+300", law([](hs_law_def& d) { d.shear_stiffness = 1e300; })},
                  {"cohesion", "1e+76", law([](hs_law_def& d) { d.cohesion = 1e76; })},
                  {"normal_damping", "1e+76", law([](hs_law_def& d) { d.normal_damping = 1e76; })}});
  CHECK((saved(w) == before));
}

TEST_CASE("velocities whose energy would be infinite are refused, one by one and as arrays") {
  const Context context = make_context();
  World world = make_world(context.get(), world_def());
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 1, &material), context.get());
  const double half = 1e74;
  const hs_block huge = add_block(context.get(), world.get(), box(-half, -half, half, half), HS_BLOCK_RIGID);
  const double spin[3] = {0, 0, 1e10}, zero[3] = {};
  hs_view spins = {&spin[0], &spin[1], &spin[2], sizeof spin, 1},
          velocities = {&zero[0], &zero[1], &zero[2], sizeof zero, 1};
  check_refusals(
      context.get(), "hs_world_set_velocity",
      {{"angular_velocity", "1e+10", [&] { return hs_world_set_velocity(world.get(), huge, zero, spin); }}});
  check_refusals(context.get(), "hs_world_set_velocities",
                 {{"angular_velocity", "1e+10",
                   [&] { return hs_world_set_velocities(world.get(), velocities, spins); }}});
  CHECK(state_of(world.get(), huge).angular_velocity[2] == 0);
}

TEST_CASE("a kick beyond all numbers ends the run as unstable, and what can be read is finite") {
  for (const std::int32_t kind : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE}) {
    const Context context = make_context();
    hs_world_def def = world_def();
    def.time_step = 1e-3;
    World world = make_world(context.get(), def);
    std::int32_t heavy = -1, light = -1;
    require_ok(hs_world_add_material(world.get(), 1000, &heavy), context.get());
    require_ok(hs_world_add_material(world.get(), 1e-299, &light), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e8, 0);
    require_ok(hs_world_set_elasticity(world.get(), light, &elasticity), context.get());
    const hs_law_def law = law_def(1e20, 0);
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    add_block(context.get(), world.get(), box(0, 0, 1, 1), HS_BLOCK_FIXED);
    const Shape shape = make_shape(context.get(), box(0, 1.01, 1, 2.01));
    hs_block_def falling;
    hs_block_def_init(&falling, sizeof falling, shape.get());
    falling.kind = kind;
    falling.material = light;
    falling.velocity[1] = -1;
    hs_block block = 0;
    require_ok(hs_world_add_block(world.get(), shape.get(), &falling, &block), context.get());
    hs_status status = HS_OK;
    for (int i = 0; i < 100 && status == HS_OK; ++i) {
      status = hs_world_step(world.get(), 1);
      const hs_block_state state = state_of(world.get(), block);
      for (int k = 0; k < 3; ++k) {
        CHECK(std::isfinite(state.velocity[k]));
        CHECK(std::isfinite(state.angular_velocity[k]));
        CHECK(std::isfinite(state.pose.position[k]));
      }
    }
    CHECK(status == HS_ERROR_UNSTABLE);
  }
}

}  // namespace halfspace_test
