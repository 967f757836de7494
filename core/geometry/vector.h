#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <memory_resource>
#include <vector>

namespace halfspace {

/// A point or direction in D dimensions.
template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

/// A linear map of vectors.
template <int D>
using Tensor = Eigen::Matrix<double, D, D>;

/// Contiguous storage that takes its memory from the caller's allocator.
template <class T>
using Array = std::pmr::vector<T>;

/// Reserves one more entry, by doubling, so that appending costs linear time.
template <class T>
void make_room_for_one(Array<T>& array) {
  if (array.capacity() == array.size()) array.reserve(2 * array.size() + 1);
}

/// Adjusts the capacity to `room`: grows it if smaller, shrinks it if much larger. Entries stay, also when
/// memory runs out.
template <class T>
void refit(Array<T>& array, std::size_t room) {
  if (array.capacity() >= room && array.capacity() <= room + room / 4) return;
  Array<T> fitting(array.get_allocator());
  fitting.reserve(std::max(room, array.size()));
  fitting.assign(array.begin(), array.end());
  array.swap(fitting);
}

using Memory = std::pmr::memory_resource;

/// z component of the cross product: > 0 when b lies counter-clockwise of a.
inline double cross(const Vector<2>& a, const Vector<2>& b) { return a.x() * b.y() - a.y() * b.x(); }

inline Vector<3> cross_product(const Vector<3>& a, const Vector<3>& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

/// The vector rotated by 90 degrees counter-clockwise.
inline Vector<2> perpendicular(const Vector<2>& v) { return {-v.y(), v.x()}; }

/// Angular velocity, angular momentum or torque: in 2D one number, counter-clockwise.
template <int D>
using Angular = Vector<D == 2 ? 1 : 3>;

/// Moment of a force that acts at the end of an arm.
inline Angular<2> moment(const Vector<2>& arm, const Vector<2>& force) {
  return Angular<2>(cross(arm, force));
}
inline Angular<3> moment(const Vector<3>& arm, const Vector<3>& force) { return cross_product(arm, force); }

/// Moment of forces whose products force * arm^T are summed in a tensor.
inline Angular<2> moment(const Tensor<2>& virial) { return Angular<2>(virial(1, 0) - virial(0, 1)); }
inline Angular<3> moment(const Tensor<3>& virial) {
  return {virial(2, 1) - virial(1, 2), virial(0, 2) - virial(2, 0), virial(1, 0) - virial(0, 1)};
}

/// Velocity of the end of an arm by a spin.
inline Vector<2> swept(const Angular<2>& spin, const Vector<2>& arm) { return spin[0] * perpendicular(arm); }
inline Vector<3> swept(const Angular<3>& spin, const Vector<3>& arm) { return cross_product(spin, arm); }

/// The tensor that maps an arm to its velocity by a spin.
inline Tensor<2> cross_tensor(const Angular<2>& spin) {
  Tensor<2> turn;
  turn << 0, -spin[0], spin[0], 0;
  return turn;
}
inline Tensor<3> cross_tensor(const Angular<3>& spin) {
  Tensor<3> turn;
  turn << 0, -spin.z(), spin.y(), spin.z(), 0, -spin.x(), -spin.y(), spin.x(), 0;
  return turn;
}

}  // namespace halfspace
