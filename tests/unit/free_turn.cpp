#include "block/free_turn.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "catch.h"
#include "rotations.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// A body of three different moments, its principal axes askew in its own frame.
Inertia<3> asymmetric() {
  Random random(21);
  return {{1, 2, 3}, random_turn(random)};
}

Vector<3> along_principal_axes(const Rotation<3>& rotation, const Inertia<3>& inertia,
                               const Vector<3>& momentum) {
  return (rotation * inertia.axes).inverse() * momentum;
}

double energy(const Rotation<3>& rotation, const Inertia<3>& inertia, const Vector<3>& momentum) {
  return 0.5 * momentum.dot(inertia.spin(momentum, rotation));
}

/// With the momentum this far off the middle axis.
Vector<3> momentum_near_middle_axis(const Inertia<3>& inertia, double off) {
  return inertia.axes * (2 * Vector<3>(off, 1, off).normalized());
}

/// Euler's equations by another method, Runge and Kutta's of fourth order, in steps so small that its error
/// is rounding: dR/dt = (I^-1 L) x R.
Eigen::Matrix3d turned_by_runge_kutta(Eigen::Matrix3d turn, const Inertia<3>& inertia,
                                      const Vector<3>& momentum, double duration, int steps) {
  const Eigen::Matrix3d axes = matrix_of(inertia.axes);
  const Eigen::Matrix3d inverse = axes * inertia.moments.cwiseInverse().asDiagonal() * axes.transpose();
  const auto rate = [&](const Eigen::Matrix3d& r) {
    const Vector<3> spin = r * (inverse * (r.transpose() * momentum));
    Eigen::Matrix3d result;
    for (int k = 0; k < 3; ++k) result.col(k) = spin.cross(r.col(k));
    return result;
  };
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Matrix3d k1 = rate(turn), k2 = rate(turn + 0.5 * h * k1), k3 = rate(turn + 0.5 * h * k2),
                          k4 = rate(turn + h * k3);
    turn += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return turn;
}

Rotation<3> turned_in_steps(Rotation<3> rotation, const Inertia<3>& inertia, const Vector<3>& momentum,
                            double duration, int steps) {
  for (int i = 0; i < steps; ++i)
    rotation = turned_freely(rotation, inertia, momentum, duration / steps).rotation;
  return rotation;
}

}  // namespace

TEST_CASE("a wing nut about its middle axis flips over and over, and keeps energy and momentum") {
  const Inertia<3> inertia = asymmetric();
  const Vector<3> momentum = momentum_near_middle_axis(inertia, 1e-3);
  const double before = energy(Rotation<3>(), inertia, momentum);
  // The splitting's own energy is off by (spin * step)^2 / 24 times differences of the moments over them,
  // below 1: with a spin of 1 and this step, 4e-8.
  const double step = 1e-3;
  Rotation<3> rotation;
  double worst_energy = 0, worst_momentum = 0;
  double along_middle = 1;
  std::vector<double> flips;
  for (int i = 0; i < 1000000; ++i) {
    rotation = turned_freely(rotation, inertia, momentum, step).rotation;
    const Vector<3> own = along_principal_axes(rotation, inertia, momentum);
    worst_energy = std::max(worst_energy, std::abs(energy(rotation, inertia, momentum) - before));
    worst_momentum = std::max(worst_momentum, std::abs(own.norm() - momentum.norm()));
    if (along_middle * own[1] < 0) flips.push_back(step * (i + own[1] / (own[1] - along_middle)));
    along_middle = own[1];
  }
  CHECK(worst_energy < 1e-7 * before);
  CHECK(worst_momentum < 1e-14 * momentum.norm());

  // Of Euler's equations: the momentum along the middle axis is the elliptic sine, which changes its sign
  // every 2 K(k) / p. A relative error of 1e-7 in the energy moves k'^2, here of the order of off^2 = 1e-6,
  // by 1e-7 in 1e-6, and K(k), the logarithm of 4 / k', by 0.05.
  const Vector<3>& I = inertia.moments;
  const double L2 = momentum.squaredNorm(), twice = 2 * before;
  const double p = std::sqrt((I[2] - I[1]) * (L2 - twice * I[0]) / (I[0] * I[1] * I[2]));
  const double k2 = (I[1] - I[0]) * (twice * I[2] - L2) / ((I[2] - I[1]) * (L2 - twice * I[0]));
  const double modulus = std::sqrt(k2 <= 1 ? k2 : 1 / k2), rate = k2 <= 1 ? p : p * std::sqrt(k2);
  const double half_period = 2 * std::comp_ellint_1(modulus) / rate;
  REQUIRE(flips.size() > 10);
  for (std::size_t i = 1; i < flips.size(); ++i)
    CHECK(flips[i] - flips[i - 1] == Approx(half_period).margin(0.1 / rate));
}

