#include "studies/safety/trials.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/interrupt.h"
#include "common/text.h"
#include "common/vector.h"
#include "output/tables.h"
#include "run/run_on.h"
#include "run/settle.h"

namespace halfspace::cli {
namespace {

std::string columns_of(const std::string& value) { return value + ",stands,moved,block,steps"; }

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
  if (cells.size() != 5) throw std::runtime_error("not a row of trials: " + row);
  return {number_of(cells[0]), cells[1] == "1", number_of(cells[2]), cells[3],
          static_cast<std::int64_t>(number_of(cells[4]))};
}

/// The elastic shear displacement of a contact before it slips, and the compression of its normal spring, m.
double yield_of(const hs_contact& contact, const hs_law_def& law) {
  if (!has_spring(law)) return 0;
  const double area = law.stiffness_kind == HS_STIFFNESS_PER_AREA ? contact.area : 1;
  const double shear = (law.shear_stiffness > 0 ? law.shear_stiffness : law.normal_stiffness) * area;
  const double limit =
      std::tan(law.friction_angle) * std::max(contact.normal_force, 0.0) + law.cohesion * contact.area;
  return (shear > 0 ? limit / shear : 0) + std::max(-contact.gap, 0.0);
}

constexpr double farthest = 0.1;  ///< of the size of a block, the largest limit

/// The largest distance of a vertex from the first one.
double size_of(const BlockFrame& block) {
  double size = 0;
  for (const Point& p : block.vertices) size = std::max(size, length(minus(p, block.vertices[0])));
  return size;
}

Point displacement(const BlockFrame& start, const BlockFrame& now) {
  return minus(point_of(now.state.pose.position), point_of(start.state.pose.position));
}

/// The ground moves with the prescribed blocks where no block is fixed, as in an earthquake.
Point displacement_of_ground(const Frame& start, const Frame& now) {
  Point sum{};
  double count = 0;
  for (std::size_t i = 0; i < now.blocks.size(); ++i) {
    if (is_removed(now.blocks[i])) continue;
    if (now.blocks[i].state.kind == HS_BLOCK_FIXED) return {};
    if (now.blocks[i].state.kind != HS_BLOCK_PRESCRIBED) continue;
    sum = plus(sum, displacement(start.blocks[i], now.blocks[i]));
    ++count;
  }
  return count > 0 ? times(1 / count, sum) : sum;
}

}  // namespace

std::string csv_of(const std::vector<Trial>& trials, const std::string& search, const std::string& column) {
  std::string text = search + '\n' + columns_of(column) + '\n';
  for (const Trial& trial : trials) {
    text += shortest(trial.value) + (trial.stands ? ",1," : ",0,") + shortest(trial.moved) + ',' +
            trial.block + ',' + std::to_string(trial.steps) + '\n';
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

/// A stable block moves by the elastic slip of the joints between it and the fixed ground, more if it tilts.
/// Ten times the sum over all joints is beyond that. Bodies that strain, and bonds, yield more than their
/// joints, and joints without springs close their gaps: their limit is the largest one.
std::vector<double> limits_at_rest(const Scene& scene, const Model& standing) {
  constexpr double smallest = 1e-3, times_yield = 10;  // the first of the size of a block
  const Frame frame = standing.frame();
  const bool is_known =
      scene.bonds.empty() && !standing.layout().has_deformable() && !any_law(scene, has_no_spring);
  double yield = 0;
  for (const hs_contact& contact : standing.contacts()) {
    yield += yield_of(contact, law_between(scene, frame.blocks[contact.block_a].state.material,
                                           frame.blocks[contact.block_b].state.material));
  }
  std::vector<double> limits = limits_at_start(frame);
  for (double& limit : limits)
    if (is_known) limit = std::clamp(times_yield * yield, smallest / farthest * limit, limit);
  return limits;
}

std::vector<double> limits_at_start(const Frame& start) {
  std::vector<double> limits;
  for (const BlockFrame& block : start.blocks)
    limits.push_back(moves_freely(block.state.kind) ? farthest * size_of(block) : 0);
  return limits;
}

std::vector<SceneStage> stages_of_search(const Scene& scene) {
  if (!scene.stages.empty()) return scene.stages;
  SceneStage stage{.settles = true};
  hs_relaxation_def_init(&stage.relaxation, sizeof stage.relaxation);
  return {stage};
}

/// A step without springs is some hundred times as long.
std::int64_t steps_of_trial_piece(const Scene& scene) { return any_law(scene, has_spring) ? 500 : 20; }

Trials::Trials(Begin begin, std::int64_t steps_of_piece, Show show)
    : begin_(std::move(begin)), steps_of_piece_(steps_of_piece), show_(std::move(show)) {}

std::optional<Trial> Trials::at(double value) {
  const TrialStart start = begin_(value);
  model_ = start.model;
  start_ = model_->frame();
  largest_limit_ = *std::max_element(start.limits.begin(), start.limits.end());
  const std::size_t events_before = model_->bond_events().size();
  Trial trial{.value = value, .stands = true};
  for (std::size_t i = 0; i < start.stages.size() && trial.stands; ++i) {
    if (start.are_of_scene) model_->begin(start.stages[i], model_->layout().excavated[i]);
    const std::optional<bool> stands = stands_through(start.stages[i], start.limits, trial);
    if (!stands) return std::nullopt;
    trial.stands = *stands;
  }
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
      if (error.status != HS_ERROR_UNSTABLE && error.status != HS_ERROR_TOO_FAST &&
          error.status != HS_ERROR_INVERTED)
        throw;
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
  const Frame now = model_->frame();
  const Point of_ground = displacement_of_ground(*start_, now);
  bool is_too_far = false;
  trial.moved = 0;
  for (std::size_t i = 0; i < now.blocks.size(); ++i) {
    if (!moves_freely(now.blocks[i].state.kind)) continue;
    const double moved = length(minus(displacement(start_->blocks[i], now.blocks[i]), of_ground));
    is_too_far = is_too_far || moved > limits[i];
    if (moved <= trial.moved) continue;
    trial.moved = moved;
    trial.block = model_->layout().blocks[i].name;
  }
  return is_too_far;
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
