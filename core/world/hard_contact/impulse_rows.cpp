#include "world/hard_contact/impulse_rows.h"

#include <algorithm>
#include <cmath>

#include "geometry/mean_distance.h"
#include "geometry/tolerances.h"
#include "narrow_phase/space/contact_plane.h"

namespace halfspace {
namespace {

/// Unit vectors along a face.
std::array<Vector<2>, 1> tangents(const Vector<2>& normal) { return {perpendicular(normal)}; }
std::array<Vector<3>, 2> tangents(const Vector<3>& normal) {
  const PlaneFrame plane(normal, Vector<3>::Zero());
  return {plane.along, plane.across};
}

/// Nothing twists in the plane.
Patch<2> patch_of_corners(std::span<const Vector<2>> corner, const Vector<2>&) {
  return {0.5 * (corner.front() + corner.back()), 0, 0};
}

/// Of a polygon, by triangles from its first corner; of fewer corners or none but on a line, of the segment
/// to the farthest one.
Patch<3> patch_of_corners(std::span<const Vector<3>> corner, const Vector<3>& normal) {
  const Vector<3>& origin = corner.front();
  Vector<3> moment = Vector<3>::Zero(), farthest = Vector<3>::Zero();
  Tensor<3> spread = Tensor<3>::Zero();
  double area = 0;
  for (std::size_t i = 1; i < corner.size(); ++i) {
    const Vector<3> side = corner[i] - origin;
    if (side.squaredNorm() > farthest.squaredNorm()) farthest = side;
    if (i + 1 == corner.size()) break;
    const Vector<3> next = corner[i + 1] - origin, sum = side + next;
    const double part = normal.dot(cross_product(side, next));
    area += part;
    moment += part / 3 * sum;
    spread += part / 12 * (side * side.transpose() + next * next.transpose() + sum * sum.transpose());
  }
  if (std::abs(area) <= face_reach * farthest.squaredNorm())
    return {origin + 0.5 * farthest, mean_distance(Tensor<3>(farthest * farthest.transpose() / 12)), 0};
  const Vector<3> center = moment / area;
  const double radius = mean_distance(Tensor<3>(spread / area - center * center.transpose()));
  return {origin + center, radius, 0.5 * std::abs(area)};
}

/// A point of a manifold, where its plane is.
template <int D>
Vector<D> on_plane(const RigidContact<D>& at, std::size_t i, const Vector<D>& arm) {
  return arm + (at.manifold.plane == ManifoldPlane::face_of_b ? 1 : -1) * at.gap[i] * at.normal;
}

}  // namespace

template <int D>
Vector<D> center_of_impulses(const RigidContact<D>& at, const Arms<D>& arm) {
  const double sum = at.normal_impulse();
  Vector<D> center = Vector<D>::Zero();
  for (std::size_t i = 0; i < std::size_t(at.manifold.count); ++i)
    center += (sum > 0 ? at.impulse[i] / sum : 1.0 / at.manifold.count) * on_plane(at, i, arm[i]);
  return center;
}

/// Inertias are those of the present rotations.
template <int D>
void ImpulseRows<D>::set_inverse_masses(ImpulseProblem<D>& problem) {
  problem.inverse_masses.assign(blocks_.slot_count(), {});
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    if (!search_.is_free(i) || blocks_.is_part(i)) continue;
    problem.inverse_masses[i] = {1 / blocks_.mass[i], blocks_.inertia[i].inverse(blocks_.rotation[i])};
  }
}

/// The region of the points that touch or bore, on the plane of the manifold. Where they bear, its centre is
/// that of their impulses, so that a block that slides over many faces does not twist, however they share its
/// weight: it has a couple, which keeps the moment of friction as the centre moves. The couple is that of
/// even pressure on the region. Of round faces the points leave out slivers.
template <int D>
Patch<D> ImpulseRows<D>::patch_of(const RigidContact<D>& at, const Arms<D>& arm) const {
  const double touching = at.min_gap() + search_.settled_gap(at);
  std::array<Vector<D>, max_manifold_points<D>> corner;
  corner.fill(Vector<D>::Zero());
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::size_t(at.manifold.count); ++i) {
    if (at.gap[i] <= touching || at.impulse[i] > 0) corner[count++] = on_plane(at, i, arm[i]);
  }
  Patch<D> patch = patch_of_corners({corner.data(), count}, at.normal);
  if (at.normal_impulse() > 0) patch.center = center_of_impulses(at, arm);
  if constexpr (D == 3) {
    const bool touches_as_a_whole = count == std::size_t(at.manifold.count) && patch.area > 0;
    if (touches_as_a_whole) patch.radius *= std::sqrt(std::max(1.0, at.manifold.area / patch.area));
  }
  return patch;
}

