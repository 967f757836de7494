#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "notes/kinds.h"
#include "vector.h"

namespace halfspace::cli {
namespace {

/// Is a point before a chain of segments (> 0) or behind it (< 0), as seen from what of the chain is nearest?
/// Beyond its ends it is neither.
double side_of(const std::vector<Point>& chain, const Point& p) {
  const auto right_of = [&](std::size_t i) {  // the direction to what is before segment i
    const Point along = minus(chain[i + 1], chain[i]);
    return times(1 / length(along), Point{along[1], -along[0], 0});
  };
  const std::size_t segments = chain.size() - 1;
  const bool is_closed = chain.front() == chain.back();
  double least = std::numeric_limits<double>::infinity();
  double side = 0;
  for (std::size_t i = 0; i < segments; ++i) {
    const Point along = minus(chain[i + 1], chain[i]);
    const double share = std::clamp(dot(minus(p, chain[i]), along) / dot(along, along), 0.0, 1.0);
    const Point way = minus(p, plus(chain[i], times(share, along)));
    if (length(way) >= least) continue;
    least = length(way);
    Point before = right_of(i);
    const bool at_end = (share == 0 && i == 0) || (share == 1 && i + 1 == segments);
    if (share == 0) before = plus(before, right_of((i + segments - 1) % segments));
    if (share == 1) before = plus(before, right_of((i + 1) % segments));
    side = at_end && !is_closed ? 0 : dot(way, before);
  }
  return side;
}

/// Where a boundary's points are once it is placed.
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
    const std::string most = before > 0 ? "most of what is free to move, " : "all that is free to move, ";
    faults.note(block.shape_place, block.making.key + ".boundary",
                quoted(block.making.name) + " seems to run the wrong way round: " + most +
                    std::to_string(behind) + (behind == 1 ? " block" : " blocks") +
                    ", is behind it; before it is what is at the right on the way from point to point");
  }
}

}  // namespace halfspace::cli
