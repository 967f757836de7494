#include "output/picture/line_chart.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "output/picture/colour.h"
#include "output/picture/svg.h"

namespace halfspace::cli {
namespace {

constexpr double chart_left = 92, chart_top = 56, chart_width = 560, chart_height = 380;

/// The range of an axis.
struct Span {
  double low = INFINITY;
  double high = -INFINITY;

  void hold(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Leaves room at both ends.
  void widen() {
    if (!(low <= high)) low = high = 0;
    const double margin = high > low ? 0.05 * (high - low) : std::max(0.1 * std::abs(high), 0.1);
    low -= margin;
    high += margin;
  }
  double position(double value) const { return (value - low) / (high - low); }
};

class LineDrawing {
 public:
  explicit LineDrawing(const LineChart& chart)
      : chart_(chart),
        width_(chart_left + chart_width + (chart.lines.size() > 1 ? 190 : 24)),
        svg_(width_, chart_top + chart_height + 64) {
    for (const LineChart::Line& line : chart.lines) {
      for (const Point& p : line.points) {
        x_.hold(p[0]);
        y_.hold(p[1]);
      }
    }
    x_.widen();
    y_.widen();
  }

  std::string text() {
    svg_.rectangle({0, 0}, width_, chart_top + chart_height + 64, R"(fill="#ffffff")");
    svg_.label({chart_left, 28}, chart_.title, 15, "start");
    draw_axes();
    for (std::size_t i = 0; i < chart_.lines.size(); ++i) draw(chart_.lines[i], colour_of_line(i));
    if (chart_.lines.size() > 1) draw_legend();
    return svg_.text();
  }

 private:
  Point at(double x, double y) const {
    return {chart_left + chart_width * x_.position(x), chart_top + chart_height * (1 - y_.position(y))};
  }

  std::string colour_of_line(std::size_t i) const {
    const auto count = static_cast<double>(std::max<std::size_t>(chart_.lines.size() - 1, 1));
    return hex(ramp_colour(0.85 * static_cast<double>(i) / count));
  }

  void draw_tick(double x, const std::string& name) {
    const double pixel = at(x, y_.low)[0];
    svg_.line({pixel, chart_top}, {pixel, chart_top + chart_height}, R"(stroke="#dddddd")");
    svg_.label({pixel, chart_top + chart_height + 20}, name, 12, "middle");
  }

  void draw_axes() {
    for (std::size_t i = 0; i < chart_.x_names.size(); ++i)
      draw_tick(static_cast<double>(i), chart_.x_names[i]);
    if (chart_.x_names.empty()) {
      const double step = even_step(x_.high - x_.low, 7);
      for (const double x : multiples_of(step, x_.low, x_.high))
        draw_tick(x, number_on_scale(x, step, x_.low, x_.high));
    }
    const double step = even_step(y_.high - y_.low, 6);
    for (const double y : multiples_of(step, y_.low, y_.high)) {
      const double pixel = at(x_.low, y)[1];
      svg_.line({chart_left, pixel}, {chart_left + chart_width, pixel}, R"(stroke="#dddddd")");
      svg_.label({chart_left - 8, pixel + 4}, number_on_scale(y, step, y_.low, y_.high), 12, "end");
    }
    svg_.rectangle({chart_left, chart_top}, chart_width, chart_height, R"(fill="none" stroke="#888888")");
    svg_.label({chart_left + chart_width / 2, chart_top + chart_height + 46}, chart_.x_label, 13, "middle");
    svg_.label({22, chart_top + chart_height / 2}, chart_.y_label, 13, "middle", -90);
  }

  void draw(const LineChart::Line& line, const std::string& colour) {
    const auto is_drawn = [](const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); };
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      if (!is_drawn(line.points[i])) continue;
      const Point here = at(line.points[i][0], line.points[i][1]);
      svg_.rectangle({here[0] - 3, here[1] - 3}, 6, 6, "fill=\"" + colour + '"');
      if (i == 0 || !is_drawn(line.points[i - 1])) continue;
      svg_.line(at(line.points[i - 1][0], line.points[i - 1][1]), here,
                "stroke=\"" + colour + "\" stroke-width=\"1.5\"");
    }
  }

  void draw_legend() {
    constexpr std::size_t max_names = 18;
    const double x = chart_left + chart_width + 16;
    double y = chart_top + 10;
    svg_.label({x, y}, chart_.line_label, 12, "start");
    for (std::size_t i = 0; i < std::min(chart_.lines.size(), max_names); ++i) {
      y += 20;
      svg_.rectangle({x, y - 9}, 10, 10, "fill=\"" + colour_of_line(i) + '"');
      svg_.label({x + 16, y}, chart_.lines[i].name, 12, "start");
    }
    if (chart_.lines.size() > max_names) svg_.label({x + 16, y + 20}, "...", 12, "start");
  }

  const LineChart& chart_;
  const double width_;
  Svg svg_;
  Span x_, y_;
};

}  // namespace

std::string line_chart(const LineChart& chart) { return LineDrawing(chart).text(); }

}  // namespace halfspace::cli
