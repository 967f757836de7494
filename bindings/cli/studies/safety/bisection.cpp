#include "studies/safety/bisection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/hash.h"
#include "common/text.h"

namespace halfspace::cli {
namespace {

constexpr const char* trials_file = "trials.csv";

/// At 1/64 of the given time step a search has cost more than a hundred times as much.
constexpr int max_halvings = 6;

const char* side(bool is_below) { return is_below ? "below " : "above "; }

}  // namespace

Bisection::Bisection(const SearchOptions& options, const SearchWords& words, const std::string& identity,
                     double time_step, OutputDirectory& directory)
    : options_(options),
      words_(words),
      directory_(directory),
      name_("# trials of scene " + std::to_string(hash_of(identity)) + ", limit " + shortest(options.limit) +
            " m, by halfspace " + hs_version()),
      time_step_(time_step) {
  if (!options.resumes) {
    save();
    return;
  }
  const std::string file = (directory.path() / trials_file).string();
  try {
    known_ = trials_from(content_of(file), name_, words.column);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot resume from " + file + ": " + error.what());
  }
}

bool Bisection::run(Trials& trials) {
  if (!take(trials, stable_end())) return false;
  if (!stands_) return true;
  return take(trials, falling_end()) && narrow(trials);
}

/// Bisects a bracket, if there is one.
bool Bisection::narrow(Trials& trials) {
  while (is_found() && std::abs(falls_->value - stands_->value) > options_.resolution) {
    const double value = middle();
    if (value == stands_->value || value == falls_->value) break;  // there is no number between them
    if (!take(trials, value)) return false;
  }
  return true;
}

bool Bisection::refine(Trials& trials) {
  limits_.push_back({time_step_, middle()});
  for (int i = 0; i < max_halvings && !has_converged_; ++i) {
    time_step_ *= 0.5;
    if (!bracket_again(trials)) return false;
    if (!is_found()) return true;
    limits_.push_back({time_step_, middle()});
    has_converged_ = std::abs(middle() - limits_[limits_.size() - 2].value) <= options_.resolution;
  }
  return true;
}

/// Finds the bracket at a new time step, from that at the last one.
bool Bisection::bracket_again(Trials& trials) {
  const double stable = stands_->value, falling = falls_->value;
  stands_.reset();
  falls_.reset();
  if (!take(trials, falling)) return false;
  if (falls_ && !take(trials, stable)) return false;
  return is_found() || (widen(trials, stands_.has_value()) && narrow(trials));
}

/// Goes from a bracket of which both ends stand, or both fall, to the other kind of trial, in steps that
/// double.
bool Bisection::widen(Trials& trials, bool towards_fall) {
  const double end = towards_fall ? falling_end() : stable_end();
  const double from = towards_fall ? stands_->value : falls_->value;
  for (double step = options_.resolution; !is_found(); step *= 2) {
    const double value = end > from ? std::min(from + step, end) : std::max(from - step, end);
    if (!take(trials, value)) return false;
    if (value == end) break;
  }
  return true;
}

double Bisection::count_of_all() const {
  return 2 + std::ceil(std::log2((options_.high - options_.low) / options_.resolution));
}

std::string Bisection::text(bool is_over) const {
  if (is_found()) {
    const std::string bracket =
        "between " + rounded(stands_->value, 5) + " (stable) and " + rounded(falls_->value, 5) + " (falls)";
    return is_over ? rounded(middle(), 4) + ", " + bracket : bracket;
  }
  if (falls_) return side(!options_.smallest) + rounded(falls_->value, 4) + ": the scene falls there";
  if (stands_) return side(options_.smallest) + rounded(stands_->value, 4) + ": the scene is stable there";
  return "unknown yet";
}

std::string Bisection::time_steps() const {
  if (limits_.size() < 2) return {};
  std::string text = has_converged_ ? "halved until the result stays within " + shortest(options_.resolution)
                                    : "NOT CONVERGED: the result still changes with it";
  for (const Limit& limit : limits_)
    text += (&limit == &limits_.front() ? ": " : ", ") + rounded(limit.value, 4) + " at " +
            rounded(limit.time_step, 3) + " s";
  return report_line("time step", text);
}

void Bisection::save() { directory_.write(trials_file, csv_of(known_, name_, words_.column)); }

bool Bisection::take(Trials& trials, double value) {
  const auto known = std::find_if(known_.begin(), known_.end(), [&](const Trial& trial) {
    return trial.value == value && trial.time_step == time_step_;
  });
  std::optional<Trial> trial;
  if (known != known_.end()) {
    trial = *known;
  } else {
    trial = trials.at(value, time_step_);
    if (!trial) return false;
    known_.push_back(*trial);
    save();
  }
  (trial->stands ? stands_ : falls_) = trial;
  return true;
}

}  // namespace halfspace::cli
