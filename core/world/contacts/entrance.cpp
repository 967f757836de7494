#include "world/contacts/entrance.h"

#include <algorithm>

#include "narrow_phase/pair.h"
#include "narrow_phase/space/potential_pairs.h"

namespace halfspace {
namespace {

/// Surfaces that differ by no more than this share of the smaller block's radius are flush: files round their
/// coordinates, and supports give way.
constexpr double flush = 1e-3;

/// A side that looks farther away from the lift than this does not keep blocks apart because of the lift.
constexpr double least_cosine = 0.5;

}  // namespace

/// Only contacts of before count, so that the order in which pairs are met is of no matter.
template <int D>
bool Entrances<D>::has_met(std::size_t k, std::span<const PairSums> found) const {
  const std::size_t chunk = k / pairs_per_chunk;
  const auto met = contacts_.met_in(chunk, found[chunk]);
  return std::binary_search(met.begin(), met.end(), k);
}

/// The pair of faces that look along the lift, where these are the outermost ones; or what keeps the blocks
/// apart when one of them is lifted out of a third.
template <int D>
typename Entrances<D>::Way Entrances<D>::way_beside(const Candidate<D>& met, std::int32_t lifted,
                                                    const Candidate<D>& known) const {
  Contact<D> contact;
  contacts_.describe(known, contact);
  // From the third block to the lifted one.
  const Vector<D> up = known.a == lifted ? Vector<D>(-contact.normal) : contact.normal;
  const double depth = std::max(-contact.gap, 0.0);
  const double sign = met.a == lifted ? -1 : 1;
  const Vector<D> normal = sign * up;
  PlacedBlocks<D> at = model_.blocks.placed(met.a, met.b);
  at.to_b += depth * normal;

  const double entrance_cosine = normal_of(at.a, at.b, met.witness.pair).dot(normal);
  const auto is_another_way = [&](const PotentialPair<D>& pair) {
    const double cosine = normal_of(at.a, at.b, pair).dot(normal);
    return cosine >= least_cosine && cosine > entrance_cosine;
  };
  PotentialPair<D> pair = pair_along(at.a, at.b, at.to_b, normal);
  const double radius =
      std::min(model_.blocks.radius[std::size_t(met.a)], model_.blocks.radius[std::size_t(met.b)]);
  const double gap = refresh(at.a, at.b, at.to_b, pair);
  if (gap >= -flush * radius && is_another_way(pair)) return {pair, gap};
  const Separation<D> apart = find_largest_separation(at.a, at.b, at.to_b);
  if (!(apart.gap > 0)) return {};
  pair = initial_pair(at.a, at.b, at.to_b, witness_of(apart));
  return is_another_way(pair) ? Way{pair, apart.gap} : Way{};
}

template <int D>
typename Entrances<D>::Way Entrances<D>::free_way(const Candidate<D>& met,
                                                  std::span<const PairSums> found) const {
  const NeighborList<D>& neighbors = contacts_.neighbors();
  Way best;
  for (const std::int32_t block : {met.a, met.b}) {
    neighbors.for_each_pair_of(block, [&](std::size_t k) {
      const Candidate<D>& known = neighbors.pairs()[k];
      if (!contacts_.was_in_contact(known) || has_met(k, found)) return;
      const Way way = way_beside(met, block, known);
      if (way.gap > best.gap) best = way;
    });
  }
  return best;
}

template <int D>
void Entrances<D>::describe(std::size_t k, std::span<const PairSums> found, Contact<D>& contact) {
  contacts_.neighbors().index_pairs();
  Candidate<D>& met = contacts_.neighbors().pairs()[k];
  if (!met.bonded) {
    const Way way = free_way(met, found);
    if (way.gap > -HUGE_VAL) met.witness.pair = way.pair;
  }
  const PlacedBlocks<D> at = model_.blocks.placed(met.a, met.b);
  describe_contact<D>(at.a, at.b, at.to_b, met.witness, model_.settings.detect, contact);
}

template class Entrances<2>;
template class Entrances<3>;

}  // namespace halfspace
