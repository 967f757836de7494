#pragma once

#include "geometry/vector.h"
#include "simd/four_lanes.h"

namespace halfspace {

/// A vector in 3D; with lanes, one vector per lane.
template <class Number>
struct Coordinates {
  Number x, y, z;
};

// Always inlined: see four_lanes.h.

template <class Number>
[[gnu::always_inline]] inline Coordinates<Number> operator+(const Coordinates<Number>& a,
                                                            const Coordinates<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Number>
[[gnu::always_inline]] inline Coordinates<Number> operator-(const Coordinates<Number>& a,
                                                            const Coordinates<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
[[gnu::always_inline]] inline Coordinates<Number> operator*(const Number& factor,
                                                            const Coordinates<Number>& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}

template <class Number>
[[gnu::always_inline]] inline Number dot_product(const Coordinates<Number>& a, const Coordinates<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
[[gnu::always_inline]] inline Coordinates<Number> cross_product(const Coordinates<Number>& a,
                                                                const Coordinates<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Four>
[[gnu::always_inline]] inline Coordinates<Four> all_four(const Vector<3>& a) {
  return {all_four<Four>(a.x()), all_four<Four>(a.y()), all_four<Four>(a.z())};
}
inline Vector<3> vector_of(const Coordinates<double>& a) { return {a.x, a.y, a.z}; }

}  // namespace halfspace
