#pragma once

#include <string>
#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// Lines through points; a value that is not finite is a gap.
struct LineChart {
  struct Line {
    std::string name;
    std::vector<Point> points;
  };
  std::string title, x_label, y_label;
  std::string line_label;            ///< above the names of several lines
  std::vector<std::string> x_names;  ///< of x = 0, 1, ...; empty: x has numbers
  std::vector<Line> lines;
};

std::string line_chart(const LineChart& chart);

}  // namespace halfspace::cli
