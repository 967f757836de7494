#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/vector.h"
#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

/// The side of a point relative to the nearest segment of a chain: > 0 in front, < 0 behind, 0 beyond its
/// ends.
double side_of(const std::vector<Point>& chain, const Point& p) {
  const auto right_of = [&](std::size_t i) {  // the normal of segment i, to the front
    const Point along = minus(chain[i + 1], chain[i]);
    return times(1 / length(along), Point{along[1], -along[0], 0});
  };
  const std::size_t segments = chain.size() - 1;
  const bool is_closed = chain.front() == chain.back();
  double min_distance = std::numeric_limits<double>::infinity();
  double side = 0;
  for (std::size_t i = 0; i < segments; ++i) {
    const Point along = minus(chain[i + 1], chain[i]);
    const double position = std::clamp(dot(minus(p, chain[i]), along) / dot(along, along), 0.0, 1.0);
    const Point offset = minus(p, plus(chain[i], times(position, along)));
    if (length(offset) >= min_distance) continue;
    min_distance = length(offset);
    Point before = right_of(i);
    const bool at_end = (position == 0 && i == 0) || (position == 1 && i + 1 == segments);
    if (position == 0) before = plus(before, right_of((i + segments - 1) % segments));
    if (position == 1) before = plus(before, right_of((i + 1) % segments));
    side = at_end && !is_closed ? 0 : dot(offset, before);
  }
  return side;
}

/// The points of a boundary after its placing.
std::vector<Point> placed(const Block& block) {
  const double sine = std::sin(block.placing.rotation[2]), cosine = std::cos(block.placing.rotation[2]);
  std::vector<Point> points;
  for (const Point& p : block.boundary)
    points.push_back(
        plus({cosine * p[0] - sine * p[1], sine * p[0] + cosine * p[1], 0}, block.placing.shift));
  return points;
}

}  // namespace

void note_boundaries(const Start& start, Faults& faults) {
  for (const Block& block : start.scene.blocks) {
    if (block.boundary.empty()) continue;
    const std::vector<Point> chain = placed(block);
    int before = 0, behind = 0;
    for (const Body& body : start.bodies) {
      if (!moves_freely(body.state.kind)) continue;
      const double side = side_of(chain, point_of(body.state.pose.position));
      before += side > 0;
      behind += side < 0;
    }
    if (behind <= before) continue;
    faults.note(block.shape_place, block.making.key + ".boundary",
                quoted(block.making.name) + " seems to be reversed: " + std::to_string(behind) + " of " +
                    counted(static_cast<std::size_t>(before + behind), "free block") +
                    " behind it; usual: free blocks on the right of the direction from point to point");
  }
}

}  // namespace halfspace::cli
