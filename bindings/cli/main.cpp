#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "common/files.h"
#include "common/suggestion.h"
#include "model/layout.h"
#include "model/library.h"
#include "model/model.h"
#include "notes/notes.h"
#include "run/checkpoint.h"
#include "run/run.h"
#include "scene/faults.h"
#include "scene/read_scene.h"
#include "studies/plan/plan.h"
#include "studies/safety/safety.h"
#include "studies/trade/trade.h"

namespace halfspace::cli {
namespace {

enum ExitCode { exit_ok = 0, exit_failed = 1, exit_usage = 2, exit_unstable = 3 };

void print(std::FILE* stream, const std::string& text) { std::fputs(text.c_str(), stream); }

/// A scene, its blocks and the context that owns them; complete only without faults.
struct CheckedScene {
  Context context;
  Scene scene;
  Layout layout;
  Faults faults;
};

/// With 0 threads the scene gives their number.
CheckedScene load(const std::string& file, int threads) {
  CheckedScene checked;
  checked.scene = read_scene(file, checked.faults);
  if (threads > 0) checked.scene.threads = threads;
  checked.context = make_context(checked.scene.threads);
  checked.layout = lay_out_blocks(checked.context, checked.scene, checked.faults);
  return checked;
}

int refuse(const std::string& file, const Faults& faults) {
  print(stderr, faults.describe(file));
  print(stderr,
        std::to_string(faults.count()) + (faults.count() == 1 ? " fault in " : " faults in ") + file + '\n');
  return exit_failed;
}

int check(const std::string& file) {
  CheckedScene checked = load(file, 1);
  if (!checked.faults.none()) return refuse(file, checked.faults);
  const Model model(checked.context, checked.scene, std::move(checked.layout));
  note_start(checked.context, checked.scene, model, checked.faults);
  std::string text = file + ": no faults, " + std::to_string(model.layout().blocks.size()) + " blocks";
  if (model.layout().left_out > 0)
    text += ", " + std::to_string(model.layout().left_out) + " left out as too small";
  print(stdout, text + '\n' + checked.faults.describe_notes(file));
  return exit_ok;
}

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

int run(const std::string& file, const std::string& output, Earlier earlier, int threads, RunOptions options,
        const std::string& from) {
  CheckedScene checked = load(file, threads);
  if (!checked.faults.none()) return refuse(file, checked.faults);
  if (!from.empty()) {
    options.from = open_checkpoint(from);
    if (is_in(from, output)) earlier = Earlier::keep;
    options.resumes_in_place =
        is_in(from, output) && std::filesystem::exists(std::filesystem::path(output) / frame_name(0));
  }
  OutputDirectory directory(output, earlier);
  Model model(checked.context, checked.scene, std::move(checked.layout));
  note_start(checked.context, checked.scene, model, checked.faults);
  print(stderr, checked.faults.describe_notes(file));
  const RunResult result =
      run_scene(checked.scene, model, checked.faults.describe_notes("scene"), options, directory);
  print(stdout, result.summary + result.timings);
  print_files(directory);
  if (result.outcome == Outcome::unstable) {
    print(stderr, "halfspace: unstable run: " + result.trouble + "; reduce time_step or safety in [world]\n");
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

/// The bytes of a scene: its own file, and the files of its blocks and meshes.
std::string bytes_of(const std::string& file, const Scene& scene) {
  std::string bytes = content_of(file);
  for (const Block& block : scene.blocks)
    if (!block.file.empty()) bytes += content_of(block.file);
  for (const Mesh& mesh : scene.meshes)
    if (!mesh.file.empty()) bytes += content_of(mesh.file);
  return bytes;
}

void require_free_block(CheckedScene& checked, const std::string& by) {
  const auto is_free = [](const LayoutBlock& block) { return moves_freely(block.kind); };
  const std::vector<LayoutBlock>& blocks = checked.layout.blocks;
  if (checked.faults.none() && std::none_of(blocks.begin(), blocks.end(), is_free))
    checked.faults.add({}, "", "no free block; required for " + by + ": a rigid, affine or mesh block");
}

int trade(const std::string& file, const std::string& output, Earlier earlier, const TradeOptions& options) {
  CheckedScene checked = load(file, 0);
  require_free_block(checked, "a trade");
  if (!checked.faults.none()) return refuse(file, checked.faults);
  if (options.resumes && !std::filesystem::exists(std::filesystem::path(output) / "trade.csv"))
    throw std::runtime_error("cannot resume: there is no trade.csv in " + output);
  OutputDirectory directory(output, options.resumes ? Earlier::keep : earlier);
  checked.scene.output.tracked.clear();  // another setting may have other cells
  const TradeResult result = trade(checked.scene, bytes_of(file, checked.scene), options, directory);
  print(stdout, result.report);
  if (result.is_interrupted) print(stderr, "\nhalfspace: interrupted; --resume continues\n");
  if (result.is_interrupted) return exit_failed;
  return result.has_results ? exit_ok : exit_unstable;
}

int plan(const std::string& file, const PlanOptions& options) {
  CheckedScene checked = load(file, 0);
  require_free_block(checked, "a plan");
  if (options.time > 0 && !checked.scene.stages.empty())
    checked.faults.add({}, "stage", "a plan runs all stages; allowed: no --time");
  if (!checked.faults.none()) return refuse(file, checked.faults);
  checked.scene.output.tracked.clear();  // the tracked blocks may be cells, which a run may be without
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

int safety(const std::string& file, const std::string& output, Earlier earlier, int threads,
           const SafetyOptions& options) {
  if (!(options.low < options.high)) {
    print(stderr, "--low: must be below --high\n");
    return exit_usage;
  }
  CheckedScene checked = load(file, threads);
  require_free_block(checked, "a factor of safety");
  for (const SceneStage& stage : checked.scene.stages) {
    if (stage.settles) continue;
    checked.faults.add({}, "stage",
                       "a factor of safety requires a scene at rest; allowed: stages that settle");
    break;
  }
  if (!checked.faults.none()) return refuse(file, checked.faults);
  if (options.resumes && !std::filesystem::exists(std::filesystem::path(output) / "trials.csv"))
    throw std::runtime_error("cannot resume: there is no trials.csv in " + output);
  OutputDirectory directory(output, options.resumes ? Earlier::keep : earlier);
  Model model(checked.context, checked.scene, std::move(checked.layout));
  note_start(checked.context, checked.scene, model, checked.faults);
  print(stderr, checked.faults.describe_notes(file));
  const SafetyResult result =
      find_factor_of_safety(checked.scene, model, bytes_of(file, checked.scene), options, directory);
  print(stdout, result.report);
  if (result.end == SafetyEnd::interrupted) print(stderr, "\nhalfspace: interrupted; --resume continues\n");
  return result.end == SafetyEnd::found ? exit_ok : exit_failed;
}

/// A time in s, as 90s, 10min or 2h.
CLI::AsNumberWithUnit time_with_unit() {
  return CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"min", 60}, {"h", 3600}});
}

/// A separate check, as NaN is within all ranges of CLI11.
CLI::Validator finite_above_zero() {
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0;
        const bool is_number = CLI::detail::lexical_cast(text, value);
        return is_number && std::isfinite(value) && value > 0 ? std::string()
                                                              : "must be a number above 0: " + text;
      },
      "ABOVE ZERO");
}

