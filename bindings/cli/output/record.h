#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "common/archive.h"
#include "common/files.h"
#include "model/model.h"
#include "output/bolt_history.h"
#include "output/history.h"
#include "output/picture/stage.h"
#include "output/summary.h"
#include "output/vtk_series.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// An output at every multiple of an interval, at most once per step.
class Every {
 public:
  explicit Every(double interval) : interval_(interval) {}
  double next() const { return count_ * interval_; }
  bool due(const Model& model);
  /// After reading with another interval, it continues from the time of the model.
  void add_to(Archive& archive, const Model& model);

 private:
  double interval_;
  double count_ = 1;  ///< a whole number, beyond any integer for tiny intervals
};

/// The output of a run: frames and history on the way, pictures at its end.
class Record {
 public:
  /// The model is at its start. `on_row` is called after each row of the history.
  Record(const Scene& scene, const Model& model, OutputDirectory& directory,
         std::function<void(const Model&)> on_row = {});

  /// The stage of the following rows of the history.
  void set_stage(HistoryStage stage) { history_stage_ = std::move(stage); }
  /// Records the start.
  void begin();

  /// The time of the next output.
  double next() const;
  /// Records the output due now; true if that has a row of the history.
  bool add_due();
  /// Records the end of a stage: a row, a frame and, if the scene has stage pictures, a picture.
  void end_stage(std::size_t number, bool settles);
  /// Picture times that the run has not reached.
  std::vector<double> times_left() const;
  void add_frame();
  /// Records the end, unless it is recorded already, and draws the pictures.
  Frame finish();

  /// Adds the state of the record to an archive, or restores it; earlier frames are listed only if they are
  /// in the directory. @throws std::runtime_error if earlier picture times differ
  void add_to(Archive& archive, bool has_frames);

  /// Measures displacements, in frames and pictures, from now on.
  void reset_displacement();
  bool has_frame_of_now() const { return last_frame_step_ == model_.report().steps; }
  int frame_count() const { return series_.count(); }
  const Frame& start() const { return origins_.front(); }
  const Peaks& peaks() const { return peaks_; }

 private:
  /// The origin of the displacements in a picture; layers have the heights at the start.
  const Frame& shown_from(std::size_t origin) const;
  double next_picture() const;
  void add_row();
  void add_picture();
  void save_tables();
  /// Writes the files that remain the same during a run.
  void save_descriptions();

  const Scene& scene_;
  const Model& model_;
  OutputDirectory& directory_;
  VtkSeries series_;
  History history_;
  HistoryStage history_stage_;
  BoltHistory bolts_;
  std::deque<Frame> origins_;  ///< of displacements: the start, and later ones
  RunStage stage_;
  Peaks peaks_;
  std::vector<Frame> pictured_;                  ///< at the picture times; drawn at the end
  std::vector<std::size_t> origin_of_pictured_;  ///< indices in origins_
  struct StagePicture {
    std::size_t stage = 0;
    Frame frame;
    std::size_t origin = 0;
  };
  std::vector<StagePicture> of_stages_;
  bool has_descriptions_ = false;
  Every frames_;
  Every rows_;
  std::function<void(const Model&)> on_row_;
  std::int64_t last_row_step_ = 0;
  std::int64_t last_frame_step_ = 0;
};

}  // namespace halfspace::cli
