#include "world/contacts/entrance.h"

#include <algorithm>

#include "geometry/tolerances.h"
#include "narrow_phase/pair.h"
#include "narrow_phase/space/potential_pairs.h"

namespace halfspace {

/// From the third block to the lifted one.
template <int D>
typename Entrances<D>::Lift Entrances<D>::lift(const Candidate<D>& pair, std::int32_t lifted,
                                               const Candidate<D>& known) const {
  Contact<D> contact;
  contacts_.describe(known, contact);
  const Vector<D> up = known.a == lifted ? Vector<D>(-contact.normal) : contact.normal;
  const double sign = pair.a == lifted ? -1 : 1;
  return {sign * up, std::max(-contact.gap, 0.0), touched_before(known, contact.gap, contact.normal)};
}

/// The pair along the lift if it leaves the two blocks flush or apart, else the pair of the largest gap if
/// that separates them, else none.
template <int D>
typename Entrances<D>::Way Entrances<D>::way_along(const Candidate<D>& met, const PlacedBlocks<D>& at,
                                                   const Vector<D>& normal) const {
  const double entrance_cosine = normal_of(at.a, at.b, met.witness.pair).dot(normal);
  const auto is_another_way = [&](const PotentialPair<D>& pair) {
    const double cosine = normal_of(at.a, at.b, pair).dot(normal);
    return cosine >= revealed_cosine && cosine > entrance_cosine;
  };
  PotentialPair<D> pair = pair_along(at.a, at.b, at.to_b, normal);
  const double gap = refresh(at.a, at.b, at.to_b, pair);
  if (gap >= -nearly_flush * smaller_radius(met) && is_another_way(pair)) return {pair, gap};
  const Separation<D> apart = find_largest_separation(at.a, at.b, at.to_b);
  if (!(apart.gap > 0)) return {};
  pair = initial_pair(at.a, at.b, at.to_b, witness_of(apart));
  return is_another_way(pair) ? Way{pair, apart.gap} : Way{};
}

/// Did two blocks touch or overlap through a face before the last motion, by their translation? A face that
/// it has just crossed is the side of a joint.
template <int D>
bool Entrances<D>::touched_before(const Candidate<D>& pair, double gap, const Vector<D>& normal) const {
  const Blocks<D>& blocks = model_.blocks;
  const Vector<D> velocity = blocks.velocity[std::size_t(pair.b)] - blocks.velocity[std::size_t(pair.a)];
  return gap - made_ * normal.dot(velocity) <= contacts_.rounding_of_touch(pair);
}

/// A long floor touches blocks that are far from the one that it meets. Of those that touch a fixed or
/// prescribed block, only neighbours of the met one count: shares know no others.
template <int D>
void Entrances<D>::ask(std::uint32_t k) {
  NeighborList<D>& neighbors = contacts_.neighbors();
  neighbors.index_pairs();
  const Candidate<D>& met = neighbors.pairs()[k];
  if (met.bonded || model_.law_of(met).is_potential()) return;
  const PlacedBlocks<D> placed = model_.blocks.placed(met.a, met.b);
  Way best;
  for (const std::int32_t block : {met.a, met.b}) {
    const std::int32_t partner = met.a + met.b - block;
    const bool reaches_far = !model_.blocks.moves_freely(std::size_t(block));
    neighbors.for_each_pair_of(block, [&](std::size_t known_k) {
      const Candidate<D>& known = neighbors.pairs()[known_k];
      const std::int32_t third = known.a + known.b - block;
      if (third == partner || !contacts_.was_in_contact(known)) return;
      if (reaches_far && !neighbors.pair_between(third, partner)) return;
      const Lift lift_of_block = lift(met, block, known);
      if (!lift_of_block.is_older) return;
      PlacedBlocks<D> at = placed;
      at.to_b += lift_of_block.depth * lift_of_block.normal;
      Way way = way_along(met, at, lift_of_block.normal);
      if (!(way.gap > best.gap)) return;
      const double gap = refresh(placed.a, placed.b, placed.to_b, way.pair);
      if (touched_before(met, gap, normal_of(placed.a, placed.b, way.pair))) best = way;
    });
  }
  if (best.gap > -HUGE_VAL) answers_.push_back({k, best.pair});
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
