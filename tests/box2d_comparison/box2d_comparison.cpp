// Every scene in twin worlds, stepped side by side, and once more with both narrow phases asked about each
// pair: `box2d_comparison [--quick] [--scene NAME] -o FOLDER` leaves the figures there as CSVs, of which
// page.py makes a page. `--without-forces` leaves out force mode, which takes almost all of the time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "benchmarks/timing.h"
#include "engines.h"
#include "forces.h"
#include "tables.h"

namespace box2d_comparison {
namespace {

/// All, or the first half second.
int steps_in(double seconds, bool quick) {
  const int steps = int(std::lround(seconds / frame_seconds));
  return quick ? std::min(steps, 30) : steps;
}

using Begin = std::function<std::unique_ptr<Engine>(Stage&)>;

/// A scene on its way.
struct Run {
  Run(const Scene& scene, bool quick, float rest_gap, const Begin& begin)
      : stage(std::make_unique<Stage>(rest_gap)) {
    scene.build(*stage);
    engine = begin(*stage);
    for (int i = 0; i < steps_in(scene.settling, quick); ++i) engine->step();
    if (scene.let_go) scene.let_go(*stage);
  }

  std::unique_ptr<Stage> stage;
  std::unique_ptr<Engine> engine;  // ends before its stage
};

/// One of the twins.
struct Twin {
  Twin(const Scene& scene, bool quick, const EngineKind& kind)
      : name(kind.name),
        is_by_itself(kind.is_by_itself),
        run(scene, quick, kind.rest_gap, kind.begin),
        motion(run.stage->world(), scene.drift_axis) {}

  void step() {
    const double seconds = halfspace_benchmark::seconds_of([&] { run.engine->step(); });
    motion.look(seconds);
  }

  std::string name;
  bool is_by_itself;
  Run run;
  Motion motion;
};

/// Step by step in turn, so that what slows the machine slows all; force mode by itself, as its many
/// sub-steps would leave nothing of the others in the caches.
std::vector<Twin> run_twins(const Scene& scene, bool quick) {
  std::vector<Twin> twins;
  for (const EngineKind& kind : engine_kinds(scene.forces)) twins.emplace_back(scene, quick, kind);
  for (int i = 0; i < steps_in(scene.seconds, quick); ++i) {
    for (Twin& twin : twins) {
      if (!twin.is_by_itself) twin.step();
    }
  }
  for (Twin& twin : twins) {
    for (int i = 0; i < steps_in(scene.seconds, quick) && twin.is_by_itself; ++i) twin.step();
  }
  return twins;
}

PairRecorder judge_pairs(const Scene& scene, bool quick) {
  PairRecorder recorder;
  const auto hear = [&](const halfspace::box2d::Comparison& pair) { recorder.hear(pair); };
  const Run run(scene, quick, skins, [&](Stage& stage) { return begin_compared(stage, hear); });
  recorder = PairRecorder();  // nothing of the settling
  for (int i = 0; i < steps_in(scene.seconds, quick); ++i) {
    run.engine->step();
    recorder.end_step();
  }
  return recorder;
}

std::optional<double> stiffness_of(const Scene& scene, b2World& world) {
  if (scene.forces.bearers == 0) return {};
  return force_stiffness(world, scene.forces.bearers);
}

void compare(const Scene& scene, bool quick, Tables& tables) {
  const std::vector<Twin> twins = run_twins(scene, quick);
  const PairRecorder pairs = judge_pairs(scene, quick);
  tables.add(scene, stiffness_of(scene, twins.front().run.stage->world()));
  for (const Twin& twin : twins) {
    const PairQuality* quality = twin.name == "box2d"       ? &pairs.box2d
                                 : twin.name == "halfspace" ? &pairs.halfspace
                                                            : nullptr;
    tables.add(scene, twin.name, twin.motion.rows());
    tables.add(scene, twin.name, twin.run.engine->sub_steps(), summary_of(twin.motion.rows()), quality,
               pairs.quiet_pairs);
  }
}

/// All scenes, or the only one that is wanted.
void run(const std::filesystem::path& folder, std::string_view wanted, bool quick, bool with_forces) {
  std::filesystem::create_directories(folder);
  Tables tables(folder);
  std::vector<Scene> scenes = all_scenes();
  for (Scene& scene : scenes) {
    if (!wanted.empty() && scene.name != wanted) continue;
    if (!with_forces) scene.forces = without_forces("Force mode was left out of this comparison.");
    std::printf("%s\n", scene.title.c_str());
    std::fflush(stdout);
    compare(scene, quick, tables);
  }
}

}  // namespace
}  // namespace box2d_comparison

int main(int argc, char** argv) {
  const std::string folder(halfspace_benchmark::option_value(argc, argv, "-o", ""));
  if (folder.empty()) {
    std::fprintf(stderr, "usage: box2d_comparison [--quick] [--without-forces] [--scene NAME] -o FOLDER\n");
    return 2;
  }
  halfspace_benchmark::pin_to_this_core();
  try {
    box2d_comparison::run(folder, halfspace_benchmark::option_value(argc, argv, "--scene", ""),
                          halfspace_benchmark::has_option(argc, argv, "--quick"),
                          !halfspace_benchmark::has_option(argc, argv, "--without-forces"));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "box2d_comparison: %s\n", error.what());
    return 1;
  }
}
