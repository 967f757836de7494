// Compounds over time: snapshots, sleep, edits, and the lists of blocks.

#include <cstring>

#include "catch.h"
#include "validation/compound_scene.h"

namespace {

using namespace halfspace_test;

/// Hooks that fall into each other and onto a trough, which is one compound, too.
struct Heap : CompoundScene {
  Heap(int dimension, const hs_law_def& law, hs_world_def def) : CompoundScene(dimension, law, def) {
    trough = add({{{-6, -1}, {6, 0}}, {{-7, -1}, {-6, 8}}, {{6, -1}, {7, 8}}}, {}, {}, {}, HS_BLOCK_FIXED);
    for (int i = 0; i < 6; ++i)
      hooks.push_back(add(l_shape(), {i % 2 ? -3.1 : 0.4, 0.01 + 2.1 * (i / 2)}, {}, {0, 0, 0.2 * i}));
  }
  hs_block trough = 0;
  std::vector<hs_block> hooks;
};

/// Not as a comparison of vectors, whose failure would print every byte.
bool same(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b) { return a == b; }

}  // namespace

TEST_CASE("a world of compounds goes on bit for bit", "[compound]") {
  const int dimension = GENERATE(2, 3);
  const bool has_springs = GENERATE(true, false);
  hs_world_def def = CompoundScene::definition(dimension, has_springs ? 0 : 1e-3);
  if (has_springs) def.sleep_tolerance = 1e-4;
  Heap heap(dimension, has_springs ? damped(area_law(1e8, 0.5)) : no_spring(0.5), def);
  heap.step(has_springs ? 4000 : 500);
  REQUIRE(heap.report().contact_count >= 6);
  World copy = restored(heap.context.get(), saved(heap.world.get()));
  CHECK(same(saved(copy.get()), saved(heap.world.get())));
  for (int i = 0; i < 20; ++i) {
    REQUIRE(hs_world_step(copy.get(), 1) == HS_OK);
    copy = restored(heap.context.get(), saved(copy.get()));
  }
  heap.step(20);
  CHECK(same(saved(copy.get()), saved(heap.world.get())));
}

TEST_CASE("a compound sleeps as one member of its island, and wakes with it", "[compound]") {
  const int dimension = GENERATE(2, 3);
  hs_world_def def = CompoundScene::definition(dimension, 0);
  def.sleep_tolerance = 1e-5;
  CompoundScene scene(dimension, damped(area_law(1e8, 0.5)), def);
  scene.add_floor();
  const hs_block block = scene.add(l_shape());
  const hs_block other = scene.add(l_shape(), {8, 0});
  run(scene.context.get(), scene.world.get(), 10);  // the longer it is at rest, the longer it sleeps
  CHECK(scene.report().sleeping_count == 6);        // two compounds with two parts each
  const hs_block_state before = scene.state(block);
  scene.step(100);
  CHECK(apart(scene.state(block), before) == 0);
  const double force[3] = {100, 0, 0}, none[3] = {};
  REQUIRE(hs_world_set_applied_force(scene.world.get(), other, force, none) == HS_OK);
  CHECK(scene.report().sleeping_count == 3);  // its island is awake
  scene.step(10);
  CHECK(apart(scene.state(block), before) == 0);
  CHECK(scene.state(other).velocity[0] != 0);
  CHECK(scene.report().max_sleep_error <= 1e-5);
}

