#include "block/inertia.h"

#include <Eigen/Eigenvalues>

namespace halfspace {

Inertia<3> Inertia<3>::of(const Shape<3>& shape, double density) {
  return of(InertiaTensor<3>(density * shape.inertia()));
}

Inertia<3> Inertia<3>::of(const InertiaTensor<3>& tensor) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(tensor);
  const Eigen::Matrix3d& axes = principal.eigenvectors();
  const Vector<3> x = axes.col(0), y = axes.col(1);
  return {principal.eigenvalues(), Rotation<3>::from_axes(x, y, cross_product(x, y)).straightened()};
}

}  // namespace halfspace
