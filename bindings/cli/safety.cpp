#include "safety.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "picture/picture.h"
#include "settle.h"
#include "tables.h"
#include "text.h"
#include "vector.h"

namespace halfspace::cli {
namespace {

/// Stage by stage; a scene without any settles under its loads. What is left unbalanced where it fails to.
std::string not_settled(const Scene& scene, Model& model) {
  std::vector<SceneStage> stages = scene.stages;
  if (stages.empty()) {
    stages.push_back({.settles = true});
    hs_relaxation_def_init(&stages[0].relaxation, sizeof stages[0].relaxation);
  }
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const SceneStage& stage = stages[i];
    if (!scene.stages.empty()) model.begin(stage, model.layout().excavated[i]);
    hs_balance balance{};
    if (!settle(stage, model, balance))
      return "unbalanced by " + rounded(balance.mean, 2) + " of all forces after " +
             std::to_string(balance.steps) + " steps";
  }
  return {};
}

/// Blocks that have moved by more than a hundredth of its size, the farthest first.
std::string movers(const Layout& layout, const Frame& standing, const Frame& fallen) {
  constexpr double told_share = 0.01;
  constexpr std::size_t most_names = 5;
  std::vector<std::pair<double, std::size_t>> moved;
  for (std::size_t i = 0; i < fallen.blocks.size(); ++i) {
    const std::vector<Point>&then = standing.blocks[i].vertices, &now = fallen.blocks[i].vertices;
    double way = 0, size = 0;
    for (std::size_t k = 0; k < now.size(); ++k) {
      way = std::max(way, length(minus(now[k], then[k])));
      size = std::max(size, length(minus(then[k], then[0])));
    }
    if (way > told_share * size) moved.push_back({-way, i});
  }
  std::sort(moved.begin(), moved.end());
  std::string text = std::to_string(moved.size()) + " of " + std::to_string(fallen.blocks.size());
  for (std::size_t k = 0; k < std::min(moved.size(), most_names); ++k)
    text += (k == 0 ? ": " : ", ") + layout.blocks[moved[k].second].name + " by " +
            rounded(-moved[k].first, 2) + " m";
  return text + (moved.size() > most_names ? ", ..." : "");
}

std::string factor_text(const hs_strength_report& found) {
  if (!found.stands_at_low) return "below " + rounded(found.low, 4) + ": the scene falls even there";
  if (!found.falls_at_high) return "above " + rounded(found.high, 4) + ": the scene stands even there";
  return rounded(found.factor, 4) + ", between " + rounded(found.low, 5) + ", where it stands, and " +
         rounded(found.high, 5) + ", where it falls";
}

}  // namespace

SafetyResult find_factor_of_safety(const Scene& scene, Model& model, const SafetyOptions& options,
                                   OutputDirectory& directory) {
  SafetyResult result;
  result.report = report_line("scene", scene.title);
  const std::string trouble = not_settled(scene, model);
  if (!trouble.empty()) {
    result.report += report_line("not at rest", trouble + ": no factor is looked for");
    directory.write("safety.txt", result.report);
    return result;
  }
  hs_strength_def def;
  hs_strength_def_init(&def, sizeof def);
  def.low = options.low;
  def.high = options.high;
  def.resolution = options.resolution;
  const Frame standing = model.frame();
  const std::size_t bonds_before = model.bond_events().size();
  const auto [found, falls] = model.find_strength_factor(def);
  result.is_found = found.stands_at_low && found.falls_at_high;
  result.report += report_line("factor of safety", factor_text(found)) +
                   report_line("trials", std::to_string(found.trials));
  RunStage stage(scene, standing);
  stage.add(standing);
  const Frame fallen = falls ? model.frame() : standing;
  stage.add(fallen);
  directory.write("stands.svg", picture(stage.stage(), scene, model.layout(), standing, standing));
  if (falls) {
    result.report += report_line("what moves", movers(model.layout(), standing, fallen));
    const std::size_t failed = model.bond_events().size() - bonds_before;
    if (!scene.bonds.empty()) {
      result.report += report_line("bonds", std::to_string(failed) + " of their points fail");
      directory.write("cracks.csv", cracks_table(model));
    }
    directory.write("falls.svg", picture(stage.stage(), scene, model.layout(), standing, fallen));
  }
  directory.write("safety.txt", result.report);
  return result;
}

}  // namespace halfspace::cli
