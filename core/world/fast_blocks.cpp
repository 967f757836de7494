#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/pair.h"
#include "narrow_phase/time_of_impact.h"
#include "world/world.h"

// A step in which all pairs move little against the thinner of their blocks is one motion. Where one does
// not, its time of impact tells how far the motion may go: until just before the first touch, and from there
// on by small shares of the thickness, and stable ones, for as long as the two are fast in touch. What is
// left of the step comes after that, by the same rule. The pair that is first in time is the one through
// which blocks meet: when detection finds the contact it is remembered as what kept them apart. A world that
// shall not divide its steps refuses one that it would have to.

namespace halfspace {
namespace {

/// No motion is a smaller part of a step.
constexpr double least_part = 0x1p-24;

/// Of the thickness of the thinner block: in a motion that is shorter than this no two sides close in turn.
constexpr double short_share = 0x1p-8;

PairMemory<2> memory_of(const Impact<2>& impact) { return {PairMemory<2>::separated, impact.pair}; }
PairMemory<3> memory_of(const Impact<3>& impact) {
  return {PairMemory<3>::separated, impact.pair, impact.normal};
}

}  // namespace

/// How fast the points of a block move at most beside its centroid, now.
template <int D>
double World<D>::swing(std::size_t i) const {
  return blocks_.radius[i] *
         (blocks_.is_affine(i) ? blocks_.deformation(i).rate.norm() : blocks_.spin[i].norm());
}

template <int D>
double World<D>::thinner(const Candidate<D>& pair) const {
  return std::min(blocks_.strained_thickness(std::size_t(pair.a)),
                  blocks_.strained_thickness(std::size_t(pair.b)));
}

/// At most: of any point of one against any of the other, now.
template <int D>
double World<D>::speed_between(const Candidate<D>& pair) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  return (blocks_.velocity[b] - blocks_.velocity[a]).norm() + swing(a) + swing(b);
}

/// In which no listed pair is fast, at present speeds.
template <int D>
double World<D>::calm_time_step() const {
  double calm = HUGE_VAL;
  for (const Candidate<D>& pair : candidates_.pairs())
    calm = std::min(calm, calm_share * thinner(pair) / speed_between(pair));
  return calm;
}

/// Bounds the speed of all points by (x + y)^2 <= 2 (x^2 + y^2), with room for rounding. Boundaries that move
/// are not among them: they are as fast in their planned motion.
template <int D>
void World<D>::note_speeds(const Stock& stock) {
  peak_speed_ = std::max(peak_speed_, std::sqrt(stock.squared_speed));
  fastest_squared_ = 2.001 * (stock.squared_speed + stock.squared_swing);
}

/// In a whole step it would move far against the thinnest of itself and its neighbours: at its present speed,
/// or at that of the planned motion. A kick that stops a block makes it no slow one.
template <int D>
bool World<D>::is_fast(std::size_t i) const {
  const double calm = duration_ / time_step_ * candidates_.calm_motion(i);
  return candidates_.planned_motion(i) > calm || duration_ * (blocks_.velocity[i].norm() + swing(i)) > calm;
}

/// Most worlds are seen at once to be slow: the fastest block of all against the thinnest.
template <int D>
bool World<D>::any_fast() const {
  const double calm_speed = candidates_.least_calm_motion() / time_step_;
  if (longest_motion_ < duration_ * calm_speed && fastest_squared_ < calm_speed * calm_speed) return false;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (is_fast(i)) return true;
  }
  return false;
}

/// Of the motion that is planned.
template <int D>
Sweep<D> World<D>::planned_sweep(std::size_t i) const {
  Sweep<D> sweep;
  sweep.position = blocks_.position[i];
  sweep.gradient = blocks_.gradient(i);
  if (blocks_.kind[i] == BlockKind::fixed) return sweep;
  Vector<D> velocity = blocks_.velocity[i];
  if (blocks_.moves_freely(i)) velocity += 0.5 * duration_ * acceleration_[i];
  sweep.way = duration_ * velocity;
  if (blocks_.is_affine(i)) {
    const Deformation<D>& deformation = blocks_.deformation(i);
    sweep.stretch = duration_ * (deformation.rate + 0.5 * duration_ * deformation.acceleration);
  } else {
    sweep.turn = next_rotation_[i].turn_since(blocks_.rotation[i]);
  }
  return sweep;
}

