#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "contacts_3d.h"
#include "rotations.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// Every entry of a product of two rotations is a sum of three products of at most 1: some 4 roundings. What
/// both sides of a comparison do with a few of them stays below this.
constexpr double few_roundings = 16 * 0x1p-52;

double off_by(const Rotation<3>& rotation, const Eigen::Matrix3d& expected) {
  return (matrix_of(rotation) - expected).cwiseAbs().maxCoeff();
}

double off_unit(const Rotation<3>& rotation) {
  return off_by(rotation.inverse() * rotation, Eigen::Matrix3d::Identity());
}

}  // namespace

TEST_CASE("in space a further turn is Rodrigues' formula, whatever its length") {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Rotation<3> start = random_turn(random);
    const Vector<3> axis = random_direction(random);
    // Both sides of 0.0625, where the series gives way to the C library's functions.
    const double angle = std::exp(random.uniform(-30, 1.1)) * (i % 2 == 0 ? 1 : -1);
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * matrix_of(start);
    CHECK(off_by(start.turned_by(angle * axis), expected) < few_roundings);
  }
  const Rotation<3> start = random_turn(random);
  CHECK(off_by(start.turned_by(Vector<3>::Zero()), matrix_of(start)) == 0);
}

TEST_CASE("a turn about an own axis is that turn in the body's frame") {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const Rotation<3> start = random_turn(random);
    const double angle = random.uniform(-4, 4);
    for (int k = 0; k < 3; ++k) {
      Rotation<3> turned = start;
      turned.turn_about_own_axis(k, angle);
      const Eigen::Matrix3d expected =
          matrix_of(start) * Eigen::AngleAxisd(angle, Vector<3>::Unit(k)).toRotationMatrix();
      CHECK(off_by(turned, expected) < few_roundings);
    }
  }
}

TEST_CASE("products, inverses and vectors go by the matrix") {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Rotation<3> p = random_turn(random), q = random_turn(random);
    const Vector<3> v = random_vector(random, -1, 1);
    CHECK(off_by(p * q, matrix_of(p) * matrix_of(q)) < few_roundings);
    CHECK(off_by(p.inverse(), matrix_of(p).transpose()) == 0);
    CHECK((p * v - matrix_of(p) * v).norm() < few_roundings);
  }
}

TEST_CASE("a million turns leave axes of unit length at right angles, and add up") {
  Random random(4);
  Rotation<3> rotation;
  const int count = 1000000;
  for (int i = 0; i < count; ++i) rotation = rotation.turned_by(random_vector(random, -0.01, 0.01));
  CHECK(off_unit(rotation) < few_roundings);
  CHECK(matrix_of(rotation).determinant() == Approx(1).epsilon(few_roundings));

  // About one axis. Each turn rounds every entry by a few halves of an ulp.
  const Vector<3> axis = Vector<3>(1, 2, 3).normalized();
  Rotation<3> spun;
  for (int i = 0; i < count; ++i) spun = spun.turned_by(1e-3 * axis);
  CHECK(off_by(spun, Eigen::AngleAxisd(1e-3 * count, axis).toRotationMatrix()) < count * few_roundings);
}

TEST_CASE("straightened is the nearest rotation, to the square of what it was off") {
  Random random(5);
  for (const double off : {1e-3, 1e-5, 1e-8}) {
    for (int i = 0; i < 100; ++i) {
      Eigen::Matrix3d bent = matrix_of(random_turn(random));
      for (int k = 0; k < 3; ++k) bent.col(k) += off * random_direction(random);
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(bent, Eigen::ComputeFullU | Eigen::ComputeFullV);
      const Eigen::Matrix3d nearest = svd.matrixU() * svd.matrixV().transpose();
      // A stretch 1 + s becomes 1 - 3/2 s^2 - s^3/2, and no stretch is more than the square root of the sum
      // of the three squares added.
      const double bound = 1.5 * (3 * off * off) * (1 + off) + few_roundings;
      CHECK(off_by(rotation_of(bent).straightened(), nearest) < bound);
    }
  }
}

TEST_CASE("no unit vector is turned farther apart than farthest_from says, and some nearly so far") {
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const Rotation<3> rotation = random_turn(random);
    const double angle = std::exp(random.uniform(-12, 1.1));
    const Vector<3> axis = random_direction(random);
    const Rotation<3> other = rotation.turned_by(angle * axis);
    const double bound = rotation.farthest_from(other);
    // Across the axis a point moves by the chord; the bound is the Frobenius norm, sqrt(2) times as much.
    CHECK(bound == Approx(std::sqrt(2.0) * 2 * std::sin(0.5 * angle)).epsilon(1e-12).margin(few_roundings));
    for (int k = 0; k < 20; ++k) {
      const Vector<3> v = random_direction(random);
      CHECK((rotation * v - other * v).norm() <= bound + few_roundings);
    }
  }
}

TEST_CASE("quaternions come back, whichever part is the largest") {
  Random random(7);
  for (int largest = 0; largest < 4; ++largest) {
    for (int i = 0; i < 500; ++i) {
      Eigen::Vector4d q;
      for (int k = 0; k < 4; ++k) q[k] = k == largest ? 1 : random.uniform(-1, 1) * (i % 5) / 4;
      q = q.normalized() * (q[3] < 0 ? -1 : 1);
      const Rotation<3> rotation = Rotation<3>::from_quaternion(q.data());
      const Eigen::Matrix3d expected = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix();
      CHECK(off_by(rotation, expected) < few_roundings);
      Eigen::Vector4d back;
      rotation.write_quaternion(back.data());
      CHECK(back.norm() == Approx(1).epsilon(few_roundings));
      // Of a half turn w is 0 but for rounding, and either sign is as good.
      CHECK(back[3] > -few_roundings);
      CHECK(std::min((back - q).cwiseAbs().maxCoeff(),
                     std::abs(q[3]) < few_roundings ? (back + q).cwiseAbs().maxCoeff() : HUGE_VAL) <
            few_roundings);
    }
  }
}

TEST_CASE("a quaternion off unit length is taken as its direction") {
  const double q[] = {0.1, -0.2, 0.3, 0.4};
  const double longer[] = {1e3 * q[0], 1e3 * q[1], 1e3 * q[2], 1e3 * q[3]};
  const Rotation<3> rotation = Rotation<3>::from_quaternion(q);
  CHECK(off_unit(rotation) < few_roundings);
  CHECK(off_by(Rotation<3>::from_quaternion(longer), matrix_of(rotation)) < few_roundings);
}
