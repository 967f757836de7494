#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// A scene at rest, weakened by a factor and relaxed again.
struct Trial {
  double factor = 1;
  bool stands = false;
  double moved = 0;        ///< m, of the block that has moved the farthest
  std::string block = {};  ///< which one
  std::int64_t steps = 0;
};

/// The trials of a search as a table, behind a line that tells the search apart from others.
std::string csv_of(const std::vector<Trial>& trials, const std::string& search);
/// @throws std::runtime_error when the table is of another search, or no such table
std::vector<Trial> trials_from(const std::string& csv, const std::string& search);

/// How far any block may move, m, and still stand: a few times what its joints yield before friction gives
/// way, as far as that can be told, and at most a tenth of its size.
std::vector<double> limits_of(const Scene& scene, const Model& standing);

/// Tries factors on a model that is at rest.
class SafetyTrials {
 public:
  /// Each block stands that moves no farther than its limit. `show` is told of the steps done now and then.
  SafetyTrials(Model& model, std::vector<double> limits, std::function<void(std::int64_t, double)> show);

  /// None when it was interrupted. @throws LibraryError
  std::optional<Trial> at(double factor);

  /// The model becomes that of the last trial that fell, or the one at rest. @throws LibraryError
  void show_last_fallen();
  bool has_fallen() const { return !fallen_.empty(); }
  const Frame& standing() const { return standing_; }

  static constexpr std::int64_t max_steps = 100'000;  ///< what is not at rest by then falls

 private:
  void find_farthest(Trial& trial, bool& is_too_far) const;

  Model& model_;
  std::vector<double> limits_;
  std::function<void(std::int64_t, double)> show_;
  const Frame standing_;
  const std::string at_rest_;  ///< snapshots
  std::string fallen_;
};

}  // namespace halfspace::cli
