#include "commands/commands.h"
#include "common/interrupt.h"
#include "interface/callbacks.h"
#include "interface/scene_handle.h"
#include "run/checkpoint.h"

namespace halfspace::cli {
namespace {

RunOptions options_of(const hs_scene_run_def& def) {
  RunOptions options{.on_progress = listener_of(def.progress, def.user)};
  if (def.row) {
    options.on_row = [row = def.row, user = def.user](const Model& model) {
      if (row(user, model.world()) != 0) interrupt_this_thread(true);
    };
  }
  return options;
}

int32_t end_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::complete:
      return HS_SCENE_COMPLETE;
    case Outcome::at_rest:
      return HS_SCENE_AT_REST;
    case Outcome::interrupted:
      return HS_SCENE_INTERRUPTED;
    case Outcome::unstable:
      return HS_SCENE_UNSTABLE;
    default:
      return HS_SCENE_TOO_FAST;
  }
}

}  // namespace
}  // namespace halfspace::cli

using namespace halfspace::cli;

void hs_scene_run_def_init(hs_scene_run_def* def) { *def = {}; }

hs_status hs_scene_run(hs_scene* scene, hs_context* context, const hs_scene_run_def* def,
                       hs_scene_run_result* result, hs_world** world) {
  return guarded(scene, [&] {
    require_given(def, "def");
    require_given(def->directory, "directory");
    CheckedScene checked = checked_scene(*scene, context);
    const Target target{def->directory, def->replaces != 0 ? Earlier::replace : Earlier::refuse};
    RunStart start = begin_run(target, options_of(*def), def->from ? def->from : "");
    Model model(checked.context, checked.scene, std::move(checked.layout));
    set_notes(*scene, checked, model);
    scene->names = lines_of(model.names());
    const InterruptibleWork work;
    const RunResult run = run_scene(checked.scene, model, checked.faults.describe_notes("scene"),
                                    start.options, start.directory);
    scene->report = run.summary;
    scene->trouble = run.trouble;
    scene->names = lines_of(model.names());
    if (result) {
      *result = {.end = end_of(run.outcome),
                 .time = model.report().time,
                 .steps = model.report().steps,
                 .run_out = run.figures->run_out,
                 .max_displacement = run.figures->max_displacement,
                 .largest_overlap = run.figures->largest_overlap,
                 .energy_residual = run.figures->energy_residual};
    }
    if (world) *world = model.release_world().release();
  });
}
