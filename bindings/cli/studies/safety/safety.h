#pragma once

#include <memory>
#include <string>

#include "model/model.h"
#include "studies/safety/search.h"

namespace halfspace::cli {

/// Brings a scene to rest, by its stages or as it is, and bisects the largest factor by which all its
/// strengths can be divided before it falls; see search(). If the last stage runs for a time, each trial is
/// this stage, from its start. `scene_text` identifies the scene.
/// @throws LibraryError, std::runtime_error
SearchResult find_factor_of_safety(const Scene& scene, std::shared_ptr<Model> model,
                                   const std::string& scene_text, const SearchOptions& options,
                                   OutputDirectory& directory);

/// The same for the angle in degrees by which gravity can be turned about an axis.
SearchResult find_tilt(const Scene& scene, std::shared_ptr<Model> model, const Point& axis,
                       const std::string& scene_text, const SearchOptions& options,
                       OutputDirectory& directory);

}  // namespace halfspace::cli
