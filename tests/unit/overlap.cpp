#include "force/spring/overlap.h"

#include "catch.h"
#include "geometry/polygon/cut.h"
#include "narrow_phase/plane/separation.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// The same area by cutting: what of b lies behind all edges of a.
double area_by_cutting(const Shape<2>& a, const Shape<2>& b, const Vector<2>& to_b) {
  const Outline<2> oa = a.outline(), ob = b.outline();
  Points part;
  for (int i = 0; i < ob.count; ++i) part.push_back(ob.vertex(i) + to_b);
  for (int edge = 0; edge < oa.count && !part.empty(); ++edge) {
    const auto parts = cut_polygon(part, oa.vertex(edge), oa.normal(edge), std::pmr::get_default_resource());
    part.assign(parts.behind.begin(), parts.behind.end());
  }
  return part.empty() ? 0 : shape_of(part).area();
}

/// Unit normal from a to b of the contact plane that a pair tells.
Vector<2> normal_of(const Shape<2>& a, const Shape<2>& b, const PotentialPair<2>& pair) {
  return pair.owner == 0 ? a.outline().normal(pair.edge) : Vector<2>(-b.outline().normal(pair.edge));
}

Overlap<2> overlap_at(const Shape<2>& a, const Shape<2>& b, const Vector<2>& to_b,
                      const PotentialPair<2>& pair) {
  return measure_overlap(a.outline(), b.outline(), to_b, pair, normal_of(a, b, pair));
}

}  // namespace

TEST_CASE("aligned faces: area, width and centre of the overlap are exact") {
  const Shape<2> square = shape_of(rectangle(2, 2));
  const Vector<2> to_b(1.75, 0.5);
  const Separation<2> s = find_separation(square.outline(), square.outline(), to_b);
  const Overlap<2> overlap = overlap_at(square, square, to_b, s.pair);
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
  const Overlap<2> overlap = overlap_at(square, diamond, to_b, s.pair);
  CHECK(overlap.content == Approx(0.01).epsilon(1e-13));
  CHECK(overlap.base == Approx(0.2).epsilon(1e-13));
  CHECK(overlap.depth_squared == Approx(0.2 * 0.01 / 3).epsilon(1e-13));
  CHECK(overlap.center.isApprox(Vector<2>(1, 0.2), 1e-13));
}

TEST_CASE("overlaps of random polygons agree with cutting, however deep, and so does their energy") {
  Random random(21);
  int compared = 0;
  for (int round = 0; round < 4000; ++round) {
    const Shape<2> a = shape_of(random_polygon(random, 15, 1));
    const Shape<2> b = shape_of(random_polygon(random, 15, 1));
    const double angle = random.uniform(0, 7), distance = random.uniform(0.1, 1.9);
    const Vector<2> to_b = distance * Vector<2>(std::cos(angle), std::sin(angle));
    const Separation<2> s = find_separation(a.outline(), b.outline(), to_b);
    if (s.gap > 0) continue;
    const Overlap<2> overlap = overlap_at(a, b, to_b, s.pair);
    // Cutting rounds its new corners to the ulp of a unit coordinate.
    CHECK(overlap.content == Approx(area_by_cutting(a, b, to_b)).epsilon(1e-12).margin(1e-14));
    // Pressed on along the normal the energy grows by the area times the way.
    const double way = 1e-4;
    const Vector<2> normal = normal_of(a, b, s.pair);
    const auto pressed = [&](double by) { return overlap_at(a, b, to_b - by * normal, s.pair); };
    const Overlap<2> more = pressed(way), less = pressed(-way);
    const double mean = (more.content + 4 * overlap.content + less.content) / 6;  // Simpson's
    CHECK(0.5 * (more.depth_squared - less.depth_squared) ==
          Approx(2 * way * mean).margin(4 * way * way * way));
    ++compared;
  }
  CHECK(compared > 1000);
}

TEST_CASE("a roof cut off flat: its flanks count") {
  for (const double edge : {0.5, 0.1, 0.02}) {
    const double depth = 0.05;
    const Shape<2> roof = shape_of({{-1, -1}, {1, -1}, {edge / 2, 0}, {-edge / 2, 0}});
    const Shape<2> plate = shape_of({{-2, 0}, {2, 0}, {2, 1}, {-2, 1}});
    // From centroid to centroid: the roof's lies below its top by so much.
    const double top =
        roof.outline().vertex(2).y() > 0 ? roof.outline().vertex(2).y() : roof.outline().vertex(0).y();
    const Vector<2> to_b(0, top + 0.5 - depth);
    const Separation<2> s = find_separation(roof.outline(), plate.outline(), to_b);
    const double flank = depth * (1 - edge / 2);  // as wide as that on each side
    CHECK(overlap_at(roof, plate, to_b, s.pair).content == Approx(depth * (edge + flank)).epsilon(1e-13));
  }
}
