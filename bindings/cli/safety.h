#pragma once

#include <string>

#include "files.h"
#include "model.h"
#include "scene.h"

namespace halfspace::cli {

struct SafetyOptions {
  double low = 0.5;           ///< a factor at which the scene should stand
  double high = 5;            ///< one at which it should fall
  double resolution = 0.005;  ///< the bracket that is narrow enough
  double limit = 0;           ///< m: what moves farther has fallen; 0: see limits_of()
  bool resumes = false;       ///< from the trials that the directory holds
};

enum class SafetyEnd {
  found,
  not_found,  ///< the scene does not come to rest, falls as it is, or stands at all factors tried
  interrupted
};

struct SafetyResult {
  std::string report;
  SafetyEnd end = SafetyEnd::not_found;
};

/// Brings a scene to rest, by its stages or as it is, and looks for the factor by which all its strengths can
/// be divided until it falls. Writes pictures of what stands and of how it falls, the report, cracks, and
/// each trial as it is done. `scene_text` tells the scene apart from others.
/// @throws LibraryError, std::runtime_error
SafetyResult find_factor_of_safety(const Scene& scene, Model& model, const std::string& scene_text,
                                   const SafetyOptions& options, OutputDirectory& directory);

}  // namespace halfspace::cli
