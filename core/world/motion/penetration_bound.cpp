#include "world/motion/penetration_bound.h"

#include <cmath>
#include <limits>

#include "narrow_phase/pair.h"

namespace halfspace {

/// The mean cross-section of a block: area, in 2D width.
template <int D>
double PenetrationBound<D>::section(std::size_t i) const {
  const double volume = blocks_.mass[i] / model_.materials.density(blocks_.material[i]);
  return volume / blocks_.strained_thickness(i);
}

/// Force per penetration of two blocks in face contact, N/m.
template <int D>
double PenetrationBound<D>::stiffness_between(const Candidate<D>& pair) const {
  const double area = std::min(section(std::size_t(pair.a)), section(std::size_t(pair.b)));
  return model_.law_of(pair).face_stiffness(area, model_.potential_length());
}

/// The contact of two blocks, at their nearest features if they are separated.
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

/// The ratio of a pair that approaches at `speed` and overlaps by `depth`.
template <int D>
double PenetrationBound<D>::from(const Candidate<D>& pair, double speed, double depth) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const double way = speed > 0 ? speed * std::sqrt(blocks_.reduced_mass(a, b) / stiffness_between(pair)) : 0;
  const double thickness = blocks_.thinner(pair.a, pair.b);
  const double of_way = way / thickness, of_depth = std::max(depth, 0.0) / thickness;
  // Not std::hypot, whose last bit depends on the machine. The limit keeps the ratio of very soft springs
  // finite.
  return std::min(std::sqrt(of_way * of_way + of_depth * of_depth), std::numeric_limits<double>::max());
}

/// The ratio at the contact or the nearest features of a pair, with the approach speed there.
template <int D>
double PenetrationBound<D>::of(const Candidate<D>& pair) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Contact<D> contact = nearest_of(pair);
  const Vector<D> from_a = middle_of(contact), from_b = from_a - (blocks_.position[b] - blocks_.position[a]);
  const double speed = contact.normal.dot(blocks_.velocity_at(a, from_a) - blocks_.velocity_at(b, from_b));
  return from(pair, speed, -contact.gap);
}

/// A bound of the ratio by the speed alone, without the depth.
template <int D>
double PenetrationBound<D>::max_of(const Candidate<D>& pair) const {
  return from(pair, blocks_.speed_between(pair.a, pair.b), 0);
}

template <int D>
double PenetrationBound<D>::deepest() const {
  double deepest = deepest_;
  for (const Candidate<D>& pair : contacts_.neighbors().pairs()) {
    if (model_.law_of(pair).has_no_spring()) continue;
    if (touching(pair.witness) || max_of(pair) > deepest) deepest = std::max(deepest, of(pair));
  }
  return deepest;
}

template class PenetrationBound<2>;
template class PenetrationBound<3>;

}  // namespace halfspace
