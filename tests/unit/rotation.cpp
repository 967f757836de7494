#include "geometry/rotation.h"

#include "catch.h"

using namespace halfspace;

TEST_CASE("small turns add up to the angle and stay of unit length") {
  // Each turn rounds its cosine and sine to half an ulp: n turns are off by less than n of them, and by their
  // root as a rule.
  Rotation<2> rotation;
  const double step = 1e-3;
  const int count = 1000000;
  for (int i = 0; i < count; ++i) rotation = rotation.turned_by(Angular<2>(step));
  const Rotation<2> exact = Rotation<2>::from_angle(step * count);
  CHECK(rotation.cosine * rotation.cosine + rotation.sine * rotation.sine == Approx(1).epsilon(1e-15));
  CHECK(std::abs(rotation.cosine - exact.cosine) < count * 0x1p-53);
  CHECK(std::abs(rotation.sine - exact.sine) < count * 0x1p-53);
}

TEST_CASE("a turn and its opposite mirror each other bit for bit") {
  Rotation<2> left, right;
  for (int i = 1; i < 1000; ++i) {
    left = left.turned_by(Angular<2>(1e-4 * i));
    right = right.turned_by(Angular<2>(-1e-4 * i));
    CHECK(left.cosine == right.cosine);
    CHECK(left.sine == -right.sine);
  }
}

TEST_CASE("a quaternion off unit length by little is taken as its direction") {
  const double stretch = 1 + 1e-6;
  const double deficit = 1 - stretch * stretch;
  const CosineAndSine<double> r = cosine_and_sine(0.6 * stretch, 0.8 * stretch, deficit);
  CHECK(r.cosine == Approx(0.64 - 0.36).epsilon(1e-15));
  CHECK(r.sine == Approx(2 * 0.6 * 0.8).epsilon(1e-15));
}
