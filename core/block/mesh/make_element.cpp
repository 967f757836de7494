#include "block/mesh/make_element.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "block/mesh/cell.h"
#include "block/mesh/interpolation.h"

namespace halfspace {
namespace {

/// Hooke's law as a matrix over the components of a displacement gradient, column by column. Only its
/// symmetric part has stress.
template <int D>
CellMatrix stiffness_of_gradient(const Elasticity& elasticity) {
  CellMatrix stiffness(D * D, D * D);
  for (int k = 0; k < D * D; ++k) {
    Tensor<D> gradient = Tensor<D>::Zero();
    gradient(k) = 1;
    const Tensor<D> strain = 0.5 * (gradient + gradient.transpose());
    const Tensor<D> stress = elasticity.stress<D>(strain);
    std::copy_n(stress.data(), D * D, stiffness.col(k).data());
  }
  return stiffness;
}

/// Writes D columns: the gradients of the displacements along each axis by a scalar field with this gradient.
void write_gradients_by(const double* gradient, int dimension, int first, CellMatrix& columns) {
  columns.middleCols(first, dimension).setZero();
  for (int k = 0; k < dimension; ++k) {
    for (int j = 0; j < dimension; ++j) columns(k + dimension * j, first + k) = gradient[j];
  }
}

/// B^T H B.
CellMatrix stiffness_by(const CellMatrix& gradients, const CellMatrix& hooke) {
  return product_of_transposed(gradients, product(hooke, gradients));
}

/// The interpolation of a cell that is not a simplex, at one point.
struct Mapped {
  CellMatrix inverse_transposed;
  CellMatrix gradients;  // of the nodes' weights, in the frame of the mesh
  double determinant;
};

Mapped map_at(const CellMatrix& nodes, const Interpolation& form, const std::array<double, 3>& at) {
  const CellMatrix parent = form.gradients(at);
  const CellMatrix map = product(nodes, CellMatrix(parent.transpose()));
  Mapped mapped;
  mapped.inverse_transposed = inverse_of(map).transpose();
  mapped.gradients = product(mapped.inverse_transposed, parent);
  mapped.determinant = map.determinant();
  return mapped;
}

/// gamma: gives the amplitude of each mode, and is orthogonal to affine fields and to the other modes.
CellMatrix dual_modes(const CellMatrix& nodes, const Interpolation& form) {
  const int n = form.node_count();
  CellMatrix fields(n, n);
  fields.col(0).setOnes();
  fields.middleCols(1, form.dimension()) = nodes.transpose();
  fields.rightCols(form.mode_count()) = form.modes();
  const CellMatrix inverse = inverse_of(fields);
  return inverse.bottomRows(form.mode_count()).transpose();
}

/// K: the stiffness of the modes in the element of incompatible modes, for small strains. Modes are used
/// without their mean gradient, and bubbles with the map of the cell's centre (Taylor, Beresford and Wilson
/// 1976). Neither works against a uniform stress, so modes and affine fields share no energy and the patch
/// test holds exactly.
CellMatrix stiffness_of_modes(const CellMatrix& nodes, const CellMatrix& mean_gradients,
                              const Interpolation& form, const CellMatrix& hooke) {
  const int dimension = form.dimension(), modes = form.mode_count(), bubbles = form.bubble_count();
  const CellMatrix plain = form.modes();
  const CellMatrix mode_fields = plain - product_of_transposed(nodes, product(mean_gradients, plain));
  const Mapped middle = map_at(nodes, form, form.middle());
  const int unknowns = dimension * (modes + bubbles);
  CellMatrix stiffness = CellMatrix::Zero(unknowns, unknowns);
  CellMatrix gradients(dimension * dimension, unknowns);
  for (int i = 0; i < form.node_count(); ++i) {
    const GaussPoint point = form.point(i);
    const Mapped here = map_at(nodes, form, point.at);
    const CellMatrix of_modes = product(here.gradients, mode_fields);
    for (int k = 0; k < modes; ++k)
      write_gradients_by(of_modes.col(k).data(), dimension, dimension * k, gradients);
    for (int k = 0; k < bubbles; ++k) {
      CellMatrix bubble = product(middle.inverse_transposed, form.bubble_gradient(k, point.at));
      bubble *= middle.determinant / here.determinant;
      write_gradients_by(bubble.data(), dimension, dimension * (modes + k), gradients);
    }
    stiffness += point.weight * here.determinant * stiffness_by(gradients, hooke);
  }
  const CellMatrix across = stiffness.bottomLeftCorner(dimension * bubbles, dimension * modes);
  const CellMatrix of_bubbles = stiffness.bottomRightCorner(dimension * bubbles, dimension * bubbles);
  const CellMatrix given_way = product_of_transposed(across, product(inverse_of(of_bubbles), across));
  const CellMatrix condensed = stiffness.topLeftCorner(dimension * modes, dimension * modes) - given_way;
  return 0.5 * (condensed + condensed.transpose());
}

/// The edges of a simplex from its first node.
template <int D>
Tensor<D> edges_of(const CellMatrix& nodes, const int* corners) {
  Tensor<D> edges;
  for (int k = 0; k < D; ++k) {
    for (int axis = 0; axis < D; ++axis)
      edges(axis, k) = nodes(axis, corners[k + 1]) - nodes(axis, corners[0]);
  }
  return edges;
}

template <int D>
double volume_of_simplex(const Tensor<D>& edges) {
  return edges.determinant() / (D == 2 ? 2 : 6);
}

constexpr int first_nodes[] = {0, 1, 2, 3};

/// Volume and mean gradients, which all elements have.
struct Affine {
  double volume = 0;
  CellMatrix gradients;
};

template <int D>
Affine affine_of(const CellMatrix& nodes, CellKind kind) {
  Affine affine;
  affine.gradients = CellMatrix::Zero(D, nodes.cols());
  if (nodes.cols() == D + 1) {
    const Tensor<D> edges = edges_of<D>(nodes, first_nodes), inverse = edges.inverse();
    affine.volume = volume_of_simplex<D>(edges);
    for (int k = 0; k < D; ++k) {
      for (int axis = 0; axis < D; ++axis) {
        affine.gradients(axis, k + 1) = inverse(k, axis);
        affine.gradients(axis, 0) -= inverse(k, axis);
      }
    }
    return affine;
  }
  const Interpolation form(kind);
  for (int i = 0; i < form.node_count(); ++i) {
    const GaussPoint point = form.point(i);
    const Mapped here = map_at(nodes, form, point.at);
    affine.volume += point.weight * here.determinant;
    affine.gradients += point.weight * here.determinant * here.gradients;
  }
  affine.gradients /= affine.volume;
  return affine;
}

template <int D, int N>
constexpr CellKind kind_of() {
  if constexpr (D == 2) return N == 3 ? CellKind::triangle : CellKind::quad;
  return N == 4 ? CellKind::tetrahedron : N == 6 ? CellKind::prism : CellKind::hexahedron;
}

template <int D>
CellMatrix nodal_volumes(const CellMatrix& nodes, CellKind kind) {
  CellMatrix volumes = CellMatrix::Zero(nodes.cols(), 1);
  if (nodes.cols() == D + 1) {
    volumes.setConstant(volume_of_simplex<D>(edges_of<D>(nodes, first_nodes)) / (D + 1));
    return volumes;
  }
  const Interpolation form(kind);
  for (int i = 0; i < form.node_count(); ++i) {
    const GaussPoint point = form.point(i);
    const double share = point.weight * map_at(nodes, form, point.at).determinant;
    for (int node = 0; node < form.node_count(); ++node)
      volumes(node, 0) += share * form.weight(node, point.at);
  }
  return volumes;
}

/// The largest eigenvalue of the stiffness and the lumped masses of one element.
double largest_eigenvalue(CellMatrix stiffness, const double* masses, int dimension) {
  const int unknowns = int(stiffness.cols());
  for (int i = 0; i < unknowns; ++i) {
    for (int k = 0; k < unknowns; ++k)
      stiffness(i, k) /= std::sqrt(masses[i / dimension]) * std::sqrt(masses[k / dimension]);
  }
  if (!all_finite(stiffness)) return HUGE_VAL;
  return Eigen::SelfAdjointEigenSolver<CellMatrix>(stiffness, Eigen::EigenvaluesOnly)
      .eigenvalues()[unknowns - 1];
}

/// The change of all modes' amplitudes per displacement of each node along each axis.
CellMatrix amplitudes_by(const CellMatrix& gamma, int dimension) {
  const int nodes = int(gamma.rows()), modes = int(gamma.cols());
  CellMatrix amplitudes = CellMatrix::Zero(dimension * modes, dimension * nodes);
  for (int i = 0; i < nodes; ++i) {
    for (int k = 0; k < modes; ++k) {
      for (int axis = 0; axis < dimension; ++axis)
        amplitudes(dimension * k + axis, dimension * i + axis) = gamma(i, k);
    }
  }
  return amplitudes;
}

/// Stiffness of a uniform strain over a volume, for displacements of each node along each axis.
CellMatrix affine_stiffness(const CellMatrix& node_gradients, double volume, const CellMatrix& hooke) {
  const int dimension = int(node_gradients.rows()), nodes = int(node_gradients.cols());
  CellMatrix gradients(dimension * dimension, dimension * nodes);
  for (int i = 0; i < nodes; ++i)
    write_gradients_by(node_gradients.col(i).data(), dimension, dimension * i, gradients);
  return volume * stiffness_by(gradients, hooke);
}

template <int D>
bool keeps_upright(const CellMatrix& nodes, CellKind kind) {
  const CellForm& cell = form_of(kind);
  for (int s = 0; s < cell.simplex_count; ++s) {
    if (!(edges_of<D>(nodes, cell.simplices[s]).determinant() > 0)) return false;
  }
  if (nodes.cols() == D + 1) return true;
  const Interpolation form(kind);
  for (int node = 0; node < form.node_count(); ++node) {
    const CellMatrix map = product(nodes, CellMatrix(form.gradients(form.place(node)).transpose()));
    if (!(map.determinant() > 0)) return false;
  }
  return true;
}

}  // namespace

template <int D, int N>
Element<D, N> make_element(const Eigen::Matrix<double, D, N>& nodes, const Elasticity& elasticity) {
  const CellMatrix places = nodes;
  const Affine affine = affine_of<D>(places, kind_of<D, N>());
  Element<D, N> element;
  element.volume = affine.volume;
  element.gradients = affine.gradients;
  if constexpr (N > D + 1) {
    const Interpolation form(kind_of<D, N>());
    element.hourglass.gamma = dual_modes(places, form);
    element.hourglass.stiffness =
        stiffness_of_modes(places, affine.gradients, form, stiffness_of_gradient<D>(elasticity));
  }
  return element;
}

template <int D, int N>
Eigen::Matrix<double, N, 1> volumes_of_nodes(const Eigen::Matrix<double, D, N>& nodes) {
  return nodal_volumes<D>(CellMatrix(nodes), kind_of<D, N>());
}

template <int D, int N>
double squared_frequency(const Element<D, N>& element, const Elasticity& elasticity,
                         const Eigen::Matrix<double, N, 1>& masses) {
  CellMatrix stiffness =
      affine_stiffness(CellMatrix(element.gradients), element.volume, stiffness_of_gradient<D>(elasticity));
  if constexpr (N > D + 1) {
    stiffness += stiffness_by(amplitudes_by(CellMatrix(element.hourglass.gamma), D),
                              CellMatrix(element.hourglass.stiffness));
  }
  return largest_eigenvalue(stiffness, masses.data(), D);
}

template <int D, int N>
bool is_upright(const Eigen::Matrix<double, D, N>& nodes) {
  return keeps_upright<D>(CellMatrix(nodes), kind_of<D, N>());
}

#define HALFSPACE_ELEMENT(D, N)                                                               \
  template Element<D, N> make_element(const Eigen::Matrix<double, D, N>&, const Elasticity&); \
  template Eigen::Matrix<double, N, 1> volumes_of_nodes(const Eigen::Matrix<double, D, N>&);  \
  template double squared_frequency(const Element<D, N>&, const Elasticity&,                  \
                                    const Eigen::Matrix<double, N, 1>&);                      \
  template bool is_upright(const Eigen::Matrix<double, D, N>&);

HALFSPACE_ELEMENT(2, 3)
HALFSPACE_ELEMENT(2, 4)
HALFSPACE_ELEMENT(3, 4)
HALFSPACE_ELEMENT(3, 6)
HALFSPACE_ELEMENT(3, 8)
#undef HALFSPACE_ELEMENT

}  // namespace halfspace
