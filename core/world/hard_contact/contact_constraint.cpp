#include "world/hard_contact/contact_constraint.h"

#include <cmath>

namespace halfspace {
namespace {

/// The solver has converged when changes are below this fraction of the largest velocity.
constexpr double smallest_change = 1e-8;

constexpr int max_iterations = 1000;

/// Vertices of both blocks at faces of the other one are more constraints than degrees of freedom. Where they
/// contradict each other by rounding or rotation, the changes never vanish: the solver stops when they have
/// not fallen by a thousandth in this number of iterations.
constexpr int max_stalled_iterations = 48;

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

/// One sweep over all contacts. Returns the largest change, as a velocity.
template <int D>
double sweep_contacts(std::span<ContactConstraint<D>> constraints, bool is_backwards,
                      VelocityChange<D>& changes) {
  double changed = 0;
  const auto visit = [&](ContactConstraint<D>& at) {
    const Vector<D> velocity = at.velocity + changes.at(at.of_a) - changes.at(at.of_b);
    const Vector<D> impulse = projected_impulse(at, velocity);
    const Vector<D> change = impulse - at.impulse;
    if (change.isZero(0)) return;
    at.impulse = impulse;
    changes.add(at.of_a, change);
    changes.add(at.of_b, -change);
    changed = std::max(changed, change.norm() * at.normal_inverse_mass);
  };
  if (is_backwards) {
    for (auto at = constraints.rbegin(); at != constraints.rend(); ++at) visit(*at);
  } else {
    for (auto at = constraints.begin(); at != constraints.end(); ++at) visit(*at);
  }
  return changed;
}

/// Accelerates the sweeps: forwards and backwards is one step of a symmetric iteration, to which conjugate
/// gradients apply (Fletcher and Reeves; with bounds Silcowitz-Hansen, Niebe and Erleben 2010). A stack of
/// ten takes 9 iterations instead of a thousand, and a block under one a hundred times heavier 4 instead
/// of 78. The next sweep projects impulses beyond their bounds.
template <int D>
class NonsmoothConjugateGradient {
 public:
  void accelerate(std::span<ContactConstraint<D>> constraints, VelocityChange<D>& changes) {
    double length = 0;
    for (const ContactConstraint<D>& at : constraints)
      length += (at.impulse - at.previous_impulse).squaredNorm() * at.normal_inverse_mass;
    const bool is_shorter = length <= last_length_;
    const double ratio = is_shorter && length > 0 ? length / last_length_ : 0;
    for (ContactConstraint<D>& at : constraints) {
      const Vector<D> more = ratio * at.direction;
      at.direction =
          is_shorter ? Vector<D>(more + at.impulse - at.previous_impulse) : Vector<D>(Vector<D>::Zero());
      at.impulse += more;
      at.previous_impulse = at.impulse;
      changes.add(at.of_a, more);
      changes.add(at.of_b, -more);
    }
    last_length_ = length;
  }

 private:
  double last_length_ = HUGE_VAL;  // of the step before
};

}  // namespace

template <int D>
bool ContactConstraint<D>::fails(const Vector<D>& left) const {
  constexpr double tolerance = 1e-6;
  const Vector<D>&n = this->normal, &p = this->impulse;
  const double along = p.dot(n), across = (p - along * n).norm();
  const double opening = left.dot(n), slip = (left - opening * n).norm();
  const double limit = cohesion_limit + tan_friction * std::max(along, 0.0);
  const double noise = tolerance * normal_inverse_mass * p.norm();
  return (along <= -(1 - tolerance) * tension_limit && opening > noise) ||
         (across >= (1 - tolerance) * limit && slip > noise);
}

template <int D>
int solve_constraints(std::span<ContactConstraint<D>> constraints, VelocityChange<D>& changes) {
  double fastest = 0, least = HUGE_VAL;
  int least_in = 0;
  for (ContactConstraint<D>& at : constraints) {
    changes.add(at.of_a, at.impulse);
    changes.add(at.of_b, -at.impulse);
    fastest = std::max(fastest, at.impulse.norm() * at.normal_inverse_mass);
    at.previous_impulse = at.impulse;
    at.direction = Vector<D>::Zero();
  }
  NonsmoothConjugateGradient<D> conjugate;
  for (int iteration = 1; iteration <= max_iterations; ++iteration) {
    const bool is_backwards = iteration % 2 == 0;
    const double changed = sweep_contacts(constraints, is_backwards, changes);
    fastest = std::max(fastest, changed);
    if (changed <= smallest_change * fastest) return iteration;
    if (changed <= 0.999 * least) {
      least = changed;
      least_in = iteration;
    } else if (iteration - least_in >= max_stalled_iterations) {
      return iteration;
    }
    if (is_backwards) conjugate.accelerate(constraints, changes);
  }
  return max_iterations;
}

template struct ContactConstraint<2>;
template struct ContactConstraint<3>;
template int solve_constraints(std::span<ContactConstraint<2>>, VelocityChange<2>&);
template int solve_constraints(std::span<ContactConstraint<3>>, VelocityChange<3>&);

}  // namespace halfspace
