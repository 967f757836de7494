#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// A trial: a scene with a value goes through its stages. It stands if no block moves too far, and stages
/// that settle come to rest.
struct Trial {
  double value = 1;
  bool stands = false;
  double moved = 0;        ///< m, max displacement of a block
  std::string block = {};  ///< with that displacement
  std::int64_t steps = 0;
  double time_step = 0;  ///< s, as given; 0: that of the springs
};

/// The trials of a search as CSV, after a line that identifies the search. `column` names their value.
std::string csv_of(const std::vector<Trial>& trials, const std::string& search, const std::string& column);
/// @throws std::runtime_error for trials of another search, or an invalid table
std::vector<Trial> trials_from(const std::string& csv, const std::string& search, const std::string& column);

/// The state in which a trial begins.
struct TrialStart {
  std::shared_ptr<Model> model;    ///< with the value
  std::vector<SceneStage> stages;  ///< of the trial
  bool are_of_scene = false;       ///< all stages of the scene, whose changes are still to be made
  std::vector<double> limits;      ///< of the displacement of each block from here, m
  /// Confirms that a model that has come to the end of its stages has not failed; may be empty.
  std::function<bool(const Model& at_end)> confirms = {};
};

/// The stages that a scene goes through: its own, or one that brings it to rest under its loads.
std::vector<SceneStage> stages_of_search(const Scene& scene);

/// True for a step that is unstable, refused, or inverts a cell: then the scene has failed.
bool is_failure(const LibraryError& error);

/// The number of steps between two looks at the limits of a trial.
std::int64_t steps_of_trial_piece(const Scene& scene);

/// Tries values.
class Trials {
 public:
  using Begin = std::function<TrialStart(double value)>;
  /// Called with the fraction of a stage that is done at most, and the state of the trial in words.
  using Show = std::function<void(double fraction, const std::string& state)>;

  Trials(Begin begin, std::int64_t steps_of_piece, Show show);

  /// None when it was interrupted. @throws LibraryError
  std::optional<Trial> at(double value, double time_step);

  /// A failure.
  struct Fall {
    Frame start, end;
    std::string cracks;  ///< cracks.csv, with bonds
    std::size_t failed_points = 0;
  };
  /// The model of the last trial, and the frame at which it began.
  const std::shared_ptr<Model>& model() const { return model_; }
  const std::optional<Frame>& start() const { return start_; }
  /// The last trial that fell, and its model, which later trials may have changed.
  const std::optional<Fall>& fall() const { return fall_; }
  const std::shared_ptr<Model>& fallen_model() const { return fallen_model_; }
  /// The largest limit of the last trial, m.
  double largest_limit() const { return largest_limit_; }

 private:
  /// True if the stage is complete: at rest or at its end, and no block has moved beyond its limit. None when
  /// it was interrupted. @throws LibraryError
  std::optional<bool> stands_through(const SceneStage& stage, const std::vector<double>& limits,
                                     Trial& trial);
  /// True if a block has moved beyond its limit.
  bool find_farthest(const std::vector<double>& limits, Trial& trial) const;
  void remember_fall(std::size_t events_before);

  Begin begin_;
  std::int64_t steps_of_piece_;
  Show show_;
  std::shared_ptr<Model> model_, fallen_model_;
  std::optional<Frame> start_;
  std::optional<Fall> fall_;
  double largest_limit_ = 0;
};

}  // namespace halfspace::cli
