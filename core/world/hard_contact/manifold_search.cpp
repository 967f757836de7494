#include "world/hard_contact/manifold_search.h"

#include <algorithm>

#include "geometry/tolerances.h"

namespace halfspace {

template <int D>
PosedBlock<D> ManifoldSearch<D>::now(std::size_t slot) const {
  return {blocks_.own_outline(std::int32_t(slot)), blocks_.position[slot], blocks_.rotation[slot]};
}

template <int D>
PosedBlock<D> ManifoldSearch<D>::predicted(std::size_t slot) const {
  if (!blocks_.moves(slot)) return now(slot);
  return {blocks_.own_outline(std::int32_t(slot)),
          blocks_.position[slot] + integrator_.predicted_displacement(slot),
          integrator_.predicted_rotation(slot)};
}

/// At least the rounding of a point's place seen from either block, and the displacement by the velocity that
/// may remain unbalanced: a point within it would otherwise bear in one step and not in the next.
template <int D>
double ManifoldSearch<D>::reach(const RigidContact<D>& contact) const {
  const double duration = integrator_.duration();
  const double unbalanced = 2 * model_.settings.impulse_tolerance * model_.settings.gravity.norm() * duration;
  const std::size_t a = std::size_t(contact.a), b = std::size_t(contact.b);
  return std::max({face_reach * smaller_radius(contact),
                   place_rounding * std::max(blocks_.position[a].norm(), blocks_.position[b].norm()),
                   unbalanced * duration});
}

template <int D>
double ManifoldSearch<D>::settled_gap(const RigidContact<D>& contact) const {
  return std::max(touch_reach * smaller_radius(contact), reach(contact));
}

/// After its last rebound a block falls to the face.
template <int D>
double ManifoldSearch<D>::resting_gap(const RigidContact<D>& contact) const {
  const bool rebounds = model_.law_between(std::size_t(contact.a), std::size_t(contact.b)).restitution > 0;
  return rebounds ? settled_gap(contact) : converged_gap * smaller_radius(contact);
}

/// Two blocks have contacts of impulses when one of them moves freely and is awake.
template <int D>
bool ManifoldSearch<D>::may_touch(const Candidate<D>& pair) const {
  return model_.has_manifold(pair) && (is_free(std::size_t(pair.a)) || is_free(std::size_t(pair.b)));
}

template <int D>
double ManifoldSearch<D>::allowance(std::size_t slot) const {
  return slot < allowance_.size() ? allowance_[slot] : same_manifold * blocks_.radius[slot];
}

/// Faces are chosen where blocks would be by their present velocities: at the start of a motion the end of a
/// flush face would stop a block that slides on to the next, and with gravity a block would sink into it.
template <int D>
void ManifoldSearch<D>::pose_ahead(double duration) {
  ahead_.resize(blocks_.moving_end());
  allowance_.resize(blocks_.moving_end());
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    if (!blocks_.lives(i)) continue;
    ahead_[i] = now(i);
    allowance_[i] = same_manifold * blocks_.radius[i];
    if (!blocks_.moves(i) || integrator_.is_asleep(i)) continue;
    const std::size_t mover = blocks_.mover_of(i);
    const Angular<D> turn = duration * blocks_.spin[mover];
    const Vector<D> arm = blocks_.arm_of(i);
    ahead_[i].position += duration * blocks_.velocity[mover];
    if (mover != i) ahead_[i].position += Rotation<D>().turned_by(turn) * arm - arm;
    ahead_[i].rotation = ahead_[i].rotation.turned_by(turn);
    if (blocks_.moves_freely(i))
      allowance_[i] += duration * duration * integrator_.speed_bound_of(i).acceleration;
  }
}

/// By more than rounding.
template <int D>
bool ManifoldSearch<D>::moves(std::size_t slot, double duration) const {
  if (!blocks_.moves(slot) || integrator_.is_asleep(slot)) return false;
  const std::size_t mover = blocks_.mover_of(slot);
  return duration * (blocks_.velocity[mover].norm() + blocks_.swing(mover)) >
         face_reach * blocks_.radius[slot];
}

