#include "studies/safety/search.h"

#include <algorithm>
#include <utility>

#include "common/text.h"
#include "common/vector.h"
#include "output/picture/picture.h"
#include "studies/safety/bisection.h"

namespace halfspace::cli {
namespace {

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
  Bisection bisection(options, words, identity, scene.world.time_step, directory);
  Trials trials(
      std::move(begin), steps_of_trial_piece(scene), [&](double of_trial, const std::string& state) {
        progress.show(
            std::min((static_cast<double>(bisection.count()) + of_trial) / bisection.count_of_all(), 1.0),
            "trial " + std::to_string(bisection.count() + 1) + ", " + bisection.text(false) + ", " + state);
      });
  bool is_over = bisection.run(trials);
  // Impulses without springs give the equilibrium to an error that decreases with the given time step.
  if (is_over && bisection.is_found() && scene.world.time_step > 0 && any_law(scene, has_no_spring))
    is_over = bisection.refine(trials);
  // A failure known from an earlier search is run again for its picture.
  if (is_over && bisection.falls() && !trials.fall())
    is_over = trials.at(bisection.falls()->value, bisection.falls()->time_step).has_value();
  if (bisection.stands()) result.stands = bisection.stands()->value;
  if (bisection.falls()) result.falls = bisection.falls()->value;
  if (!is_over) result.end = SearchEnd::interrupted;
  if (is_over && bisection.is_found()) result.end = SearchEnd::found;
  result.report += report_line(words.sought, (is_over ? "" : "INTERRUPTED: ") + bisection.text(is_over)) +
                   bisection.time_steps() + report_line("trials", std::to_string(bisection.count()));
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
