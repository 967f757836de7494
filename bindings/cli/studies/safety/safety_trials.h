#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// A trial: the scene at rest, with its strengths divided by a factor, relaxed again.
struct Trial {
  double factor = 1;
  bool stands = false;
  double moved = 0;        ///< m, max displacement of a block
  std::string block = {};  ///< with that displacement
  std::int64_t steps = 0;
};

/// The trials of a search as CSV, after a line that identifies the search.
std::string csv_of(const std::vector<Trial>& trials, const std::string& search);
/// @throws std::runtime_error for trials of another search, or an invalid table
std::vector<Trial> trials_from(const std::string& csv, const std::string& search);

/// The displacement of each block, m, beyond which it has fallen: ten times the elastic slip of all joints,
/// from a thousandth to a tenth of its size.
std::vector<double> limits_of(const Scene& scene, const Model& standing);

/// Tries factors on a model that is at rest.
class SafetyTrials {
 public:
  /// A block falls when it moves farther than its limit, which is looked at after each piece of a trial.
  /// `show` is called with the fraction of the trial's largest number of steps, and the unbalanced ratio.
  SafetyTrials(Model& model, std::vector<double> limits, std::int64_t steps_of_piece,
               std::function<void(double, double)> show);

  /// None when it was interrupted. @throws LibraryError
  std::optional<Trial> at(double factor);

  /// Restores the last trial that fell, or the model at rest. @throws LibraryError
  void show_last_fallen();
  bool has_fallen() const { return !fallen_.empty(); }
  const Frame& standing() const { return standing_; }

 private:
  void find_farthest(Trial& trial, bool& is_too_far) const;

  Model& model_;
  std::vector<double> limits_;
  std::int64_t steps_of_piece_;
  std::function<void(double, double)> show_;
  const Frame standing_;
  const std::string at_rest_;  ///< snapshots
  std::string fallen_;
};

}  // namespace halfspace::cli
