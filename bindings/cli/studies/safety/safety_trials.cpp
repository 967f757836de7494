#include "studies/safety/safety_trials.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/interrupt.h"
#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

constexpr const char* columns = "factor,stands,moved,block,steps";

double number_of(const std::string& cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !(value >= 0))
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

/// The largest distance of a vertex from the first one.
double size_of(const BlockFrame& block) {
  double size = 0;
  for (const Point& p : block.vertices) size = std::max(size, length(minus(p, block.vertices[0])));
  return size;
}

}  // namespace

std::string csv_of(const std::vector<Trial>& trials, const std::string& search) {
  std::string text = search + '\n' + columns + '\n';
  for (const Trial& trial : trials) {
    text += shortest(trial.factor) + (trial.stands ? ",1," : ",0,") + shortest(trial.moved) + ',' +
            trial.block + ',' + std::to_string(trial.steps) + '\n';
  }
  return text;
}

std::vector<Trial> trials_from(const std::string& csv, const std::string& search) {
  std::istringstream stream(csv);
  std::string line;
  if (!std::getline(stream, line) || line != search)
    throw std::runtime_error("its trials are of another scene or search, or by another version");
  std::getline(stream, line);
  if (line != columns) throw std::runtime_error("its columns are not those of a table of trials");
  std::vector<Trial> trials;
  while (std::getline(stream, line)) trials.push_back(trial_from(line));
  return trials;
}

/// A stable block moves by the elastic slip of the joints between it and the fixed ground, more if it tilts.
/// Ten times the sum over all joints is beyond that. Bodies that strain, and bonds, yield more than their
/// joints, and joints without springs close their gaps: their limit is the largest one.
std::vector<double> limits_of(const Scene& scene, const Model& standing) {
  constexpr double farthest = 0.1, smallest = 1e-3, times_yield = 10;  // of the size of a block, but the last
  const Frame frame = standing.frame();
  const bool is_known =
      scene.bonds.empty() && !standing.layout().has_deformable() && !any_law(scene, has_no_spring);
  double yield = 0;
  for (const hs_contact& contact : standing.contacts()) {
    yield += yield_of(contact, law_between(scene, frame.blocks[contact.block_a].state.material,
                                           frame.blocks[contact.block_b].state.material));
  }
  std::vector<double> limits;
  for (const BlockFrame& block : frame.blocks) {
    const double size = moves_freely(block.state.kind) ? size_of(block) : 0;
    limits.push_back(is_known ? std::clamp(times_yield * yield, smallest * size, farthest * size)
                              : farthest * size);
  }
  return limits;
}

SafetyTrials::SafetyTrials(Model& model, std::vector<double> limits, std::int64_t steps_of_piece,
                           std::function<void(double, double)> show)
    : model_(model),
      limits_(std::move(limits)),
      steps_of_piece_(steps_of_piece),
      show_(std::move(show)),
      standing_(model.frame()),
      at_rest_(model.snapshot()) {}

std::optional<Trial> SafetyTrials::at(double factor) {
  constexpr std::int64_t max_pieces = 200;  // a trial that is not at rest by then falls
  const std::int64_t max_steps = max_pieces * steps_of_piece_;
  Trial trial{.factor = factor};
  hs_relaxation_def piece;
  hs_relaxation_def_init(&piece, sizeof piece);
  piece.hold_bonds = 0;
  piece.max_steps = steps_of_piece_;
  model_.restore(at_rest_);
  model_.weaken(factor);
  bool has_fallen = false;
  while (!trial.stands && !has_fallen && trial.steps < max_steps) {
    if (interrupt_requested()) return std::nullopt;
    hs_balance balance{};
    try {
      trial.stands = model_.settle(piece, balance);
    } catch (const LibraryError& error) {
      if (error.status != HS_ERROR_UNSTABLE && error.status != HS_ERROR_TOO_FAST &&
          error.status != HS_ERROR_INVERTED)
        throw;
      has_fallen = true;
    }
    trial.steps += balance.steps;
    bool is_too_far = false;
    find_farthest(trial, is_too_far);
    has_fallen = has_fallen || is_too_far;
    show_(static_cast<double>(trial.steps) / static_cast<double>(max_steps), balance.mean);
  }
  trial.stands = trial.stands && !has_fallen;
  if (!trial.stands) fallen_ = model_.snapshot();
  return trial;
}

void SafetyTrials::find_farthest(Trial& trial, bool& is_too_far) const {
  const Frame now = model_.frame();
  trial.moved = 0;
  for (std::size_t i = 0; i < now.blocks.size(); ++i) {
    if (!moves_freely(now.blocks[i].state.kind)) continue;
    const double moved = length(minus(point_of(now.blocks[i].state.pose.position),
                                      point_of(standing_.blocks[i].state.pose.position)));
    is_too_far = is_too_far || moved > limits_[i];
    if (moved <= trial.moved) continue;
    trial.moved = moved;
    trial.block = model_.layout().blocks[i].name;
  }
}

void SafetyTrials::show_last_fallen() { model_.restore(fallen_.empty() ? at_rest_ : fallen_); }

}  // namespace halfspace::cli
