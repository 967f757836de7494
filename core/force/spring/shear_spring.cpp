#include "force/spring/shear_spring.h"

#include <cmath>
#include <utility>

namespace halfspace {
namespace {

/// A vector, rotated by the angle and about the axis whose half has this tangent.
Vector<3> turned_by(const Vector<3>& half_tangent, const Vector<3>& v) {
  const Vector<3> across = cross_product(half_tangent, v);
  return v + 2 / (1 + half_tangent.squaredNorm()) * (across + cross_product(half_tangent, across));
}

/// A vector, rotated by the smallest rotation between two normals.
Vector<3> tilted(const Vector<3>& before, const Vector<3>& normal, const Vector<3>& v) {
  const double cosine = before.dot(normal);
  // Opposite normals have no unique smallest rotation: what is across them lies in both planes.
  if (!(cosine > -1)) return v;
  const Vector<3> axis = cross_product(before, normal), moved = cross_product(axis, v);
  return v + moved + cross_product(axis, moved) / (1 + cosine);
}

}  // namespace

Shear<3> carried(const ShearSpring<3>& spring, const Vector<3>& normal, const PairMotion<3>& motion,
                 double elapsed) {
  const bool is_there = elapsed == 0 && normal == spring.normal;  // to evaluate it again changes no bit
  if (is_there || spring.force == Shear<3>::Zero()) return spring.force;
  const double about_normal = normal.dot(motion.half_turn(elapsed));
  const Vector<3> force =
      turned_by(about_normal * normal, tilted(spring.normal, normal, spring.force.head<3>()));
  Shear<3> shear;
  shear << force - normal.dot(force) * normal, spring.force[3];
  return shear;
}

/// Between two blocks that roll on each other the point moves with the mean of both.
void move(ShearSpring<3>& spring, Shear<3>& force, const Vector<3>& point, double twist_radius,
          const Vector<3>& normal, const PairMotion<3>& motion, double elapsed) {
  const Vector<3> arm = point - 0.5 * motion.to_b, before = std::exchange(spring.arm, arm);
  if (elapsed == 0 || spring.stiffness == preloaded || force == Shear<3>::Zero()) return;
  const Vector<3> moved = turned_by(motion.half_turn(elapsed), before) -
                          0.25 * elapsed * swept(Angular<3>(motion.spin_b - motion.spin_a), motion.to_b);
  const double square = force.squaredNorm();
  force[3] += normal.dot(cross_product(moved - arm, force.head<3>())) / twist_radius;
  const double square_now = force.squaredNorm();
  if (square_now > 0) force *= std::sqrt(square / square_now);
}

}  // namespace halfspace
