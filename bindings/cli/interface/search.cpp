#include <cmath>
#include <limits>
#include <memory>

#include "commands/commands.h"
#include "commands/limit_search.h"
#include "common/text.h"
#include "interface/callbacks.h"
#include "interface/scene_handle.h"

namespace halfspace::cli {
namespace {

int32_t end_of(SearchEnd end) {
  if (end == SearchEnd::found) return HS_SCENE_COMPLETE;
  return end == SearchEnd::interrupted ? HS_SCENE_INTERRUPTED : HS_SCENE_NOT_FOUND;
}

/// The directory of a search, of either definition.
template <class Definition>
OutputDirectory directory_of(const Definition& def) {
  const Target target{def.directory, def.replaces != 0 ? Earlier::replace : Earlier::refuse};
  return directory_of(target, def.resumes != 0, "trials.csv");
}

void set_result(hs_scene& scene, const SearchResult& found, hs_scene_search_result* result) {
  scene.report = found.report;
  scene.trouble.clear();
  if (!result) return;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  *result = {
      .end = end_of(found.end), .stable = found.stands.value_or(none), .falls = found.falls.value_or(none)};
}

void require_displacement(double limit) {
  if (!(limit >= 0 && std::isfinite(limit)))
    throw Refusal(HS_ERROR_ARGUMENT, "limit is " + shortest(limit) + "; allowed: at least 0, in m");
}

/// An end of a bracket; NaN: its default.
std::optional<double> end_of_bracket(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

/// The quantity that the search varies, by its HS_SCENE_VARY_ value.
Varied varied_of(int32_t varied) {
  switch (varied) {
    case HS_SCENE_VARY_TILT:
      return Varied::tilt;
    case HS_SCENE_VARY_LOADS:
      return Varied::loads;
    case HS_SCENE_VARY_SETTING:
      return Varied::setting;
    default:
      throw Refusal(HS_ERROR_ARGUMENT,
                    "varied is " + std::to_string(varied) + "; allowed: an HS_SCENE_VARY_ value");
  }
}

/// The options of a search. @throws Refusal
LimitOptions options_of(const hs_scene_limit_def& def) {
  require_displacement(def.limit);
  if (!(def.resolution >= 0 && std::isfinite(def.resolution)))
    throw Refusal(HS_ERROR_ARGUMENT, "resolution is " + shortest(def.resolution) + "; allowed: at least 0");
  const LimitOptions options{.varied = varied_of(def.varied),
                             .name = def.name ? def.name : "",
                             .low = end_of_bracket(def.low),
                             .high = end_of_bracket(def.high),
                             .resolution = def.resolution,
                             .limit = def.limit,
                             .smallest = def.smallest != 0,
                             .resumes = def.resumes != 0,
                             .on_progress = listener_of(def.progress, def.user)};
  if (options.varied == Varied::setting && (options.name.empty() || !options.low || !options.high))
    throw Refusal(HS_ERROR_ARGUMENT, "a setting requires name, its key, and low and high");
  return options;
}

}  // namespace
}  // namespace halfspace::cli

using namespace halfspace::cli;

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
                               hs_scene_search_result* result) {
  return guarded(scene, [&] {
    require_given(def, "def");
    require_given(def->directory, "directory");
    if (!(def->low > 0 && def->low < def->high && std::isfinite(def->high) && def->resolution > 0))
      throw Refusal(HS_ERROR_ARGUMENT, "low, high and resolution must be above 0, and low below high");
    require_displacement(def->limit);
    CheckedScene checked = checked_scene(*scene, context);
    require_free_block(checked, "a factor of safety");
    require_faultless(*scene, checked.faults);
    OutputDirectory directory = directory_of(*def);
    const auto model = std::make_shared<Model>(checked.context, checked.scene, std::move(checked.layout));
    set_notes(*scene, checked, *model);
    const SearchOptions options{.low = def->low,
                                .high = def->high,
                                .resolution = def->resolution,
                                .limit = def->limit,
                                .resumes = def->resumes != 0,
                                .on_progress = listener_of(def->progress, def->user)};
    const InterruptibleWork work;
    set_result(
        *scene,
        find_factor_of_safety(checked.scene, model, bytes_of(scene->file, checked.scene), options, directory),
        result);
  });
}

void hs_scene_limit_def_init(hs_scene_limit_def* def) {
  constexpr double by_default = std::numeric_limits<double>::quiet_NaN();
  *def = {.varied = HS_SCENE_VARY_TILT,
          .smallest = 0,
          .name = nullptr,
          .low = by_default,
          .high = by_default,
          .resolution = 0,
          .limit = 0,
          .directory = nullptr,
          .replaces = 0,
          .resumes = 0,
          .progress = nullptr,
          .user = nullptr};
}

hs_status hs_scene_find_limit(hs_scene* scene, hs_context* context, const hs_scene_limit_def* def,
                              hs_scene_search_result* result) {
  return guarded(scene, [&] {
    require_given(def, "def");
    require_given(def->directory, "directory");
    const LimitOptions options = options_of(*def);
    require_read(*scene, context);
    LimitSearch search(scene->file, options, [&](const SceneFile& file) { return read_in(context, file); });
    require_faultless(*scene, search.faults());
    OutputDirectory directory = directory_of(*def);
    scene->notes = search.faults().describe_notes(scene->file.path);
    const InterruptibleWork work;
    set_result(*scene, search.find(directory), result);
  });
}
