#include "block/inertia.h"

#include <Eigen/LU>
#include <cmath>

#include "catch.h"
#include "contacts_3d.h"
#include "rotations.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double density = 2500;

/// Turned back into the shape's frame.
Eigen::Matrix3d tensor_of(const Inertia<3>& inertia) {
  const Eigen::Matrix3d axes = matrix_of(inertia.axes);
  return axes * inertia.moments.asDiagonal() * axes.transpose();
}

}  // namespace

TEST_CASE("of a box: mass and a twelfth of its sides' squares") {
  const Shape<3> shape = shape_of(completed(box({1, 2, 3}, {5, 6, 7})));
  const Inertia<3> inertia = Inertia<3>::of(shape, density);
  const double twelfth = density * 6 / 12;
  CHECK(mass_of(shape, density) == Approx(density * 6).epsilon(1e-15));
  // Principal moments in ascending order: about the longest side first.
  CHECK(inertia.moments.isApprox(twelfth * Vector<3>(1 + 4, 1 + 9, 4 + 9), 1e-15));
  CHECK(inertia.min_moment() == inertia.moments[0]);
  for (int k = 0; k < 3; ++k) CHECK(std::abs(inertia.axes.axis(k)[2 - k]) == Approx(1).epsilon(1e-15));
}

TEST_CASE("of a tetrahedron at the origin with legs 1") {
  // Integrals of x^2 and xy are 1/60 and 1/120; about the centroid, a quarter along each leg, V/16 = 1/96
  // less each: 1/80 on the diagonal and 1/480 off it. So 1/60 about (1, 1, 1) and 1/96 across.
  const Shape<3> shape = block_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Inertia<3> inertia = Inertia<3>::of(shape, density);
  CHECK(inertia.moments.isApprox(density * Vector<3>(1 / 96.0, 1 / 96.0, 1 / 60.0), 1e-14));
  CHECK(std::abs(inertia.axes.axis(2).dot(Vector<3>(1, 1, 1).normalized())) == Approx(1).epsilon(1e-14));
}

TEST_CASE("of regular solids: the same about every axis, and still three axes") {
  for (const PlatonicSolid& solid : platonic_solids()) {
    INFO(solid.name);
    const Inertia<3> inertia = Inertia<3>::of(block_of(solid.vertices), density);
    CHECK(inertia.moments.maxCoeff() == Approx(inertia.moments.minCoeff()).epsilon(1e-14));
    CHECK(matrix_of(inertia.axes).determinant() == Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("principal moments and axes are those of the shape's inertia") {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const Vector<3> stretch = random_vector(random, 0.1, 1);
    Cloud cloud = random_cloud(random, 12, 1, 1);
    for (Vector<3>& p : cloud) p = stretch.cwiseProduct(p);
    const Shape<3> shape = block_of(turned(cloud, random_rotation(random)));
    const Inertia<3> inertia = Inertia<3>::of(shape, density);
    const Eigen::Matrix3d expected = density * shape.inertia();
    // The eigenvalues are exact to a few roundings of the largest.
    CHECK((tensor_of(inertia) - expected).norm() < 32 * 0x1p-52 * expected.norm());
    CHECK(matrix_of(inertia.axes).determinant() == Approx(1).epsilon(1e-14));
    CHECK(inertia.min_moment() == inertia.moments[0]);

    // What momentum and spin are of one another, and by definition.
    const Rotation<3> rotation = random_turn(random);
    const Vector<3> spin = random_vector(random, -3, 3);
    const Vector<3> momentum = inertia.momentum(spin, rotation);
    const Eigen::Matrix3d turn = matrix_of(rotation);
    const Vector<3> by_definition = turn * (expected * (turn.transpose() * spin));
    CHECK((momentum - by_definition).norm() < 64 * 0x1p-52 * expected.norm() * spin.norm());
    const double condition = inertia.moments[2] / inertia.moments[0];
    CHECK((inertia.spin(momentum, rotation) - spin).norm() < 64 * 0x1p-52 * condition * spin.norm());
  }
}

TEST_CASE("a shape scaled by a power of two has its moments scaled, bit for bit, about the same axes") {
  Random random(12);
  const Cloud cloud = random_cloud(random, 15, 0.5, 1);
  const Inertia<3> inertia = Inertia<3>::of(block_of(cloud), density);
  for (const int power : {-60, -7, 1, 60}) {
    const Inertia<3> large = Inertia<3>::of(block_of(scaled(cloud, std::ldexp(1.0, power))), density);
    CHECK(large.moments == std::ldexp(1.0, 5 * power) * inertia.moments);
    CHECK(matrix_of(large.axes) == matrix_of(inertia.axes));
  }
}
