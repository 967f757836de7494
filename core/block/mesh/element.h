#pragma once

#include <Eigen/LU>
#include <array>
#include <cstdint>

#include "block/elasticity.h"
#include "geometry/finite.h"
#include "geometry/numbers.h"
#include "geometry/vector.h"

namespace halfspace {

// A cell of a mesh as a finite element. Its points move by an affine field, given by the mean gradient F of
// the places, and by hourglass modes where it has more nodes than a simplex, with amplitudes
// h = sum_i y_i gamma_i (Belytschko and Bindeman 1993). Both parts store energy independently:
//
//   U = V (1/2 E : C : E) + 1/2 q . K q,    E = 1/2 (F^T F - 1),    q_k = F^T h_k
//
// E and q are invariant to rotations, so that large rotations cause no strain. Forces are the exact
// derivative of U, so that the energy balance closes. For small strains K makes the element that of
// incompatible modes (Taylor, Beresford and Wilson 1976), which bends without locking: see make_element.cpp.
// Linear triangles and tetrahedra have no modes.

/// The hourglass modes of an element.
template <int D, int N>
struct Hourglass {
  static constexpr int modes = N - D - 1;

  bool is_consistent() const { return all_finite(gamma) && all_finite(stiffness); }

  Eigen::Matrix<double, N, modes> gamma;
  Eigen::Matrix<double, D * modes, D * modes> stiffness;  // K
};
struct NoHourglass {
  bool is_consistent() const { return true; }
};
template <>
struct Hourglass<2, 3> : NoHourglass {};
template <>
struct Hourglass<3, 4> : NoHourglass {};

/// Vectors of the given nodes, one per column.
template <int D, int N>
Eigen::Matrix<double, D, N> gathered(const Array<Vector<D>>& of_nodes,
                                     const std::array<std::int32_t, N>& nodes) {
  Eigen::Matrix<double, D, N> all;
  for (int i = 0; i < N; ++i) all.col(i) = of_nodes[std::size_t(nodes[std::size_t(i)])];
  return all;
}

/// A finite element of N nodes. Without implicit padding, so that all saved bytes are defined.
template <int D, int N>
struct Element {
  static constexpr int modes = N - D - 1;
  using Nodes = Eigen::Matrix<double, D, N>;
  using Modes = Eigen::Matrix<double, D, modes>;
  using Amplitudes = Eigen::Matrix<double, D * modes, 1>;

  /// Positions or velocities of its nodes.
  struct Field {
    Tensor<D> gradient;
    Modes amplitude;
  };

  Field field_of(const Nodes& nodes) const {
    if constexpr (modes == 0) {
      return {nodes * gradients.transpose(), {}};
    } else {
      return {nodes * gradients.transpose(), nodes * hourglass.gamma};
    }
  }

  /// Green-Lagrange strain.
  static Tensor<D> strain_of(const Field& place) {
    return 0.5 * (place.gradient.transpose() * place.gradient - Tensor<D>::Identity());
  }
  static Tensor<D> strain_rate_of(const Field& place, const Field& rate) {
    const Tensor<D> half = 0.5 * place.gradient.transpose() * rate.gradient;
    return half + half.transpose();
  }
  /// The strain that causes stress: with the initial strain of the cell.
  Tensor<D> stressing_strain(const Tensor<D>& strain) const { return strain + prestrain; }
  /// Cauchy stress, elastic.
  Tensor<D> stress(const Field& place, const Elasticity& elasticity) const {
    const Tensor<D> inner = elasticity.stress<D>(stressing_strain(strain_of(place)));
    return place.gradient * inner * place.gradient.transpose() / place.gradient.determinant();
  }
  void set_stress(const Field& place, const Tensor<D>& wanted, const Elasticity& elasticity) {
    const Tensor<D> back = place.gradient.inverse();
    const Tensor<D> inner = place.gradient.determinant() * back * wanted * back.transpose();
    prestrain = elasticity.strain<D>(inner) - strain_of(place);
  }
  /// Amplitudes in the rotating frame of the cell.
  static Amplitudes bending_of(const Field& place) {
    if constexpr (modes == 0) return {};
    const Modes bending = place.gradient.transpose() * place.amplitude;
    return Eigen::Map<const Amplitudes>(bending.data());
  }
  static Amplitudes bending_rate_of(const Field& place, const Field& rate) {
    if constexpr (modes == 0) return {};
    const Modes bending =
        rate.gradient.transpose() * place.amplitude + place.gradient.transpose() * rate.amplitude;
    return Eigen::Map<const Amplitudes>(bending.data());
  }

