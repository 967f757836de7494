#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

template <int D>
struct Outline;

/// A Gauss map on a grid: for every direction, a few of a polyhedron's many vertices, with the deepest one
/// among them. The faces of a cube about the origin are divided into cells; each cell has the vertices that
/// are deepest along some direction through it, in the orientation of the given outline.
class GaussMap {
 public:
  /// A cube face has a quarter as many cells as there are vertices: more would cost more memory access than
  /// they save.
  GaussMap(const Outline<3>& outline, Memory* memory);

  /// The zero vector gets some valid candidates.
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
    // Returns a valid cell for any direction: max() replaces NaN by 0.
    const auto along = [&](int c) {
      return int(std::min(std::max(0.0, direction[c] * scale + 0.5 * cells_), cells_ - 1.0));
    };
    const int side = 2 * axis + (direction[axis] < 0 ? 1 : 0);
    return (side * cells_ + along(u)) * cells_ + along(v);
  }

  int cells_ = 0;  // per edge of the cube
  Array<std::int32_t> first_of_cell_;
  Array<std::int32_t> vertices_;
};

}  // namespace halfspace
