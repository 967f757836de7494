#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "force/potential/potential_force.h"
#include "geometry/convex_reach.h"
#include "geometry/mean_distance.h"

namespace halfspace {

/// The potential force as a resultant along a line (Zheng et al. 2020, section 3.2.4).
template <int D>
struct LineOfAction {
  Vector<D> direction;                     // unit, of the force on b
  double force = 0;                        // along it
  Vector<D> loading_point;                 // on the line, nearest to the centroid of the overlap;
                                           // relative to the centroid of a
  Angular<D> couple = Angular<D>::Zero();  // on b, with the force at that point
  double energy = 0;                       // stored
  double stiffness = 0;                    // of the force, along the line
  double twist_radius = 0;  // in 3D: mean distance of the overlap from the parallel line through its centroid
  Vector<D> middle = Vector<D>::Zero();  // centroid of the overlap
  Tensor<D> spread = Tensor<D>::Zero();  // of the overlap: mean of r r^T about its centroid

  /// Distance of the line from the centroid, divided by the certain extent of the overlap there; at most 1.
  double unevenness() const {
    const Vector<D> way = loading_point - middle, across = way - direction.dot(way) * direction;
    if (across.isZero(0)) return 0;
    // Only the spread across the line counts. The value along it is arbitrary, but must not be 0.
    const Tensor<D> shadow = Tensor<D>::Identity() - direction * direction.transpose();
    const Tensor<D> seen = shadow * spread * shadow + spread.trace() * (direction * direction.transpose());
    const double square = across.dot(seen.inverse() * across);
    return square >= 0 ? std::min(std::sqrt(square) / certain_reach_of_body, 1.0) : 1;
  }
};

/// The virial of the couple of forces along a normal, at arms across it: these strain as they rotate. Forces
/// across the normal that twist about it cause no strain.
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

/// The vector from a point to the line of action of a force with this moment about the point. A moment about
/// the force itself has no such line.
inline Vector<2> way_to_line(const Vector<2>& force, const Angular<2>& moment) {
  return -moment[0] / force.squaredNorm() * perpendicular(force);
}
inline Vector<3> way_to_line(const Vector<3>& force, const Vector<3>& moment) {
  return cross_product(force, moment) / force.squaredNorm();
}

/// Mean distance of a body with this spread from a line through its centroid.
inline double mean_distance_from_line(const Tensor<2>&, const Vector<2>&) { return 0; }
inline double mean_distance_from_line(const Tensor<3>& spread, const Vector<3>& direction) {
  const Vector<3> column = spread * direction;
  const double along = direction.dot(column), across = spread.trace() - along;
  const double squares = spread.squaredNorm() - 2 * column.squaredNorm() + along * along;
  return mean_distance(across, 0.5 * (across * across - squares));
}

/// `stiffness` is k_n / H. A zero force has the direction between the centroids, and the point halfway. Where
/// the forces nearly cancel, the line is far from the blocks: then the force acts at the centroid, with a
/// couple.
template <int D>
LineOfAction<D> line_of_action(const PotentialForce<D>& potential, double stiffness, const Vector<D>& to_b) {
  LineOfAction<D> line{to_b.normalized(), 0, 0.5 * to_b};
  line.middle = line.loading_point;
  if (!(potential.energy > 0)) return line;
  line.loading_point = line.middle = potential.centroid;
  line.energy = stiffness * potential.energy;
  // Length or area over which the blocks touch: exact for parallel faces.
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
  line.twist_radius = mean_distance_from_line(potential.spread, line.direction);
  return line;
}

/// The virials without those of the force at the loading point and of the couple: they strain affine blocks
/// but do not rotate them.
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
