#include "world/hard_contact/rest.h"

#include <algorithm>

namespace halfspace {

/// Calls `visit(slot)` for all awake blocks that move by themselves, until it returns false. False, too,
/// where a block deforms.
template <int D>
template <class Visit>
bool Rest<D>::for_all_movers(Visit visit) const {
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    if (!blocks_.lives(i) || !blocks_.moves(i) || blocks_.is_part(i) || integrator_.is_asleep(i)) continue;
    if (blocks_.is_deformable(i) || !visit(i)) return false;
  }
  return true;
}

/// A prescribed block may not move at all: others would be held back.
template <int D>
bool Rest<D>::is_slow(std::size_t i, const BlockMotion<D>& motion, double speed) const {
  if (blocks_.kind[i] != BlockKind::rigid) return motion.velocity.isZero(0) && motion.spin.isZero(0);
  const double radius = blocks_.radius[i];
  return motion.velocity.squaredNorm() + radius * radius * motion.spin.squaredNorm() <= speed * speed;
}

/// The last impulses held blocks against the rates that they had then.
template <int D>
bool Rest<D>::lasts(double duration) const {
  if (!lasts_ || duration != duration_) return false;
  return for_all_movers([&](std::size_t i) {
    if (blocks_.kind[i] == BlockKind::rigid) return integrator_.is_held(i);
    const auto [acceleration, spin_rate] = integrator_.rates_of(i);
    return acceleration.isZero(0) && spin_rate.isZero(0) &&
           is_slow(i, {blocks_.velocity[i], blocks_.spin[i]}, 0);
  });
}

template <int D>
void Rest<D>::repeat() {
  for_all_movers([&](std::size_t i) {
    if (blocks_.kind[i] == BlockKind::rigid) integrator_.hold_again(i);
    return true;
  });
}

template <int D>
bool Rest<D>::may_hold_all(Half half, double speed) const {
  if (half == Half::second) return repeated_halves_ == 1;
  return speed > 0 && for_all_movers([&](std::size_t i) {
           return is_slow(i, {blocks_.velocity[i], blocks_.spin[i]}, speed);
         });
}

/// A block without contacts falls, and is faster.
template <int D>
bool Rest<D>::hold_all(Half half, const ImpulseProblem<D>& problem, double speed) {
  if (!for_all_movers([&](std::size_t i) { return is_slow(i, problem.motions[i], speed); })) return false;
  for_all_movers([&](std::size_t i) {
    if (blocks_.kind[i] == BlockKind::rigid) integrator_.hold(i, half == Half::first);
    return true;
  });
  ++standing_halves_;
  ++repeated_halves_;
  return true;
}

/// Blocks that impulses do not move join no islands.
template <int D>
void Rest<D>::find_islands(const ImpulseProblem<D>& problem, double speed) {
  islands_.begin(problem.motions.size());
  state_.assign(problem.motions.size(), State::without_contacts);
  for (const ImpulseContact<D>& contact : problem.contacts) {
    if (contact.inverse_mass_a > 0 && contact.inverse_mass_b > 0) islands_.join(contact.a, contact.b);
    state_[std::size_t(contact.a)] = state_[std::size_t(contact.b)] = State::stands;
  }
  for (const ImpulseContact<D>& contact : problem.contacts) {
    if (are_slow(contact, problem, speed)) continue;
    for (const std::int32_t block : {contact.a, contact.b})
      state_[std::size_t(islands_.head_of(block))] = State::moves;
  }
}

template <int D>
bool Rest<D>::are_slow(const ImpulseContact<D>& contact, const ImpulseProblem<D>& problem,
                       double speed) const {
  const auto is_slow_in_problem = [&](std::int32_t i) {
    return std::size_t(i) >= blocks_.moving_end() ||
           is_slow(std::size_t(i), problem.motions[std::size_t(i)], speed);
  };
  return is_slow_in_problem(contact.a) && is_slow_in_problem(contact.b);
}

/// Does the island of a block stand?
template <int D>
bool Rest<D>::stands(std::size_t block) {
  return state_[block] != State::without_contacts &&
         state_[std::size_t(islands_.head_of(std::int32_t(block)))] == State::stands;
}

template <int D>
void Rest<D>::hold_islands(Half half, const ImpulseProblem<D>& problem, double speed) {
  const auto is_slow_contact = [&](const ImpulseContact<D>& contact) {
    return are_slow(contact, problem, speed);
  };
  if (!(speed > 0) || std::none_of(problem.contacts.begin(), problem.contacts.end(), is_slow_contact)) return;
  find_islands(problem, speed);
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i)
    if (problem.inverse_masses[i].of_mass > 0 && stands(i)) integrator_.hold(i, half == Half::first);
  standing_halves_ += for_all_movers([&](std::size_t i) {
    return blocks_.kind[i] == BlockKind::rigid ? stands(i) : is_slow(i, problem.motions[i], speed);
  });
}

template class Rest<2>;
template class Rest<3>;

}  // namespace halfspace
