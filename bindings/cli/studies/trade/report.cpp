#include "studies/trade/report.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "studies/trade/runs.h"

namespace halfspace::cli {
namespace {

std::string trade_line(const std::string& name, const std::string& text) {
  return report_line(name, text, 18);
}

std::string step_text(double step) { return step == 1 ? "1" : "1/" + std::to_string(std::lround(1 / step)); }

std::string with_unit(double value, const Scene& scene) {
  const std::string unit = unit_of(scene.reference.quantity);
  return rounded(value, 7) + (unit.empty() ? "" : " " + unit);
}

std::string convergence_text(const Front& front) {
  const Convergence& found = front.convergence();
  if (!found.is_known) return "unknown: too few runs";
  const double change = found.last_change / front.scale();
  if (front.chance() > change && change > 0)
    return "within chance: the last halving of the step changes the result by " + rounded(change, 2);
  if (!found.converges)
    return "NO: halving the step changes the result by " + rounded(change, 2) +
           ", no less than the halving before";
  if (found.order == 0) return "yes, to rounding";
  return "yes, order " + rounded(found.order, 2) + " of the last three steps; their limit is " +
         rounded(found.limit, 7);
}

std::string reference_text(const Scene& scene, const Front& front) {
  const std::string value = with_unit(front.reference(), scene);
  if (front.reference_is_given()) return value + ", given by the scene";
  if (!front.finest()) return "none: no run reached its end";
  return value + ", of the finest run (" + describe(front.finest()->setting) + "), as the scene gives none";
}

std::string scale_text(const Scene& scene, const Front& front) {
  if (front.has_scale()) return "1 is " + with_unit(front.scale(), scene);
  return std::string("in ") + unit_of(scene.reference.quantity) +
         ", as the natural scale is 0; give a scale in [reference]";
}

std::string chance_text(const Front& front, double tolerance) {
  const std::optional<double> chance = front.chance();
  if (!chance) return "unknown: too few runs";
  return rounded(*chance, 2) + " between starts that differ by 1e-9 of a block's size" +
         (*chance > tolerance ? ": MORE THAN THE TOLERANCE, so that no setting is surely within it" : "");
}

/// The discretization error of the cells. The errors of the runs do not contain it, as their reference has
/// the same cells.
std::string cells_line(const Front& front, double tolerance) {
  const std::optional<Result> own = front.run_of({.step = held_step}),
                              finer = front.run_of({.step = held_step, .cells = 2});
  if (!own || !finer) return {};
  const double change = std::abs(finer->outcomes.value - own->outcomes.value) / front.scale();
  return trade_line("cells", "twice as many along each length change the result by " + rounded(change, 2) +
                                 (change > tolerance ? ": MORE THAN THE TOLERANCE, refine the cells" : ""));
}

std::string row(const Front& front, const Result& run) {
  return padded(rounded(front.error(run), 2), 12) + padded(rounded(Front::cost(run), 3), 12) +
         describe(run.setting) + '\n';
}

std::string front_text(const Scene& scene, const Front& front) {
  if (front.best().empty()) return {};
  std::string text = "\nPareto front, with the scene's damping and kinds of blocks\nerror       " +
                     padded(scene.stages.empty() ? "CPU s / s" : "CPU s", 12) + "setting\n";
  for (const Result& run : front.best()) text += row(front, run);
  return text;
}

std::string costs_text(const Scene& scene, const Front& front) {
  if (!front.has_scale()) return {};
  std::string text = "\ncost to reach\n";
  for (const double error : {0.1, 0.01, 0.001, 0.0001}) {
    const std::optional<Result> run = front.cheapest_within(error);
    text += padded(rounded(100 * error, 3) + " %", 12) +
            (run ? rounded(Front::cost(*run), 3) + ' ' + unit_of_cost(scene) : "not reached") + '\n';
  }
  return text;
}

/// The difference between two runs, as an error.
std::string apart(const Front& front, const Result& run, const Result& from) {
  const double difference = std::abs(run.outcomes.value - from.outcomes.value);
  return rounded(difference / front.scale(), 2);
}

/// The effect of one parameter, with all others as in the scene: each of its values against one of them.
class ParameterEffect {
 public:
  ParameterEffect(const Front& front, std::string name, const Setting& against)
      : front_(front), against_(front.run_of(against)) {
    text_ = padded(std::move(name), 14);
  }
  void add(const std::string& name, const Setting& setting) {
    const std::optional<Result> run = front_.run_of(setting);
    if (!run || !against_) return;
    text_ += (any_ ? ", " : "") + name + ' ' + apart(front_, *run, *against_);
    any_ = true;
  }
  std::string text() const { return any_ ? text_ + '\n' : std::string(); }

