#pragma once

#include <Eigen/Core>
#include <cmath>

namespace halfspace {

/// The same as Eigen's allFinite(), whose templates take far longer to compile.
template <class Matrix>
bool all_finite(const Eigen::PlainObjectBase<Matrix>& matrix) {
  const double* const values = matrix.data();
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    if (!std::isfinite(values[i])) return false;
  }
  return true;
}

}  // namespace halfspace
