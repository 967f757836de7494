#include "world/hard_contact/contact_constraint.h"

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"

namespace halfspace {
namespace {

/// The impulse that stops a contact if all others keep theirs, projected onto the friction cone: the normal
/// part first, then the shear part with the velocity that remains. Both depend on each other where a block
/// turns.
template <int D>
Vector<D> projected_impulse(const ContactConstraint<D>& at, const Vector<D>& velocity) {
  const double before = at.impulse.dot(at.normal), opening = velocity.dot(at.normal);
  const double normal = std::max(before - opening / at.normal_inverse_mass, -at.tension_limit);
  const double limit = at.cohesion_limit + at.tan_friction * std::max(normal, 0.0);
  if (limit == 0) return normal * at.normal;
  const Vector<D> left = velocity + (normal - before) * at.normal_velocity_response;
  const Vector<D> across = left - left.dot(at.normal) * at.normal;
  Vector<D> shear = at.impulse - before * at.normal - across / at.shear_inverse_mass;
  const double length = shear.norm();
  if (length > limit) shear *= limit / length;
  return normal * at.normal + shear;
}

}  // namespace

template <int D>
bool ContactConstraint<D>::fails(const Vector<D>& left) const {
  const Vector<D>&n = this->normal, &p = this->impulse;
  const double along = p.dot(n), across = (p - along * n).norm();
  const double opening = left.dot(n), slip = (left - opening * n).norm();
  const double limit = cohesion_limit + tan_friction * std::max(along, 0.0);
  const double noise = equal_within * normal_inverse_mass * p.norm();
  return (along <= -(1 - equal_within) * tension_limit && opening > noise) ||
         (across >= (1 - equal_within) * limit && slip > noise);
}

template <int D>
double PointRows<D>::begin() {
  double fastest = 0;
  for (ContactConstraint<D>& at : constraints_) {
    changes_.add(at.of_a, at.impulse);
    changes_.add(at.of_b, -at.impulse);
    fastest = std::max(fastest, at.impulse.norm() * at.normal_inverse_mass);
    at.previous_impulse = at.impulse;
    at.direction = Vector<D>::Zero();
  }
  return fastest;
}

template <int D>
double PointRows<D>::sweep(bool is_backwards) {
  double changed = 0;
  const auto visit = [&](ContactConstraint<D>& at) {
    const Vector<D> velocity = at.velocity + changes_.at(at.of_a) - changes_.at(at.of_b);
    const Vector<D> impulse = projected_impulse(at, velocity);
    const Vector<D> change = impulse - at.impulse;
    if (change.isZero(0)) return;
    at.impulse = impulse;
    changes_.add(at.of_a, change);
    changes_.add(at.of_b, -change);
    changed = std::max(changed, change.norm() * at.normal_inverse_mass);
  };
  if (is_backwards) {
    std::for_each(constraints_.rbegin(), constraints_.rend(), visit);
  } else {
    std::for_each(constraints_.begin(), constraints_.end(), visit);
  }
  return changed;
}

template <int D>
double PointRows<D>::squared_change() const {
  double length = 0;
  for (const ContactConstraint<D>& at : constraints_)
    length += (at.impulse - at.previous_impulse).squaredNorm() * at.normal_inverse_mass;
  return length;
}

template <int D>
void PointRows<D>::accelerate(const ConjugateDirection& direction) {
  for (ContactConstraint<D>& at : constraints_) {
    const Vector<D> more = direction.advance(at.impulse, at.previous_impulse, at.direction);
    changes_.add(at.of_a, more);
    changes_.add(at.of_b, -more);
  }
}

template struct ContactConstraint<2>;
template struct ContactConstraint<3>;
template class PointRows<2>;
template class PointRows<3>;

}  // namespace halfspace
