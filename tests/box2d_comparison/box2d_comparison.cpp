// Every scene in twin worlds, stepped side by side, and once more with both narrow phases asked about each
// pair: `box2d_comparison [--quick] -o FOLDER` leaves the figures there as CSVs, of which page.py makes a
// page.

#include <cmath>
#include <cstdio>
#include <exception>

#include "benchmarks/timing.h"
#include "engines.h"
#include "tables.h"

namespace box2d_comparison {
namespace {

int steps_in(double seconds) { return int(std::lround(seconds / frame_seconds)); }

using Begin = std::function<std::unique_ptr<Engine>(Stage&)>;

/// A scene on its way.
struct Run {
  Run(const Scene& scene, const Begin& begin) : stage(std::make_unique<Stage>()) {
    scene.build(*stage);
    engine = begin(*stage);
    for (int i = 0; i < steps_in(scene.settling); ++i) engine->step();
    if (scene.let_go) scene.let_go(*stage);
  }

  std::unique_ptr<Stage> stage;
  std::unique_ptr<Engine> engine;  // ends before its stage
};

/// One of the twins.
struct Twin {
  Twin(const Scene& scene, const EngineKind& kind)
      : name(kind.name), run(scene, kind.begin), motion(run.stage->world(), scene.drift_axis) {}

  void step() {
    const double seconds = halfspace_benchmark::seconds_of([&] { run.engine->step(); });
    motion.look(seconds);
  }

  std::string name;
  Run run;
  Motion motion;
};

/// Step by step in turn, so that what slows the machine slows all.
std::vector<Twin> run_twins(const Scene& scene, int steps) {
  std::vector<Twin> twins;
  for (const EngineKind& kind : engine_kinds()) twins.emplace_back(scene, kind);
  for (int i = 0; i < steps; ++i) {
    for (Twin& twin : twins) twin.step();
  }
  return twins;
}

PairRecorder judge_pairs(const Scene& scene, int steps) {
  PairRecorder recorder;
  const auto hear = [&](const halfspace::box2d::Comparison& pair) { recorder.hear(pair); };
  const Run run(scene, [&](Stage& stage) { return begin_compared(stage, hear); });
  recorder = PairRecorder();  // nothing of the settling
  for (int i = 0; i < steps; ++i) {
    run.engine->step();
    recorder.end_step();
  }
  return recorder;
}

void compare(const Scene& scene, bool quick, Tables& tables) {
  const int steps = quick ? 30 : steps_in(scene.seconds);
  const std::vector<Twin> twins = run_twins(scene, steps);
  const PairRecorder pairs = judge_pairs(scene, steps);
  tables.add(scene);
  for (const Twin& twin : twins) {
    const PairQuality* quality = twin.name == "box2d"       ? &pairs.box2d
                                 : twin.name == "halfspace" ? &pairs.halfspace
                                                            : nullptr;
    tables.add(scene, twin.name, twin.motion.rows());
    tables.add(scene, twin.name, summary_of(twin.motion.rows()), quality, pairs.quiet_pairs);
  }
}

void run(const std::filesystem::path& folder, bool quick) {
  std::filesystem::create_directories(folder);
  Tables tables(folder);
  for (const Scene& scene : all_scenes()) {
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
    std::fprintf(stderr, "usage: box2d_comparison [--quick] -o FOLDER\n");
    return 2;
  }
  halfspace_benchmark::pin_to_this_core();
  try {
    box2d_comparison::run(folder, halfspace_benchmark::has_option(argc, argv, "--quick"));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "box2d_comparison: %s\n", error.what());
    return 1;
  }
}
