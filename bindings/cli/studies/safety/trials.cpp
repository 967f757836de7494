#include "studies/safety/trials.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/interrupt.h"
#include "common/text.h"
#include "output/tables.h"
#include "run/run_on.h"
#include "run/settle.h"

namespace halfspace::cli {
namespace {

std::string columns_of(const std::string& value) { return value + ",stands,moved,block,steps,time_step"; }

double number_of(const std::string& cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw std::runtime_error("not a number: " + cell);
  return value;
}

Trial trial_from(const std::string& row) {
  std::istringstream stream(row);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  if (cells.size() != 6) throw std::runtime_error("not a row of trials: " + row);
  return {number_of(cells[0]),
          cells[1] == "1",
          number_of(cells[2]),
          cells[3],
          static_cast<std::int64_t>(number_of(cells[4])),
          number_of(cells[5])};
}

}  // namespace

std::string csv_of(const std::vector<Trial>& trials, const std::string& search, const std::string& column) {
  std::string text = search + '\n' + columns_of(column) + '\n';
  for (const Trial& trial : trials) {
    text += shortest(trial.value) + (trial.stands ? ",1," : ",0,") + shortest(trial.moved) + ',' +
            trial.block + ',' + std::to_string(trial.steps) + ',' + shortest(trial.time_step) + '\n';
  }
  return text;
}

std::vector<Trial> trials_from(const std::string& csv, const std::string& search, const std::string& column) {
  std::istringstream stream(csv);
  std::string line;
  if (!std::getline(stream, line) || line != search)
    throw std::runtime_error("its trials are of another scene or search, or by another version");
  std::getline(stream, line);
  if (line != columns_of(column)) throw std::runtime_error("its columns are not those of a table of trials");
  std::vector<Trial> trials;
  while (std::getline(stream, line)) trials.push_back(trial_from(line));
  return trials;
}

std::vector<SceneStage> stages_of_search(const Scene& scene) {
  if (!scene.stages.empty()) return scene.stages;
  SceneStage stage{.settles = true};
  hs_relaxation_def_init(&stage.relaxation, sizeof stage.relaxation);
  return {stage};
}

bool is_failure(const LibraryError& error) {
  return error.status == HS_ERROR_UNSTABLE || error.status == HS_ERROR_TOO_FAST ||
         error.status == HS_ERROR_INVERTED;
}

/// A step without springs is some hundred times as long.
std::int64_t steps_of_trial_piece(const Scene& scene) { return any_law(scene, has_spring) ? 500 : 20; }

Trials::Trials(Begin begin, std::int64_t steps_of_piece, Show show)
    : begin_(std::move(begin)), steps_of_piece_(steps_of_piece), show_(std::move(show)) {}

std::optional<Trial> Trials::at(double value, double time_step) {
  const TrialStart start = begin_(value);
  model_ = start.model;
  model_->set_time_step(time_step);
  start_ = model_->frame();
  largest_limit_ = *std::max_element(start.limits.begin(), start.limits.end());
  const std::size_t events_before = model_->bond_events().size();
  Trial trial{.value = value, .stands = true, .time_step = time_step};
  for (std::size_t i = 0; i < start.stages.size() && trial.stands; ++i) {
    if (start.are_of_scene) model_->begin(start.stages[i], model_->layout().excavated[i]);
    const std::optional<bool> stands = stands_through(start.stages[i], start.limits, trial);
    if (!stands) return std::nullopt;
    trial.stands = *stands;
  }
  if (trial.stands && start.confirms) trial.stands = start.confirms(*model_);
  if (interrupt_requested()) return std::nullopt;
  if (!trial.stands) remember_fall(events_before);
  return trial;
}

std::optional<bool> Trials::stands_through(const SceneStage& stage, const std::vector<double>& limits,
                                           Trial& trial) {
  Settling settling;
  const std::int64_t steps_before = trial.steps, steps_at_start = model_->report().steps;
  const double start = model_->report().time;
  const auto is_over = [&] {
    return stage.settles ? settling.is_over(stage, *model_) : has_ended(stage, *model_, start);
  };
  bool has_fallen = false;
  while (!has_fallen && !is_over()) {
    if (interrupt_requested()) return std::nullopt;
    hs_balance balance{};
    try {
      if (stage.settles)
        balance = settle_on(stage, *model_, settling, steps_of_piece_);
      else
        run_on(stage, *model_, start, steps_of_piece_);
    } catch (const LibraryError& error) {
      if (!is_failure(error)) throw;
      has_fallen = true;
    }
    if (find_farthest(limits, trial)) has_fallen = true;
    if (stage.settles) {
      trial.steps = steps_before + settling.steps;
      show_(static_cast<double>(settling.steps) / static_cast<double>(stage.relaxation.max_steps),
            "unbalanced " + rounded(balance.mean, 2));
    } else {
      trial.steps = steps_before + model_->report().steps - steps_at_start;
      show_((model_->report().time - start) / stage.duration,
            "t = " + rounded(model_->report().time, 4) + " s");
    }
  }
  return !has_fallen && (!stage.settles || settling.is_at_rest(*model_));
}

bool Trials::find_farthest(const std::vector<double>& limits, Trial& trial) const {
  const std::vector<double> moved = displacements(*start_, model_->frame());
  const auto farthest = std::max_element(moved.begin(), moved.end());
  trial.moved = *farthest;
  if (trial.moved > 0)
    trial.block = model_->layout().blocks[static_cast<std::size_t>(farthest - moved.begin())].name;
  return std::mismatch(moved.begin(), moved.end(), limits.begin(), std::less_equal<>()).first != moved.end();
}

void Trials::remember_fall(std::size_t events_before) {
  const bool has_bonds = model_->bond_report().bond_count > 0;
  fallen_model_ = model_;
  fall_ = {.start = *start_,
           .end = model_->frame(),
           .cracks = has_bonds ? cracks_table(*model_) : std::string(),
           .failed_points = model_->bond_events().size() - events_before};
}

}  // namespace halfspace::cli
