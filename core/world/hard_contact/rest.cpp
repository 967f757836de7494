#include "world/hard_contact/rest.h"

namespace halfspace {

/// Calls `visit(slot)` for all awake blocks that move by themselves, until it returns false. False, too, for
/// a world in which a block deforms.
template <int D>
template <class Visit>
bool Rest<D>::for_all_movers(Visit visit) const {
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    if (!blocks_.lives(i) || !blocks_.moves(i) || blocks_.is_part(i) || integrator_.is_asleep(i)) continue;
    if (blocks_.is_deformable(i) || !visit(i)) return false;
  }
  return true;
}

/// The last impulses held blocks against their accelerations.
template <int D>
bool Rest<D>::lasts(double duration) const {
  if (!lasts_ || duration != duration_) return false;
  return for_all_movers([&](std::size_t i) {
    if (blocks_.kind[i] != BlockKind::prescribed) return integrator_.is_held(i);
    const auto [acceleration, spin_rate] = integrator_.rates_of(i);
    return acceleration.isZero(0) && spin_rate.isZero(0) && blocks_.velocity[i].isZero(0) &&
           blocks_.spin[i].isZero(0);
  });
}

template <int D>
void Rest<D>::repeat() {
  for_all_movers([&](std::size_t i) {
    if (blocks_.kind[i] == BlockKind::rigid) integrator_.hold_again(i);
    return true;
  });
}

/// Blocks that are held by nothing fall: they are faster.
template <int D>
bool Rest<D>::hold(Half half, std::span<const BlockMotion<D>> motions, double speed) {
  const bool all_stand =
      speed > 0 && for_all_movers([&](std::size_t i) {
        const BlockMotion<D>& motion = motions[i];
        if (blocks_.kind[i] == BlockKind::prescribed)
          return motion.velocity.isZero(0) && motion.spin.isZero(0);
        const double radius = blocks_.radius[i];
        return motion.velocity.squaredNorm() + radius * radius * motion.spin.squaredNorm() <= speed * speed;
      });
  if (!all_stand) return false;
  for_all_movers([&](std::size_t i) {
    if (blocks_.kind[i] == BlockKind::rigid) integrator_.hold(i, half == Half::first);
    return true;
  });
  ++held_halves_;
  return true;
}

template class Rest<2>;
template class Rest<3>;

}  // namespace halfspace
