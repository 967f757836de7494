#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

template <int D>
struct Outline;

/// For every direction, a few vertices of a polyhedron of many: the one that lies deepest along it is among
/// them. The faces of a cube about the origin are divided into cells; to a cell belongs what lies deepest
/// along some direction through it: the Gauss map of the polyhedron, on a raster. In the orientation of the
/// outline that it was made for.
class GaussMap {
 public:
  /// With a quarter as many cells to a face of the cube as there are vertices: more would be slower to read
  /// from memory than they save.
  GaussMap(const Outline<3>& outline, Memory* memory);

  /// A direction without length has some, but no matter which.
  std::span<const std::int32_t> candidates(const Vector<3>& direction) const {
    const std::size_t cell = std::size_t(cell_of(direction));
    const std::int32_t first = first_of_cell_[cell];
    return {vertices_.data() + first, std::size_t(first_of_cell_[cell + 1] - first)};
  }

 private:
  int cell_of(const Vector<3>& direction) const {
    const double x = std::abs(direction.x()), y = std::abs(direction.y()), z = std::abs(direction.z());
    const int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    const double scale = 0.5 * cells_ / std::max(std::max(x, y), z);
    // Whatever the direction, a cell: where there is none, max() takes NaN for 0.
    const auto along = [&](int c) {
      return int(std::min(std::max(0.0, direction[c] * scale + 0.5 * cells_), cells_ - 1.0));
    };
    const int side = 2 * axis + (direction[axis] < 0 ? 1 : 0);
    return (side * cells_ + along(u)) * cells_ + along(v);
  }

  int cells_ = 0;  // along an edge of the cube
  Array<std::int32_t> first_of_cell_;
  Array<std::int32_t> vertices_;
};

}  // namespace halfspace
