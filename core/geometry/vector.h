#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory_resource>
#include <vector>

namespace halfspace {

/// A point or direction in D dimensions.
template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

/// Contiguous storage that takes its memory from the caller's allocator.
template <class T>
using Array = std::pmr::vector<T>;

/// Room for one entry more, gained by doubling, so that entries added one by one cost linear time.
template <class T>
void make_room_for_one(Array<T>& array) {
  if (array.capacity() == array.size()) array.reserve(2 * array.size() + 1);
}

/// Capacity near `room` for an array whose entries are not needed any more: more when it is short, less when
/// most would lie idle.
template <class T>
void refit(Array<T>& array, std::size_t room) {
  array.clear();
  if (array.capacity() >= room && array.capacity() <= room + room / 4) return;
  Array<T> fitting(array.get_allocator());
  fitting.reserve(room);
  array.swap(fitting);
}

using Memory = std::pmr::memory_resource;

/// z component of the cross product: > 0 when b lies counter-clockwise of a.
inline double cross(const Vector<2>& a, const Vector<2>& b) { return a.x() * b.y() - a.y() * b.x(); }

inline Vector<3> cross_product(const Vector<3>& a, const Vector<3>& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

/// The vector turned by a right angle counter-clockwise.
inline Vector<2> perpendicular(const Vector<2>& v) { return {-v.y(), v.x()}; }

}  // namespace halfspace
