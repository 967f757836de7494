#include "world/reaction.h"

#include <cmath>

namespace halfspace {
namespace {

/// Changes that are smaller than this share of the velocities at hand are none.
constexpr double smallest_change = 1e-8;

constexpr int most_rounds = 1000;

/// Corners of both blocks at faces of the other one are more contacts than there are ways to move. Where they
/// do not quite want the same, by rounding and by turns within the motion, changes go on for ever: rounds end
/// when so many have not made them smaller by a thousandth.
constexpr int most_idle_rounds = 48;

/// The impulse of a contact that stops it, if all others stay as they are: its normal part first, then what
/// shear is left of that. A rigid block at whose side it lies turns, so that both depend on each other.
template <int D>
Vector<D> stopping_impulse(const Reaction<D>& at, const Vector<D>& velocity) {
  const double before = at.impulse.dot(at.normal), opening = velocity.dot(at.normal);
  const double normal = std::max(before - opening / at.normal_mobility, -at.most_tension);
  const double most = at.most_cohesion + at.tan_friction * std::max(normal, 0.0);
  if (most == 0) return normal * at.normal;
  const Vector<D> left = velocity + (normal - before) * at.normal_response;
  const Vector<D> across = left - left.dot(at.normal) * at.normal;
  Vector<D> shear = at.impulse - before * at.normal - across / at.shear_mobility;
  const double wanted = shear.norm();
  if (wanted > most) shear *= most / wanted;
  return normal * at.normal + shear;
}

}  // namespace

template <int D>
bool Reaction<D>::fails(const Vector<D>& left) const {
  constexpr double little = 1e-6;
  const double along = impulse.dot(normal), across = (impulse - along * normal).norm();
  const double opening = left.dot(normal), slip = (left - opening * normal).norm();
  const double most = most_cohesion + tan_friction * std::max(along, 0.0);
  const double noise = little * normal_mobility * impulse.norm();
  return (along <= -(1 - little) * most_tension && opening > noise) ||
         (across >= (1 - little) * most && slip > noise);
}

template <int D>
int find_impulses(std::span<Reaction<D>> reactions, Kicks<D>& kicks) {
  double fastest = 0, least = HUGE_VAL;
  int least_in = 0;
  for (const Reaction<D>& at : reactions) {
    kicks.add(at.of_a, at.impulse);
    kicks.add(at.of_b, -at.impulse);
    fastest = std::max(fastest, at.impulse.norm() * at.normal_mobility);
  }
  for (int round = 1; round <= most_rounds; ++round) {
    double changed = 0;
    const auto visit = [&](Reaction<D>& at) {
      const Vector<D> velocity = at.velocity + kicks.at(at.of_a) - kicks.at(at.of_b);
      const Vector<D> impulse = stopping_impulse(at, velocity);
      const Vector<D> change = impulse - at.impulse;
      if (change.isZero(0)) return;
      at.impulse = impulse;
      kicks.add(at.of_a, change);
      kicks.add(at.of_b, -change);
      changed = std::max(changed, change.norm() * at.normal_mobility);
    };
    if (round % 2 == 1) {
      for (auto at = reactions.begin(); at != reactions.end(); ++at) visit(*at);
    } else {
      for (auto at = reactions.rbegin(); at != reactions.rend(); ++at) visit(*at);
    }
    fastest = std::max(fastest, changed);
    if (changed <= smallest_change * fastest) return round;
    if (changed <= 0.999 * least) {
      least = changed;
      least_in = round;
    } else if (round - least_in >= most_idle_rounds) {
      return round;
    }
  }
  return most_rounds;
}

template struct Reaction<2>;
template struct Reaction<3>;
template int find_impulses(std::span<Reaction<2>>, Kicks<2>&);
template int find_impulses(std::span<Reaction<3>>, Kicks<3>&);

}  // namespace halfspace
