#include "geometry/polygon/check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/box.h"
#include "geometry/numbers.h"
#include "geometry/orientation.h"
#include "geometry/tolerances.h"

namespace halfspace {
namespace {

// Second moments grow with the fourth power of the size: between this and the largest number neither they nor
// their products with a density overflow or underflow.
constexpr double smallest_polygon_extent = 1e-75;

FaultReport first_not_finite(std::span<const Vector<2>> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!all(vertices[i], is_within_limits)) return {Fault::not_finite, std::int64_t(i)};
  }
  return {};
}

FaultReport first_repeated(std::span<const Vector<2>> vertices) {
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (vertices[i] == vertices[next]) return {Fault::repeated_vertex, std::int64_t(next)};
  }
  return {};
}

// Shorter edges have no accurate length and normal, as their components are subnormal.
constexpr double shortest_edge = std::numeric_limits<double>::min() / machine_epsilon;

FaultReport first_too_short(std::span<const Vector<2>> vertices) {
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if ((vertices[next] - vertices[i]).cwiseAbs().maxCoeff() < shortest_edge)
      return {Fault::not_finite, std::int64_t(next)};
  }
  return {};
}

bool all_on_one_line(std::span<const Vector<2>> vertices) {
  // From two vertices far apart, so that the line is accurate.
  const auto farther = [&](const Vector<2>& from) {
    return *std::max_element(vertices.begin(), vertices.end(), [&](const Vector<2>& p, const Vector<2>& q) {
      return (p - from).squaredNorm() < (q - from).squaredNorm();
    });
  };
  const Vector<2> a = farther(vertices[0]);
  const Vector<2> b = farther(a);
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](const Vector<2>& p) { return turn(a, b, p) == Turn::straight; });
}

/// The half of the plane to which a direction belongs.
bool points_up(const Vector<2>& direction) {
  return direction.y() > 0 || (direction.y() == 0 && direction.x() > 0);
}

/// Tests the area divided by the length, which is about the width.
bool is_narrow(std::span<const Vector<2>> vertices, double length) {
  double doubled_area_over_length = 0;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
    doubled_area_over_length += cross((vertices[i] - vertices[0]) / length, vertices[i + 1] - vertices[0]);
  return std::abs(doubled_area_over_length) < smallest_polygon_extent;
}

/// The number of turns of the edges' directions: 1 for a convex outline.
int winding_of_directions(std::span<const Vector<2>> vertices) {
  const std::size_t n = vertices.size();
  int changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector<2> arriving = vertices[(i + 1) % n] - vertices[i];
    const Vector<2> leaving = vertices[(i + 2) % n] - vertices[(i + 1) % n];
    if (points_up(arriving) != points_up(leaving)) ++changes;
  }
  return changes / 2;
}

FaultReport first_wrong_turn(std::span<const Vector<2>> vertices) {
  const std::size_t n = vertices.size();
  const Turn wanted = is_clockwise(vertices) ? Turn::right : Turn::left;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector<2>& before = vertices[(i + n - 1) % n];
    const Vector<2>& after = vertices[(i + 1) % n];
    const Turn here = turn(before, vertices[i], after);
    if (here == Turn::straight) {
      // Straight ahead: a superfluous vertex. Straight back: the outline folds onto itself.
      const bool folds = (vertices[i] - before).dot(after - vertices[i]) < 0;
      return {folds ? Fault::self_crossing : Fault::collinear_vertex, std::int64_t(i)};
    }
    if (here != wanted) return {Fault::not_convex, std::int64_t(i)};
  }
  return {};
}

bool edges_cross(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d) {
  return int(turn(a, b, c)) * int(turn(a, b, d)) < 0 && int(turn(c, d, a)) * int(turn(c, d, b)) < 0;
}

/// Quadratic in cost, but only reached for invalid input.
bool outline_crosses_itself(std::span<const Vector<2>> vertices) {
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (edges_cross(vertices[i], vertices[(i + 1) % n], vertices[j], vertices[(j + 1) % n])) return true;
    }
  }
  return false;
}

}  // namespace

bool is_clockwise(std::span<const Vector<2>> vertices) {
  // Relative to a vertex, so that the distance from the origin costs no accuracy.
  double doubled_area = 0;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    doubled_area += cross(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
  }
  return doubled_area < 0;
}

FaultReport check_polygon(std::span<const Vector<2>> vertices) {
  if (vertices.size() < 3) return {Fault::too_few_vertices, -1};
  if (const FaultReport r = first_not_finite(vertices); r.fault != Fault::none) return r;
  if (const FaultReport r = first_repeated(vertices); r.fault != Fault::none) return r;

  Box<2> box;
  for (const Vector<2>& v : vertices) box.include(v);
  if (box.extent() < smallest_polygon_extent) return {Fault::not_finite, -1};
  if (all_on_one_line(vertices)) return {Fault::zero_area, -1};

  const FaultReport wrong_turn = first_wrong_turn(vertices);
  if (wrong_turn.fault == Fault::not_convex && outline_crosses_itself(vertices))
    return {Fault::self_crossing, -1};
  if (wrong_turn.fault != Fault::none) return wrong_turn;
  if (winding_of_directions(vertices) != 1) return {Fault::self_crossing, -1};
  if (is_narrow(vertices, box.extent())) return {Fault::not_finite, -1};
  return first_too_short(vertices);
}

}  // namespace halfspace