TEST_CASE("the attitude is that of Euler's equations, to the second order of the step") {
  Random random(22);
  for (int i = 0; i < 5; ++i) {
    const Inertia<3> inertia{Vector<3>(1, random.uniform(1.1, 1.5), random.uniform(1.6, 2.4)),
                             random_turn(random)};
    const Rotation<3> start = random_turn(random);
    const Vector<3> momentum = 1.5 * random_direction(random);
    const double duration = 3;
    const Eigen::Matrix3d exact = turned_by_runge_kutta(matrix_of(start), inertia, momentum, duration, 4000);
    const auto error = [&](int steps) {
      return (matrix_of(turned_in_steps(start, inertia, momentum, duration, steps)) - exact).norm();
    };
    const double coarse = error(100), middle = error(200), fine = error(400);
    CHECK(coarse < 1e-2);
    // The next term of the error is of fourth order, 1e-3 of this one.
    CHECK(coarse / middle == Approx(4).epsilon(0.01));
    CHECK(middle / fine == Approx(4).epsilon(0.01));
  }
}

TEST_CASE("a symmetric top precesses about its momentum at |L| / I") {
  Random random(23);
  for (const Vector<3>& moments : {Vector<3>(2, 2, 0.5), Vector<3>(2, 2, 3.5), Vector<3>(0.5, 2, 2)}) {
    const int symmetry_axis = moments[0] == moments[1] ? 2 : 0;
    const double across = moments[1], along = moments[symmetry_axis];
    const Inertia<3> inertia{moments, random_turn(random)};
    const Rotation<3> start = random_turn(random);
    const Vector<3> momentum = 2 * random_direction(random);
    const double duration = 20;
    // Turned about the momentum at |L| / I, after a turn about its own axis by what the spin has more there.
    const Vector<3> axis = inertia.axes.axis(symmetry_axis);
    const double share = momentum.dot(start * axis);
    const Eigen::Matrix3d expected =
        Eigen::AngleAxisd(duration * momentum.norm() / across, momentum.normalized()).toRotationMatrix() *
        matrix_of(start) *
        Eigen::AngleAxisd(duration * share * (1 / along - 1 / across), axis).toRotationMatrix();
    const auto error = [&](int steps) {
      return (matrix_of(turned_in_steps(start, inertia, momentum, duration, steps)) - expected).norm();
    };
    const double coarse = error(2000), fine = error(4000);
    // Of second order: the spin times the step is at most 0.04, its square over 24 is 7e-5, over a way of 80.
    CHECK(coarse < 80 * 7e-5);
    if (coarse > 1e-9) CHECK(coarse / fine == Approx(4).epsilon(0.01));
  }
}

TEST_CASE("turned back in time it comes back") {
  Random random(24);
  const Inertia<3> inertia = asymmetric();
  const Vector<3> momentum = momentum_near_middle_axis(inertia, 0.3);
  const Rotation<3> start = random_turn(random);
  const int steps = 1000;
  const Rotation<3> there = turned_in_steps(start, inertia, momentum, 10, steps);
  CHECK(there.farthest_from(start) > 0.1);
  const Rotation<3> back = turned_in_steps(there, inertia, momentum, -10, steps);
  // The steps undo each other exactly. What they round, 1e-15 each, grows with e^(t / sqrt 3) at most, that
  // is 322 times.
  CHECK(back.farthest_from(start) < 2 * steps * 1e-15 * 322);
}

TEST_CASE("about a principal axis, and in the plane, the spin stays and the turn is exact") {
  const Inertia<3> inertia = asymmetric();
  for (int k = 0; k < 3; ++k) {
    const Vector<3> spin = 0.7 * inertia.axes.axis(k);
    const Vector<3> momentum = inertia.momentum(spin, Rotation<3>());
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(0.7 * 0.5, spin.normalized()).toRotationMatrix();
    CHECK((matrix_of(turned_freely(Rotation<3>(), inertia, momentum, 0.5).rotation) - expected).norm() <
          1e-14);
  }
  const Inertia<2> flat{3};
  const Rotation<2> turned = turned_freely(Rotation<2>(), flat, Angular<2>(6), 0.25).rotation;
  CHECK(turned.cosine == Approx(std::cos(0.5)).epsilon(1e-15));
  CHECK(turned.sine == Approx(std::sin(0.5)).epsilon(1e-15));
}
