#include "run/run.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "common/archive.h"
#include "common/interrupt.h"
#include "common/text.h"
#include "model/model.h"
#include "output/progress.h"
#include "output/record.h"
#include "output/summary.h"
#include "run/checkpoint.h"
#include "run/settle.h"

namespace halfspace::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// The number of steps per batch: about 0.1 s of wall time, so that progress and interrupts are prompt.
/// Batches end at the steps at which peaks are sampled.
class Batch {
 public:
  std::int64_t steps_from(std::int64_t done) const {
    return std::min(steps_, Peaks::steps_between - done % Peaks::steps_between);
  }
  void adapt(std::int64_t done, std::chrono::duration<double> took) {
    const double target = std::min(2.0, 0.1 / took.count()) * static_cast<double>(done);
    steps_ = std::clamp<std::int64_t>(std::llround(target), 1, Peaks::steps_between);
  }

 private:
  std::int64_t steps_ = 1;
};

/// The position of a run in its stages.
struct Position {
  std::size_t stage = 0;
  bool has_begun = false;
  bool is_over = false;
  bool is_at_rest = false;  ///< ended by rest, not by its duration
  double start = 0;         ///< s
  Settling settling = {};
  double mean = 0, largest = 0;  ///< last unbalanced ratios
  int slow_rows = 0;             ///< consecutive rows of the history with all free blocks slow

  void add_to(Archive& archive) {
    archive.add(stage);
    for (bool* flag : {&has_begun, &is_over, &is_at_rest, &settling.is_balanced, &settling.is_driven})
      archive.add(*flag);
    for (double* value : {&start, &mean, &largest}) archive.add(*value);
    archive.add(settling.steps);
    archive.add(settling.portions);
    archive.add(slow_rows);
    archive.require(settling.steps >= 0 && settling.portions >= 0 && slow_rows >= 0, "a count is below 0");
  }
};

/// A block that reverses is slow at one row only; ten rows are rest.
constexpr int slow_rows_of_rest = 10;

/// All parameters of a stage except its end.
std::string nature_of(const SceneStage& stage) {
  Archive archive;
  const auto add = [&](auto value) { archive.add(value); };
  const auto add_change = [&](const std::optional<double>& change) {
    add(change.has_value());
    add(change.value_or(0));
  };
  add(stage.settles);
  add(stage.gravity.has_value());
  add(stage.gravity.value_or(Point{}));
  add_change(stage.local_damping);
  add_change(stage.mass_damping);
  add_change(stage.strength_factor);
  add_change(stage.loads);
  add(stage.default_law.has_value());
  add(stage.default_law.value_or(hs_law_def{}));
  for (const PairLaw& pair : stage.laws) {
    add(pair.a);
    add(pair.b);
    add(pair.law);
  }
  add(stage.water.has_value());
  if (stage.water) {
    std::vector<Point> table = stage.water->table;
    add(stage.water->def);
    archive.add(table);
  }
  std::vector<std::size_t> installed = stage.installed;
  archive.add(installed);
  add(stage.ramp);
  add(stage.portions);
  add(stage.resets_displacement);
  for (std::string name : stage.excavated) archive.add(name);
  if (stage.settles) {
    add(stage.relaxation.measure);
    add(stage.relaxation.local_damping);
    add(stage.relaxation.is_adaptive);
    add(stage.relaxation.hold_bonds);
  }
  return archive.bytes();
}

/// The parameters of the end of a stage.
std::string end_of(SceneStage stage) {
  Archive archive;
  archive.add(stage.duration);
  archive.add(stage.rest_speed);
  archive.add(stage.relaxation.ratio);
  archive.add(stage.relaxation.max_steps);
  return archive.bytes();
}

/// The stages of a scene: one when it has none.
std::vector<SceneStage> stages_of(const Scene& scene) {
  if (!scene.stages.empty()) return scene.stages;
  return {{.duration = scene.duration, .rest_speed = scene.rest_speed}};
}

/// Steps a model through its stages, and records it on the way.
class Run {
 public:
  Run(const Scene& scene, Model& model, const RunOptions& options, OutputDirectory& directory)
      : scene_(scene),
        stages_(stages_of(scene)),
        model_(model),
        options_(options),
        directory_(directory),
        fingerprint_(fingerprint(model, scene)),
        record_(scene, model, directory, options.on_row),
        progress_(options.on_progress) {
    stage_lines_.resize(stages_.size());
    if (options.from.empty()) {
      record_.set_stage(history_stage());
      record_.begin();
    } else {
      resume_from(options.from);
      if (options.resumes_in_place) {
        directory.remove_frames_from(record_.frame_count());
        directory.remove_stages_from(at_.stage + 1);
      }
    }
  }

