#pragma once

#include <string>

#include "files.h"
#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// How a run ended. All but the last two are what the scene asked for.
enum class Outcome { complete, at_rest, interrupted, unstable, too_fast };

struct RunResult {
  Outcome outcome = Outcome::complete;
  std::string trouble;  ///< what the library said of an unstable run, or one with blocks too fast
  std::string summary;  ///< of the physics: the same for the same scene
  std::string timings;  ///< of this run of it
};

/// Runs a scene from its start, of which the notes are told in the summary, and writes frames, history,
/// pictures and summary. Whatever happens, the directory holds whole files of everything up to the end,
/// regular or not. @throws LibraryError, std::runtime_error
RunResult run_scene(const Scene& scene, Model& model, const std::string& notes, OutputDirectory& directory);

}  // namespace halfspace::cli
