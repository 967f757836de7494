// Settles scenes, and steps them so that valgrind can count instructions. The script `instructions` runs
// this.
//
//   about                       prints compiler and machine
//   scenes                      their names
//   settle SCENE FILE [STEPS]   saves the state at rest; gives up after so many steps. Returns 3 where the
//                               library is an earlier one, which lacks what the scene needs
//   count SCENE FILE            restores it, steps, and prints how many blocks took how many steps

#include <cstdio>
#include <fstream>
#include <iterator>

#include "counted_pairs.h"
#include "counted_scenes.h"

/// What callgrind counts, by this name.
extern "C" [[gnu::noinline]] void counted(const std::function<void()>& work) { work(); }

namespace halfspace_benchmark {
namespace {

using halfspace_test::require_ok;
using halfspace_test::World;

constexpr int counted_steps = 20, pair_count = 200;
constexpr int uncounted_steps = 3;  // the first ones after a restore build the neighbour list
constexpr long most_steps = 200000;

struct PairScene {
  const char* name;
  int dimension;
};
constexpr PairScene pair_scenes[] = {{"pair-polygons", 2}, {"pair-polyhedra", 3}};

std::string compiler() {
#ifdef __clang__
  const std::string name = "clang++ " __clang_version__;
#else
  const std::string name = "g++ " __VERSION__;
#endif
#ifdef __OPTIMIZE__
  return name + ", optimized";
#else
  return name + ", not optimized";
#endif
}

std::string machine() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") ? "x86_64 with AVX2" : "x86_64 without AVX2";
#elif defined __aarch64__
  return "aarch64";
#else
  return "other";
#endif
}

hs_world_report report_of(const World& world, const hs_context* context) {
  hs_world_report report{};
  require_ok(hs_world_get_report(world.get(), &report, sizeof report), context);
  return report;
}

std::string not_settled(const CountedScene& scene, const hs_world_report& report) {
  char text[200];
  std::snprintf(text, sizeof text,
                "%s has not settled in %lld steps: a block has %.2g m/s, at rest less than %.2g m/s, or the "
                "solver goes on",
                scene.name.c_str(), static_cast<long long>(report.steps), report.largest_speed, scene.rest);
  return text;
}

/// Saves the state at rest: all blocks are slow, and laws without springs have nothing left to solve.
void settle(const CountedScene& scene, const char* path, long give_up_after) {
  const halfspace_test::Context context = halfspace_test::make_context();
  const World world = scene.make(context.get());
  hs_world_report report{};
  bool is_settled = false;
  do {
    const std::int64_t iterations = report.iteration_count;
    require_ok(hs_world_step(world.get(), scene.wait), context.get());
    report = report_of(world, context.get());
    is_settled = report.largest_speed <= scene.rest && report.iteration_count == iterations;
  } while (!is_settled && report.steps < give_up_after);
  if (!is_settled) throw std::runtime_error(not_settled(scene, report));
  std::size_t size = 0;
  (void)hs_world_save(world.get(), nullptr, 0, &size);  // which tells how many bytes there are
  std::vector<char> bytes(size);
  require_ok(hs_world_save(world.get(), bytes.data(), size, &size), context.get());
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), std::streamsize(size));
  if (!file.flush()) throw std::runtime_error(std::string("cannot write ") + path);
}

void count_steps(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  const halfspace_test::Context context = halfspace_test::make_context();
  hs_world* made = nullptr;
  require_ok(hs_world_restore(context.get(), bytes.data(), bytes.size(), &made), context.get());
  const World world(made);
  require_ok(hs_world_step(made, uncounted_steps), context.get());
  counted([&] { require_ok(hs_world_step(made, counted_steps), context.get()); });
  std::printf("%lld %d\n", static_cast<long long>(report_of(world, context.get()).block_count),
              counted_steps);
}

void count_pairs(int dimension) {
  const halfspace_test::Context context = halfspace_test::make_context();
  CountedPairs pairs(context.get(), dimension, pair_count);
  for (int i = 0; i < uncounted_steps; ++i) pairs.detect();
  counted([&] {
    for (int i = 0; i < counted_steps; ++i) pairs.detect();
  });
  std::printf("%d %d\n", pair_count, counted_steps);
}

int dimension_of_pairs(const std::string& scene) {
  for (const PairScene& pairs : pair_scenes)
    if (pairs.name == scene) return pairs.dimension;
  return 0;
}

CountedScene scene_of(const std::string& name) {
  for (const CountedScene& scene : counted_scenes())
    if (scene.name == name) return scene;
  throw std::runtime_error("there is no scene " + name);
}

void print_scenes() {
  for (const CountedScene& scene : counted_scenes()) std::printf("%s\n", scene.name.c_str());
  for (const PairScene& scene : pair_scenes) std::printf("%s\n", scene.name);
}

void run(const std::vector<std::string>& given) {
  const std::string command = given.empty() ? "" : given[0];
  if (command == "about") {
    std::printf("%s\n%s\n", compiler().c_str(), machine().c_str());
  } else if (command == "scenes") {
    print_scenes();
  } else if (given.size() < 3 || (command != "settle" && command != "count")) {
    throw std::runtime_error("usage: about | scenes | settle SCENE FILE [STEPS] | count SCENE FILE");
  } else if (const int dimension = dimension_of_pairs(given[1])) {
    if (command == "count") count_pairs(dimension);  // they need not settle
  } else if (command == "count") {
    count_steps(given[2].c_str());
  } else {
    settle(scene_of(given[1]), given[2].c_str(), given.size() > 3 ? std::stol(given[3]) : most_steps);
  }
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  try {
    halfspace_benchmark::run({argv + 1, argv + argc});
  } catch (const halfspace_benchmark::NotOffered& error) {
    std::fprintf(stderr, "count_instructions: this library cannot run it: %s\n", error.what());
    return 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "count_instructions: %s\n", error.what());
    return 1;
  }
}
