#pragma once

#include <Eigen/LU>
#include <cmath>

#include "block/deformation.h"
#include "guard.h"
#include "require.h"

namespace halfspace::capi {

/// From 9 values, row by row.
template <int D>
Tensor<D> read_finite_tensor(const double* values, const char* name) {
  require_pointer(values, name);
  Tensor<D> tensor;
  for (int row = 0; row < D; ++row) {
    for (int column = 0; column < D; ++column) {
      const int i = 3 * row + column;
      tensor(row, column) = require_component(values[i], name, i);
    }
  }
  return tensor;
}

/// `first` is the index of the first component in the error text.
template <int D>
Tensor<D> read_symmetric_tensor(const double* values, const char* name, int first = 0) {
  require_pointer(values, name);
  for (int i = 0; i < D; ++i) {
    for (int k = 0; k < D; ++k) require_component(values[3 * i + k], name, first + 3 * i + k);
  }
  for (int i = 0; i < D; ++i) {
    for (int k = 0; k < i; ++k) {
      if (values[3 * i + k] != values[3 * k + i]) {
        refuse(HS_ERROR_ARGUMENT, "%s[%d] is %g, %s[%d] is %g; the tensor must be symmetric", name,
               first + 3 * k + i, values[3 * k + i], name, first + 3 * i + k, values[3 * i + k]);
      }
    }
  }
  return read_finite_tensor<D>(values, name);
}

template <int D>
void write_tensor(const Tensor<D>& tensor, double out[9]) {
  for (int row = 0; row < D; ++row)
    for (int column = 0; column < D; ++column) out[3 * row + column] = tensor(row, column);
}

/// Refuses a deformation gradient that inverts a shape or flattens it to rounding.
template <int D>
void require_gradient(const Tensor<D>& gradient, const char* name) {
  const auto require_of = [&](bool holds, double value, const char* words, const char* range) {
    if (!holds) refuse(HS_ERROR_ARGUMENT, words, name, value, range);
  };
  const double determinant = gradient.determinant();
  require_of(determinant > 0, determinant, "the determinant of %s is %g; it must be %s", "> 0");
  const double shrinking = gradient.inverse().cwiseAbs().maxCoeff();
  require_of(is_within_limits(shrinking), shrinking,
             "the largest entry of the inverse of %s is %g; it must be %s", "at most 1e75");
  const double condition = condition_of<D>(gradient);
  require_of(condition <= largest_condition, condition,
             "the norm of %s times that of its inverse is %g; it must be %s", "at most 2^40");
}

}  // namespace halfspace::capi