/// The error text for an unknown command or option; else empty.
std::string unknown_word(const CLI::App& app, const std::vector<std::string>& words) {
  if (app.get_subcommands().empty()) {
    const auto is_option = [](const std::string& word) { return word.starts_with('-'); };
    const auto word = std::find_if_not(words.begin(), words.end(), is_option);
    if (word == words.end()) return {};
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
    std::string allowed;
    for (const std::string& name : names) allowed += (allowed.empty() ? "" : ", ") + name;
    return "unknown command: \"" + *word + '"' + suggestion(*word, {names.begin(), names.end()}) +
           "; allowed: " + allowed + "\nRun with --help for more information.\n";
  }
  const CLI::App* command = app.get_subcommands()[0];
  std::vector<std::string> names;
  for (const CLI::Option* option : command->get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const std::string& word : command->remaining()) {
    if (!word.starts_with("--")) continue;
    return "unknown option: " + word +
           suggestion(word.substr(0, word.find('=')), {names.begin(), names.end()}) + "\nRun with " +
           command->get_name() + " --help for more information.\n";
  }
  return {};
}

int main_of(int argc, char** argv) {
  CLI::App app("Moves convex blocks in contact, from a scene file to pictures.", "halfspace");
  app.set_version_flag("--version", std::string("halfspace ") + hs_version());
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 ok, 1 failed or faulty scene, 2 wrong usage, 3 unstable run, or blocks too fast for it "
      "(its output is kept).");

  std::string file;
  std::string output;
  bool force = false;
  int threads = 0;
  CLI::App* run_command = app.add_subcommand("run", "Run a scene");
  run_command->add_option("scene", file, "The scene file (TOML)")->required();
  const auto add_output = [&](CLI::App* command) {
    command->add_option("-o,--output", output, "Directory for the output; made if missing")->required();
    return command->add_flag("--force", force, "Replace an earlier run in the directory");
  };
  add_output(run_command);
  const auto add_threads = [&](CLI::App* command) {
    command
        ->add_option("-j,--threads", threads,
                     "Number of threads; overrides the scene; the output has the same bytes for any number")
        ->check(CLI::Range(1, max_threads));
  };
  add_threads(run_command);
  RunOptions run_options;
  std::string from;
  run_command->add_option(
      "--from", from,
      "Resume from a checkpoint of an earlier run of the scene; later stages, the duration "
      "and the output may have changed");
  run_command
      ->add_option("--checkpoint-every", run_options.checkpoint_interval,
                   "Wall time between two checkpoints, as 90s, 10min or 2h; 10min by default")
      ->transform(time_with_unit())
      ->check(finite_above_zero());
  CLI::App* check_command = app.add_subcommand("check", "List all faults of a scene, without running it");
  check_command->add_option("scene", file, "The scene file (TOML)")->required();

  TradeOptions trade_options;
  CLI::App* trade_command =
      app.add_subcommand("trade", "Vary the parameters of a scene: the error and the cost of each setting");
  trade_command->add_option("scene", file, "The scene file (TOML); [reference] names the measured quantity")
      ->required();
  CLI::Option* force_option = add_output(trade_command);
  trade_command->add_flag("--resume", trade_options.resumes, "Continue from the runs in the directory")
      ->excludes(force_option);
  trade_command->add_option("--tolerance", trade_options.tolerance, "Max error of the cheapest setting")
      ->capture_default_str()
      ->check(finite_above_zero());
  trade_command
      ->add_option("--budget", trade_options.budget,
                   "Time for all runs, as 90s, 10min or 2h; none by default")
      ->transform(time_with_unit())
      ->check(finite_above_zero());

  PlanOptions plan_options;
  CLI::App* plan_command = app.add_subcommand(
      "plan", "Report the active parts of a scene, their cost, and the parts that could be left out");
  plan_command->add_option("scene", file, "The scene file (TOML)")->required();
  plan_command
      ->add_option("--time", plan_options.time, "Simulated time in s; the scene's duration by default")
      ->check(finite_above_zero());
  plan_command
      ->add_option("--tolerance", plan_options.tolerance,
                   "Max displacement error of a block, over its size, when a part is left out")
      ->capture_default_str()
      ->check(finite_above_zero());

  SafetyOptions safety_options;
  CLI::App* safety_command = app.add_subcommand(
      "safety", "Find the factor of safety: the largest factor by which all strengths can be divided");
  safety_command->add_option("scene", file, "The scene file (TOML)")->required();
  safety_command->add_flag("--resume", safety_options.resumes, "Continue from the trials in the directory")
      ->excludes(add_output(safety_command));
  add_threads(safety_command);
  safety_command
      ->add_option("--low", safety_options.low,
                   "Lower end of the bracket: a factor at which the scene is stable")
      ->capture_default_str()
      ->check(finite_above_zero());
  safety_command
      ->add_option("--high", safety_options.high, "Upper end of the bracket: a factor at which it falls")
      ->capture_default_str()
      ->check(finite_above_zero());
  safety_command->add_option("--resolution", safety_options.resolution, "Final width of the bracket")
      ->capture_default_str()
      ->check(finite_above_zero());
  safety_command
      ->add_option("--limit", safety_options.limit,
                   "Displacement of a block, in m, that counts as failure; by default ten times the elastic "
                   "slip of all joints, at most a tenth of the block's size")
      ->check(finite_above_zero());

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const std::string unknown =
        error.get_exit_code() == 0 ? std::string() : unknown_word(app, {argv + 1, argv + argc});
    if (!unknown.empty()) {
      print(stderr, unknown);
      return exit_usage;
    }
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  const Earlier earlier = force ? Earlier::replace : Earlier::refuse;
  try {
    if (plan_command->parsed()) return plan(file, plan_options);
    if (safety_command->parsed()) return safety(file, output, earlier, threads, safety_options);
    if (trade_command->parsed()) return trade(file, output, earlier, trade_options);
    return run_command->parsed() ? run(file, output, earlier, threads, run_options, from) : check(file);
  } catch (const SceneFault& fault) {
    Faults faults;
    faults.add(fault.place, fault.key, fault.what());
    return refuse(file, faults);
  }
}

}  // namespace
}  // namespace halfspace::cli

int main(int argc, char** argv) {
  try {
    return halfspace::cli::main_of(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "halfspace: %s\n", error.what());
    return halfspace::cli::exit_failed;
  }
}
