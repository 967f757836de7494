#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/files.h"
#include "studies/safety/search.h"
#include "studies/safety/trials.h"

namespace halfspace::cli {

/// Bisects a bracket. Known trials are not repeated.
class Bisection {
 public:
  /// `time_step`: of the scene, s; 0 if it gives none.
  Bisection(const SearchOptions& options, const SearchWords& words, const std::string& identity,
            double time_step, OutputDirectory& directory);

  /// False when it was interrupted.
  bool run(Trials& trials);
  /// Halves the time step until the limit stays within the resolution. False when it was interrupted.
  bool refine(Trials& trials);

  const std::optional<Trial>& stands() const { return stands_; }
  const std::optional<Trial>& falls() const { return falls_; }
  bool is_found() const { return stands_ && falls_; }
  std::size_t count() const { return known_.size(); }
  /// The number of trials for this bracket at one time step.
  double count_of_all() const;

  std::string text(bool is_over) const;
  /// The limits at all time steps; empty if there is one only.
  std::string time_steps() const;

 private:
  /// The limit at a time step.
  struct Limit {
    double time_step = 0, value = 0;
  };

  double stable_end() const { return options_.smallest ? options_.high : options_.low; }
  double falling_end() const { return options_.smallest ? options_.low : options_.high; }
  double middle() const { return 0.5 * (stands_->value + falls_->value); }
  void save();
  bool take(Trials& trials, double value);
  bool narrow(Trials& trials);
  bool bracket_again(Trials& trials);
  bool widen(Trials& trials, bool towards_fall);

  const SearchOptions& options_;
  const SearchWords& words_;
  OutputDirectory& directory_;
  const std::string name_;
  double time_step_;
  std::vector<Trial> known_;
  std::optional<Trial> stands_, falls_;
  std::vector<Limit> limits_;
  bool has_converged_ = false;
};

}  // namespace halfspace::cli
