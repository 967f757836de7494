#include "studies/safety/safety.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/hash.h"
#include "common/interrupt.h"
#include "common/text.h"
#include "common/vector.h"
#include "output/picture/picture.h"
#include "output/progress.h"
#include "output/tables.h"
#include "run/settle.h"
#include "studies/safety/safety_trials.h"

namespace halfspace::cli {
namespace {

/// Settles all stages; a scene without stages settles under its loads. @return the imbalance, if one of them
/// fails
std::string not_settled(const Scene& scene, Model& model, Progress& progress) {
  std::vector<SceneStage> stages = scene.stages;
  if (stages.empty()) {
    stages.push_back({.settles = true});
    hs_relaxation_def_init(&stages[0].relaxation, sizeof stages[0].relaxation);
  }
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const SceneStage& stage = stages[i];
    if (!scene.stages.empty()) model.begin(stage, model.layout().excavated[i]);
    Settling settling;
    hs_balance balance{};
    while (!settling.is_over(stage, model) && !interrupt_requested()) {
      balance = settle_on(stage, model, settling);
      progress.show(static_cast<double>(settling.steps) / static_cast<double>(stage.relaxation.max_steps),
                    "settling, unbalanced " + rounded(balance.mean, 2));
    }
    if (!settling.is_at_rest(model))
      return "unbalanced by " + rounded(balance.mean, 2) + " of all forces after " +
             std::to_string(settling.steps) + " steps" +
             (settling.is_driven ? ", \"" + endless_motion(model) + "\" moves and never stops" : "");
  }
  return {};
}

/// Blocks that have moved by more than a tenth of the largest displacement, largest first.
std::string movers(const Layout& layout, const Frame& standing, const Frame& fallen) {
  constexpr double reported_ratio = 0.1;
  constexpr std::size_t max_names = 5;
  std::vector<std::pair<double, std::size_t>> moved;
  double farthest = 0;
  for (std::size_t i = 0; i < fallen.blocks.size(); ++i) {
    const std::vector<Point>&then = standing.blocks[i].vertices, &now = fallen.blocks[i].vertices;
    double displacement = 0;
    for (std::size_t k = 0; k < now.size(); ++k)
      displacement = std::max(displacement, length(minus(now[k], then[k])));
    if (displacement > 0) moved.push_back({-displacement, i});
    farthest = std::max(farthest, displacement);
  }
  std::erase_if(moved, [&](const auto& mover) { return -mover.first < reported_ratio * farthest; });
  std::sort(moved.begin(), moved.end());
  std::string text = std::to_string(moved.size()) + " of " + std::to_string(fallen.blocks.size());
  for (std::size_t k = 0; k < std::min(moved.size(), max_names); ++k)
    text += (k == 0 ? ": " : ", ") + layout.blocks[moved[k].second].name + " by " +
            rounded(-moved[k].first, 2) + " m";
  return text + (moved.size() > max_names ? ", ..." : "");
}

/// Bisection between two factors; known trials are not repeated.
class Search {
 public:
  Search(const SafetyOptions& options, const std::string& scene_text, OutputDirectory& directory)
      : options_(options),
        directory_(directory),
        name_("# trials of scene " + std::to_string(hash_of(scene_text)) + ", limit " +
              shortest(options.limit) + " m, by halfspace " + hs_version()) {
    if (!options.resumes) {
      directory.write(file, csv_of(known_, name_));
      return;
    }
    try {
      known_ = trials_from(content_of((directory.path() / file).string()), name_);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("cannot resume from " + (directory.path() / file).string() + ": " +
                               error.what());
    }
  }

  /// False when it was interrupted.
  bool run(SafetyTrials& trials) {
    if (!take(trials, options_.low)) return false;
    if (!stands_) return true;
    if (!take(trials, options_.high)) return false;
    while (falls_ && falls_->factor - stands_->factor > options_.resolution) {
      const double middle = 0.5 * (stands_->factor + falls_->factor);
      if (middle <= stands_->factor || middle >= falls_->factor) break;  // there is no number between them
      if (!take(trials, middle)) return false;
    }
    return true;
  }

  const std::optional<Trial>& stands() const { return stands_; }
  const std::optional<Trial>& falls() const { return falls_; }
  bool is_found() const { return stands_ && falls_; }
  std::size_t count() const { return known_.size(); }
  /// The number of trials for this bracket.
  double count_of_all() const {
    return 2 + std::ceil(std::log2((options_.high - options_.low) / options_.resolution));
  }

