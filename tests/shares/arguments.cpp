#include "capi/loads.h"
#include "capi/refusals.h"
#include "shares/row.h"

// Refusals of shares, and their report to a host whose copies do not reach far enough.

using namespace halfspace_test;

namespace {

std::string refusal_of(const Row& row) {
  CHECK(row.assemble(left) == HS_ERROR_STATE);
  return row.error();
}

}  // namespace

TEST_CASE("what shares cannot hold is refused by name", "[shares]") {
  using Catch::Contains;
  hs_world_def def = world_def();
  def.sleep_tolerance = 1e-3;
  CHECK_THAT(refusal_of(Row(def)), Contains("sleep"));

  hs_law_def law = law_def(1e8, 0.5);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  CHECK_THAT(refusal_of(Row(world_def(), law)), Contains("laws without springs"));

  const Row stepless;
  require_ok(hs_world_set_time_step(stepless.world.get(), 0), stepless.context.get());
  CHECK_THAT(refusal_of(stepless), Contains("time step"));

  const Row bolted;
  const hs_bolt_def bolt = bolt_def(bolted.boxes[0], {0, 0, 0}, bolted.boxes[1], {1, 0, 0}, 1e6);
  require_ok(hs_world_add_bolt(bolted.world.get(), &bolt, nullptr), bolted.context.get());
  CHECK_THAT(refusal_of(bolted), Contains("bolts"));

  const Row pushed;
  hs_action_def action;
  require_ok(hs_action_def_init(&action, sizeof action), pushed.context.get());
  action.kind = HS_ACTION_SERVO;
  action.max_speed = 1;
  action.scale[1] = action.scale[2] = 0;
  const double time = 0, value[3] = {1, 0, 0};
  require_ok(
      hs_world_add_table(pushed.world.get(), &time, {value, value + 1, value + 2, 24, 1}, &action.table),
      pushed.context.get());
  require_ok(hs_world_hold_block(pushed.world.get(), pushed.boxes[1], 1), pushed.context.get());
  require_ok(hs_world_add_action(pushed.world.get(), pushed.boxes[1], &action), pushed.context.get());
  CHECK_THAT(refusal_of(pushed), Contains("servos"));

  const Row bonded;
  hs_bond_def bond;
  require_ok(hs_bond_def_init(&bond, sizeof bond), bonded.context.get());
  require_ok(hs_world_bond_blocks(bonded.world.get(), bonded.boxes[0], bonded.boxes[1], &bond),
             bonded.context.get());
  CHECK_THAT(refusal_of(bonded), Contains("bonds of bond.h"));
}

TEST_CASE("a share refuses what only the whole world can do", "[shares]") {
  const Row row;
  World share;
  require_ok(row.assemble(left, &share), row.context.get());
  CHECK(hs_world_step(share.get(), 1) == HS_ERROR_STATE);
  const hs_pose pose = {{0, 5, 0}, {0, 0, 0, 1}};
  std::int64_t count = 0;
  hs_block boxes[4];
  require_ok(hs_world_get_blocks(share.get(), boxes, 4, &count), row.context.get());
  CHECK(count == 4);
  CHECK(hs_world_set_pose(share.get(), boxes[1], &pose) == HS_ERROR_STATE);
  CHECK(hs_world_remove_block(share.get(), boxes[1]) == HS_ERROR_STATE);
  CHECK_THAT(row.error(), Catch::Contains("share of a larger world"));
  CHECK(info_of(share.get()).is_whole == 0);
  CHECK(info_of(share.get()).own_count == 2);
  CHECK(info_of(share.get()).neighbor_count == 1);
  CHECK(info_of(share.get()).everywhere_count == 1);
}

