#include "world/motion/penetration_bound.h"

#include <cmath>
#include <limits>

#include "narrow_phase/pair.h"

namespace halfspace {

/// The mean area, in the plane the mean width, that a block turns to another.
template <int D>
double PenetrationBound<D>::section(std::size_t i) const {
  const double volume = blocks_.mass[i] / model_.materials.density(blocks_.material[i]);
  return volume / blocks_.strained_thickness(i);
}

/// Force per depth of two blocks whose faces meet squarely.
template <int D>
double PenetrationBound<D>::stiffness_between(const Candidate<D>& pair) const {
  const ContactLaw& law = model_.law_of(pair);
  if (law.stiffness_kind == StiffnessKind::per_contact) return law.normal_stiffness;
  const double area = std::min(section(std::size_t(pair.a)), section(std::size_t(pair.b)));
  return area *
         (law.is_potential() ? 2 * law.normal_stiffness / model_.potential_length() : law.normal_stiffness);
}

/// The contact where two blocks touch or, apart, are nearest.
template <int D>
Contact<D> PenetrationBound<D>::nearest_of(const Candidate<D>& pair) const {
  Contact<D> contact;
  if (touching(pair.witness)) {
    contacts_.describe(pair, contact);
  } else {
    const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
    PotentialPair<D> apart =
        initial_pair(at.a, at.b, at.to_b, witness_of(find_largest_separation(at.a, at.b, at.to_b)));
    describe_contact(at.a, at.b, at.to_b, apart, model_.settings.detect, contact);
  }
  return contact;
}

/// How deep the springs of a pair let it come that approaches at such a speed and lies so deep already, over
/// the thickness of the thinner one.
template <int D>
double PenetrationBound<D>::from(const Candidate<D>& pair, double speed, double depth) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const double way = speed > 0 ? speed * std::sqrt(blocks_.reduced_mass(a, b) / stiffness_between(pair)) : 0;
  const double thickness = blocks_.thinner(pair.a, pair.b);
  const double of_way = way / thickness, of_depth = std::max(depth, 0.0) / thickness;
  // Not by the C library's hypot, whose last bit is the machine's; springs next to nothing let all through.
  return std::min(std::sqrt(of_way * of_way + of_depth * of_depth), std::numeric_limits<double>::max());
}

/// A pair is looked at where it touches or is nearest, and at the speed at which it approaches there.
template <int D>
double PenetrationBound<D>::of(const Candidate<D>& pair) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Contact<D> contact = nearest_of(pair);
  const Vector<D> from_a = middle_of(contact), from_b = from_a - (blocks_.position[b] - blocks_.position[a]);
  const double speed = contact.normal.dot(blocks_.velocity_at(a, from_a) - blocks_.velocity_at(b, from_b));
  return from(pair, speed, -contact.gap);
}

/// A bound without a close look, but for how deep the pair lies.
template <int D>
double PenetrationBound<D>::most_of(const Candidate<D>& pair) const {
  return from(pair, blocks_.speed_between(pair.a, pair.b), 0);
}

template <int D>
double PenetrationBound<D>::deepest() const {
  double deepest = deepest_;
  for (const Candidate<D>& pair : contacts_.neighbors().pairs()) {
    if (model_.law_of(pair).has_no_spring()) continue;
    if (touching(pair.witness) || most_of(pair) > deepest) deepest = std::max(deepest, of(pair));
  }
  return deepest;
}

template class PenetrationBound<2>;
template class PenetrationBound<3>;

}  // namespace halfspace
