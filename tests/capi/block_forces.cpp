// The force of a block is the sum of the forces of its contacts, under every law, for every kind of block.

#include <array>
#include <map>

#include "capi/snapshot_worlds.h"
#include "catch.h"

using namespace halfspace_test;

namespace {

using Triple = std::array<double, 3>;

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Load {
  Triple force{}, torque{};

  void add(const Triple& force_at, const Triple& arm, const Triple& couple, double sign) {
    const Triple moment = cross(arm, force_at);
    for (std::size_t k = 0; k < 3; ++k) {
      force[k] += sign * force_at[k];
      torque[k] += sign * (moment[k] + couple[k]);
    }
  }
};

Triple triple(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

Triple arm_to(const hs_contact& contact, const hs_block_state& state) {
  Triple arm;
  for (std::size_t k = 0; k < 3; ++k) arm[k] = contact.force_point[k] - state.pose.position[k];
  return arm;
}

/// The compound of a part; 0: the block is none.
hs_block compound_of(const hs_world* world, hs_block block) {
  hs_block compound = 0;
  REQUIRE(hs_world_get_compound_of_block(world, block, &compound, nullptr) == HS_OK);
  return compound;
}

std::vector<hs_block> blocks_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_blocks(world, nullptr, 0, &count);
  std::vector<hs_block> blocks(static_cast<std::size_t>(count));
  REQUIRE(hs_world_get_blocks(world, blocks.data(), count, nullptr) == HS_OK);
  return blocks;
}

/// Compares the loads of all blocks with their contacts. Returns the largest force.
double check_loads(const hs_world* world) {
  std::map<hs_block, Load> sums;
  double largest = 0, reach = 0;
  for (const hs_contact& contact : contacts_of(world)) {
    const Triple force = triple(contact.force), couple = triple(contact.torque);
    const auto add = [&](hs_block block, double sign) {
      const Triple arm = arm_to(contact, state_of(world, block));
      for (std::size_t k = 0; k < 3; ++k) {
        largest = std::max(largest, std::abs(force[k]));
        reach = std::max(reach, std::abs(arm[k]));
      }
      sums[block].add(force, arm, couple, sign);
    };
    for (const auto& [block, sign] : {std::pair(contact.block_a, -1.0), std::pair(contact.block_b, 1.0)}) {
      add(block, sign);
      if (const hs_block compound = compound_of(world, block)) add(compound, sign);
    }
  }
  const double tolerance = 1e-13 * largest;
  const std::vector<hs_block> blocks = blocks_of(world);
  std::vector<hs_block_state> states(blocks.size());
  REQUIRE(hs_world_get_block_states(world, states.data(), std::int64_t(states.size()), nullptr) == HS_OK);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Load& sum = sums[blocks[i]];
    const hs_block_state one = state_of(world, blocks[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(std::abs(states[i].force[k] - sum.force[k]) <= tolerance);
      CHECK(std::abs(states[i].torque[k] - sum.torque[k]) <= tolerance * reach);
      CHECK(states[i].force[k] == one.force[k]);
      CHECK(states[i].torque[k] == one.torque[k]);
    }
  }
  return largest;
}

World world_without_springs(hs_context* context, int dimension) {
  hs_world_def def = world_def(dimension);
  def.time_step = 1e-3;
  World world = make_world(context, def);
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2000, &material), context);
  const hs_elasticity_def elasticity = elasticity_def(1e7, 1e-3);
  require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context);
  hs_law_def law = law_def(1, 0.5);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  require_ok(hs_world_set_default_law(world.get(), &law), context);
  return world;
}

}  // namespace

TEST_CASE("the force of a block is the sum over its contacts under every law") {
  const Context context = make_context();
  for (const int dimension : {2, 3}) {
    for (const std::int32_t law : all_laws) {
      for (const std::int32_t block : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE}) {
        INFO(dimension << "D, law " << law << ", blocks of kind " << block);
        const World world = restored(context.get(), snapshot_of(context.get(), {dimension, law, block}));
        CHECK(check_loads(world.get()) > 0);
        require_ok(hs_world_step(world.get(), 20), context.get());
        CHECK(check_loads(world.get()) > 0);
      }
    }
  }
}