TEST_CASE("a share is saved between steps, with its keys and roles", "[shares]") {
  const Row row;
  World share;
  require_ok(row.assemble(left, &share), row.context.get());
  std::size_t size = 0;
  require_ok(hs_world_begin(share.get()), row.context.get());
  CHECK(hs_world_save(share.get(), nullptr, 0, &size) == HS_ERROR_STATE);
  CHECK_THAT(row.error(), Catch::Contains("call hs_world_end_begin() first"));
  require_ok(hs_world_end_begin(share.get()), row.context.get());
  std::vector<unsigned char> bytes = saved(share.get());
  const World again = restored(row.context.get(), bytes);
  CHECK(keys_of(again.get()) == keys_of(share.get()));
  CHECK(roles_of(again.get()) == roles_of(share.get()));
  CHECK(info_of(again.get()).lost_pairs == info_of(share.get()).lost_pairs);
  CHECK(saved(again.get()) == bytes);
}

TEST_CASE("the pieces of a step are called in their order", "[shares]") {
  const Row row;
  hs_world* const w = row.world.get();
  hs_share_plan plan;
  double loads[3];
  const std::int64_t key = 1;
  CHECK(hs_world_plan_motion(w, &plan) == HS_ERROR_STATE);  // not begun
  CHECK(hs_world_end_begin(w) == HS_ERROR_STATE);
  require_ok(hs_world_begin(w), row.context.get());
  CHECK(hs_world_move(w) == HS_ERROR_STATE);
  CHECK(hs_world_get_loads(w, &key, 1, loads) == HS_OK);
  require_ok(hs_world_end_begin(w), row.context.get());
  CHECK(hs_world_get_loads(w, &key, 1, loads) == HS_ERROR_STATE);
  CHECK(hs_world_move(w) == HS_ERROR_STATE);
  CHECK(hs_world_renew_list(w, &plan) == HS_ERROR_STATE);
  CHECK(hs_world_end_step(w) == HS_ERROR_STATE);
  require_ok(hs_world_plan_motion(w, &plan), row.context.get());
  CHECK(plan.refusal == HS_OK);
  require_ok(hs_world_plan_motion(w, &plan), row.context.get());
  require_ok(hs_world_move(w), row.context.get());
  CHECK(hs_world_plan_motion(w, &plan) == HS_ERROR_STATE);
  require_ok(hs_world_end_step(w), row.context.get());
  CHECK(report_of(w).steps == 1);
}

TEST_CASE("a step that has not ended is neither cut short nor taken for one that has", "[shares]") {
  using Catch::Contains;
  const Row row;
  hs_world* const w = row.world.get();
  const auto check_refusals = [&](const std::string& call) {
    const std::int64_t key = 1;
    std::size_t size = 0;
    CHECK(hs_world_save(w, nullptr, 0, &size) == HS_ERROR_STATE);
    CHECK_THAT(row.error(), Contains(call));
    CHECK(hs_world_pack(w, &key, 1, 0, nullptr, 0, nullptr, &size) == HS_ERROR_STATE);
    CHECK_THAT(row.error(), Contains(call));
    CHECK(row.assemble(left) == HS_ERROR_STATE);
    CHECK_THAT(row.error(), Contains(call));
    CHECK(hs_world_step(w, 1) == HS_ERROR_STATE);
    CHECK_THAT(row.error(), Contains(call));
  };
  require_ok(hs_world_begin(w), row.context.get());
  check_refusals("hs_world_end_begin()");
  require_ok(hs_world_begin(w), row.context.get());
  require_ok(hs_world_end_begin(w), row.context.get());
  hs_share_plan plan;
  require_ok(hs_world_plan_motion(w, &plan), row.context.get());
  require_ok(hs_world_move(w), row.context.get());
  check_refusals("hs_world_end_step()");
  CHECK(hs_world_begin(w) == HS_ERROR_STATE);
  CHECK_THAT(row.error(), Contains("hs_world_end_step()"));
  require_ok(hs_world_end_step(w), row.context.get());
  CHECK(hs_world_step(w, 1) == HS_OK);
}

TEST_CASE("shares of affine blocks refuse a first law of potentials without its length", "[shares]") {
  const std::vector<unsigned char> start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_AFFINE);
  const SplitWorld split(start, 2);
  const hs_law_def law = law_of(laws_of_stiffness[2], 5e7, 0.4);
  CHECK(hs_world_set_default_law(split.world(1), &law) == HS_ERROR_STATE);
  CHECK(hs_world_set_law(split.world(1), 0, 0, &law) == HS_ERROR_STATE);
  const Context context = make_context();
  CHECK(hs_world_set_default_law(restored(context.get(), start).get(), &law) == HS_OK);
}

