#pragma once

#include <bit>
#include <cstdint>

#include "geometry/numbers.h"
#include "geometry/rotation.h"
#include "geometry/vector.h"
#include "simd/two_lanes.h"

namespace halfspace {

template <int D>
struct Pose {
  Vector<D> position;
  Rotation<D> rotation;
};

/// A pose in the host's memory: the centroid's three coordinates, and a quaternion x, y, z, w. In 2D the
/// quaternion is a rotation about z.
struct GivenPose {
  const double* position;
  const double* quaternion;
};

/// The norm of a quaternion may deviate from 1 by 1e-6, and so its square by this. Other faults of a pose are
/// weighted so that this is their limit, too.
constexpr double largest_fault = 2e-6;
/// Weight of the squares of x and y in 2D: each may be 1e-6.
constexpr double weight_off_axis = 1e6;
/// Weight of coordinates: they matter only near the largest number. Values that are not finite exceed the
/// limit or fail the comparison.
constexpr double weight_far_off = largest_fault / largest_number;

inline double fault_of_quaternion(const double q[4]) {
  return abs(1.0 - ((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3])));
}

/// Rotations by quaternions about z, and the deviation of their squared norms from 1. Number is a double, or
/// TwoLanes for two poses.
template <class Number>
struct TurnAboutZ {
  CosineAndSine<Number> turn;
  Number fault;
};

template <class Number>
TurnAboutZ<Number> turn_about_z(const Number& z, const Number& w) {
  const Number deficit = 1.0 - (z * z + w * w);
  return {cosine_and_sine(z, w, deficit), abs(deficit)};
}

inline TurnAboutZ<TwoLanes> turns_about_z(const GivenPose& a, const GivenPose& b) {
  const TwoLanes zw_a = load_two(a.quaternion + 2), zw_b = load_two(b.quaternion + 2);
  return turn_about_z(firsts(zw_a, zw_b), seconds(zw_a, zw_b));
}

/// Are the x and y of both quaternions 0?
inline bool turn_exactly_about_z(const GivenPose& a, const GivenPose& b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const double *p = a.quaternion, *q = b.quaternion;
  const std::uint64_t any = bits(p[0]) | bits(p[1]) | bits(q[0]) | bits(q[1]);
  return any << 1 == 0;  // without the sign
}

/// Is the quaternion of unit norm, in 2D about z, and the position within limits? False also for NaN.
template <int D>
bool is_tolerable(const GivenPose& given) {
  const double *p = given.position, *q = given.quaternion;
  if (!(is_within_limits(p[0]) && is_within_limits(p[1]))) return false;
  if constexpr (D == 3) return is_within_limits(p[2]) && fault_of_quaternion(q) <= largest_fault;
  const double off_axis = q[0] * q[0] + q[1] * q[1];
  return turn_about_z(q[2], q[3]).fault + weight_off_axis * off_axis <= largest_fault;
}

/// Faster; true only if both poses are tolerable, but may be false for tolerable ones.
template <int D>
[[gnu::always_inline]] inline bool are_tolerable(const GivenPose& a, const GivenPose& b) {
  const TwoLanes far_off = abs(load_two(a.position)) + abs(load_two(b.position));
  if constexpr (D == 2) {
    const TwoLanes fault = turns_about_z(a, b).fault + both(weight_far_off) * far_off;
    return fault[0] + fault[1] <= largest_fault && turn_exactly_about_z(a, b);
  }
  const double farthest = far_off[0] + far_off[1] + abs(a.position[2]) + abs(b.position[2]);
  return fault_of_quaternion(a.quaternion) <= largest_fault &&
         fault_of_quaternion(b.quaternion) <= largest_fault && weight_far_off * farthest <= largest_fault;
}

/// Converts a tolerable pose.
template <int D>
Pose<D> pose_of(const GivenPose& given) {
  const double* q = given.quaternion;
  if constexpr (D == 2) {
    const CosineAndSine<double> turn = turn_about_z(q[2], q[3]).turn;
    return {Vector<2>(given.position), {turn.cosine, turn.sine}};
  } else {
    return {Vector<3>(given.position), Rotation<3>::from_quaternion(q)};
  }
}

}  // namespace halfspace
