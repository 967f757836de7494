#pragma once

#include <cmath>

#include "geometry/vector.h"

namespace halfspace {

/// A number in two doubles, high + low: about 32 decimal digits (Dekker 1971).
struct Precise {
  double high;
  double low;
};

/// Without rounding error (Knuth's two-sum).
inline Precise difference(double a, double b) {
  const double d = a - b;
  const double b_in_d = a - d;
  const double a_in_d = d + b_in_d;
  return {d, (a - a_in_d) + (b_in_d - b)};
}

inline Precise operator*(const Precise& a, const Precise& b) {
  const double p = a.high * b.high;
  return {p, std::fma(a.high, b.high, -p) + (a.high * b.low + a.low * b.high)};
}

inline Precise operator-(const Precise& a, const Precise& b) {
  const Precise d = difference(a.high, b.high);
  return {d.high, d.low + (a.low - b.low)};
}

/// (a - o) x (b - o), accurate to the last bits however narrow the triangle o, a, b is.
inline Vector<3> precise_cross_product(const Vector<3>& o, const Vector<3>& a, const Vector<3>& b) {
  Precise p[3], q[3];
  for (int i = 0; i < 3; ++i) {
    p[i] = difference(a[i], o[i]);
    q[i] = difference(b[i], o[i]);
  }
  const auto component = [&](int i, int j) {
    const Precise c = p[i] * q[j] - p[j] * q[i];
    return c.high + c.low;
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

}  // namespace halfspace
