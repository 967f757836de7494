#include "world/motion/continuous_collision.h"

#include <algorithm>

#include "narrow_phase/pair.h"
#include "narrow_phase/time_of_impact.h"

namespace halfspace {
namespace {

/// A share of the thinner block's thickness: in a motion that is shorter no two sides close in turn.
constexpr double short_share = 0x1p-8;

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

/// Bounds the speed of all points by (x + y)^2 <= 2 (x^2 + y^2), with room for rounding. Boundaries that move
/// are not among them: they are as fast in their planned motion.
template <int D>
void ContinuousCollision<D>::note_speeds(const EnergySample& sample) {
  fastest_squared_ = 2.001 * (sample.squared_speed + sample.squared_swing);
}

/// A fast block would move far in a whole step against the thinnest of itself and its neighbours: at its
/// present speed, or at that of the planned motion. A kick that stops a block makes it no slow one.
template <int D>
bool ContinuousCollision<D>::is_fast(std::size_t i) const {
  const double calm =
      integrator_.duration() / clock_.time_step() * contacts_.neighbors().safe_displacement(i);
  return contacts_.neighbors().announced_motion(i) > calm ||
         integrator_.duration() * (blocks_.velocity[i].norm() + blocks_.swing(i)) > calm;
}

/// Most worlds are seen at once to be slow: the fastest block of all against the thinnest.
template <int D>
bool ContinuousCollision<D>::any() const {
  const double calm_speed = contacts_.neighbors().min_safe_displacement() / clock_.time_step();
  if (integrator_.longest_motion() < integrator_.duration() * calm_speed &&
      fastest_squared_ < calm_speed * calm_speed)
    return false;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (is_fast(i)) return true;
  }
  return false;
}

/// The motion that is planned.
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

/// The motion that has just been made, worked out from its end back to its start. In space the block is taken
/// to have turned at its last spin all along. Time runs on as in the motion.
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

/// Where they touched at the start already but for rounding, the contact stays as it is; and in a motion that
/// is short against the thinner block the pair that kept them apart decides as well as time does.
template <int D>
void ContinuousCollision<D>::find_entrance(Candidate<D>& pair, double made, int worker) {
  if (made * blocks_.speed_between(pair.a, pair.b) <= short_share * blocks_.thinner(pair.a, pair.b)) return;
  const Impact<D> impact =
      time_of_impact(blocks_.own_outline(pair.a), made_sweep(std::size_t(pair.a), made),
                     blocks_.own_outline(pair.b), made_sweep(std::size_t(pair.b), made), room_of(worker));
  if (impact.state != Impact<D>::touches) return;
  if (impact.time * made * blocks_.speed_between(pair.a, pair.b) <= contacts_.rounding_of_touch(pair)) return;
  pair.witness = witness_of(impact);
  pair.witness.state = PairCache<D>::touching;
}

/// The part of the planned motion that a pair may make at once. Where it meets in that part, it is told
/// through what.
template <int D>
double ContinuousCollision<D>::safe_fraction_of(Candidate<D>& pair, double& stable_duration) {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Sweep<D> of_a = predicted_sweep(a), of_b = predicted_sweep(b);
  const auto swing_by = [&](const Sweep<D>& sweep, std::size_t i) {
    return blocks_.radius[i] * (sweep.turn.norm() + sweep.stretch.norm());
  };
  const double planned = (of_b.way - of_a.way).norm() + swing_by(of_a, a) + swing_by(of_b, b);
  const double motion = std::max(planned, integrator_.duration() * blocks_.speed_between(pair.a, pair.b));
  const double thickness = blocks_.thinner(pair.a, pair.b);
  if (motion <= integrator_.duration() / clock_.time_step() * safe_thickness_fraction * thickness) return 1;
  pair_ = {pair.a, pair.b, motion / integrator_.duration(), thickness,
           safe_thickness_fraction * thickness * integrator_.duration() / motion};
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
  }
  if (stable_duration == 0) stable_duration = model_.settings.safety * stable_step_.bound();
  const double calm = safe_thickness_fraction * thickness / motion,
               stable = stable_duration / integrator_.duration();
  if (calm >= 1 && stable >= 1) return 1;
  // Where springs would drive the motion out of hand, what they do shows in a stable one only.
  const double at_once = 0.5 * (stable < 1 ? stable : calm);
  return std::max(time_of_touch - at_once, at_once);
}

template <int D>
double ContinuousCollision<D>::safe_fraction() {
  double part = 1;
  double stable_duration = 0;  // not known: it costs a look at all contacts
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