 private:
  const Front& front_;
  std::optional<Result> against_;
  std::string text_;
  bool any_ = false;
};

std::string parameters_text(const Front& front) {
  const Setting held{.step = held_step};
  ParameterEffect steps(front, "time step", {.step = std::end(step_ladder)[-1]});
  for (const double step : step_ladder)
    if (step != std::end(step_ladder)[-1]) steps.add(step_text(step) + ':', {.step = step});
  ParameterEffect stiffness(front, "stiffness", held);
  for (const double factor : stiffness_ladder)
    stiffness.add("x " + shortest(factor) + ':', {.step = held_step, .stiffness = factor});
  ParameterEffect laws(front, "law", held);
  for (const int law : law_kinds) laws.add(name_of_law(law) + ':', {.step = held_step, .law = law});
  ParameterEffect cells(front, "cells", held);
  for (const double factor : cell_factors)
    cells.add("x " + shortest(factor) + ':', {.step = held_step, .cells = factor});
  ParameterEffect kinds(front, "kind", held);
  for (const int kind : block_kinds)
    kinds.add(name_of_kind(kind) + std::string(":"), {.step = held_step, .kind = kind});
  ParameterEffect dampings(front, "damping", held);
  for (const double damping : damping_values)
    dampings.add(shortest(damping) + ':', {.step = held_step, .damping = damping});
  ParameterEffect skins(front, "skin", held);
  for (const double skin : skin_values) skins.add(shortest(skin) + ':', {.step = held_step, .skin = skin});
  ParameterEffect tolerances(front, "tolerance", held);
  for (const double tolerance : tolerance_values)
    tolerances.add(shortest(tolerance) + ':', {.step = held_step, .tolerance = tolerance});
  const std::string text = steps.text() + stiffness.text() + laws.text() + cells.text() + kinds.text() +
                           dampings.text() + skins.text() + tolerances.text();
  if (text.empty()) return text;
  return "\nerror by parameter, all others held\n" + text +
         "(the step against the finest, the others against the scene's own at the same step)\n";
}

const char* reason_of(RunEnd end) {
  switch (end) {
    case RunEnd::unstable:
      return "unstable";
    case RunEnd::too_fast:
      return "refused, as blocks are too fast for the step";
    case RunEnd::inverted:
      return "refused, as a cell would turn inside out";
    case RunEnd::too_few_steps:
      return "too few steps for the time";
    case RunEnd::not_at_rest:
      return "a stage is not at rest after its max_steps";
    case RunEnd::no_angle:
      return "stable without friction, or not stable at 89 degrees";
    default:
      return "interrupted";
  }
}

std::string failures_text(const Front& front) {
  std::string text;
  for (const Result& run : front.results()) {
    if (run.outcomes.end != RunEnd::whole)
      text += "  " + describe(run.setting) + ": " + reason_of(run.outcomes.end) + '\n';
  }
  return text.empty() ? text : "\nruns without a result\n" + text;
}

std::string left_out_text(int left_out) {
  if (left_out == 0) return {};
  return "\nthe budget left out " + std::to_string(left_out) + (left_out == 1 ? " run" : " runs") +
         "; --resume with a larger one adds them\n";
}

/// Rigid blocks with springs that some run has without.
bool leaves_out_springs(const Scene& scene, const Front& front) {
  return !has_stable_step(with_setting(scene, {.law = HS_STIFFNESS_NONE}, {})) &&
         std::any_of(front.results().begin(), front.results().end(),
                     [](const Result& run) { return run.setting.law == HS_STIFFNESS_NONE; });
}

std::string cheapest_text(const Scene& scene, const Front& front, const FaceSize& face, double tolerance) {
  const std::string limit =
      front.has_scale() ? rounded(100 * tolerance, 3) + " %" : with_unit(tolerance, scene);
  const std::optional<Result> run = front.cheapest_within(tolerance);
  if (!run) return "\nno setting was within " + limit + '\n';
  return "\ncheapest within " + limit + " (error " + rounded(front.error(*run), 2) + ", " +
         rounded(Front::cost(*run), 3) + ' ' + unit_of_cost(scene) + ")\n\n" +
         scene_lines(run->setting, scene, face);
}

}  // namespace

std::string describe(const Setting& setting) {
  std::string text = "step " + step_text(setting.step);
  if (setting.stiffness != 1) text += ", stiffness x " + shortest(setting.stiffness);
  if (setting.cells != 1) text += ", cells x " + shortest(setting.cells);
  if (setting.law) text += ", " + name_of_law(*setting.law);
  if (setting.kind) text += std::string(", ") + name_of_kind(*setting.kind) + " blocks";
  if (setting.damping) text += ", damping " + shortest(*setting.damping);
  if (setting.skin) text += ", skin " + shortest(*setting.skin);
  if (setting.tolerance) text += ", tolerance " + shortest(*setting.tolerance);
  if (setting.disturbance > 0) text += ", disturbed start " + std::to_string(setting.disturbance);
  return text;
}

std::string report(const Scene& scene, const Front& front, const FaceSize& face, double tolerance,
                   int left_out) {
  std::string step;
  if (!has_stable_step(scene)) {
    step = trade_line("time step",
                      "fractions of the scene's own: without springs and elements there is no stable one");
  } else {
    if (scene.world.time_step != 0)
      step = trade_line("time step", "the scene's own is not used: steps are fractions of the stable one");
    if (leaves_out_springs(scene, front))
      step += trade_line("without springs", "steps are fractions of 1/60 s");
  }
  return trade_line("scene", scene.title.empty() ? "untitled" : scene.title) +
         (scene.settings.empty() ? std::string() : trade_line("set", scene.settings)) +
         trade_line("quantity", describe_quantity(scene)) +
         trade_line("reference", reference_text(scene, front)) +
         trade_line("error", scale_text(scene, front)) + step +
         trade_line("runs converge", convergence_text(front)) +
         trade_line("by chance", chance_text(front, tolerance)) + cells_line(front, tolerance) +
         front_text(scene, front) + costs_text(scene, front) + parameters_text(front) + failures_text(front) +
         left_out_text(left_out) + cheapest_text(scene, front, face, tolerance);
}

}  // namespace halfspace::cli
