#include "world/contacts/entrance.h"

#include <algorithm>

#include "narrow_phase/pair.h"
#include "narrow_phase/space/potential_pairs.h"

namespace halfspace {
namespace {

/// Surfaces are flush when they differ by at most this fraction of the smaller radius: files round their
/// coordinates, and supports deflect.
constexpr double flush = 1e-3;

/// Minimum cosine of the angle between the lift and the normal of an entry face that it reveals.
constexpr double least_cosine = 0.5;

}  // namespace

/// Pairs that meet in this detection do not count as third blocks, so the order of pairs does not matter.
template <int D>
bool Entrances<D>::has_met(std::size_t k, std::span<const PairSums> found) const {
  const std::size_t chunk = k / pairs_per_chunk;
  const auto met = contacts_.met_in(chunk, found[chunk]);
  return std::binary_search(met.begin(), met.end(), k);
}

/// Lifts a block out of a third. Returns the pair along the lift if it leaves the two flush or apart, else
/// the pair of the largest gap if that separates them, else none.
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

/// A long floor touches blocks that are far from the one that it meets. Of those that touch a fixed or
/// prescribed block, only neighbours of the met one count: shares know no others.
template <int D>
typename Entrances<D>::Way Entrances<D>::free_way(const Candidate<D>& met,
                                                  std::span<const PairSums> found) const {
  const NeighborList<D>& neighbors = contacts_.neighbors();
  Way best;
  for (const std::int32_t block : {met.a, met.b}) {
    const std::int32_t other = met.a + met.b - block;
    const bool reaches_far = !model_.blocks.moves_freely(std::size_t(block));
    neighbors.for_each_pair_of(block, [&](std::size_t k) {
      const Candidate<D>& known = neighbors.pairs()[k];
      if (!contacts_.was_in_contact(known) || has_met(k, found)) return;
      if (reaches_far && !neighbors.pair_between(known.a + known.b - block, other)) return;
      const Way way = way_beside(met, block, known);
      if (way.gap > best.gap) best = way;
    });
  }
  return best;
}

template <int D>
bool Entrances<D>::find(std::size_t k, std::span<const PairSums> found) {
  contacts_.neighbors().index_pairs();
  Candidate<D>& met = contacts_.neighbors().pairs()[k];
  if (met.bonded) return false;
  const Way way = free_way(met, found);
  if (!(way.gap > -HUGE_VAL)) return false;
  met.witness.pair = way.pair;
  return true;
}

template <int D>
void Entrances<D>::describe(std::size_t k, Contact<D>& contact) {
  Candidate<D>& met = contacts_.neighbors().pairs()[k];
  const PlacedBlocks<D> at = model_.blocks.placed(met.a, met.b);
  describe_contact<D>(at.a, at.b, at.to_b, met.witness, model_.settings.detect, contact);
}

template class Entrances<2>;
template class Entrances<3>;

}  // namespace halfspace
