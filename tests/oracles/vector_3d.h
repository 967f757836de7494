#pragma once

// Vectors in space over any number type: doubles, and the exact numbers of the oracles.

#include <cmath>
#include <vector>

namespace halfspace_test {

template <class Number>
struct Vector3 {
  Number x{};
  Number y{};
  Number z{};
};

template <class N>
Vector3<N> operator+(const Vector3<N>& a, const Vector3<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
Vector3<N> operator-(const Vector3<N>& a, const Vector3<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
Vector3<N> operator*(const N& s, const Vector3<N>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class N>
N dot(const Vector3<N>& a, const Vector3<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
Vector3<N> cross(const Vector3<N>& a, const Vector3<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Point3 = Vector3<double>;
using Points3 = std::vector<Point3>;

inline double length(const Point3& a) { return std::sqrt(dot(a, a)); }
inline Point3 unit(const Point3& a) { return (1 / length(a)) * a; }

template <class Number>
Vector3<Number> converted(const Point3& p) {
  return {Number(p.x), Number(p.y), Number(p.z)};
}

}  // namespace halfspace_test
