#include "run/run_on.h"

#include <algorithm>

namespace halfspace::cli {
namespace {

/// Steps between two increments of gradual changes.
constexpr std::int64_t steps_of_change = 16;

}  // namespace

void run_on(const SceneStage& stage, Model& model, double start, std::int64_t max_steps) {
  const double end = start + stage.duration, ramp_end = start + stage.ramp;
  if (!model.is_changed()) model.change_to(progress_of(stage, model, start));
  const bool is_changed = model.is_changed();
  model.step_towards(is_changed ? end : ramp_end,
                     is_changed ? max_steps : std::min(max_steps, steps_of_change),
                     stage.ends_exactly ? end : Model::never);
  if (has_ended(stage, model, start)) model.change_to(1);
}

}  // namespace halfspace::cli
