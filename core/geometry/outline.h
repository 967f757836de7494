#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// A convex shape as detection reads it: plain component arrays, relative to the centroid, in some
/// orientation.
template <int D>
struct Outline;

/// Vertex i, and half-space i of the edge from vertex i to vertex i + 1: inside is nx*x + ny*y <= offset. The
/// arrays are padded to an even count by repeating the last entry, so that a pair of entries can be read at a
/// time.
template <>
struct Outline<2> {
  int count = 0;
  const double* x = nullptr;
  const double* y = nullptr;
  const double* nx = nullptr;
  const double* ny = nullptr;
  const double* offset = nullptr;

  Vector<2> vertex(int i) const { return {x[i], y[i]}; }
  Vector<2> normal(int i) const { return {nx[i], ny[i]}; }
  int next(int i) const { return i + 1 == count ? 0 : i + 1; }
  int previous(int i) const { return i == 0 ? count - 1 : i - 1; }
  static int padded(int count) { return count + (count & 1); }
};

}  // namespace halfspace
