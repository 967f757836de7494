#include "studies/safety/start.h"

#include <algorithm>
#include <vector>

#include "common/archive.h"
#include "common/interrupt.h"
#include "common/text.h"
#include "output/summary.h"
#include "run/run_on.h"
#include "run/settle.h"
#include "studies/safety/failure.h"
#include "studies/safety/trials.h"

namespace halfspace::cli {
namespace {

/// A model at the start of the trials, or where it has ended before.
struct Passage {
  Frame end;
  std::vector<double> limits = {};
  std::string failed = {};   ///< blocks beyond their limits; empty without any
  std::string trouble = {};  ///< why it has not come to its end; empty: it has
};

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

/// Returns the imbalance if the stage does not come to rest. @throws LibraryError
std::string settle_through(const SceneStage& stage, Model& model, Progress& progress) {
  Settling settling;
  hs_balance balance{};
  while (!settling.is_over(stage, model) && !interrupt_requested()) {
    balance = settle_on(stage, model, settling);
    progress.show(static_cast<double>(settling.steps) / static_cast<double>(stage.relaxation.max_steps),
                  "settling, unbalanced " + rounded(balance.mean, 2));
  }
  if (settling.is_at_rest(model)) return {};
  return "unbalanced by " + rounded(balance.mean, 2) + " of all forces after " +
         std::to_string(settling.steps) + " steps" +
         (settling.fallen.empty() ? "" : ", \"" + settling.fallen + "\" has fallen out of the scene") +
         (settling.is_driven ? ", \"" + endless_motion(model) + "\" moves and never stops" : "");
}

/// Returns why the stages have not come to their end.
std::string trouble_on_the_way(const Scene& scene, Model& model, double factor, Progress& progress) {
  const std::vector<SceneStage> stages = stages_of_search(scene);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const SceneStage& stage = stages[i];
    if (!scene.stages.empty()) model.begin(stage, model.layout().excavated[i]);
    if (factor != 1) model.weaken(factor);
    if (!stage.settles) {
      if (i + 1 < stages.size() && !run_through(stage, model, progress)) return "interrupted";
      continue;
    }
    const std::string imbalance = settle_through(stage, model, progress);
    if (!imbalance.empty()) return imbalance;
  }
  return {};
}

/// The end of a model's way to the start of the trials.
Passage passage_of(const Scene& scene, const Model& model, const Frame& start) {
  Passage passage{.end = model.frame()};
  const std::vector<SceneStage> stages = stages_of_search(scene);
  const bool has_run = std::any_of(stages.begin(), stages.end() - (last_runs(scene) ? 1 : 0),
                                   [](const SceneStage& stage) { return !stage.settles; });
  passage.limits = has_run ? limits_at_start(passage.end) : limits_at_rest(scene, model);
  passage.failed = failed_blocks(model.layout(), displacements(start, passage.end), passage.limits);
  return passage;
}

/// Goes to the start of the trials with all strengths divided by a factor. @throws LibraryError
Passage pass(const Scene& scene, Model& model, double factor, const Frame& start, Progress& progress) {
  std::string trouble, refusal;
  try {
    trouble = trouble_on_the_way(scene, model, factor, progress);
  } catch (const LibraryError& error) {
    if (!is_failure(error)) throw;
    trouble = refusal = error.what();
  }
  Passage passage = passage_of(scene, model, start);
  passage.trouble = trouble;
  if (passage.failed.empty()) passage.failed = refusal;
  return passage;
}

std::string not_at_rest(const Passage& passage) {
  return report_line("not at rest", passage.trouble + ": no search");
}

/// A factor that divides strengths so far that nothing exceeds them.
constexpr double unlimited = 0.01;

/// True if both are at rest with all blocks within their limits of the places with unlimited strengths.
bool is_in_place(const Passage& passage, const Passage& held, const Layout& layout) {
  return passage.trouble.empty() && held.trouble.empty() &&
         failed_blocks(layout, displacements(held.end, passage.end), passage.limits).empty();
}

/// The way to a result for a scene that has failed before any search.
constexpr const char* other_way =
    ": no search; find the strength at which it stands by halfspace limit --smallest --set "
    "default_law.friction_angle=LOW:HIGH";

}  // namespace

bool last_runs(const Scene& scene) { return !scene.stages.empty() && !scene.stages.back().settles; }

std::string state_of(Model& model) {
  Archive archive;
  model.add_to(archive);
  return archive.bytes();
}

void restore(Model& model, const std::string& state) {
  Archive archive(state);
  model.add_to(archive);
}

/// Blocks that move by more than their limits, while the scene comes to rest, have failed unless they come to
/// the same place with strengths that nothing exceeds: then they fall onto their support.
SearchStart start_of_search(const Scene& scene, Model& model, GivenFailure on_failure, double low,
                            Progress& progress) {
  constexpr double default_raise = 0.5;
  const Frame start = model.frame();
  const std::string state = state_of(model);
  const Passage given = pass(scene, model, 1, start, progress);
  if (interrupt_requested()) return {{}, not_at_rest(given)};
  if (given.failed.empty())
    return given.trouble.empty() ? SearchStart{state_of(model), {}} : SearchStart{{}, not_at_rest(given)};

  const std::string state_of_given = state_of(model);
  restore(model, state);
  const Passage held = pass(scene, model, unlimited, start, progress);
  if (interrupt_requested()) return {{}, not_at_rest(held)};
  if (is_in_place(given, held, model.layout())) {
    restore(model, state_of_given);
    return {state_of_given, report_line("falls into place", given.failed + ", as with any strength")};
  }
  const double raise = low < 1 ? low : default_raise;
  const std::string fell = given.failed + ", while the scene settled",
                    times = rounded(1 / raise, 3) + " times the given strengths";
  restore(model, state);
  const Passage raised = pass(scene, model, raise, start, progress);
  if (interrupt_requested()) return {{}, not_at_rest(raised)};
  if (!is_in_place(raised, held, model.layout()))
    return {{}, report_line("FELL AT FIRST", fell + ", also with " + times + other_way)};
  if (on_failure == GivenFailure::ends || low >= 1)
    return {{}, report_line("FELL AT FIRST", fell + ", but not with " + times + other_way)};
  return {state_of(model), report_line("falls as given", fell + "; the search begins at rest with " + times)};
}

bool has_come_to_its_place(const Scene& scene, const Model& at_rest, Model& fresh, Progress& progress) {
  const Frame start = fresh.frame();
  const Passage given = passage_of(scene, at_rest, start);
  return given.failed.empty() ||
         is_in_place(given, pass(scene, fresh, unlimited, start, progress), at_rest.layout());
}

}  // namespace halfspace::cli
