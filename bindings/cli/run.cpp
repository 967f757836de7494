#include "run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "history.h"
#include "interrupt.h"
#include "model.h"
#include "picture/picture.h"
#include "progress.h"
#include "summary.h"
#include "text.h"
#include "vtk_series.h"

namespace halfspace::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Something to be done at every multiple of an interval, but not twice at a step.
class Every {
 public:
  explicit Every(double interval) : interval_(interval) {}
  double next() const { return count_ * interval_; }
  bool due(const Model& model) {
    if (!model.reached(next())) return false;
    const double passed = (model.report().time + model.report().time_step / 2) / interval_;
    count_ = std::min(std::max(count_ + 1, std::ceil(passed)), std::numeric_limits<double>::max());
    return true;
  }

 private:
  double interval_;
  double count_ = 1;  ///< whole; more than any integer has room for where the interval is tiny
};

/// Steps between two looks at the clock: about a tenth of a second, so that progress and interrupts are
/// prompt.
class Batch {
 public:
  std::int64_t steps() const { return steps_; }
  void adapt(std::int64_t done, std::chrono::duration<double> took) {
    const double wanted = std::min(2.0, 0.1 / took.count()) * static_cast<double>(done);
    steps_ = std::clamp<std::int64_t>(std::llround(wanted), 1, Peaks::steps_between);
  }

 private:
  std::int64_t steps_ = 1;
};

/// Has every rigid block been slow at enough rows of the history in a row? A block at the turn of its path is
/// slow once; ten rows are no turn.
class RestWatch {
 public:
  explicit RestWatch(double speed) : speed_(speed) {}
  bool at_rest(const Model& model) {
    const bool slow = model.report().largest_speed < speed_ && model.motions_over();
    slow_rows_ = slow ? slow_rows_ + 1 : 0;
    return slow_rows_ >= 10;
  }

 private:
  double speed_;
  int slow_rows_ = 0;
};

/// Steps a model to its end and records it on the way.
class Recorder {
 public:
  Recorder(const Scene& scene, Model& model, OutputDirectory& directory)
      : scene_(scene),
        model_(model),
        directory_(directory),
        series_(model.layout(), directory),
        history_(model.layout()),
        start_(model.frame()),
        stage_(scene, start_),
        frames_(scene.output.frame_interval),
        rows_(scene.output.history_interval) {
    peaks_.add(model_.report());
    record_frame();
    history_.add(model_);
    save_history();
  }

  /// Stage by stage, or for the scene's duration when it has none.
  Outcome run(std::string& trouble) {
    try {
      if (scene_.stages.empty()) return run_until(scene_.duration, scene_.rest_speed);
      Outcome outcome = Outcome::complete;
      for (const SceneStage& stage : scene_.stages) {
        model_.begin(stage);
        outcome = stage.settles ? settle(stage)
                                : run_until(model_.report().time + stage.duration, stage.rest_speed);
        if (!stage.settles)
          told_ += stage_line(stage, outcome == Outcome::at_rest ? "at rest before its end" : "");
        if (outcome == Outcome::interrupted) break;
      }
      return outcome;
    } catch (const LibraryError& error) {
      if (error.status != HS_ERROR_UNSTABLE && error.status != HS_ERROR_TOO_FAST) throw;
      trouble = error.what();
      return error.status == HS_ERROR_UNSTABLE ? Outcome::unstable : Outcome::too_fast;
    }
  }

  /// What has become of each stage, a line each.
  const std::string& told() const { return told_; }

  /// The last moment, if it was not recorded yet, and the pictures.
  Frame finish() {
    if (last_frame_step_ != model_.report().steps) record_frame();
    if (last_row_step_ != model_.report().steps) record_row();
    save_history();
    const Frame end = model_.frame();
    stage_.add(end);
    const Stage stage = stage_.stage();
    directory_.write("first.svg", picture(stage, scene_, model_.layout(), start_, start_));
    for (std::size_t i = 0; i < pictured_.size(); ++i) {
      directory_.write("at_" + shortest(scene_.output.picture_times[i]) + "s.svg",
                       picture(stage, scene_, model_.layout(), start_, pictured_[i]));
    }
    directory_.write("last.svg", picture(stage, scene_, model_.layout(), start_, end));
    return end;
  }

  const Frame& start() const { return start_; }
  const Peaks& peaks() const { return peaks_; }

