#pragma once

#include <Eigen/Core>

#include "geometry/rotation.h"
#include "polyhedra.h"

namespace halfspace::test {

inline Eigen::Matrix3d matrix_of(const Rotation<3>& rotation) {
  Eigen::Matrix3d matrix;
  matrix << rotation.axis(0), rotation.axis(1), rotation.axis(2);
  return matrix;
}

inline Rotation<3> rotation_of(const Eigen::Matrix3d& matrix) {
  return Rotation<3>::from_axes(matrix.col(0), matrix.col(1), matrix.col(2));
}

inline Rotation<3> random_turn(Random& random) { return rotation_of(random_rotation(random)); }

}  // namespace halfspace::test
