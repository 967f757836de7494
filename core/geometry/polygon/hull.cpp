#include "geometry/polygon/hull.h"

#include <algorithm>

#include "geometry/orientation.h"

namespace halfspace {
namespace {

/// Appends one chain of Andrew's monotone chain (1979): points are sorted, and each corner kept turns left.
template <class Iterator>
void append_chain(Iterator first, Iterator last, Array<Vector<2>>& hull) {
  const std::size_t start = hull.size();
  for (; first != last; ++first) {
    while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *first) != Turn::left) {
      hull.pop_back();
    }
    hull.push_back(*first);
  }
  hull.pop_back();  // first point of the other chain
}

/// Removes straight corners where the two chains meet, which the chains themselves do not test.
void drop_straight_corners(Array<Vector<2>>& hull) {
  for (std::size_t i = 0; hull.size() >= 3 && i < hull.size();) {
    const std::size_t n = hull.size();
    if (turn(hull[(i + n - 1) % n], hull[i], hull[(i + 1) % n]) == Turn::left) {
      ++i;
    } else {
      hull.erase(hull.begin() + std::ptrdiff_t(i));
      if (i > 0) --i;
    }
  }
}

}  // namespace

Array<Vector<2>> convex_hull(std::span<const Vector<2>> points, Memory* memory) {
  Array<Vector<2>> sorted(points.begin(), points.end(), memory);
  std::sort(sorted.begin(), sorted.end(), [](const Vector<2>& a, const Vector<2>& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;

  Array<Vector<2>> hull(memory);
  hull.reserve(sorted.size() + 2);
  append_chain(sorted.begin(), sorted.end(), hull);
  append_chain(sorted.rbegin(), sorted.rend(), hull);
  drop_straight_corners(hull);
  return hull;
}

}  // namespace halfspace