  Outcome run(std::string& trouble) {
    try {
      const Outcome outcome = run_stages();
      save_checkpoint();
      return outcome;
    } catch (const LibraryError& error) {
      if (error.status == HS_ERROR_INTERRUPTED) {
        save_checkpoint();
        return Outcome::interrupted;
      }
      if (error.status != HS_ERROR_UNSTABLE && error.status != HS_ERROR_TOO_FAST) throw;
      trouble = model_.with_names(error.what());
      return error.status == HS_ERROR_UNSTABLE ? Outcome::unstable : Outcome::too_fast;
    }
  }

  /// The results of the stages, a line each; empty for a scene without stages.
  std::string stage_lines() const {
    std::string text;
    if (scene_.stages.empty()) return text;
    for (const std::string& line : stage_lines_) text += line;
    return text;
  }

  Record& record() { return record_; }

 private:
  Outcome run_stages() {
    while (true) {
      const SceneStage& stage = stages_[at_.stage];
      if (!at_.has_begun) begin(stage);
      if (!at_.is_over && !(stage.settles ? settle(stage) : run_to_end(stage))) return Outcome::interrupted;
      if (!scene_.stages.empty()) write_checkpoint(stage_checkpoint_name(at_.stage));
      if (at_.stage + 1 == stages_.size()) return at_.is_at_rest ? Outcome::at_rest : Outcome::complete;
      at_ = {.stage = at_.stage + 1};
    }
  }

  void begin(const SceneStage& stage) {
    if (!scene_.stages.empty()) model_.begin(stage, model_.layout().excavated[at_.stage]);
    if (stage.resets_displacement) record_.reset_displacement();
    at_.has_begun = true;
    at_.start = model_.report().time;
    record_.set_stage(history_stage());
  }

  HistoryStage history_stage() const {
    const std::string& name = stages_[at_.stage].name;
    return {name.empty() ? std::to_string(at_.stage) : name, at_.start};
  }

  /// False when it was interrupted.
  bool run_to_end(const SceneStage& stage) {
    Batch batch;
    const double end = at_.start + stage.duration;
    while (!at_.is_at_rest && !has_ended(stage, model_, at_.start)) {
      if (is_interrupted()) return false;
      const Clock::time_point before = Clock::now();
      const std::int64_t steps_before = model_.report().steps;
      change(stage, steps_before);
      const double ramp_end = model_.is_changed() ? end : at_.start + stage.ramp;
      model_.step_towards(std::min({record_.next(), ramp_end, end}), batch.steps_from(steps_before),
                          stage.ends_exactly ? end : Model::never);
      batch.adapt(model_.report().steps - steps_before, Clock::now() - before);
      const double time = model_.report().time;
      progress_.show((time - at_.start) / stage.duration,
                     "t = " + rounded(time, 4) + " of " + rounded(end, 4) + " s");
      if (record_.add_due()) watch_rest(stage);
    }
    if (!at_.is_at_rest) change(stage, model_.report().steps);
    at_.is_over = true;
    report_stage("ran", at_.is_at_rest ? "at rest before its end" : "");
    record_.end_stage(at_.stage, false);
    return true;
  }

  /// Applies gradual changes every few steps and at the end of the ramp, whatever the wall time.
  void change(const SceneStage& stage, std::int64_t steps) {
    if (model_.is_changed()) return;
    const double progress = progress_of(stage, model_, at_.start);
    if (progress == 1 || steps % Peaks::steps_between == 0) model_.change_to(progress);
  }

  /// Ends the stage once all free blocks have been slow for long enough.
  void watch_rest(const SceneStage& stage) {
    const bool is_slow =
        model_.report().largest_speed < stage.rest_speed && model_.motions_over() && model_.is_changed();
    at_.slow_rows = is_slow ? at_.slow_rows + 1 : 0;
    at_.is_at_rest = at_.slow_rows >= slow_rows_of_rest;
  }

  /// Settles portion by portion, in short pieces, so that interrupts are prompt. False when it was
  /// interrupted.
  bool settle(const SceneStage& stage) {
    hs_balance balance{};
    while (!at_.settling.is_over(stage, model_)) {
      if (is_interrupted()) return false;
      balance = settle_on(stage, model_, at_.settling);
      at_.mean = balance.mean;
      at_.largest = balance.largest;
      progress_.show(
          static_cast<double>(at_.settling.steps) / static_cast<double>(stage.relaxation.max_steps),
          "unbalanced " + rounded(balance.mean, 2));
      record_.add_due();
    }
    at_.is_over = true;
    report_stage("settled", (at_.settling.is_balanced ? "at rest after " : "NOT AT REST after ") +
                                std::to_string(at_.settling.steps) + " steps, unbalanced ratio " +
                                rounded(at_.mean, 2) + ", of a single block " + rounded(at_.largest, 2) +
                                drive() +
                                (at_.settling.is_balanced ? "" : largest_force_block(model_, balance)));
    record_.end_stage(at_.stage, true);
    return true;
  }