/// The motion that has just been made, worked out from its end back to its start. In space the block is taken
/// to have turned at its last spin all along. Time runs on as in the motion.
template <int D>
Sweep<D> World<D>::made_sweep(std::size_t i) const {
  Sweep<D> sweep;
  sweep.position = blocks_.position[i];
  sweep.gradient = blocks_.gradient(i);
  if (blocks_.kind[i] == BlockKind::fixed) return sweep;
  sweep.way = made_ * blocks_.velocity[i];
  sweep.position -= sweep.way;
  if (blocks_.is_affine(i)) {
    sweep.stretch = made_ * blocks_.deformation(i).rate;
    sweep.gradient -= sweep.stretch;
  } else {
    sweep.turn = made_ * blocks_.spin[i];
    sweep.gradient = blocks_.rotation[i].turned_by(-sweep.turn).tensor();
  }
  return sweep;
}

/// Two blocks have met in the motion just made. Of the pairs that kept them apart at its start the last to
/// close is the one through which they met, also where others are less deep by now: their contact is
/// described there. Where they touched at the start already but for rounding, it stays as it is; and in a
/// motion that is short against the thinner block the pair that kept them apart decides as well as time does.
template <int D>
void World<D>::describe_entrance(Candidate<D>& pair, Contact<D>& contact) {
  if (made_ * speed_between(pair) <= short_share * thinner(pair)) return;
  const Impact<D> impact =
      time_of_impact(blocks_.own_outline(pair.a), made_sweep(std::size_t(pair.a)),
                     blocks_.own_outline(pair.b), made_sweep(std::size_t(pair.b)), impact_room_.data());
  if (impact.state != Impact<D>::touches) return;
  if (impact.time * made_ * speed_between(pair) <= rounding_of_touch(pair)) return;
  pair.memory = memory_of(impact);
  pair.memory.state = PairMemory<D>::touching;
  const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
  describe_contact<D>(at.a, at.b, at.to_b, pair.memory, settings_.detect, contact);
}

/// The part of the planned motion that a pair may make at once. Where it meets in that part, it is told
/// through what.
template <int D>
double World<D>::calm_part_of(Candidate<D>& pair, double& stable_duration) {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Sweep<D> of_a = planned_sweep(a), of_b = planned_sweep(b);
  const auto swing_by = [&](const Sweep<D>& sweep, std::size_t i) {
    return blocks_.radius[i] * (sweep.turn.norm() + sweep.stretch.norm());
  };
  const double planned = (of_b.way - of_a.way).norm() + swing_by(of_a, a) + swing_by(of_b, b);
  const double motion = std::max(planned, duration_ * speed_between(pair));
  const double thickness = thinner(pair);
  if (motion <= duration_ / time_step_ * calm_share * thickness) return 1;
  fast_pair_ = {pair.a, pair.b, motion / duration_, thickness, calm_share * thickness * duration_ / motion};
  double time_of_touch = 0;
  if (touching(pair.memory)) {
    deepest_stop_ = std::max(deepest_stop_, stop_of(pair));
  } else {
    const Impact<D> impact = time_of_impact(blocks_.own_outline(pair.a), of_a, blocks_.own_outline(pair.b),
                                            of_b, impact_room_.data());
    if (impact.state == Impact<D>::never) return 1;
    if (impact.state == Impact<D>::touches) {
      time_of_touch = impact.time;
      pair.memory = memory_of(impact);
    }
  }
  if (stable_duration == 0) stable_duration = settings_.safety * stable_time_step();
  const double calm = calm_share * thickness / motion, stable = stable_duration / duration_;
  if (calm >= 1 && stable >= 1) return 1;
  // Where springs would drive the motion out of hand, what they do shows in a stable one only.
  const double at_once = 0.5 * (stable < 1 ? stable : calm);
  return std::max(time_of_touch - at_once, at_once);
}

/// The part of the planned motion that all pairs may make at once.
template <int D>
double World<D>::calm_part() {
  double part = 1;
  double stable_duration = 0;  // not known: it costs a look at all contacts
  FastPair first = fast_pair_;
  for (Candidate<D>& pair : candidates_.pairs()) {
    if (!is_fast(std::size_t(pair.a)) && !is_fast(std::size_t(pair.b))) continue;
    const double of_pair = calm_part_of(pair, stable_duration);
    if (of_pair >= part) continue;
    part = of_pair;
    first = fast_pair_;
    if (settings_.fast_blocks == FastBlocks::refuse) break;
  }
  fast_pair_ = first;
  return part;
}

