#pragma once

#include <array>

#include "block/mesh/cell.h"
#include "block/mesh/cell_matrix.h"
#include "geometry/vector.h"

namespace halfspace {

/// An integration point in the parent cell, with its weight.
struct GaussPoint {
  std::array<double, 3> at{};
  double weight = 0;
};

/// The interpolation between the nodes of a cell that is not a simplex, over the parent cell: [-1, 1]^D; for
/// the prism the triangle (0, 0), (1, 0), (0, 1), times [-1, 1].
class Interpolation {
 public:
  explicit Interpolation(CellKind kind) : is_prism_(kind == CellKind::prism), form_(form_of(kind)) {}

  int dimension() const { return form_.dimension; }
  int node_count() const { return form_.nodes; }
  /// Fields besides the affine ones.
  int mode_count() const { return form_.nodes - form_.dimension - 1; }
  /// Quadratic fields that vanish at the nodes: incompatible modes for bending.
  int bubble_count() const { return is_prism_ ? 1 : form_.dimension; }

  /// As many points as nodes, by Gauss's rule.
  GaussPoint point(int i) const;
  /// The weight of a node at a point of the parent cell.
  double weight(int node, const std::array<double, 3>& at) const;
  /// Gradients of all nodes' weights, one per column.
  CellMatrix gradients(const std::array<double, 3>& at) const;
  /// The values of the modes at the nodes, one mode per column.
  CellMatrix modes() const;
  /// The gradient of a bubble, as a column.
  CellMatrix bubble_gradient(int bubble, const std::array<double, 3>& at) const;
  /// A node's place in the parent cell, and the cell's centre.
  std::array<double, 3> place(int node) const;
  std::array<double, 3> middle() const;

 private:
  double slope(int node, int axis, const std::array<double, 3>& at) const;

  bool is_prism_;
  const CellForm& form_;
};

}  // namespace halfspace