/// In order of their blocks, each with the plane that it had among the known ones, if that still serves.
template <int D>
void ManifoldSearch<D>::find(double duration, std::span<const RigidContact<D>> known,
                             Array<PredictedContact<D>>& found) {
  found.clear();
  pose_ahead(duration);
  auto before = known.begin();
  for (const Candidate<D>& pair : contacts_.neighbors().pairs()) {
    if (!may_touch(pair)) continue;
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    const double margin = allowance(a) + allowance(b);
    const double distance = blocks_.radius[a] + blocks_.radius[b] + margin;
    if ((place_ahead(a) - place_ahead(b)).squaredNorm() > distance * distance) continue;
    PredictedContact<D>& contact = found.emplace_back();
    contact.a = pair.a;
    contact.b = pair.b;
    while (before != known.end() && before->blocks() < contact.blocks()) ++before;
    const Rotation<D> to_frame = ahead(a).rotation.inverse();
    const Vector<D> to_b = to_frame * (place_ahead(b) - place_ahead(a));
    const Rotation<D> turn = to_frame * ahead(b).rotation;
    if (before != known.end() && before->blocks() == contact.blocks()) {
      contact.manifold = before->manifold;
      contact.found_to_b = before->found_to_b;
      contact.found_turn = before->found_turn;
      const double moved =
          (to_b - before->found_to_b).norm() + blocks_.radius[b] * turn.farthest_from(before->found_turn);
      const bool pair_moves = moves(a, duration) || moves(b, duration);
      contact.is_kept = moved < (pair_moves ? same_manifold * smaller_radius(contact) : reach(contact));
      if (contact.is_kept) continue;
    }
    contact.found_to_b = to_b;
    contact.found_turn = turn;
    if (!find_manifold(ahead(a), ahead(b), margin, contact.manifold)) found.pop_back();
  }
}

/// Pairs of blocks that impulses have moved farther than allowed for, and that now overlap unseen. False when
/// there are none.
template <int D>
bool ManifoldSearch<D>::find_more(Array<PredictedContact<D>>& found) const {
  const auto deviates = [&](std::size_t i) {
    if (!is_free(i)) return false;
    const PosedBlock<D> at = predicted(i);
    const double deviation = (at.position - ahead_[i].position).norm() +
                             blocks_.radius[i] * at.rotation.farthest_from(ahead_[i].rotation);
    return deviation > allowance_[i];
  };
  const std::size_t before = found.size();
  for (const Candidate<D>& pair : contacts_.neighbors().pairs()) {
    if (!may_touch(pair)) continue;
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    if (!deviates(a) && !deviates(b)) continue;
    const PosedBlock<D> at_a = predicted(a), at_b = predicted(b);
    const double distance = blocks_.radius[a] + blocks_.radius[b];
    if ((at_a.position - at_b.position).squaredNorm() > distance * distance) continue;
    PredictedContact<D> contact;
    contact.a = pair.a;
    contact.b = pair.b;
    if (std::binary_search(found.begin(), found.begin() + std::ptrdiff_t(before), contact, is_before<D>))
      continue;
    if (!find_manifold(at_a, at_b, 0, contact.manifold)) continue;
    const Rotation<D> to_frame = at_a.rotation.inverse();
    contact.found_to_b = to_frame * (at_b.position - at_a.position);
    contact.found_turn = to_frame * at_b.rotation;
    set_gaps(contact);
    found.push_back(contact);
  }
  if (found.size() == before) return false;
  std::sort(found.begin(), found.end(), is_before<D>);
  return true;
}

template <int D>
void ManifoldSearch<D>::set_gaps(PredictedContact<D>& contact) const {
  const PosedBlock<D> a = now(std::size_t(contact.a)), b = now(std::size_t(contact.b));
  contact.normal = normal_of(contact.manifold, a, b);
  contact.gap = gaps_of(contact.manifold, contact.normal, a, b);
}

template <int D>
Gaps<D> ManifoldSearch<D>::predicted_gaps(const PredictedContact<D>& contact) const {
  const PosedBlock<D> a = predicted(std::size_t(contact.a)), b = predicted(std::size_t(contact.b));
  return gaps_of(contact.manifold, normal_of(contact.manifold, a, b), a, b);
}

template <int D>
Vector<D> ManifoldSearch<D>::predicted_slip(const PredictedContact<D>& contact) const {
  const auto displacement = [&](std::int32_t block, const Vector<D>& place) {
    const PosedBlock<D> before = now(std::size_t(block)), after = predicted(std::size_t(block));
    const Vector<D> arm = place - before.position;
    return Vector<D>(after.position - before.position + after.rotation * (before.rotation.inverse() * arm) -
                     arm);
  };
  const Vector<D> place = blocks_.position[std::size_t(contact.a)] + contact.center;
  return displacement(contact.b, place) - displacement(contact.a, place);
}

template class ManifoldSearch<2>;
template class ManifoldSearch<3>;

}  // namespace halfspace
