#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/trade/convergence.h"
#include "studies/trade/results.h"

namespace halfspace::cli {

/// The errors of the runs of a scene against its reference, and their costs.
class Front {
 public:
  Front(const Scene& scene, std::vector<Result> results);

  const std::vector<Result>& results() const { return results_; }
  double reference() const { return reference_; }
  bool reference_is_given() const { return is_given_; }
  /// The run with the smallest step and all else as in the scene, or else the costliest run.
  const std::optional<Result>& finest() const { return finest_; }
  /// The difference that is an error of 1. Without a scale, errors have the unit of the quantity.
  double scale() const { return scale_; }
  bool has_scale() const { return has_scale_; }
  /// Convergence along the ladder of steps, with everything else as in the scene.
  const Convergence& convergence() const { return convergence_; }
  /// The scatter, as an error, of results from starts that differ by 1e-9 of a block's size; empty for fewer
  /// than two.
  std::optional<double> chance() const;

  double error(const Result& result) const;
  /// CPU seconds per simulated second.
  static double cost(const Result& result);
  /// True for a run that has reached its end, from the undisturbed start.
  static bool counts(const Result& result);

  /// The Pareto front, cheapest first: runs with an error at least 5 % below that of all cheaper ones.
  /// Without the reference run, and without runs of another damping or kind of block, which are other models
  /// and may match by chance.
  const std::vector<Result>& best() const { return best_; }
  std::optional<Result> cheapest_within(double tolerance) const;
  /// The run of a setting, if it has reached its end.
  std::optional<Result> run_of(const Setting& setting) const;

 private:
  std::vector<Result> find_best() const;

  std::vector<Result> results_, best_;
  Convergence convergence_;
  std::optional<Result> finest_;
  bool is_given_;
  double reference_ = 0;
  double scale_ = 1;
  bool has_scale_ = false;
};

}  // namespace halfspace::cli