TEST_CASE("shares are assembled between a change of laws and the beginning", "[shares]") {
  SplitWorld split(heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID), 2);
  while (split.assemblies() == 0) split.step();
  const hs_law_def law = law_of(laws_of_stiffness[1], 5e7, 0.4);
  require_ok(hs_world_set_default_law(split.world(0), &law), split.context());
  CHECK(hs_world_begin(split.world(0)) == HS_ERROR_STATE);
  CHECK_THAT(hs_context_last_error(split.context()), Catch::Contains("call hs_world_assemble() first"));
}

TEST_CASE("keys and roles of blocks are checked", "[shares]") {
  const Row row;
  CHECK(row.assemble({part(1, HS_ROLE_OWN), part(0, HS_ROLE_EVERYWHERE)}) == HS_ERROR_ARGUMENT);
  CHECK_THAT(row.error(), Catch::Contains("blocks[1].key is 0"));
  CHECK(row.assemble({part(0, HS_ROLE_OWN)}) == HS_ERROR_ARGUMENT);
  CHECK_THAT(row.error(), Catch::Contains("blocks[0].role is 0"));
  CHECK(row.assemble({part(0, 7)}) == HS_ERROR_ARGUMENT);
  CHECK(row.assemble({part(1, HS_ROLE_OWN)}) == HS_ERROR_ARGUMENT);
  CHECK_THAT(row.error(), Catch::Contains("blocks has 0 blocks that are everywhere; from has 1"));
  CHECK(row.assemble({part(0, HS_ROLE_EVERYWHERE), {1, nullptr, 9, HS_ROLE_OWN, 0}}) == HS_ERROR_ARGUMENT);
  CHECK_THAT(row.error(), Catch::Contains("blocks[1].bytes is NULL, but their size is 9"));
  CHECK(row.assemble({part(0, HS_ROLE_EVERYWHERE), part(99, HS_ROLE_OWN)}) == HS_ERROR_STALE_ID);
  CHECK_THAT(row.error(), Catch::Contains("key 99"));
  const std::int64_t falling[] = {5, 4, 3, 2, 1}, keys[] = {10, 20, 30, 40, 50};
  CHECK(hs_world_set_keys(row.world.get(), falling, 5) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_keys(row.world.get(), keys, 4) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_keys(row.world.get(), keys, 5) == HS_OK);
  CHECK(keys_of(row.world.get()) == std::vector<std::int64_t>(keys, keys + 5));
  CHECK(row.assemble({part(10, HS_ROLE_EVERYWHERE), part(30, HS_ROLE_OWN)}) == HS_OK);
}

TEST_CASE("records are of the step of the world that takes them", "[shares]") {
  const Row row;
  const Records records = packed(row.context.get(), row.world.get(), {1}, true);
  const auto assemble = [&] {
    return row.assemble(
        {part(0, HS_ROLE_EVERYWHERE), {1, records.bytes.data(), records.bytes.size(), HS_ROLE_OWN, 0}});
  };
  CHECK(assemble() == HS_OK);
  require_ok(hs_world_step(row.world.get(), 1), row.context.get());
  CHECK(assemble() == HS_ERROR_ARGUMENT);
  CHECK_THAT(row.error(), Catch::Contains("blocks[1].bytes are of another step"));
}

