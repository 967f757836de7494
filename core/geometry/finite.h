#pragma once

#include <Eigen/Core>
#include <cmath>

namespace halfspace {

/// Eigen's allFinite() says the same, by templates that cost the compiler far more.
template <class Matrix>
bool all_finite(const Eigen::PlainObjectBase<Matrix>& matrix) {
  const double* const values = matrix.data();
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    if (!std::isfinite(values[i])) return false;
  }
  return true;
}

}  // namespace halfspace
