#pragma once

#include <string>
#include <vector>

#include "common/archive.h"
#include "model/model.h"
#include "output/joint_motion.h"

namespace halfspace::cli {

/// The stage of a row of the history.
struct HistoryStage {
  std::string name;  ///< or its number, if it has none
  double start = 0;  ///< s
};

/// history.csv: a row for each output time, with time, energies, contacts, and the motion of the tracked
/// blocks, points and joints.
class History {
 public:
  /// The model is at its start.
  History(const Scene& scene, const Model& start);
  /// Displacements of points are measured from the frame `origin`.
  void add(const Model& model, const HistoryStage& stage, const Frame& origin);
  void add_to(Archive& archive) { archive.add(text_); }
  const std::string& text() const { return text_; }

 private:
  void add_points(const Model& model, const Frame& origin);
  void add_joints(const Model& model);

  bool has_stages_, has_water_, has_bolts_;
  std::vector<CarriedPoint> points_;
  std::vector<JointMotion> joints_;
  std::string text_;
};

}  // namespace halfspace::cli
