#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "commands/checked_scene.h"
#include "common/vector.h"
#include "model/model.h"
#include "studies/safety/search.h"

namespace halfspace::cli {

/// The quantity that a search for a limit varies.
enum class Varied { tilt, loads, setting };

struct LimitOptions {
  Varied varied = Varied::tilt;
  /// The axis of a tilt: x, y, z, -x, -y or -z; empty: z in 2D, x in 3D. Or the group, mesh or mesh/group of
  /// loads; empty: all. Or the key of a setting.
  std::string name = {};
  std::optional<double> low,
      high;               ///< the bracket; required for a setting, else 0 to 90 degrees or a factor of 10
  double resolution = 0;  ///< 0: a thousandth of the bracket
  double limit = 0;       ///< m, displacement of a fallen block; 0: by its size
  bool smallest = false;
  bool resumes = false;
  ProgressListener on_progress = {};
};

/// Reads a scene, with the context of its blocks.
using ReadScene = std::function<CheckedScene(const SceneFile&)>;

/// Bisects the largest, or the smallest, value at which a scene is stable. A tilt is searched from rest, or
/// from the start of a last stage that runs; each trial of a load or a setting is a new scene.
class LimitSearch {
 public:
  /// Makes the scene at both ends of the bracket. @throws std::invalid_argument for options that do not fit
  LimitSearch(SceneFile file, LimitOptions options, ReadScene read);

  /// The faults at both ends, and without any the notes at the low end.
  const Faults& faults() const { return low_end_.faults; }

  /// Once, and only without faults. @throws LibraryError, std::runtime_error
  SearchResult find(OutputDirectory& directory);

 private:
  CheckedScene made_at(double value) const;
  TrialStart begin(double value) const;

  SceneFile file_;
  LimitOptions options_;
  ReadScene read_;
  double low_ = 0, high_ = 0;
  CheckedScene low_end_;
  Point axis_{};
  std::shared_ptr<Model> model_;  ///< at the low end
};

}  // namespace halfspace::cli
