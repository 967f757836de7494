#include "geometry/pose.h"

#include <cmath>

#include "catch.h"
#include "kept_pose.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

TEST_CASE("a pose may be off by as much as its limits, and by no more") {
  const auto is_read = [](const Kept& kept, bool in_plane, bool in_space) {
    CHECK(is_tolerable<2>(kept.given()) == in_plane);
    CHECK(is_tolerable<3>(kept.given()) == in_space);
  };
  is_read({{1, 2, 3}, {0, 0, 0.6, 0.8}}, true, true);
  is_read({{1, 2, 3}, {0, 0, 0.6 * (1 + 9e-7), 0.8 * (1 + 9e-7)}}, true, true);
  is_read({{1, 2, 3}, {0, 0, 0.6 * (1 + 2e-6), 0.8 * (1 + 2e-6)}}, false, false);
  is_read({{1, 2, 3}, {9e-7, 0, 0.6, 0.8}}, true, true);
  is_read({{1, 2, 3}, {0.36, 0.48, 0.48, 0.64}}, false, true);
  is_read({{1, 2, 3}, {0, 0, NAN, 1}}, false, false);
  is_read({{1e76, 2, 3}, {0, 0, 0, 1}}, false, false);
  is_read({{1, NAN, 3}, {0, 0, 0, 1}}, false, false);
  is_read({{1, 2, HUGE_VAL}, {0, 0, 0, 1}}, true, false);  // z is nothing in the plane
}

TEST_CASE("poses that are good for a pair are good each by itself") {
  Random random(5);
  int good = 0;
  for (int i = 0; i < 1000; ++i) {
    Kept poses[2];
    for (Kept& kept : poses) {
      const double angle = random.uniform(-3, 3), stretch = 1 + random.uniform(-1.5e-6, 1.5e-6);
      kept = {{random.uniform(-9, 9), random.uniform(-9, 9), random.integer(0, 9) ? 0 : NAN},
              {0, 0, stretch * std::sin(angle), stretch * std::cos(angle)}};
      if (random.integer(0, 3) == 0) kept.position[random.integer(0, 1)] = 1e75;
    }
    const GivenPose a = poses[0].given(), b = poses[1].given();
    if (are_tolerable<2>(a, b)) CHECK((is_tolerable<2>(a) && is_tolerable<2>(b)));
    if (are_tolerable<3>(a, b)) CHECK((is_tolerable<3>(a) && is_tolerable<3>(b)));
    good += are_tolerable<2>(a, b);
  }
  CHECK(good > 100);
}

TEST_CASE("a turn in the plane is the quaternion that it is written as") {
  for (double angle = -3.1; angle < 3.2; angle += 0.1) {
    Kept kept{};
    Rotation<2>::from_angle(angle).write_quaternion(kept.quaternion);
    CHECK(kept.quaternion[2] == Approx(std::sin(0.5 * angle)).margin(1e-16));
    CHECK(kept.quaternion[3] == Approx(std::cos(0.5 * angle)).margin(1e-15));
    const Rotation<2> back = pose_of<2>(kept.given()).rotation;
    CHECK(back.cosine == Approx(std::cos(angle)).margin(1e-15));
    CHECK(back.sine == Approx(std::sin(angle)).margin(1e-15));
  }
}
