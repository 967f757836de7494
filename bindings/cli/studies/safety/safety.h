#pragma once

#include <string>

#include "common/files.h"
#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

struct SafetyOptions {
  double low = 0.5;           ///< a factor at which the scene is stable
  double high = 5;            ///< a factor at which it falls
  double resolution = 0.005;  ///< final width of the bracket
  double limit = 0;           ///< m, displacement of a fallen block; 0: see limits_of()
  bool resumes = false;       ///< from the trials in the directory
};

enum class SafetyEnd {
  found,
  not_found,  ///< the scene does not come to rest, falls at `low`, or is stable at `high`
  interrupted
};

struct SafetyResult {
  std::string report;
  SafetyEnd end = SafetyEnd::not_found;
};

/// Brings a scene to rest, by its stages or as it is, and bisects the largest factor by which all its
/// strengths can be divided before it falls. Writes the report, each trial, cracks, and pictures of the
/// stable scene and of its failure. `scene_text` identifies the scene.
/// @throws LibraryError, std::runtime_error
SafetyResult find_factor_of_safety(const Scene& scene, Model& model, const std::string& scene_text,
                                   const SafetyOptions& options, OutputDirectory& directory);

}  // namespace halfspace::cli
