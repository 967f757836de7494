#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "faults.h"
#include "files.h"
#include "library.h"
#include "model.h"
#include "notes.h"
#include "plan.h"
#include "read_scene.h"
#include "run.h"

namespace halfspace::cli {
namespace {

enum ExitCode { exit_ok = 0, exit_failed = 1, exit_usage = 2, exit_unstable = 3 };

void print(std::FILE* stream, const std::string& text) { std::fputs(text.c_str(), stream); }

/// A scene, its blocks and the context that owns them. Scene and blocks are whole only if there are no
/// faults.
struct CheckedScene {
  Context context;
  Scene scene;
  Plan plan;
  Faults faults;
};

/// The number of threads is the scene's own where none is given.
CheckedScene load(const std::string& file, int threads) {
  CheckedScene checked;
  checked.scene = read_scene(file, checked.faults);
  if (threads > 0) checked.scene.threads = threads;
  checked.context = make_context(checked.scene.threads);
  checked.plan = plan_blocks(checked.context, checked.scene, checked.faults);
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
  const Model model(checked.context, checked.scene, std::move(checked.plan));
  note_start(checked.context, checked.scene, model, checked.faults);
  std::string text = file + ": no faults, " + std::to_string(model.plan().blocks.size()) + " blocks";
  if (model.plan().left_out > 0)
    text += ", " + std::to_string(model.plan().left_out) + " left out as too small";
  print(stdout, text + '\n' + checked.faults.describe_notes(file));
  return exit_ok;
}

void print_files(const OutputDirectory& directory) {
  std::size_t frames = 0;
  std::string others;
  for (const std::string& name : directory.written()) {
    if (name.starts_with("frames/")) {
      ++frames;
    } else {
      others += "  " + (directory.path() / name).string() + '\n';
    }
  }
  print(stdout, "files written\n" + others + "  " + (directory.path() / "frames").string() + "/ (" +
                    std::to_string(frames) + " frames)\n");
}

int run(const std::string& file, const std::string& output, bool force, int threads) {
  CheckedScene checked = load(file, threads);
  if (!checked.faults.none()) return refuse(file, checked.faults);
  OutputDirectory directory(output, force);
  Model model(checked.context, checked.scene, std::move(checked.plan));
  note_start(checked.context, checked.scene, model, checked.faults);
  print(stderr, checked.faults.describe_notes(file));
  const RunResult result = run_scene(checked.scene, model, checked.faults.describe_notes("scene"), directory);
  print(stdout, result.summary + result.timings);
  print_files(directory);
  if (result.outcome == Outcome::unstable) {
    print(stderr,
          "halfspace: unstable run: " + result.trouble + "; give a smaller time_step or safety in [world]\n");
    return exit_unstable;
  }
  if (result.outcome == Outcome::too_fast) {
    print(stderr, "halfspace: " + result.trouble +
                      R"(; give that time_step in [world], or fast_blocks = "divide")"
                      "\n");
    return exit_unstable;
  }
  return result.outcome == Outcome::interrupted ? exit_failed : exit_ok;
}

int main_of(int argc, char** argv) {
  CLI::App app("Moves convex blocks in contact, from a scene file to pictures.", "halfspace");
  app.set_version_flag("--version", std::string("halfspace ") + hs_version());
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 ok, 1 failed or faulty scene, 2 wrong usage, 3 unstable run, or blocks too fast for it "
      "(its "
      "output is kept).");

  std::string file;
  std::string output;
  bool force = false;
  int threads = 0;
  CLI::App* run_command = app.add_subcommand("run", "Run a scene");
  run_command->add_option("scene", file, "The scene file (TOML)")->required();
  run_command->add_option("-o,--output", output, "Directory for the output; made if missing")->required();
  run_command->add_flag("--force", force, "Replace an earlier run in the directory");
  run_command
      ->add_option("-j,--threads", threads,
                   "Threads that step the world, in place of the scene's number; results have the same bits")
      ->check(CLI::Range(1, most_threads));
  CLI::App* check_command =
      app.add_subcommand("check", "Tell everything that is wrong with a scene, without running it");
  check_command->add_option("scene", file, "The scene file (TOML)")->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  return run_command->parsed() ? run(file, output, force, threads) : check(file);
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
