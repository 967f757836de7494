#include "studies/trade/stepping.h"

#include "common/interrupt.h"
#include "run/run_on.h"
#include "run/settle.h"

namespace halfspace::cli {
namespace {

RunEnd run_for_its_duration(const SceneStage& stage, Model& model, const StepCallbacks& callbacks,
                            double& end_time) {
  const double start = model.report().time;
  end_time = start + stage.duration;
  while (!has_ended(stage, model, start)) {
    run_on(stage, model, start, callbacks.steps_at_once);
    callbacks.observe();
    if (interrupt_requested()) return RunEnd::interrupted;
  }
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
