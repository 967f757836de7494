#include "studies/trade/front.h"

#include <algorithm>
#include <cmath>

#include "studies/trade/measure.h"
#include "studies/trade/runs.h"

namespace halfspace::cli {
namespace {

/// The rounding error of a sum of many numbers of this size.
double rounding_of(double size) { return 0x1p-44 * size; }

double natural_scale(const Reference& reference, double value, double start) {
  switch (reference.quantity) {
    case Quantity::position:
    case Quantity::height:
      return std::abs(value - start);
    case Quantity::stands:
      return 1;
    default:
      return std::abs(value);
  }
}

std::optional<Result> costliest(const std::vector<Result>& results) {
  std::optional<Result> costliest;
  for (const Result& run : results) {
    if (Front::counts(run) && (!costliest || Front::cost(run) > Front::cost(*costliest))) costliest = run;
  }
  return costliest;
}

bool is_same_model(const Result& run) { return !run.setting.kind && !run.setting.damping; }

}  // namespace

Front::Front(const Scene& scene, std::vector<Result> results)
    : results_(std::move(results)), is_given_(scene.reference.value.has_value()) {
  std::vector<double> ladder;
  finest_ = costliest(results_);
  for (const double step : step_ladder) {
    const std::optional<Result> run = run_of({.step = step});
    if (!run && !ladder.empty()) break;  // the steps on both sides of a gap differ by more than a factor of 2
    if (!run) continue;
    ladder.push_back(run->outcomes.value);
    finest_ = run;
  }
  const double start = finest_ ? finest_->outcomes.start : 0;
  const double size = ladder.empty() ? 0 : std::abs(ladder.back()) + std::abs(ladder.back() - start);
  const bool is_angle = scene.reference.quantity == Quantity::friction_angle;
  convergence_ = convergence_of(ladder, is_angle ? 2 * angle_resolution() : rounding_of(size));
  reference_ = is_given_ ? *scene.reference.value : finest_ ? finest_->outcomes.value : 0;
  const double natural = natural_scale(scene.reference, reference_, start);
  has_scale_ = scene.reference.scale || natural > rounding_of(std::abs(reference_) + std::abs(start));
  if (has_scale_) scale_ = scene.reference.scale.value_or(natural);
  best_ = find_best();
}

bool Front::counts(const Result& result) {
  return result.outcomes.end == RunEnd::whole && result.setting.disturbance == 0;
}

double Front::error(const Result& result) const {
  return std::abs(result.outcomes.value - reference_) / scale_;
}

double Front::cost(const Result& result) {
  return result.outcomes.cpu_seconds / std::max(result.outcomes.simulated, 1e-300);
}

std::optional<double> Front::chance() const {
  double lowest = INFINITY, highest = -INFINITY;
  int count = 0;
  for (const Result& result : results_) {
    if (result.setting.disturbance == 0 || result.outcomes.end != RunEnd::whole) continue;
    lowest = std::min(lowest, result.outcomes.value);
    highest = std::max(highest, result.outcomes.value);
    ++count;
  }
  if (count < 2) return std::nullopt;
  return (highest - lowest) / scale_;
}

std::vector<Result> Front::find_best() const {
  std::vector<Result> runs;
  const auto is_reference = [&](const Result& run) {
    return !is_given_ && finest_ && run.setting == finest_->setting;
  };
  std::copy_if(results_.begin(), results_.end(), std::back_inserter(runs),
               [&](const Result& run) { return counts(run) && is_same_model(run) && !is_reference(run); });
  std::sort(runs.begin(), runs.end(), [this](const Result& p, const Result& q) {
    return std::pair(cost(p), error(p)) < std::pair(cost(q), error(q));
  });
  std::vector<Result> best;
  for (const Result& run : runs)
    if (best.empty() || error(run) < 0.95 * error(best.back())) best.push_back(run);
  return best;
}

std::optional<Result> Front::cheapest_within(double tolerance) const {
  for (const Result& run : best_)
    if (error(run) <= tolerance) return run;
  return std::nullopt;
}

std::optional<Result> Front::run_of(const Setting& setting) const {
  for (const Result& result : results_)
    if (result.setting == setting && result.outcomes.end == RunEnd::whole) return result;
  return std::nullopt;
}

}  // namespace halfspace::cli
