#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "commands/commands.h"
#include "commands/limit.h"
#include "commands/shares.h"
#include "commands/sweep.h"
#include "common/suggestion.h"

namespace halfspace::cli {
namespace {

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

  SceneFile file;
  Target target;
  bool force = false;
  const auto add_scene = [&](CLI::App* command, const std::string& text) {
    command->add_option("scene", file.path, text)->required();
    return command
        ->add_option("--set", file.settings,
                     "A value that replaces that of the scene, as default_law.friction_angle=30, "
                     "material.rock.density=2600 or block[2].velocity=[1,0]; repeatable")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  CLI::App* run_command = app.add_subcommand("run", "Run a scene");
  add_scene(run_command, "The scene file (TOML)");
  const auto add_output = [&](CLI::App* command) {
    command->add_option("-o,--output", target.directory, "Directory for the output; made if missing")
        ->required();
    return command->add_flag("--force", force, "Replace an earlier run in the directory");
  };
  add_output(run_command);
  const auto add_threads = [&](CLI::App* command) {
    command
        ->add_option("-j,--threads", target.threads,
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
  bool views = false;
  run_command->add_flag("--view", views, "Write the run as a page of HTML, too, as `halfspace view` does");
  std::string viewed, view_file;
  CLI::App* view_command =
      app.add_subcommand("view", "Write a run as one page of HTML, which plays it in a browser");
  view_command->add_option("directory", viewed, "The output directory of `halfspace run`")->required();
  view_command->add_option("-o,--output", view_file,
                           "The file to write; view.html in the directory by default");
  CLI::App* check_command = app.add_subcommand("check", "List all faults of a scene, without running it");
  add_scene(check_command, "The scene file (TOML)");

  TradeOptions trade_options;
  CLI::App* trade_command =
      app.add_subcommand("trade", "Vary the parameters of a scene: the error and the cost of each setting");
  add_scene(trade_command, "The scene file (TOML); [reference] names the measured quantity");
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
  add_scene(plan_command, "The scene file (TOML)");
  plan_command
      ->add_option("--time", plan_options.time, "Simulated time in s; the scene's duration by default")
      ->check(finite_above_zero());
  plan_command
      ->add_option("--tolerance", plan_options.tolerance,
                   "Max displacement error of a block, over its size, when a part is left out")
      ->capture_default_str()
      ->check(finite_above_zero());

  SearchOptions safety_options;
  CLI::App* safety_command = app.add_subcommand(
      "safety", "Find the factor of safety: the largest factor by which all strengths can be divided");
  add_scene(safety_command, "The scene file (TOML)");
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
                   "displacement of all joints, from a thousandth to a tenth of the block's size")
      ->check(finite_above_zero());

  SweepOptions sweep_options;
  CLI::App* sweep_command = app.add_subcommand(
      "sweep", "Run a scene for all combinations of values: --set KEY=FIRST:LAST:STEP, --set KEY=A,B,C");
  add_scene(sweep_command, "The scene file (TOML)");
  sweep_command->add_flag("--resume", sweep_options.resumes, "Continue from the runs in the directory")
      ->excludes(add_output(sweep_command));
  sweep_command->add_flag("--safety", sweep_options.finds_safety,
                          "Find the factor of safety of each, instead of a run");
  sweep_command
      ->add_option("-j,--jobs", sweep_options.runs_at_once,
                   "Number of runs at once, each with one thread; by default one per core")
      ->check(CLI::Range(1, max_threads));
  sweep_command->add_option("--plot", sweep_options.plotted,
                            "Result that table.svg shows: a column of table.csv");

  LimitArguments limit_arguments;
  CLI::App* limit_command = app.add_subcommand(
      "limit",
      "Find the largest tilt, load or value of a key at which a scene is stable: --tilt, --load, or "
      "--set KEY=LOW:HIGH");
  add_scene(limit_command, "The scene file (TOML)");
  limit_command
      ->add_flag("--resume", limit_arguments.search.resumes, "Continue from the trials in the directory")
      ->excludes(add_output(limit_command));
  add_threads(limit_command);
  limit_command->add_flag("--tilt", limit_arguments.tilts, "Turn gravity, by an angle in degrees");
  limit_command->add_option("--axis", limit_arguments.axis,
                            "Axis of the tilt: x, y, z, -x, -y or -z; by default z in 2D, x in 3D");
  limit_command
      ->add_option("--load", limit_arguments.load,
                   "Scale the mesh loads of this group, mesh or mesh/group; without a name all loads")
      ->expected(0, 1);
  limit_command->add_option("--low", limit_arguments.search.low, "Lower end of the bracket; 0 by default");
  limit_command->add_option("--high", limit_arguments.search.high,
                            "Upper end of the bracket; 90 degrees or a factor of 10 by default");
  limit_command
      ->add_option("--resolution", limit_arguments.search.resolution,
                   "Final width of the bracket; a thousandth of the bracket by default")
      ->check(finite_above_zero());
  limit_command
      ->add_option(
          "--limit", limit_arguments.search.limit,
          "Displacement of a block, in m, that counts as failure; by default that of `safety`, and a "
          "tenth of the block's size in motion")
      ->check(finite_above_zero());
  limit_command->add_flag("--smallest", limit_arguments.search.smallest,
                          "Find the smallest value instead: the scene falls below it");

  std::int64_t share_count = 0;
  CLI::App* split_command = app.add_subcommand(
      "split", "Cut a scene, or a snapshot *.hsw, into shares, which hosts spread over processes");
  add_scene(split_command, "The scene file (TOML), or the snapshot");
  split_command->add_option("count", share_count, "Number of shares")
      ->required()
      ->check(CLI::Range(std::int64_t(1), std::int64_t(1) << 24));
  split_command
      ->add_option("directory", target.directory,
                   "Directory for the shares, share_0.hsw and so on; made if missing")
      ->required();
  split_command->add_flag("--force", force, "Replace earlier shares in the directory");
  std::string shares_directory, joined_file;
  CLI::App* join_command = app.add_subcommand("join", "Join the shares in a directory to one snapshot");
  join_command->add_option("directory", shares_directory, "The directory of the shares")->required();
  join_command->add_option("file", joined_file, "The snapshot to write, *.hsw")->required();

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
  RunResult run_result;
  SearchResult safety_result;
  if (force) target.earlier = Earlier::replace;
  try {
    if (plan_command->parsed()) return plan(file, plan_options);
    if (sweep_command->parsed()) return sweep(file, target, sweep_options);
    if (limit_command->parsed()) return limit(file, target, limit_arguments);
    if (safety_command->parsed()) return safety(file, target, safety_options, safety_result);
    if (trade_command->parsed()) return trade(file, target, trade_options);
    if (split_command->parsed()) return split(file, share_count, target);
    if (join_command->parsed()) return join(shares_directory, joined_file);
    if (view_command->parsed()) return view(viewed, view_file);
    if (check_command->parsed()) return check(file);
    const int code = run(file, target, run_options, from, run_result);
    return views && run_result.figures ? std::max(code, view(target.directory, {})) : code;
  } catch (const SceneFault& fault) {
    Faults faults;
    faults.add(fault.place, fault.key, fault.what());
    return refuse(file, faults);
  }
}

/// Output that is lost, as on a full disk, is a failure.
int flushed(int code) {
  if (std::fflush(stdout) == 0) return code;
  std::fprintf(stderr, "halfspace: cannot write the standard output: %s\n", std::strerror(errno));
  return exit_failed;
}

}  // namespace
}  // namespace halfspace::cli

int main(int argc, char** argv) {
  try {
    return halfspace::cli::flushed(halfspace::cli::main_of(argc, argv));
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "halfspace: %s\n", hs_status_string(HS_ERROR_OUT_OF_MEMORY));
    return halfspace::cli::exit_failed;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "halfspace: %s\n", error.what());
    return halfspace::cli::exit_failed;
  }
}