  /// The generalized forces of the modes at these amplitudes.
  Amplitudes drive(const Amplitudes& bending) const {
    if constexpr (modes == 0) {
      return {};
    } else {
      return hourglass.stiffness * bending;
    }
  }

  double strain_energy(const Tensor<D>& strain, const Amplitudes& bending,
                       const Elasticity& elasticity) const {
    const Tensor<D> whole = stressing_strain(strain);
    const double affine = 0.5 * volume * whole.cwiseProduct(elasticity.stress<D>(whole)).sum();
    if constexpr (modes == 0) return affine;
    return affine + 0.5 * bending.dot(drive(bending));
  }

  /// The nodal forces by a second Piola-Kirchhoff stress and the generalized forces of the modes.
  Nodes forces(const Field& place, const Tensor<D>& stress, const Amplitudes& drive) const {
    Tensor<D> by_gradient = volume * place.gradient * stress;
    if constexpr (modes == 0) {
      return -by_gradient * gradients;
    } else {
      const Eigen::Map<const Modes> of_mode(drive.data());
      by_gradient += place.amplitude * of_mode.transpose();
      return -by_gradient * gradients - place.gradient * of_mode * hourglass.gamma.transpose();
    }
  }

  /// The elastic nodal forces, without damping.
  Nodes elastic_forces(const Field& place, const Elasticity& elasticity) const {
    return forces(place, elasticity.stress<D>(stressing_strain(strain_of(place))), drive(bending_of(place)));
  }

  bool is_finite() const {
    return all_finite(gradients) && all_finite(prestrain) && hourglass.is_consistent();
  }
  /// False for data of a damaged snapshot.
  bool is_consistent(std::size_t node_count, std::int32_t material_count) const {
    const auto is_node = [&](std::int32_t i) { return i >= 0 && std::size_t(i) < node_count; };
    return all(node, is_node) && cell >= 0 && material >= 0 && material < material_count &&
           is_positive(volume) && is_finite();
  }

  std::array<std::int32_t, N> node{};  // index in the world's array
  std::int32_t body = 0;
  std::int32_t cell = 0;  // index in the mesh of the body
  std::int32_t material = 0;
  std::array<std::int32_t, D == 2 ? 4 - (N + 1) % 4 : 4 - (N + 3) % 4> padding{};
  double volume = 0;  // of the undeformed cell; in 2D its area
  Tensor<D> prestrain = Tensor<D>::Zero();
  Eigen::Matrix<double, D, N> gradients;  // means over the cell of the gradients of the nodes' interpolation
  [[no_unique_address]] Hourglass<D, N> hourglass;
};

template <int D, int N>
constexpr bool has_no_gap = sizeof(Element<D, N>) ==
                            sizeof(double) * (1 + D * D + D * N + N * (N - D - 1) +
                                              D * D * (N - D - 1) * (N - D - 1)) +
                                sizeof(std::int32_t) *
                                    (N + 3 + sizeof(Element<D, N>::padding) / sizeof(std::int32_t));
static_assert(has_no_gap<2, 3> && has_no_gap<2, 4> && has_no_gap<3, 4> && has_no_gap<3, 6> &&
              has_no_gap<3, 8>);

}  // namespace halfspace
