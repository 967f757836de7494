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

/// Where a run begins, and how often it keeps what it has.
struct RunOptions {
  std::string from;                  ///< the state in a checkpoint; empty: the scene's start
  bool goes_on_in_place = false;     ///< the files of the run up to there are in its directory
  double checkpoint_interval = 600;  ///< s of work between two checkpoints
};

/// Runs a scene, of which the notes are told in the summary, and writes frames, history, pictures, summary
/// and, from time to time and at its end, a checkpoint. Whatever happens, the directory holds whole files of
/// everything up to the end, regular or not. The model is at the scene's start.
/// @throws LibraryError, std::runtime_error; nothing has been written where a checkpoint is not the scene's
RunResult run_scene(const Scene& scene, Model& model, const std::string& notes, const RunOptions& options,
                    OutputDirectory& directory);

}  // namespace halfspace::cli