 private:
  Outcome run_until(double end, double rest_speed) {
    RestWatch rest(rest_speed);
    Batch batch;
    const double start = model_.report().time;
    while (!model_.reached(end)) {
      const Clock::time_point before = Clock::now();
      const std::int64_t steps_before = model_.report().steps;
      model_.step_towards(std::min({frames_.next(), rows_.next(), next_picture(), end}), batch.steps());
      batch.adapt(model_.report().steps - steps_before, Clock::now() - before);
      const double time = model_.report().time;
      progress_.show((time - start) / (end - start),
                     "t = " + rounded(time, 4) + " of " + rounded(end, 4) + " s");
      const bool row_due = record_due();
      if (row_due && rest.at_rest(model_)) return Outcome::at_rest;
      if (interrupt_asked()) return Outcome::interrupted;
    }
    return Outcome::complete;
  }

  /// Piece by piece, so that who interrupts it does not wait for long.
  Outcome settle(const SceneStage& stage) {
    constexpr std::int64_t steps_of_piece = 20000;
    std::int64_t steps = 0;
    hs_balance balance{};
    bool is_at_rest = false, is_interrupted = false;
    while (!is_at_rest && !is_interrupted && steps < stage.relaxation.most_steps) {
      hs_relaxation_def piece = stage.relaxation;
      piece.most_steps = std::min(steps_of_piece, stage.relaxation.most_steps - steps);
      is_at_rest = model_.settle(piece, balance);
      steps += balance.steps;
      progress_.show(static_cast<double>(steps) / static_cast<double>(stage.relaxation.most_steps),
                     "unbalanced " + rounded(balance.mean, 2));
      record_due();
      is_interrupted = !is_at_rest && interrupt_asked();
    }
    told_ +=
        stage_line(stage, (is_at_rest ? "at rest after " : "NOT AT REST after ") + std::to_string(steps) +
                              " steps, unbalanced by " + rounded(balance.mean, 2) + " of all forces, by " +
                              rounded(balance.largest, 2) + " of a single block's");
    if (last_frame_step_ != model_.report().steps) record_frame();
    return is_interrupted ? Outcome::interrupted : Outcome::complete;
  }

  std::string stage_line(const SceneStage& stage, const std::string& end) const {
    const std::string name = stage.name.empty() ? "" : " " + stage.name;
    return padded("stage" + name, 20) + (stage.settles ? "settled" : "ran") + " until " +
           rounded(model_.report().time, 4) + " s" + (end.empty() ? "" : ", ") + end + '\n';
  }

  /// Records what is due now; true when that is a row of the history.
  bool record_due() {
    peaks_.add(model_.report());
    const bool row_due = rows_.due(model_);
    if (row_due) record_row();
    if (frames_.due(model_)) record_frame();
    while (model_.reached(next_picture())) record_picture();
    return row_due;
  }
  double next_picture() const {
    const std::vector<double>& times = scene_.output.picture_times;
    return pictured_.size() < times.size() ? times[pictured_.size()]
                                           : std::numeric_limits<double>::infinity();
  }
  void record_row() {
    history_.add(model_);
    last_row_step_ = model_.report().steps;
  }
  void record_picture() {
    pictured_.push_back(model_.frame());
    stage_.add(pictured_.back());
  }
  void record_frame() {
    const Frame frame = model_.frame();
    series_.add(frame, start_);
    stage_.add(frame);
    last_frame_step_ = model_.report().steps;
    save_history();
  }
  void save_history() { directory_.write("history.csv", history_.text()); }

  const Scene& scene_;
  Model& model_;
  OutputDirectory& directory_;
  VtkSeries series_;
  History history_;
  Frame start_;
  RunStage stage_;
  Peaks peaks_;
  std::vector<Frame>
      pictured_;  ///< at the picture times; all pictures share a stage that is known at the end
  Every frames_;
  Every rows_;
  Progress progress_;
  std::string told_;
  std::int64_t last_row_step_ = 0;
  std::int64_t last_frame_step_ = 0;
};

}  // namespace

RunResult run_scene(const Scene& scene, Model& model, const std::string& notes, OutputDirectory& directory) {
  remember_interrupts();
  RunResult result;
  Recorder recorder(scene, model, directory);
  const Clock::time_point before = Clock::now();
  result.outcome = recorder.run(result.trouble);
  const std::chrono::duration<double> took = Clock::now() - before;
  const Frame end = recorder.finish();
  result.summary = summary(scene, model, recorder.peaks(), recorder.start(), end, result.outcome) +
                   recorder.told() + notes;
  result.timings = timings(model.report(), took.count());
  directory.write("summary.txt", result.summary);
  return result;
}

}  // namespace halfspace::cli