/// Shortens the planned motion until it is one that can be made at once: no block turns by more than an angle
/// whose arc is as long as its radius, and no fast pair enters deep.
template <int D>
StepResult World<D>::divide() {
  for (;;) {
    double part = 1;
    if (most_turned_ > most_turn) {
      part = 0.9 * most_turn / most_turned_;
    } else if (any_fast()) {
      part = calm_part();
      if (part < 1 && settings_.fast_blocks == FastBlocks::refuse) return StepResult::too_fast;
    }
    if (part >= 1) return StepResult::ok;
    if (!(part * duration_ >= least_part * time_step_)) return StepResult::unstable;
    if (!plan_motion(part * duration_)) return StepResult::unstable;
  }
}

/// The mean area, in the plane the mean width, that a block turns to another.
template <int D>
double World<D>::section(std::size_t i) const {
  const double volume = blocks_.mass[i] / density(blocks_.material[i]);
  return volume / blocks_.strained_thickness(i);
}

/// Force per depth of two blocks whose faces meet squarely.
template <int D>
double World<D>::stiffness_between(const Candidate<D>& pair) const {
  const SpringLaw& law = law_of(pair);
  if (law.stiffness_kind == StiffnessKind::per_contact) return law.normal_stiffness;
  const double area = std::min(section(std::size_t(pair.a)), section(std::size_t(pair.b)));
  return area * (law.is_potential() ? 2 * law.normal_stiffness / potential_length() : law.normal_stiffness);
}

/// The contact where two blocks touch or, apart, are nearest.
template <int D>
Contact<D> World<D>::nearest_of(const Candidate<D>& pair) const {
  Contact<D> contact;
  if (touching(pair.memory)) {
    describe(pair, contact);
  } else {
    const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
    PotentialPair<D> apart =
        initial_pair(at.a, at.b, at.to_b, memory_of(find_largest_separation(at.a, at.b, at.to_b)));
    describe_contact(at.a, at.b, at.to_b, apart, settings_.detect, contact);
  }
  return contact;
}

/// The velocity of a point of a block, at a place seen from its centroid.
template <int D>
Vector<D> World<D>::velocity_at(std::size_t i, const Vector<D>& arm) const {
  if (blocks_.is_affine(i)) return blocks_.velocity[i] + blocks_.deformation(i).velocity_gradient() * arm;
  return blocks_.velocity[i] + swept(blocks_.spin[i], arm);
}

/// How deep the springs of a pair let it come that approaches at such a speed and lies so deep already, over
/// the thickness of the thinner one.
template <int D>
double World<D>::stop_from(const Candidate<D>& pair, double speed, double depth) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const double way = speed > 0 ? speed * std::sqrt(reduced_mass(a, b) / stiffness_between(pair)) : 0;
  const double of_way = way / thinner(pair), of_depth = std::max(depth, 0.0) / thinner(pair);
  // Not by the C library's hypot, whose last bit is the machine's; springs next to nothing let all through.
  return std::min(std::sqrt(of_way * of_way + of_depth * of_depth), std::numeric_limits<double>::max());
}

/// The same from where the pair touches or is nearest, at the speed at which it approaches there.
template <int D>
double World<D>::stop_of(const Candidate<D>& pair) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Contact<D> contact = nearest_of(pair);
  const Vector<D> from_a = middle_of(contact), from_b = from_a - (blocks_.position[b] - blocks_.position[a]);
  const double speed = contact.normal.dot(velocity_at(a, from_a) - velocity_at(b, from_b));
  return stop_from(pair, speed, -contact.gap);
}

/// A bound without a close look, but for how deep the pair lies.
template <int D>
double World<D>::most_of_stop(const Candidate<D>& pair) const {
  return stop_from(pair, speed_between(pair), 0);
}

/// Notes how deep springs will let two blocks come that were apart and touch now.
template <int D>
void World<D>::note_meeting(const Candidate<D>& pair) {
  if (most_of_stop(pair) > deepest_stop_) deepest_stop_ = std::max(deepest_stop_, stop_of(pair));
}

template <int D>
double World<D>::deepest_stop() const {
  double deepest = deepest_stop_;
  for (const Candidate<D>& pair : candidates_.pairs()) {
    if (touching(pair.memory) || most_of_stop(pair) > deepest) deepest = std::max(deepest, stop_of(pair));
  }
  return deepest;
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
