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

/// Here and not in the header: of the copies that callers would make, the linker takes any, and some are
/// slow.
Angular<3> Inertia<3>::spin(const Angular<3>& momentum, const Rotation<3>& rotation) const {
  const Rotation<3> turned = rotation * axes;
  return turned * Vector<3>((turned.inverse() * momentum).cwiseQuotient(moments));
}

}  // namespace halfspace
