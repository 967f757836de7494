#pragma once

#include <Eigen/Core>

namespace halfspace {

/// A matrix over the nodes, modes or unknowns of one cell, 24 at most. The size is set at run time: templates
/// for each size take minutes to compile.
using CellMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 24, 24>;

// Products of these matrices are summed in ascending order. Eigen's order depends on the machine's caches and
// registers, and with it the last bits of an element.

CellMatrix product(const CellMatrix& a, const CellMatrix& b);

/// a^T b.
CellMatrix product_of_transposed(const CellMatrix& a, const CellMatrix& b);

/// Gauss-Jordan elimination with partial pivoting.
CellMatrix inverse_of(CellMatrix matrix);

}  // namespace halfspace
