#include "force/overlap.h"

#include "catch.h"
#include "detect/separation.h"
#include "geometry/polygon_cut.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// The same area by cutting: what of b lies behind the edge and between the edge's ends.
double area_by_cutting(const Shape<2>& a, const Shape<2>& b, const Vector<2>& to_b, int edge) {
  const Outline<2> oa = a.outline(), ob = b.outline();
  Points part;
  for (int i = 0; i < ob.count; ++i) part.push_back(ob.vertex(i) + to_b);
  const Vector<2> normal = oa.normal(edge), tangent = perpendicular(normal);
  const Vector<2> start = oa.vertex(edge), end = oa.vertex(oa.next(edge));
  const auto keep_behind = [&](const Vector<2>& point, const Vector<2>& n) {
    const auto parts = cut_polygon(part, point, n, std::pmr::get_default_resource());
    part.assign(parts.behind.begin(), parts.behind.end());
    return !part.empty();
  };
  if (!keep_behind(start, normal) || !keep_behind(start, -tangent) || !keep_behind(end, tangent)) return 0;
  return shape_of(part).area();
}

}  // namespace

TEST_CASE("aligned faces: area, width and centre of the overlap are exact") {
  const Shape<2> square = shape_of(rectangle(2, 2));
  const Vector<2> to_b(1.75, 0.5);
  const Separation<2> s = find_separation(square.outline(), square.outline(), to_b);
  const Overlap<2> overlap = measure_overlap(square.outline(), square.outline(), to_b, s.pair);
  CHECK(overlap.content == Approx(0.25 * 1.5).epsilon(1e-15));
  CHECK(overlap.base == Approx(1.5).epsilon(1e-15));
  CHECK(overlap.depth_squared == Approx(0.25 * 0.25 * 1.5).epsilon(1e-15));
  CHECK(overlap.center.isApprox(Vector<2>(1, 0.25), 1e-15));
}

TEST_CASE("a corner behind an edge: half its depth times its width") {
  const Shape<2> square = shape_of(rectangle(2, 2));
  const Shape<2> diamond = shape_of({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  const Vector<2> to_b(1.9, 0.2);
  const Separation<2> s = find_separation(square.outline(), diamond.outline(), to_b);
  const Overlap<2> overlap = measure_overlap(square.outline(), diamond.outline(), to_b, s.pair);
  CHECK(overlap.content == Approx(0.01).epsilon(1e-13));
  CHECK(overlap.base == Approx(0.2).epsilon(1e-13));
  CHECK(overlap.depth_squared == Approx(0.2 * 0.01 / 3).epsilon(1e-13));
  CHECK(overlap.center.isApprox(Vector<2>(1, 0.2), 1e-13));
}

TEST_CASE("shallow overlaps of random polygons agree with cutting") {
  Random random(21);
  int compared = 0;
  for (int round = 0; round < 2000; ++round) {
    const Shape<2> a = shape_of(random_polygon(random, 15, 1));
    const Shape<2> b = shape_of(random_polygon(random, 15, 1));
    const double angle = random.uniform(0, 7), distance = random.uniform(1.2, 1.9);
    const Vector<2> to_b = distance * Vector<2>(std::cos(angle), std::sin(angle));
    const Separation<2> s = find_separation(a.outline(), b.outline(), to_b);
    if (s.gap > 0 || s.gap < -0.1) continue;
    const bool a_owns = s.pair.owner == 0;
    const double area = measure_overlap(a.outline(), b.outline(), to_b, s.pair).content;
    const double expected =
        a_owns ? area_by_cutting(a, b, to_b, s.pair.edge) : area_by_cutting(b, a, -to_b, s.pair.edge);
    // Cutting rounds its new corners to the ulp of a unit coordinate.
    CHECK(area == Approx(expected).margin(1e-14));
    ++compared;
  }
  CHECK(compared > 100);
}
