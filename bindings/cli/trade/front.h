#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trade/convergence.h"
#include "trade/results.h"

namespace halfspace::cli {

/// The runs of a scene measured against its reference: what error each has, and for what cost.
class Front {
 public:
  Front(const Scene& scene, std::vector<Result> results);

  const std::vector<Result>& results() const { return results_; }
  double reference() const { return reference_; }
  bool reference_is_given() const { return is_given_; }
  /// The run of the smallest step with everything else as in the scene; without any, the costliest one.
  const std::optional<Result>& finest() const { return finest_; }
  /// The difference that counts as an error of 1. Where nothing tells it, errors have the unit of the
  /// quantity.
  double scale() const { return scale_; }
  bool has_scale() const { return has_scale_; }
  /// Convergence along the ladder of steps, with everything else as in the scene.
  const Convergence& convergence() const { return convergence_; }
  /// The width, as an error, of the results of starts that differ by 1e-9 of a block's size; none without two
  /// of them.
  std::optional<double> chance() const;

  double error(const Result& result) const;
  /// CPU seconds to a simulated second.
  static double cost(const Result& result);
  /// Has it run to its end, from the scene's own start?
  static bool counts(const Result& result);

  /// Runs that are more exact than all cheaper ones by a twentieth at least, from the cheapest on;
  /// without the one that the others are measured against. Runs with another damping or kind of block are
  /// left out too: they are other models, right by chance at best.
  const std::vector<Result>& best() const { return best_; }
  std::optional<Result> cheapest_within(double tolerance) const;
  /// The run of a setting, when it has gone to its end.
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
