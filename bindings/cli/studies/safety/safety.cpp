#include "studies/safety/safety.h"

#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "common/archive.h"
#include "common/interrupt.h"
#include "common/text.h"
#include "common/vector.h"
#include "output/summary.h"
#include "run/run_on.h"
#include "run/settle.h"

namespace halfspace::cli {
namespace {

/// Is the last stage one that runs? Then each trial is this stage.
bool last_runs(const Scene& scene) { return !scene.stages.empty() && !scene.stages.back().settles; }

/// False when it was interrupted. @throws LibraryError
bool run_through(const SceneStage& stage, Model& model, Progress& progress) {
  constexpr std::int64_t steps_of_piece = 100;
  const double start = model.report().time;
  while (!has_ended(stage, model, start)) {
    if (interrupt_requested()) return false;
    run_on(stage, model, start, steps_of_piece);
    progress.show((model.report().time - start) / stage.duration,
                  "before the search, t = " + rounded(model.report().time, 4) + " s");
  }
  return true;
}

/// Goes through the stages to the start of all trials: the end of the last stage, or its start if it runs. A
/// scene without stages settles under its loads. @return the imbalance, if a stage does not come to rest
std::string not_settled(const Scene& scene, Model& model, Progress& progress) {
  const std::vector<SceneStage> stages = stages_of_search(scene);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const SceneStage& stage = stages[i];
    if (!scene.stages.empty()) model.begin(stage, model.layout().excavated[i]);
    if (!stage.settles) {
      if (i + 1 < stages.size() && !run_through(stage, model, progress)) return "interrupted";
      continue;
    }
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

/// Reports blocks that moved by more than a tenth of their size while the scene settled: it fell by itself,
/// and the search begins from the state after that.
std::string fall_before(const Layout& layout, const Frame& start, const Frame& rest) {
  const std::vector<double> limits = limits_at_start(start);
  std::size_t count = 0, farthest = 0;
  double largest = 0;
  for (std::size_t i = 0; i < rest.blocks.size(); ++i) {
    if (is_removed(rest.blocks[i]) || !moves_freely(rest.blocks[i].state.kind)) continue;
    const double moved = length(
        minus(point_of(rest.blocks[i].state.pose.position), point_of(start.blocks[i].state.pose.position)));
    if (moved <= limits[i]) continue;
    ++count;
    if (moved <= largest) continue;
    largest = moved;
    farthest = i;
  }
  if (count == 0) return {};
  return report_line("FELL AT FIRST",
                     std::to_string(count) + " of " + std::to_string(rest.blocks.size()) +
                         " blocks moved by more than a tenth of their size while the scene settled, " +
                         layout.blocks[farthest].name + " by " + rounded(largest, 3) +
                         " m: the result is that of the scene after this");
}

/// The stage of each trial: the last one of the scene if that runs, else a relaxation. What is not at rest by
/// its end falls.
SceneStage trial_stage(const Scene& scene) {
  if (last_runs(scene)) return scene.stages.back();
  constexpr std::int64_t max_pieces = 200;
  SceneStage stage{.settles = true};
  hs_relaxation_def_init(&stage.relaxation, sizeof stage.relaxation);
  stage.relaxation.hold_bonds = 0;
  stage.relaxation.max_steps = max_pieces * steps_of_trial_piece(scene);
  return stage;
}

/// The state of a model between stages or at the start of one.
std::string state_of(Model& model) {
  Archive archive;
  model.add_to(archive);
  return archive.bytes();
}

/// Searches from the state before the trials: each of them sets its value on the model in this state.
SearchResult search_from(const Scene& scene, const std::shared_ptr<Model>& model,
                         const std::function<void(double)>& set, const SearchWords& words,
                         const SearchOptions& options, const std::string& identity,
                         OutputDirectory& directory) {
  Progress progress(options.on_progress);
  SearchResult result{.report = scene_lines(scene)};
  const Frame start = model->frame();
  const std::string trouble = not_settled(scene, *model, progress);
  if (!trouble.empty()) {
    if (interrupt_requested()) result.end = SearchEnd::interrupted;
    result.report += report_line("not at rest", trouble + ": no search");
    directory.write(words.report, result.report);
    return result;
  }
  result.report += fall_before(model->layout(), start, model->frame());
  if (last_runs(scene))
    result.report +=
        report_line("each trial", "the last stage, " + rounded(scene.stages.back().duration, 4) + " s");
  std::vector<double> limits =
      last_runs(scene) ? limits_at_start(model->frame()) : limits_at_rest(scene, *model);
  if (options.limit > 0) limits.assign(limits.size(), options.limit);
  const std::string state = state_of(*model);
  const auto begin = [&](double value) {
    Archive archive(state);
    model->add_to(archive);
    set(value);
    return TrialStart{.model = model, .stages = {trial_stage(scene)}, .limits = limits};
  };
  return search(scene, begin, words, options, identity, result.report, progress, directory);
}

}  // namespace

SearchResult find_factor_of_safety(const Scene& scene, std::shared_ptr<Model> model,
                                   const std::string& scene_text, const SearchOptions& options,
                                   OutputDirectory& directory) {
  return search_from(
      scene, model, [&](double factor) { model->weaken(factor); },
      {.sought = "factor of safety", .column = "factor", .report = "safety.txt"}, options, scene_text,
      directory);
}

SearchResult find_tilt(const Scene& scene, std::shared_ptr<Model> model, const Point& axis,
                       const std::string& scene_text, const SearchOptions& options,
                       OutputDirectory& directory) {
  return search_from(
      scene, model, [&](double angle) { model->tilt(axis, angle * std::numbers::pi / 180); },
      {.sought = options.smallest ? "smallest tilt" : "largest tilt",
       .column = "degrees",
       .report = "limit.txt"},
      options, scene_text + "\ntilt about " + described(axis), directory);
}

}  // namespace halfspace::cli
