#include "studies/trade/chart.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "output/picture/svg.h"
#include "studies/trade/runs.h"

namespace halfspace::cli {
namespace {

constexpr double left = 84, top = 64, width = 560, height = 380, legend = 170;
constexpr const char* colours[] = {"#1b6ca8", "#d1495b", "#3a7d44", "#7b3294", "#8c6d1f", "#4d4d4d"};
static_assert(std::size(colours) >= law_names.size(), "each law has a colour");

/// Whole decades that enclose the values.
struct Decades {
  double low = INFINITY;
  double high = -INFINITY;

  void hold(double value) {
    low = std::min(low, std::floor(std::log10(value)));
    high = std::max(high, std::ceil(std::log10(value)));
  }
  void widen() {
    if (!(high > low)) high = low + 1;
  }
  double position(double value) const { return (std::log10(value) - low) / (high - low); }
};

/// The lower limit of drawn errors.
constexpr double min_error = 1e-9;

class Chart {
 public:
  Chart(const Scene& scene, const Front& front)
      : scene_(scene), front_(front), svg_(left + width + legend, top + height + 64) {
    for (const Result& run : front.results()) {
      if (!Front::counts(run)) continue;
      costs_.hold(cost_of(run));
      errors_.hold(error_of(run));
    }
    costs_.widen();
    errors_.widen();
  }

  std::string text() {
    svg_.rectangle({0, 0}, left + width + legend, top + height + 64, R"(fill="#ffffff")");
    draw_axes();
    draw_chance();
    for (const Result& run : front_.results())
      if (Front::counts(run)) draw_dot(run);
    draw_best();
    draw_legend();
    return svg_.text();
  }

 private:
  static double cost_of(const Result& run) { return std::max(Front::cost(run), 1e-12); }
  double error_of(const Result& run) const { return std::max(front_.error(run), min_error); }
  Point at(double cost, double error) const {
    return {left + width * costs_.position(cost), top + height * (1 - errors_.position(error))};
  }
  Point at(const Result& run) const { return at(cost_of(run), error_of(run)); }
  int law_of(const Result& run) const { return run.setting.law.value_or(scene_.default_law.stiffness_kind); }

  void draw_axes() {
    svg_.label({left, 24}, scene_.title, 15, "start");
    svg_.label({left, 44}, "error of the " + describe_quantity(scene_), 12, "start");
    for (double power = costs_.low; power <= costs_.high; ++power) {
      const double x = left + width * (power - costs_.low) / (costs_.high - costs_.low);
      svg_.line({x, top}, {x, top + height}, R"(stroke="#dddddd")");
      svg_.label({x, top + height + 20}, shortest(std::pow(10.0, power)), 12, "middle");
    }
    for (double power = errors_.low; power <= errors_.high; ++power) {
      const double y = top + height * (errors_.high - power) / (errors_.high - errors_.low);
      svg_.line({left, y}, {left + width, y}, R"(stroke="#dddddd")");
      svg_.label({left - 8, y + 4}, shortest(std::pow(10.0, power)), 12, "end");
    }
    svg_.rectangle({left, top}, width, height, R"(fill="none" stroke="#888888")");
    svg_.label({left + width / 2, top + height + 46}, unit_of_cost(scene_), 13, "middle");
    svg_.label({22, top + height / 2}, front_.has_scale() ? "error" : "error (unit of the quantity)", 13,
               "middle", -90);
  }

  /// The band of errors that are due to chance.
  void draw_chance() {
    const std::optional<double> chance = front_.chance();
    if (!chance || *chance <= std::pow(10.0, errors_.low)) return;
    const double position = std::min(errors_.position(*chance), 1.0);
    svg_.rectangle({left, top + height * (1 - position)}, width, height * position,
                   R"(fill="#f2b134" fill-opacity="0.18")");
    svg_.label({left + width - 8, top + height * (1 - position) + 16}, "chance", 12, "end");
  }

  void draw_dot(const Result& run) {
    constexpr double r = 4;
    const Point c = at(run);
    std::vector<Point> circle;
    for (int i = 0; i < 12; ++i)
      circle.push_back({c[0] + r * std::cos(i * 0.5236), c[1] + r * std::sin(i * 0.5236), 0});
    svg_.polygon(circle, std::string("fill=\"") + colours[law_of(run)] + R"(" fill-opacity="0.7")");
  }

  void draw_best() {
    const std::vector<Result> best = front_.best();
    for (std::size_t i = 1; i < best.size(); ++i)
      svg_.line(at(best[i - 1]), at(best[i]), R"(stroke="#222222" stroke-width="1.5")");
  }

  void draw_legend() {
    double y = top + 10;
    for (const int law : law_kinds) {
      const bool is_there =
          std::any_of(front_.results().begin(), front_.results().end(),
                      [&](const Result& run) { return Front::counts(run) && law_of(run) == law; });
      if (!is_there) continue;
      svg_.rectangle({left + width + 16, y - 9}, 10, 10, std::string("fill=\"") + colours[law] + '"');
      svg_.label({left + width + 32, y}, name_of_law(law), 12, "start");
      y += 20;
    }
    svg_.line({left + width + 14, y - 4}, {left + width + 28, y - 4},
              R"(stroke="#222222" stroke-width="1.5")");
    svg_.label({left + width + 32, y}, "Pareto front", 12, "start");
  }

  const Scene& scene_;
  const Front& front_;
  Svg svg_;
  Decades costs_, errors_;
};

}  // namespace

std::string chart(const Scene& scene, const Front& front) { return Chart(scene, front).text(); }

}  // namespace halfspace::cli
