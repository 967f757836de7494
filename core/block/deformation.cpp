#include "block/deformation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "block/inertia.h"

namespace halfspace {
namespace {

/// A force f at X accelerates the gradient by f X^T M^-1, and X by that times X: maximum at a vertex.
template <int D>
double strain_mobility_of(const Outline<D>& own, const Tensor<D>& inverse_mass_matrix) {
  double most = 0;
  for (int i = 0; i < own.vertex_count(); ++i)
    most = std::max(most, own.vertex(i).dot(inverse_mass_matrix * own.vertex(i)));
  return most;
}

/// The smallest eigenvalue of a symmetric tensor; in 2D the determinant divided by the largest eigenvalue.
double min_eigenvalue(const Tensor<2>& t) {
  const double mean = 0.5 * (t(0, 0) + t(1, 1));
  const double difference = 0.5 * (t(0, 0) - t(1, 1)) / mean, across = t(0, 1) / mean;
  const double largest = mean * (1 + std::sqrt(difference * difference + across * across));
  return t(0, 0) * (t(1, 1) / largest) - t(0, 1) * (t(0, 1) / largest);
}
double min_eigenvalue(const Tensor<3>& t) {
  return Eigen::SelfAdjointEigenSolver<Tensor<3>>(t, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

/// Scaled by a power of two, which is exact: the determinant is a square or cube of the entries and could
/// overflow or underflow.
template <int D>
Tensor<D> inverse_of(const Tensor<D>& t) {
  int exponent = 0;
  std::frexp(t.cwiseAbs().maxCoeff(), &exponent);
  const double scale = std::ldexp(1.0, -exponent);
  return scale * (scale * t).inverse();
}

}  // namespace

template <int D>
Deformation<D> undeformed(const Shape<D>& shape, double density, std::int32_t slot) {
  Deformation<D> deformation;
  deformation.slot = slot;
  deformation.volume = mass_of(shape, 1);
  deformation.mass_matrix = density * second_moment_of(shape);
  deformation.inverse_mass_matrix = inverse_of<D>(deformation.mass_matrix);
  deformation.min_moment = min_eigenvalue(deformation.mass_matrix);
  deformation.strain_mobility = strain_mobility_of(shape.outline(), deformation.inverse_mass_matrix);
  return deformation;
}

template Deformation<2> undeformed(const Shape<2>&, double, std::int32_t);
template Deformation<3> undeformed(const Shape<3>&, double, std::int32_t);

}  // namespace halfspace
