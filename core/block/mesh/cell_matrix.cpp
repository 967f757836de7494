#include "block/mesh/cell_matrix.h"

#include <cmath>

namespace halfspace {

CellMatrix product(const CellMatrix& a, const CellMatrix& b) {
  CellMatrix sums = CellMatrix::Zero(a.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    for (Eigen::Index k = 0; k < a.cols(); ++k) {
      for (Eigen::Index i = 0; i < a.rows(); ++i) sums(i, j) += a(i, k) * b(k, j);
    }
  }
  return sums;
}

CellMatrix product_of_transposed(const CellMatrix& a, const CellMatrix& b) {
  return product(CellMatrix(a.transpose()), b);
}

CellMatrix inverse_of(CellMatrix matrix) {
  const Eigen::Index size = matrix.rows();
  CellMatrix inverse = CellMatrix::Identity(size, size);
  for (Eigen::Index column = 0; column < size; ++column) {
    Eigen::Index pivot = column;
    for (Eigen::Index i = column + 1; i < size; ++i) {
      if (std::abs(matrix(i, column)) > std::abs(matrix(pivot, column))) pivot = i;
    }
    matrix.row(pivot).swap(matrix.row(column));
    inverse.row(pivot).swap(inverse.row(column));
    const double divisor = matrix(column, column);
    matrix.row(column) /= divisor;
    inverse.row(column) /= divisor;
    for (Eigen::Index i = 0; i < size; ++i) {
      const double factor = matrix(i, column);
      if (i == column || factor == 0) continue;
      matrix.row(i) -= factor * matrix.row(column);
      inverse.row(i) -= factor * inverse.row(column);
    }
  }
  return inverse;
}

}  // namespace halfspace
