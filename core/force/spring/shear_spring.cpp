#include "force/spring/shear_spring.h"

#include "geometry/rotation.h"

namespace halfspace {

Shear<3> carried(const ShearSpring<3>& spring, const Vector<3>& normal, const PairMotion<3>& motion,
                 double elapsed) {
  const bool is_there = elapsed == 0 && normal == spring.normal;  // to evaluate it again changes no bit
  if (is_there || spring.force == Shear<3>::Zero()) return spring.force;
  Vector<3> force = spring.force.head<3>();
  const Vector<3> axis = cross_product(spring.normal, normal);
  const double cosine = spring.normal.dot(normal);
  // Opposite normals have no unique smallest rotation: the force lies in both planes.
  if (cosine > -1) {
    const Vector<3> moved = cross_product(axis, force);
    force += moved + cross_product(axis, moved) / (1 + cosine);
  }
  const double spun = 0.5 * elapsed * normal.dot(motion.spin_a + motion.spin_b);
  if (spun != 0) {
    const auto [c, s] = cosine_and_sine_of(spun);
    force = c * force + s * cross_product(normal, force);
  }
  Shear<3> shear;
  shear << force - normal.dot(force) * normal, spring.force[3];
  return shear;
}

}  // namespace halfspace
