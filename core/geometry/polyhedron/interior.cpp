#include "geometry/polyhedron/interior.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"

namespace halfspace {
namespace {

using Vector4 = Eigen::Vector4d;

/// The largest sphere between planes n.p = d: maximizes the radius r under n.x + r <= d, with the centre x.
/// The dual minimizes the offset of a convex combination of the planes whose normals cancel. The simplex
/// method solves it with a basis of four planes, those that the sphere touches; a plane that cuts the sphere
/// replaces one of them.
class LargestSphere {
 public:
  LargestSphere(std::span<const Halfspace<3>> halfspaces, Memory* memory)
      : planes_(halfspaces.begin(), halfspaces.end(), memory) {
    double largest = 0;
    for (const Halfspace<3>& h : halfspaces) largest = std::max(largest, std::abs(h.offset));
    const double far_away = 1e6 * (largest > 0 ? largest : 1);
    // Starts from a regular tetrahedron around everything: with equal weights its normals cancel.
    const double c = 1 / std::sqrt(3.0);
    for (const Vector<3>& normal :
         {Vector<3>(c, c, c), Vector<3>(c, -c, -c), Vector<3>(-c, c, -c), Vector<3>(-c, -c, c)}) {
      planes_.push_back({normal, far_away});
    }
    for (std::size_t i = 0; i < 4; ++i) touched_[i] = halfspaces.size() + i;
  }

  Interior find() {
    // Rounding could cause cycling; convergence takes far fewer iterations than this limit.
    for (std::size_t round = 0; round < 10 * planes_.size(); ++round) {
      fit_sphere();
      const std::size_t deepest = farthest_plane();
      if (deepest == planes_.size()) break;
      exchange(deepest);
    }
    return {sphere_.head<3>(), min_distance()};
  }

 private:
  Vector4 column(std::size_t plane) const {
    const Vector<3>& n = planes_[plane].normal;
    return {n.x(), n.y(), n.z(), 1};
  }

  void fit_sphere() {
    Vector4 offsets;
    for (int i = 0; i < 4; ++i) {
      basis_.col(i) = column(touched_[i]);
      offsets[i] = planes_[touched_[i]].offset;
    }
    sphere_ = basis_.transpose().fullPivLu().solve(offsets);
  }

  /// The distance by which the sphere exceeds a plane.
  double violation(std::size_t plane) const { return column(plane).dot(sphere_) - planes_[plane].offset; }

  /// Returns the number of planes when the sphere is behind all of them to rounding.
  std::size_t farthest_plane() const {
    const double rounding = place_rounding * sphere_.cwiseAbs().maxCoeff();
    std::size_t worst = planes_.size();
    double most = rounding;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      if (violation(i) <= most) continue;
      most = violation(i);
      worst = i;
    }
    return worst;
  }

  /// As the weight of the new plane grows, the plane whose weight vanishes first leaves the basis.
  void exchange(std::size_t entering) {
    const Eigen::FullPivLU<Eigen::Matrix4d> lu(basis_);
    const Vector4 weights = lu.solve(Vector4(0, 0, 0, 1));
    const Vector4 rates = lu.solve(column(entering));
    int leaving = -1;
    double least = HUGE_VAL;
    for (int i = 0; i < 4; ++i) {
      if (rates[i] <= singular_pivot) continue;
      const double ratio = std::max(weights[i], 0.0) / rates[i];
      if (ratio >= least) continue;
      least = ratio;
      leaving = i;
    }
    if (leaving >= 0) touched_[leaving] = entering;
  }

  double min_distance() const {
    double least = HUGE_VAL;
    for (const Halfspace<3>& plane : planes_)
      least = std::min(least, plane.offset - plane.normal.dot(sphere_.head<3>()));
    return least;
  }

  Array<Halfspace<3>> planes_;  // the caller's, then the tetrahedron's
  std::size_t touched_[4];
  Eigen::Matrix4d basis_ = Eigen::Matrix4d::Zero();  // columns of the touched planes
  Vector4 sphere_ = Vector4::Zero();                 // centre, radius
};

}  // namespace

Interior farthest_inside(std::span<const Halfspace<3>> halfspaces, Memory* memory) {
  return LargestSphere(halfspaces, memory).find();
}

}  // namespace halfspace
