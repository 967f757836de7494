// Every function of a world at every piece of a step in pieces (share.h): it is done as between whole steps,
// or refused by name, and then nothing has changed.

#include <algorithm>

#include "capi/seen.h"
#include "catch.h"

namespace halfspace_test {
namespace {

enum class Piece { ready, planned, listed, begun, moved };
constexpr Piece all_pieces[] = {Piece::ready, Piece::planned, Piece::listed, Piece::begun, Piece::moved};
constexpr const char* names[] = {"ready", "planned", "listed", "begun", "moved"};

bool is_within(Piece piece) { return piece == Piece::begun || piece == Piece::moved; }

bool is_one_of(const std::string& name, const std::vector<std::string>& all) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

/// The pieces at which the functions that make a step in pieces are called.
bool is_done_at(const std::string& name, Piece piece) {
  if (name == "hs_world_begin") return piece != Piece::moved;
  if (name == "hs_world_end_begin") return piece == Piece::begun;
  if (name == "hs_world_renew_list" || name == "hs_world_move")
    return piece == Piece::planned || piece == Piece::listed;
  if (name == "hs_world_end_step") return piece == Piece::moved;
  if (is_one_of(name, {"hs_world_get_loads", "hs_world_set_loads"})) return is_within(piece);
  const bool needs_contacts = is_one_of(name, {"hs_world_forces", "hs_world_set_shear_force"});
  if (needs_contacts && piece == Piece::listed) return false;  // a new list needs detection
  return !is_within(piece);
}

bool is_piece(const std::string& name) {
  return is_one_of(name,
                   {"hs_world_begin", "hs_world_end_begin", "hs_world_plan_motion", "hs_world_renew_list",
                    "hs_world_move", "hs_world_get_loads", "hs_world_set_loads", "hs_world_end_step"});
}

/// Reads the world, and may do so at any piece.
bool is_query(const std::string& name) {
  constexpr const char* get = "hs_world_get_";
  return (name.rfind(get, 0) == 0 && !is_one_of(name, {"hs_world_get_balance", "hs_world_get_loads"})) ||
         is_one_of(name, {"hs_world_cast_ray", "hs_world_check", "hs_world_detect"}) ||
         name.rfind("hs_world_", 0) != 0 ||
         is_one_of(name, {"hs_world_def_init", "hs_world_create", "hs_world_destroy", "hs_world_restore"});
}

/// Some scenes are arranged within a step.
void end_piece(hs_world* world) {
  if (hs_world_end_step(world) != HS_OK) (void)hs_world_end_begin(world);
}

/// False where the world has what shares cannot hold.
bool enter(hs_world* world, Piece piece) {
  hs_share_plan plan;
  if (hs_world_begin(world) != HS_OK) return false;
  if (piece == Piece::begun) return true;
  REQUIRE(hs_world_end_begin(world) == HS_OK);
  if (piece == Piece::ready) return true;
  REQUIRE(hs_world_plan_motion(world, &plan) == HS_OK);
  REQUIRE(plan.refusal == HS_OK);
  if (piece == Piece::planned) return true;
  REQUIRE(hs_world_renew_list(world, &plan) == HS_OK);
  if (piece == Piece::listed) return true;
  REQUIRE(hs_world_move(world) == HS_OK);
  return true;
}

/// Ends the step that is under way, or makes one.
hs_status finish(hs_world* world) {
  if (hs_world_end_step(world) == HS_OK) return HS_OK;
  if (hs_world_move(world) == HS_OK) return hs_world_end_step(world);
  (void)hs_world_end_begin(world);
  return hs_world_step(world, 1);
}

std::unique_ptr<Scene> scene_at(const EntryPoint& entry, int dimension, Piece piece) {
  auto scene = std::make_unique<Scene>(dimension);
  if (entry.arrange) entry.arrange(*scene);
  end_piece(scene->world.get());
  require_ok(hs_world_set_time_step(scene->world.get(), 1e-5), scene->context.get());
  return enter(scene->world.get(), piece) ? std::move(scene) : nullptr;
}

/// The world after its next step, where the call was made between steps; or without it, where that refuses
/// it.
std::vector<unsigned char> expected(const EntryPoint& entry, int dimension, Piece piece) {
  const std::unique_ptr<Scene> scene = scene_at(entry, dimension, piece);
  if (is_query(entry.name) || is_done_at(entry.name, piece)) {
    // Without a change nothing begins, but a planned motion ends.
    if (!is_within(piece)) {
      REQUIRE(hs_world_begin(scene->world.get()) == HS_OK);
      REQUIRE(hs_world_end_begin(scene->world.get()) == HS_OK);
    }
    REQUIRE(entry.call(*scene) >= HS_OK);
  }
  (void)finish(scene->world.get());
  return saved(scene->world.get());
}

void check_call(const EntryPoint& entry, int dimension, Piece piece) {
  const std::unique_ptr<Scene> scene = scene_at(entry, dimension, piece);
  const hs_status status = entry.call(*scene);
  if (is_query(entry.name) || is_done_at(entry.name, piece)) {
    CHECK(status >= HS_OK);  // hs_world_save() tells the size
  } else {
    CHECK(status == HS_ERROR_STATE);
    const std::string text = hs_context_last_error(scene->context.get());
    INFO(text);
    CHECK(text.find("call hs_world_") != std::string::npos);
  }
  if (is_piece(entry.name)) return;
  (void)finish(scene->world.get());
  const bool is_as_expected = saved(scene->world.get()) == expected(entry, dimension, piece);
  CHECK(is_as_expected);
}

}  // namespace

TEST_CASE("every call at every piece of a step is done as between steps, or refused by name") {
  const int dimension = GENERATE(2, 3);
  int calls = 0;
  for (const EntryPoint& entry : entry_points()) {
    if (!scene_at(entry, dimension, Piece::ready)) continue;  // shares hold no world of its arrangement
    for (const Piece piece : all_pieces) {
      INFO(entry.name << " in " << dimension << "D, " << names[int(piece)]);
      check_call(entry, dimension, piece);
      ++calls;
    }
  }
  CHECK(calls > 5 * 80);
}

}  // namespace halfspace_test
