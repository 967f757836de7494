#pragma once

#include <cstddef>

#include "geometry/outline.h"
#include "geometry/vector.h"
#include "simd/four_lanes.h"

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
  with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    Four columns[3][3];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) columns[i][k] = all_four<Four>(map(k, i));
    const auto& [of_x, of_y, of_z] = columns;
    for (std::size_t i = 0; i < count; i += 4) {
      const Four x = load_four<Four>(own + i), y = load_four<Four>(own + count + i),
                 z = load_four<Four>(own + 2 * count + i);
      for (std::size_t k = 0; k < 3; ++k)
        store_four(mapped + k * count + i, of_x[k] * x + of_y[k] * y + of_z[k] * z);
    }
  });
}

/// The number of doubles of an outline: x, y, nx, ny, offset, or x, y, z, nx, ny, nz, offset, each padded.
std::size_t component_count(const Outline<2>& outline);
std::size_t component_count(const Outline<3>& outline);

/// The outline of a shape mapped by a deformation gradient: vertices by the gradient, half-spaces so that
/// they remain those of the faces. `components` has room for component_count() doubles.
Outline<2> deformed(const Outline<2>& own, const Tensor<2>& gradient, double* components);
Outline<3> deformed(const Outline<3>& own, const Tensor<3>& gradient, double* components);

}  // namespace halfspace
