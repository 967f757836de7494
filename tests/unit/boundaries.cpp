#include <algorithm>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <numbers>

#include "catch.h"
#include "geometry/polygon/boundary.h"
#include "geometry/polygon/check.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double pi = std::numbers::pi;

Vector<2> direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Two segments that meet, with what is behind them. Positive bends are ridges.
struct Chain {
  Vector<2> joint;
  double heading;  // of the first segment
  double bend;
  double lengths[2];
  double depth;

  double heading_of_second() const { return heading + bend; }
  Points behind(int segment) const {
    const Vector<2> start = joint - lengths[0] * direction(heading);
    const Vector<2> end = joint + lengths[1] * direction(heading_of_second());
    const BoundarySegment one{2 * start - joint, start, joint, end},
        other{start, joint, end, 2 * end - joint};
    const auto polygon = polygon_behind(segment == 0 ? one : other, depth, std::pmr::get_default_resource());
    return {polygon.begin(), polygon.end()};
  }
};

Chain draw_chain(Random& random, double most_bend) {
  return {{random.uniform(-5, 5), random.uniform(-5, 5)},
          random.uniform(0, 7),
          random.uniform(-most_bend, most_bend),
          {random.uniform(1, 3), random.uniform(1, 3)},
          random.uniform(0.1, 1)};
}

/// Distance to the nearest edge, 0 outside: the potential but for the stiffness over H.
double depth_in(const Points& polygon, const Vector<2>& p) {
  const Shape<2> shape = shape_of(polygon);
  const Outline<2>& outline = shape.outline();
  double least = HUGE_VAL;
  for (int edge = 0; edge < outline.count; ++edge)
    least = std::min(least, outline.offset[edge] - outline.normal(edge).dot(p - shape.centroid()));
  return std::max(least, 0.0);
}

}  // namespace

TEST_CASE("the potentials of two boundary segments in line add up to that of one") {
  // Up to half the depth, where the base is as near as the segment. Coordinates of 10 and a dozen operations.
  constexpr double rounding = 12 * 10 * std::numeric_limits<double>::epsilon();
  Random random(1);
  double worst = 0;
  for (int round = 0; round < 1000; ++round) {
    const Chain chain = draw_chain(random, 0);
    const double along = random.uniform(-0.4, 0.4), below = random.uniform(0, 0.5) * chain.depth;
    const Vector<2> p =
        chain.joint + along * direction(chain.heading) + below * direction(chain.heading + pi / 2);
    const double sum = depth_in(chain.behind(0), p) + depth_in(chain.behind(1), p);
    worst = std::max(worst, std::abs(sum - below));
  }
  CHECK(worst <= rounding);
}

TEST_CASE("where boundary segments meet nothing stands out and no gap is left, whichever way they bend") {
  // Behind both lie the directions from the second segment's counter-clockwise to the first one's back. Of
  // 170 degrees of bend the narrowest side that a polygon has there is 5 degrees wide.
  Random random(2);
  int inside = 0;
  for (int round = 0; round < 5000; ++round) {
    const Chain chain = draw_chain(random, 170 * pi / 180);
    const double behind = pi - chain.bend, turn = random.uniform(0, 2 * pi);
    if (std::min({turn, std::abs(turn - behind), 2 * pi - turn}) < 1e-6) continue;  // on a segment
    const Vector<2> p = chain.joint + 1e-3 * direction(chain.heading_of_second() + turn);
    const bool is_inside = depth_in(chain.behind(0), p) > 0 || depth_in(chain.behind(1), p) > 0;
    INFO("bend " << chain.bend << ", direction " << turn);
    CHECK(is_inside == (turn < behind));
    inside += is_inside;
  }
  CHECK(inside > 1000);
}

TEST_CASE("the segment is an edge of the polygon behind it, which reaches no farther than it says") {
  Random random(3);
  for (int round = 0; round < 1000; ++round) {
    const Chain chain = draw_chain(random, 170 * pi / 180);
    const Points polygon = chain.behind(0);
    CHECK(check_polygon(polygon).fault == Fault::none);
    CHECK(!is_clockwise(polygon));
    const Vector<2> along = direction(chain.heading);
    const double reach = chain.depth / std::sqrt(3.0), rounding = 1e-14;
    double highest = -1, lowest = 1;
    for (const Vector<2>& vertex : polygon) {
      const double x = along.dot(vertex - chain.joint), below = cross(along, Vector<2>(vertex - chain.joint));
      CHECK(x >= -chain.lengths[0] - reach - rounding);
      CHECK(x <= reach + rounding);
      highest = std::max(highest, below);
      lowest = std::min(lowest, below);
    }
    CHECK(lowest == Approx(0).margin(rounding));
    CHECK(highest <= chain.depth + rounding);
    const Vector<2> middle = chain.joint - chain.lengths[0] / 2 * along;
    CHECK(depth_in(polygon, middle + 1e-6 * perpendicular(along)) == Approx(1e-6).epsilon(1e-6));
  }
}
