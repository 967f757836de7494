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
    if (blocks_.kind[i] == BlockKind::rigid) return integrator_.is_held(i, duration);
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
void Rest<D>::note_slow(double speed, Array<std::uint8_t>& slow) const {
  slow.assign(blocks_.slot_count(), true);
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    if (blocks_.lives(i) && blocks_.moves(i) && !integrator_.is_asleep(i))
      slow[i] = speed > 0 && is_slow(i, {blocks_.velocity[i], blocks_.spin[i]}, speed);
  }
}

template <int D>
bool Rest<D>::may_hold_all(Half half, double speed) const {
  if (half == Half::second) return is_repeated_[0];
  return speed > 0 && for_all_movers([&](std::size_t i) {
           return is_slow(i, {blocks_.velocity[i], blocks_.spin[i]}, speed);
         });
}

template <int D>
bool Rest<D>::is_slow(const ImpulseContact<D>& contact, const ImpulseProblem<D>& problem,
                      double speed) const {
  const auto is_slow_in_problem = [&](std::int32_t i) {
    return std::size_t(i) >= blocks_.moving_end() ||
           is_slow(std::size_t(i), problem.motions[std::size_t(i)], speed);
  };
  return is_slow_in_problem(contact.a) && is_slow_in_problem(contact.b);
}

/// A support or an action may give it a velocity.
template <int D>
bool Rest<D>::is_guided(std::size_t i) const {
  return (blocks_.any_held() && blocks_.held[i] != 0) || model_.actions.target_of(i) != nullptr;
}

template <int D>
void Rest<D>::find_standing(ImpulseProblem<D>& problem, double speed) {
  const std::int32_t all_that_stays = std::int32_t(problem.motions.size());
  stuck_.begin(problem.motions.size() + 1);
  moves_.assign(problem.islands.count(), 0);
  const auto moves = [&](std::int32_t block) {
    return problem.inverse_masses[std::size_t(block)].of_mass > 0;
  };
  for (const ImpulseContact<D>& contact : problem.contacts) {
    if (problem.sticks(contact))
      stuck_.join(moves(contact.a) ? contact.a : all_that_stays,
                  moves(contact.b) ? contact.b : all_that_stays);
  }
  for (std::size_t c = 0; c < problem.contacts.size(); ++c)
    moves_[problem.islands.of_contact(c)] |= !is_slow(problem.contacts[c], problem, speed);
  for (std::int32_t i = 0; i < std::int32_t(blocks_.moving_end()); ++i) {
    const std::int32_t island = moves(i) ? problem.islands.of_block(i) : -1;
    if (island >= 0 && (stuck_.head_of(i) != stuck_.head_of(all_that_stays) || is_guided(std::size_t(i))))
      moves_[std::size_t(island)] = true;
  }
}

template <int D>
bool Rest<D>::all_stand(const ImpulseProblem<D>& problem, double speed) {
  return for_all_movers([&](std::size_t i) {
    return blocks_.kind[i] == BlockKind::rigid ? stands(problem, i) : is_slow(i, problem.motions[i], speed);
  });
}

template <int D>
void Rest<D>::hold_standing(Half half, const ImpulseProblem<D>& problem) {
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i)
    if (problem.inverse_masses[i].of_mass > 0 && stands(problem, i)) integrator_.hold(i, half == Half::first);
}

template <int D>
bool Rest<D>::hold_all(Half half, ImpulseProblem<D>& problem, double speed) {
  find_standing(problem, speed);
  if (!all_stand(problem, speed)) return false;
  hold_standing(half, problem);
  holds_all_[std::size_t(half)] = is_repeated_[std::size_t(half)] = true;
  return true;
}

template <int D>
void Rest<D>::hold_islands(Half half, ImpulseProblem<D>& problem, double speed) {
  holds_all_[std::size_t(half)] = is_repeated_[std::size_t(half)] = false;
  const auto is_slow_contact = [&](const ImpulseContact<D>& contact) {
    return is_slow(contact, problem, speed);
  };
  if (!(speed > 0) || std::none_of(problem.contacts.begin(), problem.contacts.end(), is_slow_contact)) return;
  find_standing(problem, speed);
  hold_standing(half, problem);
  holds_all_[std::size_t(half)] = all_stand(problem, speed);
}

template class Rest<2>;
template class Rest<3>;

}  // namespace halfspace
