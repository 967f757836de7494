#include "studies/safety/search.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/hash.h"
#include "common/text.h"
#include "common/vector.h"
#include "output/picture/picture.h"

namespace halfspace::cli {
namespace {

constexpr const char* trials_file = "trials.csv";

/// Bisection between two values; known trials are not repeated.
class Bisection {
 public:
  Bisection(const SearchOptions& options, const SearchWords& words, const std::string& identity,
            OutputDirectory& directory)
      : options_(options),
        words_(words),
        directory_(directory),
        name_("# trials of scene " + std::to_string(hash_of(identity)) + ", limit " +
              shortest(options.limit) + " m, by halfspace " + hs_version()) {
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

  /// False when it was interrupted.
  bool run(Trials& trials) {
    if (!take(trials, stable_end())) return false;
    if (!stands_) return true;
    if (!take(trials, falling_end())) return false;
    while (falls_ && std::abs(falls_->value - stands_->value) > options_.resolution) {
      const double middle = 0.5 * (stands_->value + falls_->value);
      if (middle == stands_->value || middle == falls_->value) break;  // there is no number between them
      if (!take(trials, middle)) return false;
    }
    return true;
  }

  const std::optional<Trial>& stands() const { return stands_; }
  const std::optional<Trial>& falls() const { return falls_; }
  bool is_found() const { return stands_ && falls_; }
  std::size_t count() const { return known_.size(); }
  /// The number of trials for this bracket.
  double count_of_all() const {
    return 2 + std::ceil(std::log2((options_.high - options_.low) / options_.resolution));
  }

  std::string text(bool is_over) const {
    if (is_found()) {
      const std::string bracket =
          "between " + rounded(stands_->value, 5) + " (stable) and " + rounded(falls_->value, 5) + " (falls)";
      return is_over ? rounded(0.5 * (stands_->value + falls_->value), 4) + ", " + bracket : bracket;
    }
    if (falls_) return side(!options_.smallest) + rounded(falls_->value, 4) + ": the scene falls there";
    if (stands_) return side(options_.smallest) + rounded(stands_->value, 4) + ": the scene is stable there";
    return "unknown yet";
  }

 private:
  double stable_end() const { return options_.smallest ? options_.high : options_.low; }
  double falling_end() const { return options_.smallest ? options_.low : options_.high; }
  static const char* side(bool is_below) { return is_below ? "below " : "above "; }

  void save() { directory_.write(trials_file, csv_of(known_, name_, words_.column)); }

  bool take(Trials& trials, double value) {
    const auto known =
        std::find_if(known_.begin(), known_.end(), [&](const Trial& trial) { return trial.value == value; });
    std::optional<Trial> trial;
    if (known != known_.end()) {
      trial = *known;
    } else {
      trial = trials.at(value);
      if (!trial) return false;
      known_.push_back(*trial);
      save();
    }
    (trial->stands ? stands_ : falls_) = trial;
    return true;
  }

  const SearchOptions& options_;
  const SearchWords& words_;
  OutputDirectory& directory_;
  const std::string name_;
  std::vector<Trial> known_;
  std::optional<Trial> stands_, falls_;
};

/// Blocks that have moved by more than a tenth of the largest displacement, largest first.
std::string movers(const Layout& layout, const Frame& standing, const Frame& fallen) {
  constexpr double reported_ratio = 0.1;
  constexpr std::size_t max_names = 5;
  std::vector<std::pair<double, std::size_t>> moved;
  double farthest = 0;
  for (std::size_t i = 0; i < fallen.blocks.size(); ++i) {
    const std::vector<Point>&then = standing.blocks[i].vertices, &now = fallen.blocks[i].vertices;
    double displacement = 0;
    for (std::size_t k = 0; k < now.size(); ++k)
      displacement = std::max(displacement, length(minus(now[k], then[k])));
    if (displacement > 0) moved.push_back({-displacement, i});
    farthest = std::max(farthest, displacement);
  }
  std::erase_if(moved, [&](const auto& mover) { return -mover.first < reported_ratio * farthest; });
  std::sort(moved.begin(), moved.end());
  std::string text = std::to_string(moved.size()) + " of " + std::to_string(fallen.blocks.size());
  for (std::size_t k = 0; k < std::min(moved.size(), max_names); ++k)
    text += (k == 0 ? ": " : ", ") + layout.blocks[moved[k].second].name + " by " +
            rounded(-moved[k].first, 2) + " m";
  return text + (moved.size() > max_names ? ", ..." : "");
}

/// Writes pictures and tables of the stable scene and of the last failure, and reports them.
std::string show_fall(const Scene& scene, const Trials& trials, OutputDirectory& directory) {
  if (!trials.start()) return {};  // all trials were known
  const Frame& standing = trials.fall() ? trials.fall()->start : *trials.start();
  const Layout& layout = (trials.fall() ? trials.fallen_model() : trials.model())->layout();
  RunStage stage(scene, standing);
  stage.add(standing);
  if (trials.fall()) stage.add(trials.fall()->end);
  directory.write("stands.svg", picture(stage.stage(), scene, layout, standing, standing));
  if (!trials.fall()) return {};
  const Trials::Fall& fall = *trials.fall();
  std::string text = report_line("moving blocks", movers(layout, standing, fall.end));
  if (!fall.cracks.empty()) {
    text += report_line("bonds", std::to_string(fall.failed_points) + " points fail");
    directory.write("cracks.csv", fall.cracks);
  }
  directory.write("falls.svg", picture(stage.stage(), scene, layout, standing, fall.end));
  return text;
}

}  // namespace

SearchResult search(const Scene& scene, Trials::Begin begin, const SearchWords& words,
                    const SearchOptions& options, const std::string& identity, const std::string& first_lines,
                    Progress& progress, OutputDirectory& directory) {
  SearchResult result{.report = first_lines};
  Bisection bisection(options, words, identity, directory);
  Trials trials(
      std::move(begin), steps_of_trial_piece(scene), [&](double of_trial, const std::string& state) {
        progress.show(
            (static_cast<double>(bisection.count()) + of_trial) / bisection.count_of_all(),
            "trial " + std::to_string(bisection.count() + 1) + ", " + bisection.text(false) + ", " + state);
      });
  bool is_over = bisection.run(trials);
  // A failure known from an earlier search is run again for its picture.
  if (is_over && bisection.falls() && !trials.fall())
    is_over = trials.at(bisection.falls()->value).has_value();
  if (bisection.stands()) result.stands = bisection.stands()->value;
  if (bisection.falls()) result.falls = bisection.falls()->value;
  if (!is_over) result.end = SearchEnd::interrupted;
  if (is_over && bisection.is_found()) result.end = SearchEnd::found;
  result.report += report_line(words.sought, (is_over ? "" : "INTERRUPTED: ") + bisection.text(is_over)) +
                   report_line("trials", std::to_string(bisection.count()));
  if (trials.largest_limit() > 0) {
    result.report += report_line("limit", rounded(trials.largest_limit(), 3) +
                                              " m, displacement of a fallen block; less for smaller blocks");
  }
  if (const std::optional<Trial>& stands = bisection.stands(); stands && !stands->block.empty()) {
    result.report += report_line("max displacement", stands->block + " by " + rounded(stands->moved, 3) +
                                                         " m at " + rounded(stands->value, 5) + " (stable)");
  }
  result.report += show_fall(scene, trials, directory);
  directory.write(words.report, result.report);
  return result;
}

}  // namespace halfspace::cli
