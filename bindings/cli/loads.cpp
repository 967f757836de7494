#include "loads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "vector.h"

namespace halfspace::cli {
namespace {

/// A block's reach along each of three axes: two level ones, and upwards.
struct Box {
  Point low{INFINITY, INFINITY, INFINITY};
  Point high{-INFINITY, -INFINITY, -INFINITY};
  double middle = 0;  ///< height of the centroid

  void add(const Point& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
};

/// Two level axes and the one that points up.
std::array<Point, 3> axes_of(const Point& gravity) {
  const Point up = times(-1 / length(gravity), gravity);
  const Point least = std::abs(up[2]) < 0.5 ? Point{0, 0, 1} : Point{1, 0, 0};
  const Point level = minus(least, times(dot(least, up), up));
  const Point first = times(1 / length(level), level);
  return {first, cross(up, first), up};
}

Box box_of(const BlockFrame& block, const std::array<Point, 3>& axes) {
  const auto along_axes = [&](const Point& p) {
    return Point{dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)};
  };
  Box box;
  for (const Point& p : block.vertices) box.add(along_axes(p));
  box.middle = along_axes(point_of(block.state.pose.position))[2];
  return box;
}

/// Upright columns side by side, each with the weight that is in it so far.
class Columns {
 public:
  explicit Columns(double width) : width_(width) {}

  void add(const Box& box, double weight) {
    each(box, [&](double& column, double, double share_of_box) { column += weight * share_of_box; });
  }
  double above(const Box& box) {
    double weight = 0;
    each(box, [&](double& column, double share_of_column, double) { weight += column * share_of_column; });
    return weight;
  }

 private:
  /// The part that the box and one column of a row have in common, as shares of both.
  struct Part {
    std::int64_t column;
    double of_column, of_box;
  };

  /// A box without width is all in one column, as everything is across the plane in 2D.
  std::vector<Part> parts(double low, double high) const {
    if (!(high > low)) return {{0, 1, 1}};
    std::vector<Part> parts;
    const auto first = static_cast<std::int64_t>(std::floor(low / width_));
    const auto last = static_cast<std::int64_t>(std::floor(high / width_));
    for (std::int64_t k = first; k <= last; ++k) {
      const double begin = static_cast<double>(k) * width_;
      const double common = std::min(high, begin + width_) - std::max(low, begin);
      if (common > 0) parts.push_back({k, common / width_, common / (high - low)});
    }
    return parts;
  }

  template <class Do>
  void each(const Box& box, Do what) {
    const std::vector<Part> across = parts(box.low[1], box.high[1]);
    for (const Part& i : parts(box.low[0], box.high[0])) {
      for (const Part& j : across)
        what(weight_[{i.column, j.column}], i.of_column * j.of_column, i.of_box * j.of_box);
    }
  }

  double width_;
  std::map<std::pair<std::int64_t, std::int64_t>, double> weight_;
};

/// A quarter of the mean width, but no more than so many columns across one block, and none that the place
/// of the farthest would round away.
double width_of_columns(const std::vector<Box>& boxes) {
  constexpr double most_across = 64;
  double sum = 0, largest = 0, farthest = 0;
  for (const Box& box : boxes) {
    const double width = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    sum += width;
    largest = std::max(largest, width);
    for (std::size_t k : {0, 1}) farthest = std::max({farthest, std::abs(box.low[k]), std::abs(box.high[k])});
  }
  return std::max(
      {0.25 * sum / static_cast<double>(boxes.size()), largest / most_across, std::ldexp(farthest, -40)});
}

}  // namespace

std::vector<double> loads_of(const Frame& frame, const Point& gravity) {
  std::vector<double> loads(frame.blocks.size());
  const double strength = length(gravity);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    if (moves_freely(frame.blocks[i].state.kind)) free.push_back(i);
  }
  if (strength == 0 || free.empty()) return loads;

  // Blocks are gone through from the top: one asks for what is above at the height of its middle, and is
  // above what is lower than its lowest point. So blocks side by side bear nothing of each other.
  struct Event {
    double height;
    bool asks;
    std::size_t index;
  };
  std::vector<Box> boxes;
  std::vector<Event> events;
  for (const std::size_t i : free) {
    boxes.push_back(box_of(frame.blocks[i], axes_of(gravity)));
    events.push_back({boxes.back().middle, true, boxes.size() - 1});
    events.push_back({boxes.back().low[2], false, boxes.size() - 1});
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.height > b.height; });
  Columns columns(width_of_columns(boxes));
  for (const Event& event : events) {
    const std::size_t block = free[event.index];
    const double weight = frame.blocks[block].state.mass * strength;
    if (event.asks) {
      loads[block] = weight + columns.above(boxes[event.index]);
    } else {
      columns.add(boxes[event.index], weight);
    }
  }
  return loads;
}

}  // namespace halfspace::cli