  std::string factor_text(bool is_over) const {
    if (is_found()) {
      const std::string bracket = "between " + rounded(stands_->factor, 5) + " (stable) and " +
                                  rounded(falls_->factor, 5) + " (falls)";
      return is_over ? rounded(0.5 * (stands_->factor + falls_->factor), 4) + ", " + bracket : bracket;
    }
    if (falls_) return "below " + rounded(falls_->factor, 4) + ": the scene falls there";
    if (stands_) return "above " + rounded(stands_->factor, 4) + ": the scene is stable there";
    return "unknown yet";
  }

  static constexpr const char* file = "trials.csv";

 private:
  bool take(SafetyTrials& trials, double factor) {
    const auto known = std::find_if(known_.begin(), known_.end(),
                                    [&](const Trial& trial) { return trial.factor == factor; });
    std::optional<Trial> trial;
    if (known != known_.end()) {
      trial = *known;
    } else {
      trial = trials.at(factor);
      if (!trial) return false;
      known_.push_back(*trial);
      directory_.write(file, csv_of(known_, name_));
    }
    (trial->stands ? stands_ : falls_) = trial;
    return true;
  }

  const SafetyOptions& options_;
  OutputDirectory& directory_;
  const std::string name_;
  std::vector<Trial> known_;
  std::optional<Trial> stands_, falls_;
};

/// Writes pictures and tables of the stable scene and of the last failure, and reports them.
std::string show_fall(const Scene& scene, Model& model, SafetyTrials& trials, std::size_t bonds_before,
                      OutputDirectory& directory) {
  const Frame& standing = trials.standing();
  trials.show_last_fallen();
  RunStage stage(scene, standing);
  stage.add(standing);
  const Frame fallen = model.frame();
  stage.add(fallen);
  directory.write("stands.svg", picture(stage.stage(), scene, model.layout(), standing, standing));
  if (!trials.has_fallen()) return {};
  std::string text = report_line("moving blocks", movers(model.layout(), standing, fallen));
  const std::size_t failed = model.bond_events().size() - bonds_before;
  if (!scene.bonds.empty()) {
    text += report_line("bonds", std::to_string(failed) + " points fail");
    directory.write("cracks.csv", cracks_table(model));
  }
  directory.write("falls.svg", picture(stage.stage(), scene, model.layout(), standing, fallen));
  return text;
}

}  // namespace

SafetyResult find_factor_of_safety(const Scene& scene, Model& model, const std::string& scene_text,
                                   const SafetyOptions& options, OutputDirectory& directory) {
  remember_interrupts();
  SafetyResult result;
  result.report = report_line("scene", scene.title);
  Search search(options, scene_text, directory);
  Progress progress;
  const std::string trouble = not_settled(scene, model, progress);
  if (!trouble.empty()) {
    if (interrupt_requested()) result.end = SafetyEnd::interrupted;
    result.report += report_line("not at rest", trouble + ": no search");
    directory.write("safety.txt", result.report);
    return result;
  }
  std::vector<double> limits = limits_of(scene, model);
  if (options.limit > 0) limits.assign(limits.size(), options.limit);
  const double farthest = *std::max_element(limits.begin(), limits.end());
  const std::size_t bonds_before = model.bond_events().size();
  // A step without springs is some hundred times as long.
  const std::int64_t steps_of_piece = any_law(scene, has_spring) ? 500 : 20;
  SafetyTrials trials(model, std::move(limits), steps_of_piece, [&](double of_trial, double unbalanced) {
    progress.show((static_cast<double>(search.count()) + of_trial) / search.count_of_all(),
                  "trial " + std::to_string(search.count() + 1) + ", " + search.factor_text(false) +
                      ", unbalanced " + rounded(unbalanced, 2));
  });
  bool is_over = search.run(trials);
  // A failure known from an earlier search is run again for its picture.
  if (is_over && search.falls() && !trials.has_fallen())
    is_over = trials.at(search.falls()->factor).has_value();
  if (!is_over) result.end = SafetyEnd::interrupted;
  if (is_over && search.is_found()) result.end = SafetyEnd::found;
  result.report +=
      report_line("factor of safety", (is_over ? "" : "INTERRUPTED: ") + search.factor_text(is_over)) +
      report_line("trials", std::to_string(search.count())) +
      report_line("limit",
                  rounded(farthest, 3) + " m, displacement of a fallen block; less for smaller blocks");
  if (const std::optional<Trial>& stands = search.stands(); stands && !stands->block.empty()) {
    result.report += report_line("max displacement", stands->block + " by " + rounded(stands->moved, 3) +
                                                         " m at " + rounded(stands->factor, 5) + " (stable)");
  }
  result.report += show_fall(scene, model, trials, bonds_before, directory);
  directory.write("safety.txt", result.report);
  return result;
}

}  // namespace halfspace::cli
