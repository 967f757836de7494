#include "commands/sweep.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "common/hash.h"
#include "common/interrupt.h"
#include "common/suggestion.h"
#include "common/text.h"
#include "output/progress.h"
#include "output/summary.h"
#include "run/checkpoint.h"
#include "studies/sweep/children.h"
#include "studies/sweep/table.h"
#include "studies/trade/measure.h"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

/// The results of one run, which its process leaves for the table.
constexpr const char* results_file = "results.csv";

std::string directory_of_run(std::size_t number) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "%04zu", number);
  return "runs/" + std::string(digits);
}

std::vector<std::string> result_names(const Scene& scene, bool finds_safety) {
  if (finds_safety) return {"factor_of_safety", "stable", "falls"};
  std::vector<std::string> names = {"run_out", "max_displacement", "largest_overlap", "energy_residual"};
  if (scene.reference.is_given) names.push_back("reference");
  return names;
}

/// Searches the factor of safety of one combination, from the trials of an interrupted search.
int find_safety(const SceneFile& file, Target target, bool resumes, std::string& results) {
  resumes = resumes && fs::exists(fs::path(target.directory) / "trials.csv");
  SearchResult result;
  const int code = safety(file, target, {.resumes = resumes}, result);
  if (result.stands && result.falls) results = shortest(0.5 * (*result.stands + *result.falls));
  results += ',' + (result.stands ? shortest(*result.stands) : "") + ',' +
             (result.falls ? shortest(*result.falls) : "");
  return code;
}

/// The quantity of [reference], in a second run that measures it at its time.
std::string reference_value(const SceneFile& file) {
  CheckedScene checked = load(file, 1);
  checked.scene.output.track_nothing();
  const Outcomes outcomes = measure({}, checked.scene, {});
  return outcomes.end == RunEnd::whole ? shortest(outcomes.value) : "";
}

/// Runs one combination, from the checkpoint of an interrupted run.
int run_scene_once(const SceneFile& file, const Target& target, bool resumes, std::string& results) {
  const std::string checkpoint = (fs::path(target.directory) / checkpoint_name).string();
  RunResult result;
  const int code = run(file, target, {}, resumes && fs::exists(checkpoint) ? checkpoint : "", result);
  if (!result.figures) return code;
  for (const double figure : {result.figures->run_out, result.figures->max_displacement,
                              result.figures->largest_overlap, result.figures->energy_residual})
    results += (results.empty() ? "" : ",") + shortest(figure);
  if (code == exit_ok && load(file, 1).scene.reference.is_given) results += ',' + reference_value(file);
  return code;
}

/// The work of a child.
int run_combination(const SceneFile& file, const std::string& directory, const SweepOptions& options) {
  const Target target{directory, Earlier::replace, 1};
  std::string results;
  const int code = options.finds_safety ? find_safety(file, target, options.resumes, results)
                                        : run_scene_once(file, target, options.resumes, results);
  write_file(fs::path(directory) / results_file, results + '\n');
  return code;
}

std::vector<std::string> results_in(const fs::path& directory) {
  const fs::path file = directory / results_file;
  if (!fs::exists(file)) return {};
  std::string row = content_of(file.string());
  if (row.ends_with('\n')) row.pop_back();
  return cells_of(row);
}

/// Faults of a combination that its file and its settings have.
int refuse_faulty(const SceneFile& file, const Grid& grid) {
  for (std::size_t number = 0; number < grid.count(); ++number) {
    const SceneFile combination{file.path, grid.settings_of(number)};
    const CheckedScene checked = read(combination, 1);
    if (!checked.faults.none()) return refuse(combination, checked.faults);
  }
  return exit_ok;
}

/// The result that the picture shows. @throws std::invalid_argument
std::string plotted_of(const SweepOptions& options, const std::vector<std::string>& names) {
  if (options.plotted.empty()) {
    if (options.finds_safety) return "factor_of_safety";
    return names.back() == "reference" ? "reference" : "max_displacement";
  }
  if (std::find(names.begin(), names.end(), options.plotted) != names.end()) return options.plotted;
  throw std::invalid_argument("--plot: no such result: " + options.plotted +
                              suggestion(options.plotted, {names.begin(), names.end()}) +
                              "; allowed: " + joined(names));
}

