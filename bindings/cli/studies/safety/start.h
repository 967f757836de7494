#pragma once

#include <string>

#include "model/model.h"
#include "output/progress.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The start of all trials of a search.
struct SearchStart {
  std::string state;   ///< of the model; empty: there is no search
  std::string report;  ///< lines on the way there
};

/// What a search does with a scene that fails as it is given.
enum class GivenFailure {
  raises_strength,  ///< begins at rest with higher strengths
  ends              ///< has no result
};

/// The state of a model between stages or at the start of one.
std::string state_of(Model& model);
/// Returns a model to such a state.
void restore(Model& model, const std::string& state);

/// Is the last stage one that runs? Then each trial is this stage.
bool last_runs(const Scene& scene);

/// Takes a model through the stages of its scene to the start of all trials: the end of the last stage, or
/// its start if it runs. A scene without stages settles under its loads. `low`: the smallest factor by which
/// the search divides strengths. @throws LibraryError
SearchStart start_of_search(const Scene& scene, Model& model, GivenFailure on_failure, double low,
                            Progress& progress);

/// Has a model that came to rest through all stages of its scene moved beyond its limits only where it would
/// with any strength? `fresh`: a model of the scene at its start. @throws LibraryError
bool has_come_to_its_place(const Scene& scene, const Model& at_rest, Model& fresh, Progress& progress);

}  // namespace halfspace::cli
