// Every function of the C API, with each of its allocations failing in turn.

#include <algorithm>
#include <fstream>
#include <iterator>

#include "capi/seen.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// Not within a step in pieces.
bool can_be_saved(const Scene& scene) {
  std::size_t size = 0;
  return scene.world && hs_world_save(scene.world.get(), nullptr, 0, &size) == HS_OK;
}

/// All that a call has led to: what is written and the whole state of a world that can be saved, what it
/// keeps to itself included.
using Ending = std::pair<std::vector<unsigned char>, std::vector<unsigned char>>;
Ending ending(const Scene& scene) {
  Ending end{seen(scene), {}};
  if (can_be_saved(scene)) end.second = saved(scene.world.get());
  return end;
}

std::unique_ptr<Scene> scene_for(const EntryPoint& entry, int dimension) {
  auto scene = std::make_unique<Scene>(dimension);
  if (entry.arrange) entry.arrange(*scene);
  return scene;
}

void check_all_is_given_back(std::unique_ptr<Scene> scene) {
  scene->made = {};
  scene->world.reset();
  scene->bar.reset();
  scene->round.reset();
  scene->box.reset();
  scene->context.reset();
  CHECK(scene->ledger.bytes_in_use() == 0);
  CHECK(scene->ledger.mismatches == 0);
}

/// The first step is under way: it is one that fast blocks divide, and some of its parts are made.
bool is_between_parts(const Scene& scene) {
  if (!scene.world) return false;
  const hs_world_report report = report_of(scene.world.get());
  return report.steps == 0 && report.time > 0;
}

/// Steps and detection may have another list of pairs before memory runs out. All other calls leave every
/// byte of a snapshot as it was.
bool leaves_all_bytes(const EntryPoint& entry) {
  static const std::vector<std::string> others = {
      "hs_world_step",  "hs_world_relax",       "hs_world_detect",    "hs_world_forces",
      "hs_world_begin", "hs_world_plan_motion", "hs_world_renew_list"};
  return std::find(others.begin(), others.end(), entry.name) == others.end();
}

/// Fails allocation n of a call, if it comes to that: then nothing may have changed, but for the good parts
/// of a step, and the next try does what the call does undisturbed. Was there an allocation n?
bool survives_failure(const EntryPoint& entry, int dimension, long n, const Ending& expected) {
  std::unique_ptr<Scene> scene = scene_for(entry, dimension);
  const std::vector<unsigned char> before = seen(*scene);
  const bool could_be_saved = can_be_saved(*scene);
  const std::vector<unsigned char> state = could_be_saved ? saved(scene->world.get()) : before;
  scene->ledger.fail_at = scene->ledger.allocations + n;
  const hs_status status = entry.call(*scene);
  const bool failed = scene->ledger.allocations > scene->ledger.fail_at;
  CHECK(status == (failed ? HS_ERROR_OUT_OF_MEMORY : HS_OK));
  if (failed) {
    const bool unchanged = seen(*scene) == before;
    CHECK((unchanged || is_between_parts(*scene)));
    if (could_be_saved && leaves_all_bytes(entry)) {
      const bool is_same_state = saved(scene->world.get()) == state;
      CHECK(is_same_state);
    }
    if (could_be_saved) CHECK_NOTHROW(restored(scene->context.get(), saved(scene->world.get())));
    CHECK(entry.call(*scene) == HS_OK);
  }
  const bool ends_the_same = ending(*scene) == expected;
  CHECK(ends_the_same);
  check_all_is_given_back(std::move(scene));
  return failed;
}

/// Fails each allocation of a call in turn.
void survive_every_failure(const EntryPoint& entry, int dimension) {
  const std::unique_ptr<Scene> undisturbed = scene_for(entry, dimension);
  REQUIRE(entry.call(*undisturbed) == HS_OK);
  const Ending expected = ending(*undisturbed);
  long n = 0;
  for (bool failed = true; failed; ++n) {
    INFO(entry.name << " in " << dimension << "D, allocation " << n << " fails");
    failed = survives_failure(entry, dimension, n, expected);
  }
  INFO(entry.name << " in " << dimension << "D: " << n - 1 << " allocations");
  const bool allocates =
      entry.allocates == Allocates::always || (entry.allocates == Allocates::in_the_plane && dimension == 2);
  CHECK((n > 1) == allocates);
}

}  // namespace

TEST_CASE("every exported function is among the entry points") {
  std::vector<std::string> called;
  for (const EntryPoint& entry : entry_points()) called.push_back(entry.name);
  called.push_back("hs_task_run");  // called within steps: see world_threads.cpp
  std::sort(called.begin(), called.end());
  std::ifstream ledger(HALFSPACE_SYMBOLS);
  const std::vector<std::string> exported{std::istream_iterator<std::string>(ledger),
                                          std::istream_iterator<std::string>()};
  CHECK(called == exported);
}

TEST_CASE("any allocation of any function may fail") {
  const int dimension = GENERATE(2, 3);
  for (const EntryPoint& entry : entry_points()) survive_every_failure(entry, dimension);
}

TEST_CASE("any allocation of a call on a world with bodies and bonds may fail") {
  const int dimension = GENERATE(2, 3);
  for (const EntryPoint& entry : calls_on_bodies_and_bonds()) survive_every_failure(entry, dimension);
}

TEST_CASE("any allocation of a call on a world with actions may fail") {
  const int dimension = GENERATE(2, 3);
  for (const EntryPoint& entry : calls_on_worlds_with_actions()) survive_every_failure(entry, dimension);
}

TEST_CASE("any allocation of a step from a changed world may fail") {
  const int dimension = GENERATE(2, 3);
  for (const EntryPoint& entry : steps_of_changed_worlds()) survive_every_failure(entry, dimension);
}

}  // namespace halfspace_test
