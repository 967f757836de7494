// Whatever the history of a world is, its snapshot holds all of it: it is accepted, goes on bit for bit, and
// no query or refused call has left a trace in it.

#include "capi/full_worlds.h"
#include "catch.h"

namespace halfspace_test {
namespace {

std::vector<hs_block> blocks_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_blocks(world, nullptr, 0, &count);
  std::vector<hs_block> blocks(static_cast<std::size_t>(count));
  require_ok(hs_world_get_blocks(world, blocks.data(), count, nullptr), nullptr);
  return blocks;
}

std::vector<std::int64_t> keys_of(const hs_world* world) {
  std::vector<std::int64_t> keys(blocks_of(world).size());
  require_ok(hs_world_get_keys(world, keys.data(), std::int64_t(keys.size()), nullptr), nullptr);
  return keys;
}

void set_keys(hs_context* context, hs_world* world) {
  std::vector<std::int64_t> keys(blocks_of(world).size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = 10 * std::int64_t(i + 1);
  require_ok(hs_world_set_keys(world, keys.data(), std::int64_t(keys.size())), context);
}

/// A row of boxes, each upon the last by a thousandth; the first is fixed.
struct Row {
  Row(int dimension, std::int32_t stiffness_kind, double cohesion = 0) : dimension(dimension) {
    hs_world_def def = world_def(dimension);
    def.time_step = 1e-4;
    world = make_world(context.get(), def);
    require_ok(hs_world_add_material(world.get(), 1000, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e7);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    set_law(stiffness_kind, cohesion);
    shape = shape_of_box(context.get(), dimension);
    for (int i = 0; i < 3; ++i)
      row.push_back(add_block(context.get(), world.get(), shape, i == 0 ? HS_BLOCK_FIXED : HS_BLOCK_RIGID,
                              pose_at(0.4995 * i, 0)));
  }

  void set_law(std::int32_t stiffness_kind, double cohesion = 0) {
    hs_law_def law = law_def(1e6, 0.5);
    law.stiffness_kind = stiffness_kind;
    law.cohesion = law.tensile_strength = cohesion;
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  }
  hs_body add_bar(double x) {
    return add_body(context.get(), world.get(), bar(dimension, 0.5), body_def(pose_at(x, 0)));
  }
  void step(hs_world* of, std::int64_t steps) { require_ok(hs_world_step(of, steps), context.get()); }

  int dimension;
  Context context = make_context();
  World world;
  std::int32_t material = -1;
  Shape shape;
  std::vector<hs_block> row;
};

/// A world goes on as one that is restored from its snapshot.
void check_restores(Row& scene, std::int64_t steps = 20) {
  const World twin = restored(scene.context.get(), saved(scene.world.get()));
  scene.step(scene.world.get(), steps);
  scene.step(twin.get(), steps);
  const bool goes_on_alike = saved(twin.get()) == saved(scene.world.get());
  CHECK(goes_on_alike);
}

}  // namespace

TEST_CASE("blocks that come alone, in a compound or in a mesh end the keys") {
  const int dimension = GENERATE(2, 3);
  const int way = GENERATE(0, 1, 2, 3);
  Row scene(dimension, HS_STIFFNESS_PER_CONTACT);
  hs_world* const world = scene.world.get();
  hs_body body = 0;
  if (way == 3) body = scene.add_bar(5);
  set_keys(scene.context.get(), world);
  CHECK(keys_of(world)[1] == 20);
  if (way == 0) add_block(scene.context.get(), world, scene.shape, HS_BLOCK_RIGID, pose_at(5, 0));
  if (way == 1) add_compound(scene.context.get(), world, dimension, HS_BLOCK_RIGID, 5);
  if (way == 2) scene.add_bar(5);
  if (way == 3) {
    constexpr std::int32_t first_cell = 0;
    REQUIRE(hs_world_remove_cells(world, body, &first_cell, 1, {}) == HS_OK);
  }
  const std::vector<std::int64_t> keys = keys_of(world);
  CHECK(keys[0] == 0);
  CHECK(std::is_sorted(keys.begin(), keys.end()));
  check_restores(scene);
}

TEST_CASE("a planned motion ends with the changes of the world, which a report does not end") {
  const int dimension = GENERATE(2, 3);
  Row scene(dimension, HS_STIFFNESS_PER_CONTACT);
  hs_world* const world = scene.world.get();
  hs_share_plan plan;
  hs_world_report report;
  REQUIRE(hs_world_begin(world) == HS_OK);
  REQUIRE(hs_world_end_begin(world) == HS_OK);
  REQUIRE(hs_world_plan_motion(world, &plan) == HS_OK);
  for (int i = 0; i < 200; ++i)
    add_block(scene.context.get(), world, scene.shape, HS_BLOCK_RIGID, pose_at(5 + 2 * i, 0));
  REQUIRE(hs_world_get_report(world, &report, sizeof report) == HS_OK);
  CHECK(hs_world_move(world) == HS_ERROR_STATE);
  CHECK(hs_world_plan_motion(world, &plan) == HS_ERROR_STATE);  // begin first
  REQUIRE(hs_world_begin(world) == HS_OK);
  CHECK(hs_world_plan_motion(world, &plan) == HS_ERROR_STATE);  // end that first
  const std::string text = hs_context_last_error(scene.context.get());
  CHECK(text.find("hs_world_end_begin()") != std::string::npos);
  // A whole step uses the plan up.
  REQUIRE(hs_world_end_begin(world) == HS_OK);
  REQUIRE(hs_world_plan_motion(world, &plan) == HS_OK);
  scene.step(world, 1);
  CHECK(hs_world_move(world) == HS_ERROR_STATE);
}

TEST_CASE("reports and balances leave no trace in later snapshots") {
  const int dimension = GENERATE(2, 3);
  const std::int32_t kind =
      GENERATE(int{HS_STIFFNESS_PER_CONTACT}, int{HS_STIFFNESS_PER_AREA}, int{HS_STIFFNESS_NONE});
  const double cohesion = GENERATE(0.0, 1e3);
  Row asked(dimension, kind, cohesion), other(dimension, kind, cohesion);
  const auto look = [&] {
    const std::vector<unsigned char> before = saved(asked.world.get());
    hs_balance balance;
    REQUIRE(hs_world_get_balance(asked.world.get(), &balance, sizeof balance) == HS_OK);
    report_of(asked.world.get());
    const bool is_unchanged = saved(asked.world.get()) == before;
    CHECK(is_unchanged);
  };
  look();
  for (const double x : {0.6, 0.498}) {
    for (Row* scene : {&asked, &other}) {
      const hs_pose pose = pose_at(x, 0.01);
      require_ok(hs_world_set_pose(scene->world.get(), scene->row[1], &pose), scene->context.get());
      if (scene == &asked) look();
      scene->step(scene->world.get(), 5);
      if (scene == &asked) look();
    }
  }
  const bool is_alike = saved(asked.world.get()) == saved(other.world.get());
  CHECK(is_alike);
}

TEST_CASE("a report of a changed world counts what the world has counted") {
  Row scene(2, HS_STIFFNESS_NONE);
  scene.step(scene.world.get(), 20);
  const hs_world_report before = report_of(scene.world.get());
  CHECK(before.iteration_count > 0);
  require_ok(hs_world_set_damping(scene.world.get(), 0.1, 0), scene.context.get());
  const hs_world_report after = report_of(scene.world.get());
  const hs_world_report of_twin = report_of(restored(scene.context.get(), saved(scene.world.get())).get());
  for (const hs_world_report& report : {after, of_twin}) {
    CHECK(report.iteration_count == before.iteration_count);
    CHECK(report.touch_count == before.touch_count);
    CHECK(report.unbalanced_velocity == before.unbalanced_velocity);
    CHECK(report.steps == before.steps);
  }
}

TEST_CASE("laws without springs that get springs leave no impulses behind") {
  const int dimension = GENERATE(2, 3);
  Row scene(dimension, HS_STIFFNESS_NONE);
  hs_world* const world = scene.world.get();
  scene.step(world, 20);
  scene.set_law(HS_STIFFNESS_PER_CONTACT);
  require_ok(hs_world_set_damping(world, 0.1, 0.1), scene.context.get());
  scene.add_bar(-5);
  check_restores(scene);
  // Once apart from all others, and without gravity and damping, a block keeps its velocity.
  const double none[3] = {0, 0, 0};
  require_ok(hs_world_set_gravity(world, none), scene.context.get());
  require_ok(hs_world_set_damping(world, 0, 0), scene.context.get());
  const hs_pose away = pose_at(50, 0);
  require_ok(hs_world_set_pose(world, scene.row[2], &away), scene.context.get());
  require_ok(hs_world_set_velocity(world, scene.row[2], none, none), scene.context.get());
  scene.step(world, 20);
  for (const double component : state_of(world, scene.row[2]).velocity) CHECK(component == 0);
}

TEST_CASE("manifolds that become points leave no impulses behind") {
  const int dimension = GENERATE(2, 3);
  Row scene(dimension, HS_STIFFNESS_NONE);
  hs_world* const world = scene.world.get();
  scene.step(world, 20);
  // A held block meets others in points.
  for (const int i : {1, 2})
    require_ok(hs_world_hold_block(world, scene.row[std::size_t(i)], HS_AXIS_X), scene.context.get());
  const double push[3] = {0, -1, 0}, none[3] = {0, 0, 0};
  require_ok(hs_world_set_velocity(world, scene.row[2], push, none), scene.context.get());
  check_restores(scene);
}

TEST_CASE("a compound that is refused leaves no byte behind") {
  const int dimension = GENERATE(2, 3);
  const bool is_fixed_last = GENERATE(false, true);
  Row scene(dimension, HS_STIFFNESS_PER_CONTACT);
  hs_world* const world = scene.world.get();
  scene.step(world, 3);
  // Slots that were used are free: of a rigid block that had moved, and of a compound.
  const hs_block compound = add_compound(scene.context.get(), world, dimension, HS_BLOCK_RIGID, 5);
  if (is_fixed_last) add_block(scene.context.get(), world, scene.shape, HS_BLOCK_FIXED, pose_at(20, 0));
  scene.step(world, 3);
  require_ok(hs_world_remove_block(world, compound), scene.context.get());
  require_ok(hs_world_remove_block(world, scene.row[2]), scene.context.get());
  const std::vector<unsigned char> before = saved(world);
  const hs_shape* const shapes[6] = {scene.shape.get(), scene.shape.get(), scene.shape.get(),
                                     scene.shape.get(), scene.shape.get(), scene.shape.get()};
  const hs_pose poses[6] = {pose_at(5, 0), pose_at(6, 0), pose_at(7, 0),
                            pose_at(8, 0), pose_at(9, 0), pose_at(9.1, 0)};
  hs_block_def def;
  require_ok(hs_compound_def_init(&def, sizeof def, shapes, poses, 6), scene.context.get());
  hs_block block = 0;
  CHECK(hs_world_add_compound(world, shapes, poses, 6, &def, &block) == HS_ERROR_GEOMETRY);
  const bool is_unchanged = saved(world) == before;
  CHECK(is_unchanged);
  check_restores(scene);
}

TEST_CASE("actions and bolts of a compound end with it") {
  const int dimension = GENERATE(2, 3);
  ActionWorld scene(dimension);
  const hs_block compound =
      add_compound(scene.context.get(), scene.world.get(), dimension, HS_BLOCK_RIGID, 20);
  scene.act(compound, action_def(HS_ACTION_FORCE));
  hs_bolt_def bolt = bolt_def(compound, {20, 0, 0}, scene.rigid, {4, 0, 0}, 1e3);
  std::int64_t number = 0;
  const bool is_bolted = hs_world_add_bolt(scene.world.get(), &bolt, &number) == HS_OK;
  scene.step(3);
  require_ok(hs_world_remove_block(scene.world.get(), compound), scene.context.get());
  if (is_bolted) CHECK(bolts_of(scene.world.get()).empty());
  const World twin = restored(scene.context.get(), saved(scene.world.get()));
  require_ok(hs_world_step(twin.get(), 3), scene.context.get());
  scene.step(3);
  const bool is_alike = saved(twin.get()) == saved(scene.world.get());
  CHECK(is_alike);
}

TEST_CASE("an action that cannot act where a snapshot says so is refused") {
  const int dimension = GENERATE(2, 3);
  const std::vector<unsigned char> good = snapshot_of_full_world(dimension, HS_STIFFNESS_PER_CONTACT);
  const Context context = make_context();
  const auto status_of = [&](const std::vector<unsigned char>& bytes) {
    hs_world* made = nullptr;
    const hs_status status = hs_world_restore(context.get(), bytes.data(), bytes.size(), &made);
    const World world(made);
    return status;
  };
  CHECK(status_of(good) == HS_OK);
  // The action on all blocks: slot -1, an acceleration by table 0.
  const std::int32_t pattern[4] = {-1, HS_ACTION_ACCELERATION, 0, 0};
  int found = 0;
  for (std::size_t i = snapshot_header; i + sizeof pattern <= good.size(); ++i) {
    if (std::memcmp(&good[i], pattern, sizeof pattern) != 0) continue;
    ++found;
    for (std::int32_t kind = HS_ACTION_VELOCITY; kind <= HS_ACTION_SERVO; ++kind) {
      std::vector<unsigned char> changed = good;
      put(changed, i + 4, kind);
      mend_header(changed);
      CHECK(status_of(changed) == (kind == HS_ACTION_ACCELERATION ? HS_OK : HS_ERROR_FORMAT));
    }
  }
  CHECK(found == 1);
}

TEST_CASE("snapshots of worlds that have everything are accepted") {
  const int dimension = GENERATE(2, 3);
  const Context context = make_context();
  for (const std::int32_t kind :
       {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL, HS_STIFFNESS_NONE}) {
    const World world = restored(context.get(), snapshot_of_full_world(dimension, kind));
    CHECK(hs_world_step(world.get(), 10) == HS_OK);
    INFO(hs_context_last_error(context.get()));
  }
  const World share = restored(context.get(), snapshot_of_share(dimension));
  CHECK(hs_world_begin(share.get()) == HS_OK);
}

}  // namespace halfspace_test
