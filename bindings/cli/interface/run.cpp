#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "commands/commands.h"
#include "common/interrupt.h"
#include "interface/scene_handle.h"
#include "run/checkpoint.h"

namespace halfspace::cli {
namespace {

/// Work that callbacks of the calling thread may interrupt.
class InterruptibleWork {
 public:
  InterruptibleWork() { interrupt_this_thread(false); }
  ~InterruptibleWork() { interrupt_this_thread(false); }
  InterruptibleWork(const InterruptibleWork&) = delete;
  InterruptibleWork& operator=(const InterruptibleWork&) = delete;
};

/// Passes progress to a callback, at most some ten times per second; ends the work if that says so.
ProgressListener listener_of(hs_scene_progress progress, void* user) {
  using Clock = std::chrono::steady_clock;
  return [progress, user, last = Clock::time_point()](double fraction, const std::string& where) mutable {
    const Clock::time_point now = Clock::now();
    if (!progress || now - last < std::chrono::milliseconds(100)) return;
    last = now;
    if (progress(user, std::min(fraction, 1.0), where.c_str()) != 0) interrupt_this_thread(true);
  };
}

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

int32_t end_of(SearchEnd end) {
  if (end == SearchEnd::found) return HS_SCENE_COMPLETE;
  return end == SearchEnd::interrupted ? HS_SCENE_INTERRUPTED : HS_SCENE_NOT_FOUND;
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

void hs_scene_safety_def_init(hs_scene_safety_def* def) {
  const SearchOptions defaults;
  *def = {.low = defaults.low,
          .high = defaults.high,
          .resolution = defaults.resolution,
          .limit = defaults.limit,
          .directory = nullptr,
          .replaces = 0,
          .resumes = 0,
          .progress = nullptr,
          .user = nullptr};
}

hs_status hs_scene_find_safety(hs_scene* scene, hs_context* context, const hs_scene_safety_def* def,
                               hs_scene_safety_result* result) {
  return guarded(scene, [&] {
    require_given(def, "def");
    require_given(def->directory, "directory");
    if (!(def->low > 0 && def->low < def->high && std::isfinite(def->high) && def->resolution > 0))
      throw Refusal(HS_ERROR_ARGUMENT, "low, high and resolution must be above 0, and low below high");
    if (!(def->limit >= 0)) throw Refusal(HS_ERROR_ARGUMENT, "limit must be at least 0");
    CheckedScene checked = checked_scene(*scene, context);
    require_free_block(checked, "a factor of safety");
    require_rest(checked, "a factor of safety");
    require_faultless(*scene, checked.faults);
    const Target target{def->directory, def->replaces != 0 ? Earlier::replace : Earlier::refuse};
    OutputDirectory directory = directory_of(target, def->resumes != 0, "trials.csv");
    const auto model = std::make_shared<Model>(checked.context, checked.scene, std::move(checked.layout));
    set_notes(*scene, checked, *model);
    const SearchOptions options{.low = def->low,
                                .high = def->high,
                                .resolution = def->resolution,
                                .limit = def->limit,
                                .resumes = def->resumes != 0,
                                .on_progress = listener_of(def->progress, def->user)};
    const InterruptibleWork work;
    const SearchResult found =
        find_factor_of_safety(checked.scene, model, bytes_of(scene->file, checked.scene), options, directory);
    scene->report = found.report;
    scene->trouble.clear();
    if (!result) return;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    *result = {
        .end = end_of(found.end), .stable = found.stands.value_or(none), .falls = found.falls.value_or(none)};
  });
}