template <int D>
void ImpulseRows<D>::build(std::span<PredictedContact<D>> contacts, ImpulseProblem<D>& problem) {
  set_inverse_masses(problem);
  build_of_masses(contacts, problem, true);
}

template <int D>
void ImpulseRows<D>::build_normals(std::span<PredictedContact<D>> contacts, ImpulseProblem<D>& problem,
                                   std::span<const std::size_t> immovable) {
  set_inverse_masses(problem);
  for (const std::size_t block : immovable) problem.inverse_masses[block] = {};
  build_of_masses(contacts, problem, false);
}

template <int D>
void ImpulseRows<D>::build_of_masses(std::span<PredictedContact<D>> contacts, ImpulseProblem<D>& problem,
                                     bool with_friction) {
  problem.contacts.clear();
  problem.rows.clear();
  const auto add_row = [&](const ImpulseContact<D>& contact, const Vector<D>& direction,
                           const Angular<D>& turn_a, const Angular<D>& turn_b, double impulse) {
    ImpulseRow<D> row;
    row.direction = direction;
    row.turn_a = turn_a;
    row.turn_b = turn_b;
    row.set_masses(problem.inverse_masses[std::size_t(contact.a)],
                   problem.inverse_masses[std::size_t(contact.b)]);
    row.target = row.slip = 0;
    row.impulse = impulse;
    problem.rows.push_back(row);
  };
  for (PredictedContact<D>& at : contacts) {
    const std::size_t a = std::size_t(at.a), b = std::size_t(at.b);
    const std::size_t mover_a = blocks_.mover_of(a), mover_b = blocks_.mover_of(b);
    const Vector<D> arm_of_a = blocks_.arm_of(a), arm_of_b = blocks_.arm_of(b);
    const PosedBlock<D> pose_a = search_.now(a), pose_b = search_.now(b);
    const Vector<D> to_b = pose_b.position - pose_a.position;
    ImpulseContact<D> contact;
    contact.a = std::int32_t(mover_a);
    contact.b = std::int32_t(mover_b);
    contact.first_row = std::int32_t(problem.rows.size());
    contact.normal_count = at.manifold.count;
    contact.inverse_mass_a = problem.inverse_masses[mover_a].of_mass;
    contact.inverse_mass_b = problem.inverse_masses[mover_b].of_mass;
    contact.tan_friction = model_.law_between(a, b).tan_friction;
    contact.friction_count = 0;
    const Arms<D> arm = arms_of(at.manifold, pose_a, pose_b);
    for (std::size_t i = 0; i < std::size_t(at.manifold.count); ++i) {
      add_row(contact, at.normal, moment(Vector<D>(arm[i] + arm_of_a), at.normal),
              moment(Vector<D>(arm[i] - to_b + arm_of_b), at.normal), at.impulse[i]);
    }
    if (with_friction && contact.tan_friction > 0) {
      const Patch<D> patch = patch_of(at, arm);
      const Vector<D> from_a = patch.center + arm_of_a, from_b = patch.center - to_b + arm_of_b;
      at.center = patch.center;
      const bool is_loaded = at.normal_impulse() > 0;
      for (const Vector<D>& tangent : tangents(at.normal)) {
        add_row(contact, tangent, moment(from_a, tangent), moment(from_b, tangent), tangent.dot(at.friction));
        ImpulseRow<D>& row = problem.rows.back();
        const double slip = row.velocity(problem.start[mover_a], problem.start[mover_b]);
        if (is_loaded && std::abs(slip) > problem.slow_slip) row.slip = slip;
      }
      contact.friction_count = D - 1;
      if constexpr (D == 3) {
        if (patch.radius > 0) {
          const Vector<3> turn = patch.radius * at.normal;
          const double couple = at.couple_about(patch.center - middle_of(at, arm));
          add_row(contact, Vector<D>::Zero(), turn, turn, couple / patch.radius);
          ++contact.friction_count;
        }
      }
    }
    problem.contacts.push_back(contact);
  }
}

template Vector<2> center_of_impulses(const RigidContact<2>&, const Arms<2>&);
template Vector<3> center_of_impulses(const RigidContact<3>&, const Arms<3>&);
template class ImpulseRows<2>;
template class ImpulseRows<3>;

}  // namespace halfspace
