#pragma once

#include "block/mesh/element.h"

namespace halfspace {

/// Makes an element from its undeformed nodes, without the indices of nodes, body and cell.
template <int D, int N>
Element<D, N> make_element(const Eigen::Matrix<double, D, N>& nodes, const Elasticity& elasticity);

/// The integral of each node's interpolation over the cell: times the density, its lumped mass.
template <int D, int N>
Eigen::Matrix<double, N, 1> volumes_of_nodes(const Eigen::Matrix<double, D, N>& nodes);

/// The squared highest natural frequency of the element alone, with these nodal masses: an upper bound for
/// any mesh of such elements (Irons and Treharne 1971). Infinite on overflow.
template <int D, int N>
double squared_frequency(const Element<D, N>& element, const Elasticity& elasticity,
                         const Eigen::Matrix<double, N, 1>& masses);

/// Is the cell neither inverted nor flat? Tested at its corners, where the determinant of the map is
/// smallest.
template <int D, int N>
bool is_upright(const Eigen::Matrix<double, D, N>& nodes);

}  // namespace halfspace
