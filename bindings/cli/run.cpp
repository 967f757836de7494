#include "run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <utility>

#include "history.h"
#include "model.h"
#include "picture/picture.h"
#include "progress.h"
#include "summary.h"
#include "text.h"
#include "vtk_series.h"

namespace halfspace::cli {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupt_asked = 0;
void ask_for_interrupt(int) { interrupt_asked = 1; }

/// Signals that ask for the end, of a user, a terminal that closes or a batch system, end the run as if its
/// time were over. Those that the caller has switched off, as nohup does, stay so. A reader of the output
/// that goes away ends no run.
void end_run_on_signals() {
  for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM, SIGUSR1, SIGUSR2}) {
    if (std::signal(signal, ask_for_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

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
        series_(model.plan(), directory),
        history_(model.plan()),
        start_(model.frame()),
        stage_(scene, start_) {
    peaks_.add(model_.report());
    record_frame();
    history_.add(model_);
    save_history();
  }

  Outcome run(std::string& trouble) {
    Every frames(scene_.output.frame_interval);
    Every rows(scene_.output.history_interval);
    RestWatch rest(scene_.rest_speed);
    Batch batch;
    Progress progress;
    while (!model_.reached(scene_.duration)) {
      const Clock::time_point before = Clock::now();
      const std::int64_t steps_before = model_.report().steps;
      try {
        model_.step_towards(std::min({frames.next(), rows.next(), next_picture(), scene_.duration}),
                            batch.steps());
      } catch (const LibraryError& error) {
        if (error.status != HS_ERROR_UNSTABLE && error.status != HS_ERROR_TOO_FAST) throw;
        trouble = error.what();
        return error.status == HS_ERROR_UNSTABLE ? Outcome::unstable : Outcome::too_fast;
      }
      peaks_.add(model_.report());
      batch.adapt(model_.report().steps - steps_before, Clock::now() - before);
      progress.show(model_.report().time, scene_.duration);
      const bool row_due = rows.due(model_);
      if (row_due) record_row();
      if (frames.due(model_)) record_frame();
      while (model_.reached(next_picture())) record_picture();
      if (row_due && rest.at_rest(model_)) return Outcome::at_rest;
      if (interrupt_asked) return Outcome::interrupted;
    }
    return Outcome::complete;
  }

  /// The last moment, if it was not recorded yet, and the pictures.
  Frame finish() {
    if (last_frame_step_ != model_.report().steps) record_frame();
    if (last_row_step_ != model_.report().steps) record_row();
    save_history();
    const Frame end = model_.frame();
    stage_.add(end);
    const Stage stage = stage_.stage();
    directory_.write("first.svg", picture(stage, scene_, model_.plan(), start_, start_));
    for (std::size_t i = 0; i < pictured_.size(); ++i) {
      directory_.write("at_" + shortest(scene_.output.picture_times[i]) + "s.svg",
                       picture(stage, scene_, model_.plan(), start_, pictured_[i]));
    }
    directory_.write("last.svg", picture(stage, scene_, model_.plan(), start_, end));
    return end;
  }

  const Frame& start() const { return start_; }
  const Peaks& peaks() const { return peaks_; }

 private:
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
  std::int64_t last_row_step_ = 0;
  std::int64_t last_frame_step_ = 0;
};

}  // namespace

RunResult run_scene(const Scene& scene, Model& model, const std::string& notes, OutputDirectory& directory) {
  end_run_on_signals();
  RunResult result;
  Recorder recorder(scene, model, directory);
  const Clock::time_point before = Clock::now();
  result.outcome = recorder.run(result.trouble);
  const std::chrono::duration<double> took = Clock::now() - before;
  const Frame end = recorder.finish();
  result.summary = summary(scene, model, recorder.peaks(), recorder.start(), end, result.outcome) + notes;
  result.timings = timings(model.report(), took.count());
  directory.write("summary.txt", result.summary);
  return result;
}

}  // namespace halfspace::cli
