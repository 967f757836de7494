#include "force/spring/shear_spring.h"

#include <utility>

namespace halfspace {
namespace {

/// The smallest rotation between two normals, and then one about the second.
class Carriage {
 public:
  Carriage(const Vector<3>& before, const Vector<3>& normal, const PairMotion<3>& motion, double elapsed)
      : axis_(cross_product(before, normal)),
        cosine_(before.dot(normal)),
        normal_(normal),
        half_tangent_(0.25 * elapsed * normal.dot(motion.spin_a + motion.spin_b)) {}

  Vector<3> operator()(Vector<3> v) const {
    // Opposite normals have no unique smallest rotation: what is across them lies in both planes.
    if (cosine_ > -1) {
      const Vector<3> moved = cross_product(axis_, v);
      v += moved + cross_product(axis_, moved) / (1 + cosine_);
    }
    const Vector<3> across = cross_product(normal_, v);
    return v + 2 * half_tangent_ / (1 + half_tangent_ * half_tangent_) *
                   (across + half_tangent_ * cross_product(normal_, across));
  }

 private:
  Vector<3> axis_;
  double cosine_;
  Vector<3> normal_;
  double half_tangent_;
};

}  // namespace

Shear<3> carried(const ShearSpring<3>& spring, const Vector<3>& normal, const PairMotion<3>& motion,
                 double elapsed) {
  const bool is_there = elapsed == 0 && normal == spring.normal;  // to evaluate it again changes no bit
  if (is_there || spring.force == Shear<3>::Zero()) return spring.force;
  const Vector<3> force = Carriage(spring.normal, normal, motion, elapsed)(spring.force.head<3>());
  Shear<3> shear;
  shear << force - normal.dot(force) * normal, spring.force[3];
  return shear;
}

/// Between two blocks that roll on each other the point moves with the mean of both.
void move(ShearSpring<3>& spring, Shear<3>& force, const Vector<3>& point, double twist_radius,
          const Vector<3>& normal, const PairMotion<3>& motion, double elapsed) {
  const Vector<3> arm = point - 0.5 * motion.to_b, before = std::exchange(spring.arm, arm);
  if (elapsed == 0 || spring.stiffness == preloaded || spring.force == Shear<3>::Zero()) return;
  const Vector<3> moved = Carriage(spring.normal, normal, motion, elapsed)(before) -
                          0.25 * elapsed * swept(Angular<3>(motion.spin_b - motion.spin_a), motion.to_b);
  const double square = spring.force.squaredNorm();
  force[3] += normal.dot(cross_product(moved - arm, force.head<3>())) / twist_radius;
  spring.stiffness *= force.squaredNorm() / square;
  spring.force = force;
}

}  // namespace halfspace
