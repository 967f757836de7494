#include "notes/loads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "common/box.h"

namespace halfspace::cli {
namespace {

/// The extent of a block along two horizontal axes and the vertical one.
struct Extent : Box {
  double middle = 0;  ///< height of the centroid
};

/// Two horizontal axes and the vertical one.
std::array<Point, 3> axes_of(const Point& gravity) {
  const Point up = times(-1 / length(gravity), gravity);
  const Point aside = std::abs(up[2]) < 0.5 ? Point{0, 0, 1} : Point{1, 0, 0};
  const Point level = minus(aside, times(dot(aside, up), up));
  const Point first = times(1 / length(level), level);
  return {first, cross(up, first), up};
}

Extent extent_of(const BlockFrame& block, const std::array<Point, 3>& axes) {
  const auto along_axes = [&](const Point& p) {
    return Point{dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)};
  };
  Extent box;
  for (const Point& p : block.vertices) box.add(along_axes(p));
  box.middle = along_axes(point_of(block.state.pose.position))[2];
  return box;
}

/// Vertical columns, each with the weight added so far.
class Columns {
 public:
  explicit Columns(double width) : width_(width) {}

  void add(const Extent& box, double weight) {
    each(box, [&](double& column, double, double fraction_of_box) { column += weight * fraction_of_box; });
  }
  double above(const Extent& box) {
    double weight = 0;
    each(box,
         [&](double& column, double fraction_of_column, double) { weight += column * fraction_of_column; });
    return weight;
  }

 private:
  /// The overlap of a box and a column, as fractions of both.
  struct Part {
    std::int64_t column;
    double of_column, of_box;
  };

  /// A box without width is in one column, as all boxes are across the plane in 2D.
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
  void each(const Extent& box, Do what) {
    const std::vector<Part> across = parts(box.low[1], box.high[1]);
    for (const Part& i : parts(box.low[0], box.high[0])) {
      for (const Part& j : across)
        what(weight_[{i.column, j.column}], i.of_column * j.of_column, i.of_box * j.of_box);
    }
  }

  double width_;
  std::map<std::pair<std::int64_t, std::int64_t>, double> weight_;
};

/// A quarter of the mean width of blocks; at most `max_across` columns per block, and no width below the
/// rounding of the farthest coordinate.
double width_of_columns(const std::vector<Extent>& boxes) {
  constexpr double max_across = 64;
  double sum = 0, largest = 0, farthest = 0;
  for (const Extent& box : boxes) {
    const double width = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    sum += width;
    largest = std::max(largest, width);
    for (std::size_t k : {0, 1}) farthest = std::max({farthest, std::abs(box.low[k]), std::abs(box.high[k])});
  }
  return std::max(
      {0.25 * sum / static_cast<double>(boxes.size()), largest / max_across, std::ldexp(farthest, -40)});
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

  // A sweep from the top. A block reads the weight above it at the height of its centroid, and adds its own
  // at its lowest point, so that blocks side by side do not load each other.
  struct Event {
    double height;
    bool is_query;
    std::size_t index;
  };
  std::vector<Extent> boxes;
  std::vector<Event> events;
  for (const std::size_t i : free) {
    boxes.push_back(extent_of(frame.blocks[i], axes_of(gravity)));
    events.push_back({boxes.back().middle, true, boxes.size() - 1});
    events.push_back({boxes.back().low[2], false, boxes.size() - 1});
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.height > b.height; });
  Columns columns(width_of_columns(boxes));
  for (const Event& event : events) {
    const std::size_t block = free[event.index];
    const double weight = frame.blocks[block].state.mass * strength;
    if (event.is_query) {
      loads[block] = weight + columns.above(boxes[event.index]);
    } else {
      columns.add(boxes[event.index], weight);
    }
  }
  return loads;
}

}  // namespace halfspace::cli