  /// The motion that keeps a stage from rest.
  std::string drive() const {
    if (!at_.settling.fallen.empty()) return "; \"" + at_.settling.fallen + "\" has fallen out of the scene";
    if (!at_.settling.is_driven) return {};
    return "; \"" + endless_motion(model_) + "\" never stops; give it a stop, or use a stage that runs";
  }

  void report_stage(const std::string& what, const std::string& end) {
    const std::string& name = stages_[at_.stage].name;
    stage_lines_[at_.stage] = padded("stage" + (name.empty() ? "" : ' ' + name), 20) + what + " until " +
                              rounded(model_.report().time, 4) + " s" + (end.empty() ? "" : ", ") + end +
                              '\n';
  }

  /// Called where the state is complete; also writes a checkpoint that is due.
  bool is_interrupted() {
    if (Clock::now() - last_checkpoint_ >= std::chrono::duration<double>(options_.checkpoint_interval))
      save_checkpoint();
    return interrupt_requested();
  }

  void save_checkpoint() {
    write_checkpoint(checkpoint_name);
    last_checkpoint_ = Clock::now();
  }

  void write_checkpoint(const std::string& name) {
    Archive archive;
    add_to(archive);
    directory_.write(name, sealed(archive.bytes()));
  }

  void add_to(Archive& archive) {
    Fingerprint fingerprint = fingerprint_;
    archive.add(fingerprint);
    const std::string difference = difference_of(fingerprint, fingerprint_);
    if (!difference.empty()) throw std::runtime_error(difference);
    at_.add_to(archive);
    add_stages_to(archive);
    model_.add_to(archive);
    archive.require(at_.start <= model_.report().time, "its stage begins after its time");
    archive.require(at_.settling.portions < stages_[at_.stage].portions || model_.is_changed(),
                    "invalid number of portions");
    record_.add_to(archive, options_.resumes_in_place || !archive.reads());
  }

  /// Adds the stages that have begun. The end of the last of them may have changed.
  void add_stages_to(Archive& archive) {
    if (at_.stage >= stages_.size()) throw std::runtime_error("it had more stages");
    for (std::size_t i = 0; i <= at_.stage; ++i) {
      const SceneStage& stage = stages_[i];
      std::string nature = nature_of(stage) + model_.actions_of(i);
      std::string end = end_of(stage);
      archive.add(nature);
      archive.add(end);
      archive.add(stage_lines_[i]);
      if (nature != nature_of(stage) + model_.actions_of(i) || (i < at_.stage && end != end_of(stage)))
        throw std::runtime_error("stage " + std::to_string(i) + ", which it had begun, differs");
    }
  }

  void resume_from(const std::string& state) {
    try {
      Archive archive(state);
      add_to(archive);
      archive.end();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(std::string("the checkpoint is not of this scene: ") + error.what());
    }
    record_.set_stage(history_stage());
    const SceneStage& stage = stages_[at_.stage];
    if (stage.settles) {
      at_.is_over = at_.settling.is_over(stage, model_);
    } else if (!at_.is_at_rest) {
      at_.is_over = has_ended(stage, model_, at_.start);
    }
  }

  const Scene& scene_;
  const std::vector<SceneStage> stages_;
  Model& model_;
  const RunOptions& options_;
  OutputDirectory& directory_;
  const Fingerprint fingerprint_;  ///< of the start
  Record record_;
  Position at_;
  std::vector<std::string> stage_lines_;  ///< of each stage
  Progress progress_;
  Clock::time_point last_checkpoint_ = Clock::now();
};

/// The picture times after the end of a complete run; empty without any.
std::string pictures_left(const Record& record, Outcome outcome) {
  std::string text;
  if (outcome != Outcome::complete && outcome != Outcome::at_rest) return text;
  for (double time : record.times_left()) text += (text.empty() ? "none at " : ", ") + shortest(time);
  return text.empty() ? text : report_line("pictures", text + " s, after the end of the run");
}

}  // namespace

RunResult run_scene(const Scene& scene, Model& model, const std::string& notes, const RunOptions& options,
                    OutputDirectory& directory) {
  RunResult result;
  Run run(scene, model, options, directory);
  const std::int64_t steps_before = model.report().steps;
  const Clock::time_point before = Clock::now();
  result.outcome = run.run(result.trouble);
  const std::chrono::duration<double> took = Clock::now() - before;
  const Frame end = run.record().finish();
  result.summary = summary(scene, model, run.record().peaks(), run.record().start(), end, result.outcome) +
                   run.stage_lines() + pictures_left(run.record(), result.outcome) + notes +
                   residual_note(model.report(), model.bond_report().fracture_loss);
  result.figures = figures_of(model, run.record().peaks(), run.record().start(), end);
  result.timings = timings(model.report(), model.report().steps - steps_before, took.count());
  directory.write("summary.txt", result.summary);
  return result;
}

}  // namespace halfspace::cli
