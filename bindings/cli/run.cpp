#include "run.h"

#include <algorithm>
#include <chrono>
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

/// Something to be done at every multiple of an interval.
class Every {
 public:
  explicit Every(double interval) : interval_(interval) {}
  double next() const { return static_cast<double>(count_) * interval_; }
  bool due(const Model& model) {
    const bool is_due = model.reached(next());
    while (model.reached(next())) ++count_;
    return is_due;
  }

 private:
  double interval_;
  std::int64_t count_ = 1;
};

/// Steps between two looks at the clock: about a tenth of a second, so that progress and interrupts are
/// prompt.
class Batch {
 public:
  std::int64_t steps() const { return steps_; }
  void adapt(std::chrono::duration<double> took) {
    if (took.count() < 0.05) steps_ = std::min<std::int64_t>(2 * steps_, 1 << 20);
    if (took.count() > 0.2) steps_ = std::max<std::int64_t>(steps_ / 2, 1);
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
        start_(model.frame()) {
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
      try {
        model_.step_towards(std::min({frames.next(), rows.next(), next_picture(), scene_.duration}),
                            batch.steps());
      } catch (const LibraryError& error) {
        if (error.status != HS_ERROR_UNSTABLE) throw;
        trouble = error.what();
        return Outcome::unstable;
      }
      batch.adapt(Clock::now() - before);
      progress.show(model_.report().time, scene_.duration);
      const bool row_due = rows.due(model_);
      if (row_due) record_row();
      if (frames.due(model_)) record_frame();
      if (model_.reached(next_picture())) pictured_.push_back(model_.frame());
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
    const Stage stage = stage_for(scene_, start_, end);
    directory_.write("first.svg", picture(stage, scene_, model_.plan(), start_, start_));
    for (std::size_t i = 0; i < pictured_.size(); ++i) {
      directory_.write("at_" + shortest(scene_.output.picture_times[i]) + "s.svg",
                       picture(stage, scene_, model_.plan(), start_, pictured_[i]));
    }
    directory_.write("last.svg", picture(stage, scene_, model_.plan(), start_, end));
    return end;
  }

  const Frame& start() const { return start_; }

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
  void record_frame() {
    series_.add(model_.frame(), start_);
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
  std::vector<Frame>
      pictured_;  ///< at the picture times, kept because all pictures share the stage of the last
  std::int64_t last_row_step_ = 0;
  std::int64_t last_frame_step_ = 0;
};

}  // namespace

RunResult run_scene(const Context& context, const Scene& scene, Plan plan, OutputDirectory& directory) {
  std::signal(SIGINT, ask_for_interrupt);
  std::signal(SIGTERM, ask_for_interrupt);
  RunResult result;
  Model model(context, scene, std::move(plan));
  Recorder recorder(scene, model, directory);
  const Clock::time_point before = Clock::now();
  result.outcome = recorder.run(result.trouble);
  const std::chrono::duration<double> took = Clock::now() - before;
  const Frame end = recorder.finish();
  result.summary = summary(scene, model, recorder.start(), end, result.outcome);
  result.timings = timings(model.report(), took.count());
  directory.write("summary.txt", result.summary);
  return result;
}

}  // namespace halfspace::cli
