#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <string>
#include <vector>

#include "archive.h"
#include "files.h"
#include "history.h"
#include "model.h"
#include "picture/stage.h"
#include "scene.h"
#include "summary.h"
#include "vtk_series.h"

namespace halfspace::cli {

/// Something to be done at every multiple of an interval, but not twice at a step.
class Every {
 public:
  explicit Every(double interval) : interval_(interval) {}
  double next() const { return count_ * interval_; }
  bool due(const Model& model);
  /// One that is read goes on from the moment of the model, if its interval has changed.
  void add_to(Archive& archive, const Model& model);

 private:
  double interval_;
  double count_ = 1;  ///< whole; more than any integer has room for where the interval is tiny
};

/// The files of a run as it goes on: frames, history, and pictures at its end.
class Record {
 public:
  /// The model is at its start.
  Record(const Scene& scene, const Model& model, OutputDirectory& directory);

  /// Records the first moment.
  void begin();

  /// When something is to be recorded next.
  double next() const;
  /// Records what is due now; true when that is a row of the history.
  bool add_due();
  /// A row, a frame and, where the scene wants it, a picture of the moment at which a stage ends.
  void end_stage(std::size_t number, bool settles);
  /// Picture times that the run has not come to.
  std::vector<double> times_left() const;
  void add_frame();
  /// The last moment, if it was not recorded yet, and the pictures.
  Frame finish();

  /// All that it knows of the run so far. One that is read goes on where that was written, and lists earlier
  /// frames only if they are in its directory. @throws std::runtime_error if pictures were to be made before
  /// that at other times
  void add_to(Archive& archive, bool has_frames);

  /// Displacements, in frames and pictures, are those from now on.
  void reset_displacement();
  bool has_frame_of_now() const { return last_frame_step_ == model_.report().steps; }
  int frame_count() const { return series_.count(); }
  const Frame& start() const { return origins_.front(); }
  const Peaks& peaks() const { return peaks_; }

 private:
  /// The origin of what a picture shows: heights of layers are those at the start.
  const Frame& shown_from(std::size_t origin) const;
  double next_picture() const;
  void add_row();
  void add_picture();
  void save_tables();

  const Scene& scene_;
  const Model& model_;
  OutputDirectory& directory_;
  VtkSeries series_;
  History history_;
  std::deque<Frame> origins_;  ///< that displacements are measured from: the start, and later ones
  RunStage stage_;
  Peaks peaks_;
  std::vector<Frame> pictured_;  ///< at the picture times; their common stage is known at the end
  std::vector<std::size_t> origin_of_pictured_;  ///< which of the origins
  struct StagePicture {
    std::size_t stage = 0;
    Frame frame;
    std::size_t origin = 0;
  };
  std::vector<StagePicture> of_stages_;
  Every frames_;
  Every rows_;
  std::int64_t last_row_step_ = 0;
  std::int64_t last_frame_step_ = 0;
};

}  // namespace halfspace::cli
