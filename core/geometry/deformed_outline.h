#pragma once

#include <cstddef>

#include "geometry/outline.h"
#include "geometry/vector.h"

namespace halfspace {

/// Maps vectors stored as component arrays of length `count`, one after the other.
inline void map_vectors(const Tensor<2>& map, const double* own, std::size_t count, double* mapped) {
  const double *x = own, *y = own + count;
  double *out_x = mapped, *out_y = mapped + count;
  const double xx = map(0, 0), xy = map(0, 1), yx = map(1, 0), yy = map(1, 1);
  for (std::size_t i = 0; i < count; ++i) {
    out_x[i] = xx * x[i] + xy * y[i];
    out_y[i] = yx * x[i] + yy * y[i];
  }
}

inline void map_vectors(const Tensor<3>& map, const double* own, std::size_t count, double* mapped) {
  const double *x = own, *y = own + count, *z = own + 2 * count;
  for (int k = 0; k < 3; ++k) {
    double* out = mapped + std::size_t(k) * count;
    const double of_x = map(k, 0), of_y = map(k, 1), of_z = map(k, 2);
    for (std::size_t i = 0; i < count; ++i) out[i] = of_x * x[i] + of_y * y[i] + of_z * z[i];
  }
}

/// The number of doubles of an outline: x, y, nx, ny, offset, or x, y, z, nx, ny, nz, offset, each padded.
std::size_t component_count(const Outline<2>& outline);
std::size_t component_count(const Outline<3>& outline);

/// The outline of a shape mapped by a deformation gradient: vertices by the gradient, half-spaces so that
/// they remain those of the faces. `components` has room for component_count() doubles.
Outline<2> deformed(const Outline<2>& own, const Tensor<2>& gradient, double* components);
Outline<3> deformed(const Outline<3>& own, const Tensor<3>& gradient, double* components);

}  // namespace halfspace
