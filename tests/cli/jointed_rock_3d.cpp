#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <vector>

#include "blocks/rock/jointed_rock.h"
#include "catch.h"

using namespace halfspace::cli;

namespace {

constexpr double degree = std::numbers::pi / 180;

// Coordinates below 16 are known to 2^-49 m, and each of some 20 cuts moves a vertex by a few units of that.
// Where three joints meet at the angles below this shows at most 8 times larger: 20 * 4 * 8 * 2^-49.
constexpr double rounding = 1.2e-12;

double along(const Point& p, const Point& normal) {
  return p[0] * normal[0] + p[1] * normal[1] + p[2] * normal[2];
}

std::vector<Point> box(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (double x : {low[0], high[0]}) {
    for (double y : {low[1], high[1]}) {
      for (double z : {low[2], high[2]}) corners.push_back({x, y, z});
    }
  }
  return corners;
}

JointedRock slope_rock() {
  JointedRock rock;
  rock.joint_sets = {{.normal = joint_normal(35 * degree, 80 * degree), .spacing = 1.6},
                     {.normal = joint_normal(70 * degree, 250 * degree), .spacing = 1.8, .jitter = 0.3},
                     {.normal = joint_normal(85 * degree, 10 * degree), .spacing = 2, .offset = 0.4}};
  return rock;
}

JointedBlocks cut_hulls(const Context& context, const JointedRock& rock,
                        const std::vector<std::vector<Point>>& hulls) {
  std::vector<Shape> regions;
  for (const std::vector<Point>& points : hulls) regions.push_back(make_hull(context, points));
  return cut_jointed_rock(context, rock, std::move(regions));
}

double volume_of(const Context& context, const std::vector<Shape>& blocks) {
  double volume = 0;
  for (const Shape& block : blocks) volume += properties_of(context, block).volume;
  return volume;
}

}  // namespace

TEST_CASE("joints in space: dip is below the horizontal, its direction clockwise from north") {
  const double dip = 30 * degree;
  const double direction = GENERATE(0.0, 90.0, 200.0, 315.0) * degree;
  const Point normal = joint_normal(dip, direction);
  // Line of steepest descent and strike, by their definition; a product of two terms rounds by some 2^-53.
  const Point down_dip{std::cos(dip) * std::sin(direction), std::cos(dip) * std::cos(direction),
                       -std::sin(dip)};
  const Point strike{std::cos(direction), -std::sin(direction), 0};
  CHECK(std::abs(along(down_dip, normal)) < 4e-16);
  CHECK(std::abs(along(strike, normal)) < 4e-16);
  CHECK(normal[2] > 0);
  // Towards the east it is the joint of the same dip in the plane.
  const Point in_plane = joint_normal(dip);
  const Point east = joint_normal(dip, 90 * degree);
  CHECK(std::abs(east[0] - in_plane[0]) < 4e-16);
  CHECK(std::abs(east[1]) < 4e-16);
  CHECK(east[2] == in_plane[1]);
}

TEST_CASE("blocks of a rock in space fill the region, and no joint passes through one") {
  const Context context = make_context();
  const JointedRock rock = slope_rock();
  const JointedBlocks cut = cut_hulls(context, rock, {box({0, 0, 0}, {12, 10, 9})});
  const double volume = volume_of(context, cut.blocks);
  // Some 5000 m2 of joint faces, both sides, if all deviations had one sign.
  const double allowed = 5000 * rounding;
  std::cout << cut.blocks.size() << " blocks, volume off by " << std::abs(volume - 1080) << " m3, allowed "
            << allowed << '\n';
  CHECK(cut.blocks.size() > 200);
  CHECK(std::abs(volume - 1080) < allowed);

  double worst = -INFINITY;
  for (const JointSet& set : rock.joint_sets) {
    for (const Shape& block : cut.blocks) {
      double low = INFINITY, high = -INFINITY;
      for (const Point& p : vertices_of(context, block)) {
        low = std::min(low, along(p, set.normal));
        high = std::max(high, along(p, set.normal));
      }
      for (std::int64_t k = -20; k <= 20; ++k) {
        const double joint = joint_offset(set, k);
        worst = std::max(worst, std::min(joint - low, high - joint));
      }
    }
  }
  std::cout << "blocks reach through joints by at most " << worst << " m, allowed " << rounding << '\n';
  CHECK(worst <= rounding);
}

TEST_CASE("a region of two parts has the joints of the whole") {
  const Context context = make_context();
  const JointedRock rock = slope_rock();
  const JointedBlocks whole = cut_hulls(context, rock, {box({0, 0, 0}, {12, 10, 9})});
  const JointedBlocks parts =
      cut_hulls(context, rock, {box({0, 0, 0}, {5, 10, 9}), box({5, 0, 0}, {12, 10, 9})});
  CHECK(std::abs(volume_of(context, whole.blocks) - volume_of(context, parts.blocks)) < 5000 * rounding);
  // A block of the whole that does not reach the plane between the parts is one of theirs too, by its
  // centroid and its volume.
  std::size_t apart = 0, found = 0;
  for (const Shape& block : whole.blocks) {
    const std::vector<Point> vertices = vertices_of(context, block);
    const auto side = [](const Point& p) { return p[0] < 5; };
    const auto on_left = std::count_if(vertices.begin(), vertices.end(), side);
    if (on_left != 0 && on_left != static_cast<std::ptrdiff_t>(vertices.size())) continue;
    ++apart;
    const hs_shape_properties own = properties_of(context, block);
    found += std::any_of(parts.blocks.begin(), parts.blocks.end(), [&](const Shape& other) {
      const hs_shape_properties same = properties_of(context, other);
      const double distance =
          std::hypot(own.centroid[0] - same.centroid[0], own.centroid[1] - same.centroid[1],
                     own.centroid[2] - same.centroid[2]);
      return distance < 1e-6 && std::abs(own.volume - same.volume) < 1e-6;
    });
  }
  std::cout << apart << " blocks do not reach the plane between the parts\n";
  CHECK(apart > 100);
  CHECK(found == apart);
}

TEST_CASE("small blocks in space are left out and told") {
  const Context context = make_context();
  JointedRock rock = slope_rock();
  rock.smallest_size = 0.05;
  const JointedBlocks cut = cut_hulls(context, rock, {box({0, 0, 0}, {12, 10, 9})});
  for (const Shape& block : cut.blocks) CHECK(properties_of(context, block).volume >= 0.05);
  CHECK(cut.left_out > 0);
  CHECK(std::abs(volume_of(context, cut.blocks) + cut.size_left_out - 1080) < 5000 * rounding);
}
