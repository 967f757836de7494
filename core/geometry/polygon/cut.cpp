#include "geometry/polygon/cut.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon/clip.h"
#include "geometry/polygon/hull.h"
#include "geometry/tolerances.h"
#include "geometry/unit_vector.h"

namespace halfspace {
namespace {

void keep_if_polygon(Array<Vector<2>>& part, Memory* memory) {
  // Rounding may leave a straight or slightly concave corner: the hull removes it and nothing else.
  part = convex_hull(part, memory);
  if (part.size() < 3) part.clear();
}

}  // namespace

PolygonParts cut_polygon(std::span<const Vector<2>> vertices, const Vector<2>& point, const Vector<2>& normal,
                         Memory* memory) {
  const std::size_t n = vertices.size();
  const Vector<2> unit = unit_vector(normal);
  Array<double> heights(n, memory);
  double reach = 0, lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector<2> from_point = vertices[i] - point;
    heights[i] = unit.dot(from_point);
    lowest = std::min(lowest, heights[i]);
    highest = std::max(highest, heights[i]);
    reach = std::max(reach, from_point.cwiseAbs().maxCoeff() + vertices[i].cwiseAbs().maxCoeff());
  }
  // Coordinates have an error of half an ulp, the dot product two more: a vertex within this is on the line.
  const double rounding = 8 * machine_epsilon * reach;
  for (double& h : heights) {
    if (std::abs(h) <= rounding) h = 0;
  }
  const auto is_behind = [](double h) { return h < 0; };
  const auto is_ahead = [](double h) { return h > 0; };

  PolygonParts parts{Array<Vector<2>>(memory), Array<Vector<2>>(memory), highest > -lowest};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (heights[i] <= 0) parts.behind.push_back(vertices[i]);
    if (heights[i] >= 0) parts.ahead.push_back(vertices[i]);
    if (heights[i] * heights[next] < 0) {
      const bool rising = heights[i] < 0;
      const Vector<2> corner = rising ? crossing(vertices[i], heights[i], vertices[next], heights[next])
                                      : crossing(vertices[next], heights[next], vertices[i], heights[i]);
      parts.behind.push_back(corner);
      parts.ahead.push_back(corner);
    }
  }
  // A polygon that is on the line to rounding is on neither side.
  if (std::none_of(heights.begin(), heights.end(), is_behind)) parts.behind.clear();
  if (std::none_of(heights.begin(), heights.end(), is_ahead)) parts.ahead.clear();
  keep_if_polygon(parts.behind, memory);
  keep_if_polygon(parts.ahead, memory);
  return parts;
}

}  // namespace halfspace