TEST_CASE("a share without any block is no whole world", "[shares]") {
  const Context context = make_context();
  hs_world_def def = world_def();
  def.time_step = 1e-5;
  Stage stage(def, law_of(laws_of_stiffness[0], 1e7, 0.3));
  for (int i = 0; i < 5; ++i) stage.add(stage.rectangle({3.0 * i, 0}, {3.0 * i + 1 + i, 1}), HS_BLOCK_RIGID);
  const World whole = restored(context.get(), saved(stage.world()));
  require_ok(hs_world_step(whole.get(), 1), context.get());
  const auto cut = [&](hs_world* from, const std::vector<hs_packed>& blocks) {
    hs_world* share = nullptr;
    require_ok(hs_world_assemble(context.get(), from, blocks.data(), std::int64_t(blocks.size()), &share),
               context.get());
    return World(share);
  };
  const World empty = cut(whole.get(), {}), again = restored(context.get(), saved(empty.get()));
  const Records records = packed(context.get(), whole.get(), {4}, true);
  for (hs_world* const from : {empty.get(), again.get()}) {
    CHECK(info_of(from).is_whole == 0);
    CHECK(info_of(from).whole_count == 5);
    CHECK(hs_world_step(from, 1) == HS_ERROR_STATE);
    const World filled = cut(from, {{4, records.bytes.data(), records.bytes.size(), HS_ROLE_OWN, 0}});
    CHECK(info_of(filled.get()).whole_count == 5);
    CHECK(info_of(filled.get()).halo == info_of(cut(whole.get(), {part(4, HS_ROLE_OWN)}).get()).halo);
  }
}

TEST_CASE("records tell where they end before there is room for them", "[shares]") {
  const Row row;
  const std::vector<std::int64_t> keys = {3, 1, 2};
  const Records records = packed(row.context.get(), row.world.get(), keys, false);
  std::vector<std::size_t> ends(keys.size());
  std::size_t needed = 0;
  CHECK(hs_world_pack(row.world.get(), keys.data(), 3, 0, nullptr, 0, ends.data(), &needed) ==
        HS_NOTE_TRUNCATED);
  CHECK(needed == records.bytes.size());
  CHECK(ends == records.ends);
}

TEST_CASE("damaged records are refused", "[shares]") {
  const Row row;
  require_ok(hs_world_begin(row.world.get()), row.context.get());
  require_ok(hs_world_end_begin(row.world.get()), row.context.get());
  const Records records = packed(row.context.get(), row.world.get(), {2}, true);
  const auto assemble = [&](const std::vector<unsigned char>& bytes, std::size_t size) {
    return row.assemble({part(0, HS_ROLE_EVERYWHERE), {2, bytes.data(), size, HS_ROLE_OWN, 0}});
  };
  CHECK(assemble(records.bytes, records.bytes.size()) == HS_OK);
  for (std::size_t size = 1; size < records.bytes.size(); ++size)
    REQUIRE(assemble(records.bytes, size) == HS_ERROR_FORMAT);
  // Any other byte gives a world or a refusal.
  for (std::size_t i = 0; i < records.bytes.size(); ++i) {
    for (const int mask : {0x01, 0x80, 0xff}) {
      std::vector<unsigned char> damaged = records.bytes;
      damaged[i] = static_cast<unsigned char>(damaged[i] ^ mask);
      const hs_status status = assemble(damaged, damaged.size());
      REQUIRE((status == HS_OK || status == HS_ERROR_FORMAT || status == HS_ERROR_ARGUMENT));
    }
  }
}

TEST_CASE("copies that do not reach far enough are counted", "[shares]") {
  const std::vector<unsigned char> start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID);
  CHECK(SplitWorld(start, 3, 1, 0.1).lost_pairs() == 0);  // before any list
  SplitWorld near(start, 3, 1, 0.1);
  std::int64_t lost = 0;
  for (int i = 0; i < 2000 && lost == 0; ++i) {
    near.step();
    lost = near.lost_pairs();
  }
  CHECK(lost > 0);
}

TEST_CASE("a run goes on in another number of shares", "[shares]") {
  const std::vector<unsigned char> start = heap_in_plane(laws_of_stiffness[0], HS_BLOCK_RIGID);
  const Context context = make_context();
  const World whole = restored(context.get(), start);
  require_ok(hs_world_step(whole.get(), 3000), context.get());
  SplitWorld first(start, 2);
  for (int i = 0; i < 1500; ++i) first.step();
  for (const std::size_t shares : {1, 3}) {
    SplitWorld second(saved(first.joined().get()), shares);
    for (int i = 0; i < 1500; ++i) second.step();
    const World joined = second.joined();
    CHECK(first_difference(second.context(), joined.get(), context.get(), whole.get()) == "none");
    check_sums(second.sums(), whole.get());
  }
}
