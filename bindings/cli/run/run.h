#pragma once

#include <functional>
#include <optional>
#include <string>

#include "common/files.h"
#include "model/model.h"
#include "output/progress.h"
#include "output/summary.h"
#include "scene/scene.h"

namespace halfspace::cli {

struct RunResult {
  Outcome outcome = Outcome::complete;
  std::string trouble;                     ///< the library's error text of an unstable or refused run
  std::string summary;                     ///< the same for the same scene
  std::string timings;                     ///< of this run
  std::optional<RunFigures> figures = {};  ///< of a run that has begun
};

/// Options of a run: its start, its checkpoints, and those who follow it.
struct RunOptions {
  std::string from = {};             ///< state of a checkpoint; empty: the scene's start
  bool resumes_in_place = false;     ///< the directory has the files up to the checkpoint
  double checkpoint_interval = 600;  ///< s of wall time between checkpoints
  ProgressListener on_progress = {};
  std::function<void(const Model&)> on_row = {};  ///< after each row of the history
};

/// Runs a scene, and writes frames, history, pictures, a summary with the notes, and checkpoints. However the
/// run ends, the directory has complete files of everything up to its end. The model is at the scene's start.
/// @throws LibraryError, std::runtime_error; nothing is written if the checkpoint is of another scene
RunResult run_scene(const Scene& scene, Model& model, const std::string& notes, const RunOptions& options,
                    OutputDirectory& directory);

}  // namespace halfspace::cli
