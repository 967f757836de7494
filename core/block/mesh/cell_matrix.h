#pragma once

#include <Eigen/Core>

namespace halfspace {

/// A matrix over what one cell has: nodes, modes, or unknowns, 24 at most. Its size is told at run time: code
/// for each size by itself takes minutes to compile.
using CellMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 24, 24>;

// Sums of matrices of this size are added up in ascending order. Eigen's are in the order of the machine: its
// caches and registers decide, and with them the last bits of an element.

CellMatrix product(const CellMatrix& a, const CellMatrix& b);

/// a^T b.
CellMatrix product_of_transposed(const CellMatrix& a, const CellMatrix& b);

/// Elimination (Gauss and Jordan), each pivot the largest of its column.
CellMatrix inverse_of(CellMatrix matrix);

}  // namespace halfspace
