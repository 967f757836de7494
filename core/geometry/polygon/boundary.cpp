#include "geometry/polygon/boundary.h"

#include <iterator>
#include <numbers>

#include "geometry/polygon/cut.h"
#include "geometry/unit_vector.h"

namespace halfspace {
namespace {

/// The direction of a flank at the end to which `along` points, where the chain continues along `next`; both
/// are unit vectors. `side` is 1 when the inside is on their left, -1 when on the right.
Vector<2> flank(const Vector<2>& along, const Vector<2>& next, double side) {
  constexpr double cosine = 0.5, sine = 0.5 * std::numbers::sqrt3;  // of 60 degrees
  if (along.dot(next) >= cosine) return cosine * next + side * sine * perpendicular(next);
  const bool is_ridge = side * cross(along, next) > 0;
  return is_ridge ? Vector<2>(next - along) : along;
}

}  // namespace

Array<Vector<2>> polygon_behind(const BoundarySegment& segment, double depth, Memory* memory) {
  const auto& [before, first, second, after] = segment;
  const Vector<2> along = unit_vector<2>(second - first);
  const Vector<2> inwards = depth * perpendicular(along);
  const Vector<2> beyond = depth * std::numbers::inv_sqrt3 * along;
  const Vector<2> start = first - beyond, end = second + beyond;
  const Vector<2> box[] = {start, first, second, end, end + inwards, start + inwards};

  Array<Vector<2>> polygon(std::begin(box), std::end(box), memory);
  const auto cut = [&](const Vector<2>& from, const Vector<2>& towards, const Vector<2>& neighbour,
                       double side) {
    const Vector<2> under = flank(towards, unit_vector<2>(neighbour - from), side);
    polygon = cut_polygon(polygon, from, -side * perpendicular(under), memory).behind;
  };
  cut(second, along, after, 1);
  cut(first, -along, before, -1);
  return polygon;
}

}  // namespace halfspace
