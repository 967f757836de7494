#include "world/motion/continuous_collision.h"

#include <algorithm>

#include "geometry/tolerances.h"
#include "narrow_phase/pair.h"
#include "narrow_phase/time_of_impact.h"

namespace halfspace {
namespace {

PairCache<2> witness_of(const Impact<2>& impact) { return {PairCache<2>::separated, impact.pair}; }
PairCache<3> witness_of(const Impact<3>& impact) {
  return {PairCache<3>::separated, impact.pair, impact.normal};
}

}  // namespace

template <int D>
double ContinuousCollision<D>::safe_time_step() const {
  double calm = HUGE_VAL;
  for (const Candidate<D>& pair : contacts_.neighbors().pairs())
    calm = std::min(calm, safe_thickness_fraction * blocks_.thinner(pair.a, pair.b) /
                              blocks_.speed_between(pair.a, pair.b));
  return calm;
}

/// Bounds the speed of all points by (x + y)^2 <= 2 (x^2 + y^2), with a margin for rounding. Prescribed
/// blocks are not included: any() tests their predicted motion.
template <int D>
void ContinuousCollision<D>::note_speeds(const EnergySample& sample) {
  fastest_squared_ = 2 * bound_margin * (sample.squared_speed + sample.squared_swing);
}

/// A block is fast when a whole step would move it by more than its safe displacement, at its current speed
/// or at that of the predicted motion. So a block that an impulse stops is still fast.
template <int D>
bool ContinuousCollision<D>::is_fast(std::size_t i) const {
  const double calm =
      integrator_.duration() / clock_.time_step() * contacts_.neighbors().safe_displacement(i);
  return contacts_.neighbors().announced_motion(i) > calm ||
         integrator_.duration() * (blocks_.velocity[i].norm() + blocks_.swing(i)) > calm;
}

/// First compares the largest speed with the smallest safe displacement, which suffices for most worlds.
template <int D>
bool ContinuousCollision<D>::any() const {
  const double calm_speed = contacts_.neighbors().min_safe_displacement() / clock_.time_step();
  if (integrator_.longest_motion() < integrator_.duration() * calm_speed &&
      fastest_squared_ < calm_speed * calm_speed)
    return false;
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    if (is_fast(i)) return true;
  }
  return false;
}

template <int D>
Sweep<D> ContinuousCollision<D>::predicted_sweep(std::size_t i) const {
  Sweep<D> sweep;
  sweep.position = blocks_.position[i];
  sweep.gradient = blocks_.gradient(i);
  if (blocks_.kind[i] == BlockKind::fixed) return sweep;
  sweep.way = integrator_.predicted_displacement(i);
  if (blocks_.is_deformable(i)) {
    sweep.stretch = integrator_.predicted_stretch(i);
  } else {
    sweep.turn = integrator_.predicted_turn(i);
  }
  return sweep;
}

/// The last motion, computed backwards from its end, in its own direction of time. In 3D the angular velocity
/// at the end is taken as constant.
template <int D>
Sweep<D> ContinuousCollision<D>::made_sweep(std::size_t i, double made) const {
  Sweep<D> sweep;
  sweep.position = blocks_.position[i];
  sweep.gradient = blocks_.gradient(i);
  if (blocks_.kind[i] == BlockKind::fixed) return sweep;
  sweep.way = made * blocks_.velocity[i];
  sweep.position -= sweep.way;
  if (blocks_.is_deformable(i)) {
    sweep.stretch = made * blocks_.deformation(i).rate;
    sweep.gradient -= sweep.stretch;
  } else {
    sweep.turn = made * blocks_.spin[i];
    sweep.gradient = blocks_.rotation[i].turned_by(-sweep.turn).tensor();
  }
  return sweep;
}

/// The cached pair remains the entry if the blocks touched at the start up to rounding, or if the motion is
/// short relative to the thinner block.
template <int D>
void ContinuousCollision<D>::find_entrance(Candidate<D>& pair, double made, int worker) {
  if (made * blocks_.speed_between(pair.a, pair.b) <= short_way * blocks_.thinner(pair.a, pair.b)) return;
  const Impact<D> impact =
      time_of_impact(blocks_.own_outline(pair.a), made_sweep(std::size_t(pair.a), made),
                     blocks_.own_outline(pair.b), made_sweep(std::size_t(pair.b), made), room_of(worker));
  if (impact.state != Impact<D>::touches) return;
  if (impact.time * made * blocks_.speed_between(pair.a, pair.b) <= contacts_.rounding_of_touch(pair)) return;
  pair.witness = witness_of(impact);
  pair.witness.state = PairCache<D>::touching;
}

/// The fraction of the predicted motion that is safe for a pair. If the blocks meet, caches the pair of
/// features through which they do.
template <int D>
double ContinuousCollision<D>::safe_fraction_of(Candidate<D>& pair, double& stable_duration) {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Sweep<D> of_a = predicted_sweep(a), of_b = predicted_sweep(b);
  const auto swing_by = [&](const Sweep<D>& sweep, std::size_t i) {
    return blocks_.radius[i] * (sweep.turn.norm() + sweep.stretch.norm());
  };
  const double predicted = (of_b.way - of_a.way).norm() + swing_by(of_a, a) + swing_by(of_b, b);
  const double motion = std::max(predicted, integrator_.duration() * blocks_.speed_between(pair.a, pair.b));
  const double thickness = blocks_.thinner(pair.a, pair.b);
  if (motion <= integrator_.duration() / clock_.time_step() * safe_thickness_fraction * thickness) return 1;
  pair_ = {pair.a, pair.b, motion / integrator_.duration(), thickness,
           safe_thickness_fraction * thickness * integrator_.duration() / motion};
  const double largest_overlap = model_.has_manifold(pair) ? manifold_thickness_fraction * thickness : 0;
  if (motion <= largest_overlap) return 1;
  double time_of_touch = 0;
  if (touching(pair.witness) && !model_.law_of(pair).has_no_spring()) {
    stop_.note(pair);
  } else {
    const Impact<D> impact =
        time_of_impact(blocks_.own_outline(pair.a), of_a, blocks_.own_outline(pair.b), of_b, room_of(0));
    if (impact.state == Impact<D>::never) return 1;
    if (impact.state == Impact<D>::touches) {
      time_of_touch = impact.time;
      pair.witness = witness_of(impact);
    }
    if ((1 - time_of_touch) * motion <= largest_overlap) return 1;
  }
  if (stable_duration == 0) stable_duration = model_.settings.safety * stable_step_.bound();
  const double calm = safe_thickness_fraction * thickness / motion,
               stable = stable_duration / integrator_.duration();
  if (calm >= 1 && stable >= 1) return 1;
  // If the springs would be unstable in the predicted motion, only a stable fraction is safe.
  const double at_once = 0.5 * (stable < 1 ? stable : calm);
  return std::max(time_of_touch - at_once, at_once);
}

template <int D>
double ContinuousCollision<D>::safe_fraction() {
  double part = 1;
  double stable_duration = 0;  // 0: not computed yet, because it visits all contacts
  FastPair first = pair_;
  for (Candidate<D>& pair : contacts_.neighbors().pairs()) {
    if (!is_fast(std::size_t(pair.a)) && !is_fast(std::size_t(pair.b))) continue;
    const double of_pair = safe_fraction_of(pair, stable_duration);
    if (of_pair >= part) continue;
    part = of_pair;
    first = pair_;
    if (model_.settings.fast_blocks == FastBlocks::refuse) break;
  }
  pair_ = first;
  return part;
}

template class ContinuousCollision<2>;
template class ContinuousCollision<3>;

}  // namespace halfspace