TEST_CASE("edits of a compound move and remove its parts", "[compound]") {
  const int dimension = GENERATE(2, 3);
  CompoundScene scene(dimension, area_law(1e8), 1e-3);
  hs_world* const world = scene.world.get();
  const hs_block block = scene.add(l_shape());
  const auto parts = scene.parts(block);
  std::int64_t count = 0;
  hs_block all[3] = {};
  REQUIRE(hs_world_get_blocks(world, all, 3, &count) == HS_OK);
  REQUIRE(count == 3);
  CHECK(all[0] == block);
  CHECK(all[1] == parts[0]);
  CHECK(all[2] == parts[1]);
  hs_block compound = 0;
  std::int32_t index = -1;
  REQUIRE(hs_world_get_compound_of_block(world, parts[1], &compound, &index) == HS_OK);
  CHECK(compound == block);
  CHECK(index == 1);
  REQUIRE(hs_world_get_compound_of_block(world, block, &compound, &index) == HS_OK);
  CHECK(compound == 0);
  CHECK(index == -1);

  hs_pose pose = scene.state(block).pose;
  pose.position[0] += 2;
  pose.rotation[2] = pose.rotation[3] = std::sqrt(0.5);
  REQUIRE(hs_world_set_pose(world, block, &pose) == HS_OK);
  const hs_block_state moved = scene.state(parts[1]);
  CHECK(moved.pose.position[0] == Approx(3.25 - 0.75).epsilon(1e-14));
  CHECK(moved.pose.position[1] == Approx(0.75 - 0.75).margin(1e-14));
  const double velocity[3] = {1, 2, 0}, spin[3] = {0, 0, 3};
  REQUIRE(hs_world_set_velocity(world, block, velocity, spin) == HS_OK);
  CHECK(scene.state(parts[1]).velocity[0] == Approx(1 + 3 * 0.75).epsilon(1e-14));
  CHECK(scene.state(parts[1]).velocity[1] == Approx(2 - 3 * 0.75).epsilon(1e-14));
  const double force[3] = {0, 4 * CompoundScene::density * gravity, 0}, none[3] = {};
  REQUIRE(hs_world_set_applied_force(world, block, force, none) == HS_OK);
  scene.step(100);
  CHECK(scene.state(block).velocity[1] == Approx(2).epsilon(1e-12));

  const double zeros[3] = {}, pushes[3] = {force[1], force[1], force[1]};
  const hs_view upwards{zeros, pushes, zeros, 8, 3};
  REQUIRE(hs_world_set_applied_forces(world, upwards, {}) == HS_OK);  // entries of parts are ignored
  scene.step(100);
  CHECK(scene.state(block).velocity[1] == Approx(2).epsilon(1e-12));

  CHECK(hs_world_remove_block(world, parts[0]) == HS_ERROR_STATE);
  CHECK(hs_world_set_pose(world, parts[0], &pose) == HS_ERROR_STATE);
  CHECK(hs_world_set_velocity(world, parts[0], velocity, spin) == HS_ERROR_STATE);
  CHECK(hs_world_set_applied_force(world, parts[0], force, none) == HS_ERROR_STATE);
  REQUIRE(hs_world_remove_block(world, block) == HS_OK);
  CHECK(scene.report().block_count == 0);
  CHECK(hs_world_remove_block(world, block) == HS_ERROR_STALE_ID);
  hs_block_state state{};
  CHECK(hs_world_get_block_state(world, parts[0], &state) == HS_ERROR_STALE_ID);
  const hs_block again = scene.add_one({{0, 0}, {1, 1}});  // a free slot serves any block
  scene.add(l_shape(), {4, 0});
  scene.step(10);
  REQUIRE(hs_world_remove_block(world, again) == HS_OK);
  CHECK(scene.report().block_count == 3);
}

TEST_CASE("parts that overlap are refused, and nothing has changed", "[compound]") {
  const int dimension = GENERATE(2, 3);
  CompoundScene scene(dimension, area_law(1e8), 1e-3);
  const auto before = saved(scene.world.get());
  std::string text;
  try {
    scene.add({{{0, 0}, {1, 1}}, {{0.9, 0}, {2, 1}}});
  } catch (const std::runtime_error& error) {
    text = error.what();
  }
  CHECK(text.find("shapes[0] and shapes[1] overlap by 0.1") != std::string::npos);
  CHECK(same(saved(scene.world.get()), before));
  scene.add({{{0, 0}, {1, 1}}, {{1 - 1e-9, 0}, {2, 1}}});   // within rounding of a file
  scene.add({{{0, 0}, {1, 1}}, {{3, 0}, {4, 1}}}, {0, 5});  // apart
}

TEST_CASE("a compound may be fixed or prescribed, and is of one material", "[compound]") {
  const int dimension = GENERATE(2, 3);
  CompoundScene scene(dimension, damped(area_law(1e8, 0.5)), 1e-4);
  // A scoop that turns about its centroid lifts a block that lies in its corner.
  const hs_block scoop = scene.add(l_shape(), {}, {0, 0.5}, {}, HS_BLOCK_PRESCRIBED);
  const hs_block load = scene.add_one({{1.2, 1}, {2, 1.8}});
  const double before = scene.report().energy.outer_work;
  scene.step(10000);
  CHECK(scene.state(scoop).pose.position[1] == Approx(0.75 + 0.5).epsilon(1e-12));
  CHECK(scene.state(load).pose.position[1] == Approx(1.4 + 0.5).epsilon(1e-3));
  const hs_world_report report = scene.report();
  const double weight = 0.64 * CompoundScene::density * gravity;
  const double lifted = 0.5 * weight + 0.5 * weight / gravity * 0.25;
  CHECK(report.energy.outer_work - before ==
        Approx(lifted + report.energy.contact_damping_loss).epsilon(2e-2));
  CHECK(std::abs(report.energy.residual) < 1e-6 * weight);
  const Shape shape = scene.shape({{0, 0}, {1, 1}});
  const hs_shape* shapes[] = {shape.get()};
  hs_block_def def;
  REQUIRE(hs_compound_def_init(&def, sizeof def, shapes, nullptr, 1) == HS_OK);
  def.kind = HS_BLOCK_AFFINE;
  hs_block block = 0;
  CHECK(hs_world_add_compound(scene.world.get(), shapes, nullptr, 1, &def, &block) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_add_compound(scene.world.get(), shapes, nullptr, 0, &def, &block) == HS_ERROR_ARGUMENT);
  def.kind = HS_BLOCK_RIGID;
  def.material = 7;
  CHECK(hs_world_add_compound(scene.world.get(), shapes, nullptr, 1, &def, &block) == HS_ERROR_STALE_ID);
  CHECK(block == 0);
}