TEST_CASE("a floor without springs carries the weight of what rests on it") {
  const Context context = make_context();
  for (const int dimension : {2, 3}) {
    const World world = world_without_springs(context.get(), dimension);
    const Shape shape = shape_of_box(context.get(), dimension);
    const int up = dimension - 1;
    const auto add = [&](std::int32_t kind, double height) {
      hs_pose pose = pose_at(0, 0);
      pose.position[up] = height;
      return add_block(context.get(), world.get(), shape, kind, pose);
    };
    const hs_block floor = add(HS_BLOCK_FIXED, 0), lower = add(HS_BLOCK_RIGID, 0.5),
                   upper = add(HS_BLOCK_RIGID, 1);
    const double weight = 9.81 * state_of(world.get(), lower).mass;
    CHECK(state_of(world.get(), floor).force[up] == 0);
    require_ok(hs_world_step(world.get(), 100), context.get());
    CHECK_THAT(state_of(world.get(), floor).force[up], Catch::Matchers::WithinRel(-2 * weight, 1e-6));
    CHECK_THAT(state_of(world.get(), lower).force[up], Catch::Matchers::WithinRel(weight, 1e-6));
    check_loads(world.get());
    require_ok(hs_world_remove_block(world.get(), upper), context.get());
    check_loads(world.get());
    require_ok(hs_world_step(world.get(), 1), context.get());
    CHECK_THAT(state_of(world.get(), floor).force[up], Catch::Matchers::WithinRel(-weight, 1e-6));
    // A new place changes the arms of the contacts that are still listed.
    const hs_pose moved = [&] {
      hs_pose pose = state_of(world.get(), lower).pose;
      pose.position[0] += 0.125;
      return pose;
    }();
    require_ok(hs_world_set_pose(world.get(), lower, &moved), context.get());
    check_loads(world.get());
  }
}

TEST_CASE("held, prescribed and meshed blocks without springs have the forces of their contacts") {
  const Context context = make_context();
  for (const int dimension : {2, 3}) {
    const World world = world_without_springs(context.get(), dimension);
    const Shape shape = shape_of_box(context.get(), dimension);
    const int up = dimension - 1;
    const auto add = [&](std::int32_t kind, double x, double height) {
      hs_pose pose = pose_at(x, 0);
      pose.position[up] = height;
      return add_block(context.get(), world.get(), shape, kind, pose);
    };
    const hs_block sledge = add(HS_BLOCK_PRESCRIBED, 0, 0), held = add(HS_BLOCK_RIGID, 0.1, 0.5);
    add(HS_BLOCK_FIXED, 5.2, -0.25);
    require_ok(hs_world_hold_block(world.get(), held, HS_AXIS_X | HS_AXIS_ROTATION), context.get());
    const double velocity[3] = {0.1, 0, 0}, still[3] = {0, 0, 0};
    require_ok(hs_world_set_velocity(world.get(), sledge, velocity, still), context.get());
    hs_pose place = pose_at(5, -0.25);
    if (dimension == 3) place.position[2] = 0;
    add_body(context.get(), world.get(), bar(dimension, 0.25), body_def(place));
    require_ok(hs_world_step(world.get(), 50), context.get());
    CHECK(check_loads(world.get()) > 0);
    const double weight = 9.81 * state_of(world.get(), held).mass;
    CHECK_THAT(state_of(world.get(), held).force[up], Catch::Matchers::WithinRel(weight, 1e-6));
    CHECK_THAT(state_of(world.get(), held).force[0],
               Catch::Matchers::WithinRel(std::tan(0.5) * weight, 1e-6));
  }
}
