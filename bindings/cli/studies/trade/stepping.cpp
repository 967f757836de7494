#include "studies/trade/stepping.h"

#include <algorithm>

#include "common/interrupt.h"
#include "run/settle.h"

namespace halfspace::cli {
namespace {

/// Steps between two increments of gradual changes.
constexpr std::int64_t steps_of_change = 16;

RunEnd run_for_its_duration(const SceneStage& stage, Model& model, const StepCallbacks& callbacks,
                            double& end_time) {
  const double start = model.report().time, ramp_end = start + stage.ramp;
  end_time = start + stage.duration;
  const double exact_end = stage.ends_exactly ? end_time : Model::never;
  while (!has_ended(stage, model, start)) {
    if (!model.is_changed())
      model.change_to(
          stage.ramp == 0 || model.reached(ramp_end) ? 1 : (model.report().time - start) / stage.ramp);
    if (model.is_changed()) {
      model.step_towards(end_time, callbacks.steps_at_once, exact_end);
    } else {
      model.step_towards(ramp_end, std::min(callbacks.steps_at_once, steps_of_change), exact_end);
    }
    callbacks.observe();
    if (interrupt_requested()) return RunEnd::interrupted;
  }
  model.change_to(1);
  return RunEnd::whole;
}

RunEnd settle(const SceneStage& stage, Model& model, const StepCallbacks& callbacks, double& end_time) {
  hs_balance balance{};
  const bool is_at_rest = settle(stage, model, balance);
  if (interrupt_requested()) return RunEnd::interrupted;
  callbacks.observe();
  end_time = model.report().time;
  return is_at_rest ? RunEnd::whole : RunEnd::not_at_rest;
}

}  // namespace

RunEnd step_through(const Scene& scene, Model& model, const StepCallbacks& callbacks, double& end_time) {
  if (scene.stages.empty())
    return run_for_its_duration({.duration = scene.reference.time}, model, callbacks, end_time);
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    const SceneStage& stage = scene.stages[i];
    model.begin(stage, model.layout().excavated[i]);
    if (stage.resets_displacement) callbacks.reset_displacement();
    const RunEnd end = stage.settles ? settle(stage, model, callbacks, end_time)
                                     : run_for_its_duration(stage, model, callbacks, end_time);
    if (end != RunEnd::whole) return end;
  }
  return RunEnd::whole;
}

}  // namespace halfspace::cli
