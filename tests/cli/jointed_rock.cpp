#include "blocks/rock/jointed_rock.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

#include "catch.h"
#include "common/random.h"

using namespace halfspace::cli;

namespace {

constexpr double degree = std::numbers::pi / 180;

// A shape keeps its vertices relative to its centroid, so each of the some 60 cuts moves them by a unit in
// the last place of their coordinates below 64, 2^-47 m. Where joints of 80 degrees meet the upright border
// this shows 1 / sin(10 degrees) = 5.8 times larger: 60 * 5.8 * 2^-47.
constexpr double rounding = 2.5e-12;

// Along the 1.1 km of joints, both sides, if all deviations had one sign.
constexpr double area_rounding = 2200 * rounding;

JointedRock collapse_rock() {
  JointedRock rock;
  rock.joint_sets = {{.normal = joint_normal(80 * degree), .spacing = 1.5},
                     {.normal = joint_normal(40 * degree), .spacing = 2.5}};
  return rock;
}

JointedBlocks cut_rectangle(const Context& context, const JointedRock& rock) {
  std::vector<Shape> regions;
  regions.push_back(make_polygon(context, {{0, 0}, {20, 0}, {20, 50}, {0, 50}}));
  return cut_jointed_rock(context, rock, std::move(regions));
}

double along(Point p, Point normal) { return p[0] * normal[0] + p[1] * normal[1] + p[2] * normal[2]; }

bool on_border(Point p) { return std::min({p[0], 20 - p[0], p[1], 50 - p[1]}) < rounding; }

}  // namespace

TEST_CASE("blocks of a jointed rock fill the region") {
  const Context context = make_context();
  JointedRock rock = collapse_rock();
  rock.joint_sets[0].jitter = GENERATE(0.0, 0.7);
  const JointedBlocks cut = cut_rectangle(context, rock);
  double area = 0;
  for (const Shape& block : cut.blocks) area += properties_of(context, block).volume;
  std::cout << cut.blocks.size() << " blocks, area off by " << std::abs(area - 1000) << " m2, allowed "
            << area_rounding << '\n';
  CHECK(std::abs(area - 1000) < area_rounding);
  CHECK(cut.left_out == 0);
}

TEST_CASE("every joint separates the blocks, and blocks are no wider than the spacing") {
  const Context context = make_context();
  JointedRock rock = collapse_rock();
  rock.joint_sets[0].jitter = 0.5;
  rock.joint_sets[0].seed = 3;
  const JointedBlocks cut = cut_rectangle(context, rock);
  double worst = 0;
  for (const JointSet& set : rock.joint_sets) {
    const Point normal = set.normal;
    for (const Shape& block : cut.blocks) {
      double low = INFINITY, high = -INFINITY;
      for (Point p : vertices_of(context, block)) {
        low = std::min(low, along(p, normal));
        high = std::max(high, along(p, normal));
      }
      CHECK(high - low <= set.spacing * (1 + set.jitter) + rounding);
      for (std::int64_t k = -20; k <= 60; ++k) {
        const double joint = joint_offset(set, k);
        const double reach =
            std::min(joint - low, high - joint);  // how far the block sticks through the joint
        worst = std::max(worst, reach);
      }
    }
  }
  std::cout << "blocks reach through joints by at most " << worst << " m, allowed " << rounding << '\n';
  CHECK(worst <= rounding);
}

TEST_CASE("neighbouring blocks share their vertices") {
  const Context context = make_context();
  const JointedBlocks cut = cut_rectangle(context, collapse_rock());
  std::vector<Point> vertices;
  for (const Shape& block : cut.blocks) {
    for (Point p : vertices_of(context, block)) vertices.push_back(p);
  }
  int inside = 0;
  double farthest = 0;
  for (Point p : vertices) {
    if (on_border(p)) continue;
    ++inside;
    int blocks = 0;
    for (Point q : vertices) {
      const double distance = std::hypot(p[0] - q[0], p[1] - q[1]);
      if (distance > rounding) continue;
      ++blocks;
      farthest = std::max(farthest, distance);
    }
    CAPTURE(p[0], p[1]);
    CHECK(blocks == 4);  // two joints cross there, and no third goes through
  }
  std::cout << inside / 4 << " crossings of four blocks each, which differ by at most " << farthest
            << " m, allowed " << rounding << '\n';
  CHECK(inside > 400);
}

TEST_CASE("dip is measured downwards towards +x") {
  const Point normal = joint_normal(30 * degree);
  const Point downdip{std::cos(30 * degree), -std::sin(30 * degree)};
  CHECK(std::abs(along(downdip, normal)) <
        1e-16);  // the products of both terms are equal to a rounding of 0.43
  CHECK(normal[1] > 0);
  CHECK(joint_normal(-30 * degree)[0] < 0);
}

TEST_CASE("a spacing deviates by no more than its spread, and on average not at all") {
  const JointSet set{.spacing = 2, .offset = 5, .jitter = 0.6, .seed = 42};
  double least = INFINITY, largest = -INFINITY;
  for (std::int64_t k = -500; k < 500; ++k) {
    const double spacing = joint_offset(set, k + 1) - joint_offset(set, k);
    least = std::min(least, spacing);
    largest = std::max(largest, spacing);
  }
  const double ends = joint_offset(set, 500) - joint_offset(set, -500);
  std::cout << "spacings from " << least << " to " << largest << ", 2 +- 1.2 allowed\n";
  CHECK(least >= 2 * (1 - 0.6));
  CHECK(largest <= 2 * (1 + 0.6));
  CHECK(
      least <
      2 * (1 -
           0.3));  // the spread is used: a thousand draws without one in this part have a chance below 1e-50
  CHECK(largest > 2 * (1 + 0.3));
  CHECK(std::abs(ends - 2000) <= 2 * 0.6);
  CHECK(joint_offset({.spacing = 2, .offset = 5, .seed = 42}, 3) == 11);
}

TEST_CASE("blocks below the smallest area are left out and told") {
  const Context context = make_context();
  JointedRock rock = collapse_rock();
  const std::size_t all = cut_rectangle(context, rock).blocks.size();
  rock.smallest_size = 0.1;
  const JointedBlocks cut = cut_rectangle(context, rock);
  double area = cut.size_left_out;
  for (const Shape& block : cut.blocks) {
    CHECK(properties_of(context, block).volume >= 0.1);
    area += properties_of(context, block).volume;
  }
  CHECK(cut.left_out > 0);
  CHECK(cut.blocks.size() + static_cast<std::size_t>(cut.left_out) == all);
  CHECK(std::abs(area - 1000) < area_rounding);
}

TEST_CASE("random numbers are those of SplitMix64") {
  Random random(0);
  CHECK(random.bits() == 0xe220a8397b1dcdafu);
  CHECK(random.bits() == 0x6e789e6aa1b965f4u);
  for (int i = 0; i < 1000; ++i) {
    const double u = random.uniform();
    CHECK((u >= 0 && u < 1));
  }
}
