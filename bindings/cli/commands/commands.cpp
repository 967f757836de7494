#include "commands/commands.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

#include "common/interrupt.h"
#include "model/model.h"
#include "notes/notes.h"
#include "run/checkpoint.h"

namespace halfspace::cli {
namespace {

void print_files(const OutputDirectory& directory) {
  std::size_t frames = 0;
  std::string others;
  for (const std::string& name : directory.written()) {
    if (name.starts_with("frames/frame_")) {
      ++frames;
    } else if (!name.starts_with("frames/")) {
      others += "  " + (directory.path() / name).string() + '\n';
    }
  }
  print(stdout, "files written\n" + others + "  " + (directory.path() / "frames").string() + "/ (" +
                    std::to_string(frames) + " frames)\n");
}

/// True if the file is in the directory.
bool is_in(const std::string& file, const std::string& directory) {
  return std::filesystem::weakly_canonical(file).parent_path() ==
         std::filesystem::weakly_canonical(directory);
}

}  // namespace

OutputDirectory directory_of(const Target& target, bool resumes, const std::string& file) {
  if (resumes && !std::filesystem::exists(std::filesystem::path(target.directory) / file))
    throw std::runtime_error("cannot resume: there is no " + file + " in " + target.directory);
  return OutputDirectory(target.directory, resumes ? Earlier::keep : target.earlier);
}

RunStart begin_run(const Target& target, RunOptions options, const std::string& from) {
  Earlier earlier = target.earlier;
  if (!from.empty()) {
    options.from = open_checkpoint(from);
    const bool is_same = is_in(from, target.directory);
    if (is_same) earlier = Earlier::keep;
    options.resumes_in_place =
        is_same && std::filesystem::exists(std::filesystem::path(target.directory) / frame_name(0));
  }
  return {std::move(options), OutputDirectory(target.directory, earlier)};
}

int check(const SceneFile& file) {
  CheckedScene checked = load(file, 1);
  if (!checked.faults.none()) return refuse(file, checked.faults);
  const Model model(checked.context, checked.scene, std::move(checked.layout));
  require_time_step(checked.context, checked.scene, model);
  note_start(checked.context, checked.scene, model, checked.faults);
  std::string text = file.path + ": no faults, " + std::to_string(model.layout().blocks.size()) + " blocks";
  if (model.layout().left_out > 0)
    text += ", " + std::to_string(model.layout().left_out) + " left out as too small";
  print(stdout, text + '\n' + checked.faults.describe_notes(file.path));
  return exit_ok;
}

int run(const SceneFile& file, const Target& target, RunOptions options, const std::string& from,
        RunResult& result) {
  CheckedScene checked = load(file, target.threads);
  if (!checked.faults.none()) return refuse(file, checked.faults);
  RunStart start = begin_run(target, std::move(options), from);
  OutputDirectory& directory = start.directory;
  Model model(checked.context, checked.scene, std::move(checked.layout));
  require_time_step(checked.context, checked.scene, model);
  note_start(checked.context, checked.scene, model, checked.faults);
  print(stderr, checked.faults.describe_notes(file.path));
  remember_interrupts();
  result = run_scene(checked.scene, model, checked.faults.describe_notes("scene"), start.options, directory);
  print(stdout, result.summary + result.timings);
  print_files(directory);
  if (result.outcome == Outcome::unstable) {
    print(stderr, "halfspace: unstable run: " + result.trouble + '\n');
    return exit_unstable;
  }
  if (result.outcome == Outcome::too_fast) {
    print(stderr, "halfspace: " + result.trouble +
                      R"(; give that time_step in [world], or fast_blocks = "divide")"
                      "\n");
    return exit_unstable;
  }
  if (result.outcome == Outcome::interrupted)
    print(stderr, "halfspace: interrupted; --from " + (directory.path() / checkpoint_name).string() +
                      " resumes it\n");
  return result.outcome == Outcome::interrupted ? exit_failed : exit_ok;
}

int trade(const SceneFile& file, const Target& target, const TradeOptions& options) {
  CheckedScene checked = load(file, 0);
  require_free_block(checked, "a trade");
  if (!checked.faults.none()) return refuse(file, checked.faults);
  OutputDirectory directory = directory_of(target, options.resumes, "trade.csv");
  checked.scene.output.track_nothing();  // another setting may have other cells
  const TradeResult result = trade(checked.scene, bytes_of(file, checked.scene), options, directory);
  print(stdout, result.report);
  if (result.is_interrupted) print(stderr, "\nhalfspace: interrupted; --resume continues\n");
  if (result.is_interrupted) return exit_failed;
  return result.has_results ? exit_ok : exit_unstable;
}

int plan(const SceneFile& file, const PlanOptions& options) {
  CheckedScene checked = load(file, 0);
  require_free_block(checked, "a plan");
  if (options.time > 0 && !checked.scene.stages.empty())
    checked.faults.add({}, "stage", "a plan runs all stages; allowed: no --time");
  if (!checked.faults.none()) return refuse(file, checked.faults);
  checked.scene.output.track_nothing();  // the tracked blocks may be cells, which a run may be without
  const PlanResult result = plan(checked.scene, options);
  print(stdout, result.report);
  switch (result.end) {
    case RunEnd::whole:
      return exit_ok;
    case RunEnd::interrupted:
      print(stderr, "\nhalfspace: interrupted\n");
      return exit_failed;
    case RunEnd::too_few_steps:
      print(stderr, "halfspace: --time is too short: fewer than ten steps\n");
      return exit_failed;
    default:
      print(stderr, "halfspace: the scene does not run to its end\n");
      return exit_unstable;
  }
}

int safety(const SceneFile& file, const Target& target, const SearchOptions& options, SearchResult& result) {
  if (!(options.low < options.high)) {
    print(stderr, "--low: must be below --high\n");
    return exit_usage;
  }
  CheckedScene checked = load(file, target.threads);
  require_free_block(checked, "a factor of safety");
  if (!checked.faults.none()) return refuse(file, checked.faults);
  OutputDirectory directory = directory_of(target, options.resumes, "trials.csv");
  const auto model = std::make_shared<Model>(checked.context, checked.scene, std::move(checked.layout));
  note_start(checked.context, checked.scene, *model, checked.faults);
  print(stderr, checked.faults.describe_notes(file.path));
  remember_interrupts();
  result = find_factor_of_safety(checked.scene, model, bytes_of(file, checked.scene), options, directory);
  print(stdout, result.report);
  if (result.end == SearchEnd::interrupted) print(stderr, "\nhalfspace: interrupted; --resume continues\n");
  return result.end == SearchEnd::found ? exit_ok : exit_failed;
}

}  // namespace halfspace::cli
