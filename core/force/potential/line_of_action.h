#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "force/potential/potential_force.h"
#include "geometry/convex_reach.h"

namespace halfspace {

/// The potential force gathered into one that acts along a line (Zheng et al. 2020, section 3.3).
template <int D>
struct LineOfAction {
  Vector<D> direction;                     // unit, of the force on b
  double force = 0;                        // along it
  Vector<D> loading_point;                 // on the line, nearest to the centroid of what the blocks share;
                                           // relative to the centroid of a
  Angular<D> couple = Angular<D>::Zero();  // on b, besides the force at that point
  double energy = 0;                       // stored
  double stiffness = 0;                    // with which the force grows there with the depth
  double twist_radius = 0;  // in space: radius of gyration of what the blocks share, about the line
  Vector<D> middle = Vector<D>::Zero();  // centroid of what the blocks share
  Tensor<D> spread = Tensor<D>::Zero();  // of what they share: mean of the way from there times itself^T

  /// How far from the middle the line is, as a share of what is certain to belong to what the blocks share.
  double unevenness() const {
    const Vector<D> way = loading_point - middle, across = way - direction.dot(way) * direction;
    if (across.isZero(0)) return 0;
    // Only the part of the spread across the line counts; any value serves along it, as nothing is seen
    // there.
    const Tensor<D> shadow = Tensor<D>::Identity() - direction * direction.transpose();
    const Tensor<D> seen = shadow * spread * shadow + spread.trace() * (direction * direction.transpose());
    const double square = across.dot(seen.inverse() * across);
    return square >= 0 ? std::min(std::sqrt(square) / certain_reach(D), 1.0) : 1;
  }
};

/// The virial of the couple that forces along a normal make, at arms across it: these strain what they turn.
/// Forces across the normal that twist about it strain nothing.
inline Tensor<2> virial_of_couple(const Angular<2>& couple, const Vector<2>& normal) {
  return -couple[0] * normal * perpendicular(normal).transpose();
}
inline Tensor<3> virial_of_couple(const Angular<3>& couple, const Vector<3>& normal) {
  const Vector<3> twist = normal.dot(couple) * normal, bend = couple - twist;
  return normal * cross_product(normal, bend).transpose() + 0.5 * cross_tensor(twist);
}

/// The virial of a contact's force and its couple: force times arm^T.
template <int D>
Tensor<D> virial_of(const Vector<D>& force, const Vector<D>& arm, const Angular<D>& couple,
                    const Vector<D>& normal) {
  return force * arm.transpose() + virial_of_couple(couple, normal);
}

/// The way from a point to the line on which a force has this moment about the point. What of the moment is
/// about the force itself no line has.
inline Vector<2> way_to_line(const Vector<2>& force, const Angular<2>& moment) {
  return -moment[0] / force.squaredNorm() * perpendicular(force);
}
inline Vector<3> way_to_line(const Vector<3>& force, const Vector<3>& moment) {
  return cross_product(force, moment) / force.squaredNorm();
}

/// About a line through a point at `arm` from the centroid of a body with this spread.
inline double radius_of_gyration(const Tensor<2>&, const Vector<2>&, const Vector<2>&) { return 0; }
inline double radius_of_gyration(const Tensor<3>& spread, const Vector<3>& direction, const Vector<3>& arm) {
  const double square =
      spread.trace() - direction.dot(spread * direction) + cross_product(direction, arm).squaredNorm();
  return std::sqrt(std::max(0.0, square));
}

/// `stiffness` is k_n / H. No force at all is directed from one centroid to the other, halfway. Where the
/// forces all but cancel the line runs far from the blocks: then the force acts at the centroid, with a
/// couple.
template <int D>
LineOfAction<D> line_of_action(const PotentialForce<D>& potential, double stiffness, const Vector<D>& to_b) {
  LineOfAction<D> line{to_b.normalized(), 0, 0.5 * to_b};
  line.middle = line.loading_point;
  if (!(potential.energy > 0)) return line;
  line.loading_point = line.middle = potential.centroid;
  line.energy = stiffness * potential.energy;
  // Length or area over which the blocks meet: exact for faces that do so squarely.
  const double base = potential.content * (potential.content / potential.energy);
  line.stiffness = 2 * stiffness * base;
  const Vector<D> force = stiffness * potential.force;
  line.force = force.norm();
  line.couple = -stiffness * moment(potential.virial_a) - moment(potential.centroid, force);
  if (!(line.force > 0)) return line;
  line.direction = force / line.force;
  const Vector<D> way = way_to_line(force, line.couple);
  const double distance = way.norm();
  if ((D == 2 ? 1 : distance) * distance * distance <= potential.content) {
    line.loading_point += way;
    line.couple -= moment(way, force);
  }
  line.spread = potential.spread;
  line.twist_radius =
      radius_of_gyration(potential.spread, line.direction, line.loading_point - potential.centroid);
  return line;
}

/// The virials beside those of the force at the loading point and of the couple: they turn nothing and strain
/// affine blocks.
template <int D>
struct Stretch {
  Tensor<D> of_a = Tensor<D>::Zero();
  Tensor<D> of_b = Tensor<D>::Zero();
};

template <int D>
Stretch<D> stretch_besides(const LineOfAction<D>& line, const PotentialForce<D>& potential, double stiffness,
                           const Vector<D>& to_b) {
  const Vector<D> force = line.force * line.direction, arm_b = line.loading_point - to_b;
  return {
      stiffness * potential.virial_a + virial_of<D>(force, line.loading_point, line.couple, line.direction),
      stiffness * potential.virial_b - virial_of<D>(force, arm_b, line.couple, line.direction)};
}

}  // namespace halfspace