class Sweep {
 public:
  Sweep(SceneFile file, const Grid& grid, SweepTable& table, const SweepOptions& options,
        OutputDirectory& directory)
      : file_(std::move(file)), grid_(grid), table_(table), options_(options), directory_(directory) {}

  void run() {
    remember_interrupts();
    Progress progress;
    const auto cores = std::max(std::thread::hardware_concurrency(), 1u);
    const auto at_once = static_cast<std::size_t>(options_.runs_at_once > 0 ? options_.runs_at_once : cores);
    run_in_children(
        jobs(), at_once, [&](const JobEnd& end) { add(end); },
        [&](std::size_t running) {
          progress.show(static_cast<double>(table_.count()) / static_cast<double>(grid_.count()),
                        std::to_string(table_.count()) + " of " + std::to_string(grid_.count()) + " runs, " +
                            std::to_string(running) + " running");
        });
  }

 private:
  std::vector<Job> jobs() const {
    std::vector<Job> jobs;
    for (std::size_t number = 0; number < grid_.count(); ++number) {
      if (table_.has(number)) continue;
      const fs::path directory = directory_.path() / directory_of_run(number);
      std::error_code no_earlier;
      fs::remove(directory / results_file, no_earlier);
      jobs.push_back(
          {number,
           [this, number, directory] {
             return run_combination({file_.path, grid_.settings_of(number)}, directory.string(), options_);
           },
           directory / "log.txt"});
    }
    return jobs;
  }

  /// A run that an interrupt ended is not in the table, so that it is resumed.
  void add(const JobEnd& end) {
    if (interrupt_requested() && end.status != exit_ok) return;
    table_.add(end.number, {std::to_string(end.status), decimals(end.seconds, 2),
                            results_in(directory_.path() / directory_of_run(end.number))});
    directory_.write("table.csv", table_.text());
  }

  const SceneFile file_;
  const Grid& grid_;
  SweepTable& table_;
  const SweepOptions& options_;
  OutputDirectory& directory_;
};

}  // namespace

int sweep(const SceneFile& file, const Target& target, const SweepOptions& options) {
  Grid grid;
  std::string plotted;
  std::vector<std::string> names;
  Scene scene;
  try {
    grid = grid_of(file.settings);
    if (const int code = refuse_faulty(file, grid)) return code;
    scene = read({file.path, grid.settings_of(0)}, 1).scene;
    names = result_names(scene, options.finds_safety);
    plotted = plotted_of(options, names);
  } catch (const std::invalid_argument& error) {
    print(stderr, std::string("--set ") + error.what() + '\n');
    return exit_usage;
  }
  OutputDirectory directory = directory_of(target, options.resumes, "table.csv");
  const std::string bytes = bytes_of(file, scene) + (options.finds_safety ? "\nsafety" : "");
  SweepTable table(grid, names,
                   "# sweep of scene " + std::to_string(hash_of(bytes)) + ", by halfspace " + hs_version());
  if (options.resumes) {
    const std::string earlier = (directory.path() / "table.csv").string();
    try {
      table.read(content_of(earlier));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("cannot resume from " + earlier + ": " + error.what());
    }
  }
  directory.write("table.csv", table.text());
  Sweep(file, grid, table, options, directory).run();
  directory.write("table.svg", table.chart(scene.title, plotted));
  const bool is_interrupted = table.count() < grid.count();
  const std::size_t failed = table.failed_count();
  print(stdout,
        report_line("scene", scene.title) +
            report_line("runs", std::to_string(table.count()) + " of " + std::to_string(grid.count()) + ", " +
                                    std::to_string(failed) + " failed") +
            report_line("table", (directory.path() / "table.csv").string()) +
            report_line("picture", (directory.path() / "table.svg").string() + ", " + plotted));
  if (is_interrupted) print(stderr, "\nhalfspace: interrupted; --resume continues\n");
  if (failed > 0)
    print(stderr, "halfspace: " + std::to_string(failed) +
                      " runs failed; exit_status in table.csv, and log.txt of each in runs/\n");
  return is_interrupted || failed > 0 ? exit_failed : exit_ok;
}

}  // namespace halfspace::cli
