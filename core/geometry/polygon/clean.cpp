#include "geometry/polygon/clean.h"

#include <algorithm>
#include <cmath>

#include "geometry/orientation.h"
#include "geometry/polygon/check.h"

namespace halfspace {
namespace {

bool is_straight(const Vector<2>& before, const Vector<2>& here, const Vector<2>& after, double tolerance) {
  if (turn(before, here, after) == Turn::straight) return true;
  const Vector<2> chord = after - before;
  const double length = chord.norm();
  return std::abs(cross(chord, here - before)) <= tolerance * length;
}

void weld(Array<Vector<2>>& kept, double tolerance, CleanReport& report) {
  const auto is_near = [&](const Vector<2>& a, const Vector<2>& b) { return (b - a).norm() <= tolerance; };
  const std::size_t before = kept.size();
  kept.erase(std::unique(kept.begin(), kept.end(), is_near), kept.end());
  while (kept.size() > 1 && is_near(kept.back(), kept.front())) kept.pop_back();
  report.welded = std::int64_t(before - kept.size());
}

void straighten(Array<Vector<2>>& kept, double tolerance, CleanReport& report) {
  // Removing a vertex changes its neighbours: repeated until a whole pass finds nothing.
  for (std::size_t i = 0, found_bent = 0; kept.size() > 3 && found_bent < kept.size();) {
    const std::size_t n = kept.size();
    if (is_straight(kept[(i + n - 1) % n], kept[i], kept[(i + 1) % n], tolerance)) {
      kept.erase(kept.begin() + std::ptrdiff_t(i));
      ++report.straightened;
      found_bent = 0;
      i = i == 0 ? kept.size() - 1 : i - 1;
    } else {
      ++found_bent;
      i = (i + 1) % n;
    }
  }
}

}  // namespace

Array<Vector<2>> clean_polygon(std::span<const Vector<2>> vertices, double tolerance, CleanReport& report,
                               Memory* memory) {
  Array<Vector<2>> kept(vertices.begin(), vertices.end(), memory);
  weld(kept, tolerance, report);
  straighten(kept, tolerance, report);
  if (is_clockwise(kept)) {
    std::reverse(kept.begin(), kept.end());
    report.reversed = true;
  }
  return kept;
}

}  // namespace halfspace
