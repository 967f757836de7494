#pragma once

#include "block/mesh/element.h"

namespace halfspace {

/// A cell's places, as they were given, made an element: all but what names its nodes, body and cell.
template <int D, int N>
Element<D, N> make_element(const Eigen::Matrix<double, D, N>& nodes, const Elasticity& elasticity);

/// The integral of each node's interpolation over the cell: times the density, the mass that the node bears.
template <int D, int N>
Eigen::Matrix<double, N, 1> volumes_of_nodes(const Eigen::Matrix<double, D, N>& nodes);

/// The square of the highest frequency at which the element would vibrate alone, with these masses of its
/// nodes: no mesh of such elements vibrates faster (Irons and Treharne 1971). Infinite beyond all numbers.
template <int D, int N>
double squared_frequency(const Element<D, N>& element, const Elasticity& elasticity,
                         const Eigen::Matrix<double, N, 1>& masses);

/// Is the cell nowhere inside out, nor flat? Judged at its corners: the determinant of the interpolation is
/// least there.
template <int D, int N>
bool is_upright(const Eigen::Matrix<double, D, N>& nodes);

}  // namespace halfspace
