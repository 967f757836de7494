#include "studies/safety/safety.h"

#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "common/interrupt.h"
#include "common/text.h"
#include "output/summary.h"
#include "studies/safety/failure.h"
#include "studies/safety/start.h"

namespace halfspace::cli {
namespace {

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

/// Searches from the state before the trials: each of them sets its value on the model in this state.
SearchResult search_from(const Scene& scene, const std::shared_ptr<Model>& model, GivenFailure on_failure,
                         const std::function<void(double)>& set, const SearchWords& words,
                         const SearchOptions& options, const std::string& identity,
                         OutputDirectory& directory) {
  Progress progress(options.on_progress);
  SearchResult result{.report = scene_lines(scene)};
  const SearchStart start = start_of_search(scene, *model, on_failure, options.low, progress);
  result.report += start.report;
  if (start.state.empty()) {
    if (interrupt_requested()) result.end = SearchEnd::interrupted;
    directory.write(words.report, result.report);
    return result;
  }
  if (last_runs(scene))
    result.report +=
        report_line("each trial", "the last stage, " + rounded(scene.stages.back().duration, 4) + " s");
  std::vector<double> limits =
      last_runs(scene) ? limits_at_start(model->frame()) : limits_at_rest(scene, *model);
  if (options.limit > 0) limits.assign(limits.size(), options.limit);
  const auto begin = [&](double value) {
    restore(*model, start.state);
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
      scene, model, GivenFailure::raises_strength, [&](double factor) { model->weaken(factor); },
      {.sought = "factor of safety", .column = "factor", .report = "safety.txt"}, options, scene_text,
      directory);
}

SearchResult find_tilt(const Scene& scene, std::shared_ptr<Model> model, const Point& axis,
                       const std::string& scene_text, const SearchOptions& options,
                       OutputDirectory& directory) {
  return search_from(
      scene, model, GivenFailure::ends,
      [&](double angle) { model->tilt(axis, angle * std::numbers::pi / 180); },
      {.sought = options.smallest ? "smallest tilt" : "largest tilt",
       .column = "degrees",
       .report = "limit.txt"},
      options, scene_text + "\ntilt about " + described(axis), directory);
}

}  // namespace halfspace::cli
