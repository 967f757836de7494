#include "shares/compare.h"

// A world cut into shares moves with the same bits as the whole one.

using namespace halfspace_test;

TEST_CASE("shares in the plane move with the bits of the whole world", "[shares]") {
  const LawOfStiffness& of = laws_of_stiffness[GENERATE(0, 1, 2)];
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  INFO(of.name << ", kind " << kind);
  for (const std::size_t shares : {1, 3, 8}) compare(heap_in_plane(of, kind), shares, 4000);
}

TEST_CASE("shares in space move with the bits of the whole world", "[shares]") {
  const LawOfStiffness& of = laws_of_stiffness[GENERATE(0, 1, 2)];
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  INFO(of.name << ", kind " << kind);
  for (const std::size_t shares : {1, 3, 8}) compare(heap_in_space(of, kind), shares, 2000);
}

TEST_CASE("bonds by laws break in shares as in the whole world", "[shares]") {
  for (const std::size_t shares : {2, 3, 8}) compare(wall_in_plane(), shares, 8000);
}

TEST_CASE("a block meets the floor as in the whole world, whatever else touches that", "[shares]") {
  for (const std::size_t shares : {2, 3}) compare(ends_of_floor(), shares, 40);
}

TEST_CASE("water acts in shares as in the whole world", "[shares]") {
  for (const std::size_t shares : {2, 3, 8}) compare(wall_in_water(), shares, 4000);
}

TEST_CASE("blocks follow tables in shares as in the whole world", "[shares]") {
  for (const std::size_t shares : {1, 2, 3, 8}) compare(wall_in_earthquake(), shares, 8000);
}

TEST_CASE("bonds by laws are made in shares of a world that was reported", "[shares]") {
  const Context context = make_context();
  const World wall = restored(context.get(), wall_in_plane());
  (void)report_of(wall.get());  // finds the contacts of the start, and makes no bonds yet
  compare(saved(wall.get()), 3, 2000);
}

TEST_CASE("a law of potentials that shares are given has the length of the whole world", "[shares]") {
  const std::vector<unsigned char> start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const hs_law_def law = law_of(laws_of_stiffness[2], 5e7, 0.4);
  const Context context = make_context();
  const World whole = restored(context.get(), start);
  SplitWorld split(start, 3);
  require_ok(hs_world_set_default_law(whole.get(), &law), context.get());
  for (std::size_t i = 0; i < split.count(); ++i)
    require_ok(hs_world_set_default_law(split.world(i), &law), split.context());
  split.begin();
  require_ok(hs_world_step(whole.get(), 1000), context.get());
  for (int i = 0; i < 1000; ++i) split.step();
  const World joined = split.joined();
  CHECK(first_difference(split.context(), joined.get(), context.get(), whole.get()) == "none");
}

TEST_CASE("a torque on an affine block counts once, whoever has copies", "[shares]") {
  const std::vector<unsigned char> start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_AFFINE);
  const Context context = make_context();
  const World whole = restored(context.get(), start);
  SplitWorld split(start, 3);
  require_ok(hs_world_step(whole.get(), 1000), context.get());
  for (int i = 0; i < 1000; ++i) split.step();
  const auto turn_all = [](hs_world* world) {
    std::vector<hs_block> blocks(roles_of(world).size());
    require_ok(hs_world_get_blocks(world, blocks.data(), std::int64_t(blocks.size()), nullptr), nullptr);
    const double force[] = {0, 0, 0}, torque[] = {0, 0, 1e4};
    for (const hs_block block : blocks)
      if (state_of(world, block).kind == HS_BLOCK_AFFINE)
        require_ok(hs_world_set_applied_force(world, block, force, torque), nullptr);
  };
  turn_all(whole.get());
  for (std::size_t i = 0; i < split.count(); ++i) turn_all(split.world(i));
  check_sums(split.sums(), whole.get());
}

TEST_CASE("shares that were saved go on with the same bits", "[shares]") {
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  const bool is_plane = GENERATE(true, false);
  const LawOfStiffness& of = laws_of_stiffness[GENERATE(0, 2)];
  INFO(of.name << ", kind " << kind << (is_plane ? ", plane" : ", space"));
  const std::vector<unsigned char> start = is_plane ? heap_in_plane(of, kind) : heap_in_space(of, kind);
  const Context context = make_context();
  const World whole = restored(context.get(), start);
  require_ok(hs_world_step(whole.get(), 2000), context.get());
  SplitWorld split(start, 3);
  for (int i = 0; i < 2000; ++i) {
    split.step();
    if (i % 77 == 0) split.restart();
  }
  const World joined = split.joined();
  CHECK(first_difference(split.context(), joined.get(), context.get(), whole.get()) == "none");
  check_sums(split.sums(), whole.get());
}

TEST_CASE("shares with two threads each keep the bits", "[shares]") {
  compare(heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID, 1600), 2, 400, 2);
}
