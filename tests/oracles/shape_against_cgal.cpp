// Mass properties, convex hull and cutting against CGAL's exact kernel.

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "oracles/cgal_polygon.h"
#include "oracles/random_pairs.h"

namespace halfspace_test {
namespace {

constexpr double unit_roundoff = 0x1p-53;
constexpr int polygons_of_a_family = 200;

Points moved(Points points, double x, double y) {
  for (Point& p : points) p = {p.x + x, p.y + y};
  return points;
}

/// Both polygons of a pair, and one of them far away from the origin, rounded to where doubles are there.
template <class Check>
void for_each_polygon(Family family, Check check) {
  const Context context = make_context();
  Random random(7 + std::uint64_t(family));
  for (int i = 0; i < polygons_of_a_family; ++i) {
    const PolygonPair pair = draw_polygons(family, random);
    for (const Points& vertices : {pair.a, pair.b, moved(pair.a, 1e8, -1e8)}) {
      if (const Shape shape = try_shape(context.get(), vertices))
        check(context.get(), vertices, shape.get(), random);
    }
  }
}

double reach_of(const Points& vertices) {
  double reach = 0;
  for (const Point& p : vertices) {
    for (const Point& q : vertices) reach = std::max(reach, std::hypot(p.x - q.x, p.y - q.y));
  }
  return reach;
}

/// Largest magnitude of a coordinate: what a position is rounded by.
double magnitude_of(const Points& vertices) {
  double magnitude = 0;
  for (const Point& p : vertices) magnitude = std::max({magnitude, std::abs(p.x), std::abs(p.y)});
  return magnitude;
}

}  // namespace

TEST_CASE("area, centroid and second moments are those of exact arithmetic") {
  for (Family family : all_families) {
    double worst_area = 0, worst_centroid = 0, worst_moment = 0;
    for_each_polygon(family, [&](hs_context*, const Points& vertices, const hs_shape* shape, Random&) {
      const hs_shape_properties got = properties_of(shape);
      const ExactMoments exact = exact_moments(exact_polygon(vertices));
      const double n = double(vertices.size());
      const double reach = reach_of(vertices);
      // A triangle of the fan is the difference of two products of two differences each: 2 + 1 + 1 roundings
      // of numbers below reach^2, halved; n - 2 of them are summed: less than 4 n + n roundings of reach^2 in
      // all.
      const double area_error =
          rounded(CGAL::abs(ExactNumber(got.volume) - exact.area)) / (unit_roundoff * reach * reach);
      worst_area = std::max(worst_area, area_error / n);
      CHECK(area_error <= 5 * n);

      // The first moment is a sum of such areas times a distance below reach, with 3 roundings more, and is
      // divided by the area: what slivers lose there they lose in the direction of their length only. The
      // centroid itself is rounded once.
      const double area = rounded(exact.area);
      const double condition = reach * reach / area;
      for (int i = 0; i < 2; ++i) {
        const double error = rounded(CGAL::abs(ExactNumber(got.centroid[i]) - exact.centroid[i]));
        const double bound = unit_roundoff * (10 * n * reach * condition + magnitude_of(vertices));
        worst_centroid = std::max(worst_centroid, error / bound);
        CHECK(error <= bound);
      }

      // Second moments likewise: an area error times reach^2, and the centroid's own error enters twice.
      const double moment[3] = {got.second_moment[0], got.second_moment[1], got.second_moment[3]};
      for (int i = 0; i < 3; ++i) {
        const double error = rounded(CGAL::abs(ExactNumber(moment[i]) - exact.second_moment[i]));
        const double bound = unit_roundoff * 40 * n * reach * reach * reach * reach;
        worst_moment = std::max(worst_moment, error / bound);
        CHECK(error <= bound);
      }
    });
    std::printf(
        "%-16s area error %.2f of 2^-53 reach^2 per vertex, centroid %.3f and moments %.3f of their bounds\n",
        name_of(family), worst_area, worst_centroid, worst_moment);
  }
}

TEST_CASE("the hull is CGAL's, but for vertices that are straight to rounding") {
  const Context context = make_context();
  Random random(11);
  long compared = 0, dropped = 0;
  for (int i = 0; i < 3000; ++i) {
    const int n = std::uniform_int_distribution<int>(3, 60)(random);
    const double squeeze = i % 3 == 0 ? 1 : i % 3 == 1 ? 1e-3 : 1e-6;
    const bool on_grid = i % 2 == 0;  // many points on common lines, and repeated
    const double far = i % 5 == 0 ? 1e8 : 0;
    Points points;
    for (int k = 0; k < n; ++k) {
      const double x = on_grid ? std::uniform_int_distribution<int>(-4, 4)(random)
                               : std::uniform_real_distribution<double>(-4, 4)(random);
      const double y = on_grid ? std::uniform_int_distribution<int>(-4, 4)(random)
                               : std::uniform_real_distribution<double>(-4, 4)(random);
      points.push_back({far + x, far + squeeze * y});
    }
    std::vector<ExactKernel::Point_2> in, hull;
    for (const Point& p : points) in.emplace_back(p.x, p.y);
    CGAL::convex_hull_2(in.begin(), in.end(), std::back_inserter(hull));
    hs_shape* made = nullptr;
    const hs_status status = hs_polygon_create_hull(context.get(), view_of(points), &made);
    const Shape shape(made);
    const ExactPolygon exact(hull.begin(), hull.end());
    if (hull.size() < 3) {
      CHECK(status == HS_ERROR_GEOMETRY);
      continue;
    }
    // The library may call a hull flat whose height is within the rounding of its own corners' areas.
    const double reach = reach_of(points);
    const double area = rounded(exact.area());
    if (status == HS_ERROR_GEOMETRY) {
      CHECK(area <= 16 * unit_roundoff * reach * reach * double(hull.size()));
      continue;
    }
    REQUIRE(status == HS_OK);
    ++compared;
    // Every vertex of the library's hull is one of CGAL's, to the rounding of centroid + local; those dropped
    // lie on the lines of their neighbours to rounding, so that the area tells whether more was dropped.
    const Points got = vertices_of(shape.get());
    dropped += long(hull.size()) - long(got.size());
    CHECK(got.size() <= hull.size());
    const double rounding = 2 * unit_roundoff * (magnitude_of(points) + reach);
    for (const Point& p : got) {
      CHECK(std::any_of(hull.begin(), hull.end(), [&](const auto& q) {
        return std::abs(CGAL::to_double(q.x()) - p.x) <= rounding &&
               std::abs(CGAL::to_double(q.y()) - p.y) <= rounding;
      }));
    }
    CHECK(std::abs(properties_of(shape.get()).volume - area) <=
          16 * unit_roundoff * reach * reach * double(hull.size()));
  }
  std::printf("hulls compared: %ld, vertices dropped as straight to rounding: %ld\n", compared, dropped);
  CHECK(compared > 1000);
}

TEST_CASE("the parts of a cut are CGAL's clippings, convex, and fill the whole") {
  long cuts = 0;
  double worst_area = 0;
  for (Family family : all_families) {
    for_each_polygon(family, [&](hs_context* context, const Points& vertices, const hs_shape* shape,
                                 Random& random) {
      const hs_shape_properties whole = properties_of(shape);
      const double angle = std::uniform_real_distribution<double>(0, 6.28)(random);
      const double off = std::uniform_real_distribution<double>(-0.8, 0.8)(random) * whole.bounding_radius;
      const double normal[3] = {std::cos(angle), std::sin(angle), 0};
      const double point[3] = {whole.centroid[0] + off * normal[0], whole.centroid[1] + off * normal[1], 0};
      hs_shape* behind = nullptr;
      hs_shape* ahead = nullptr;
      const hs_status status = hs_shape_cut(shape, point, normal, &behind, &ahead);
      INFO(hs_context_last_error(context));
      REQUIRE(status == HS_OK);
      const Shape parts[2] = {Shape(behind), Shape(ahead)};
      ++cuts;

      // A vertex of a part is off by the rounding of the coordinates and of the crossing: below 16 roundings
      // of what the coordinates are, plus the extent. Along the outline that is an area below that times the
      // perimeter (< 4 reach).
      const double reach = reach_of(vertices);
      const double rounding = 16 * unit_roundoff * (magnitude_of(vertices) + reach) * 4 * reach;
      const ExactPolygon exact = exact_polygon(vertices);
      double sum = 0;
      for (int side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1 : -1;
        const ExactPolygon expected =
            part_behind(exact, {point[0], point[1]}, {sign * normal[0], sign * normal[1]});
        const double expected_area = expected.is_empty() ? 0 : rounded(expected.area());
        const double area = parts[side] ? properties_of(parts[side].get()).volume : 0;
        sum += area;
        worst_area = std::max(worst_area, std::abs(area - expected_area) / rounding);
        CHECK(std::abs(area - expected_area) <= rounding);
        if (!parts[side]) continue;
        // Convex to the rounding of reading the vertices back: nothing of its own hull is missing.
        const Points part = vertices_of(parts[side].get());
        ExactPolygon hull;
        const ExactPolygon as_read = exact_polygon(part);
        CGAL::convex_hull_2(as_read.vertices_begin(), as_read.vertices_end(), std::back_inserter(hull));
        CHECK(rounded(hull.area() - as_read.area()) <= rounding);
        for (const Point& p : part) {
          const double ahead_of_line = sign * (normal[0] * (p.x - point[0]) + normal[1] * (p.y - point[1]));
          CHECK(ahead_of_line <= 16 * unit_roundoff * (magnitude_of(vertices) + reach));
        }
      }
      CHECK(std::abs(sum - whole.volume) <= 2 * rounding);
    });
  }
  std::printf("cuts: %ld, worst area of a part %.3f of its bound\n", cuts, worst_area);
}

}  // namespace halfspace_test
