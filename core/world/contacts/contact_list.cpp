#include "world/contacts/contact_list.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "geometry/tolerances.h"
#include "narrow_phase/pair.h"

namespace halfspace {
namespace {

/// Bound of the rounding error of a gap, from the largest distances of both blocks from the origin. A corner
/// rotated by the caller has an error of up to 3 sqrt(2) roundings of that distance; two corners of a face
/// and one vertex count. Centroids, normal and gap add fewer than four more.
double rounding_of_touch(double reach_of_a, double reach_of_b) {
  constexpr double roundings = 3 * 3 * 1.41421356237309505 + 4;
  constexpr double rounding = 0.5 * machine_epsilon;
  return roundings * rounding * std::max(reach_of_a, reach_of_b);
}

}  // namespace

template <int D>
double ContactList<D>::rounding_of_touch(const Candidate<D>& pair) const {
  const auto reach = [&](std::int32_t block) {
    return model_.blocks.position[std::size_t(block)].norm() + model_.blocks.radius[std::size_t(block)];
  };
  return halfspace::rounding_of_touch(reach(pair.a), reach(pair.b));
}

template <int D>
double ContactList<D>::release_shear(std::size_t k) {
  if (neighbors_.shear().empty()) return 0;
  return energy_of(std::exchange(neighbors_.shear()[k], {}));
}

template <int D>
template <StiffnessKind kind>
Found ContactList<D>::find(std::size_t k, Contact<D>& contact, PairSums& sums) {
  Candidate<D>& pair = neighbors_.pairs()[k];
  PairCache<D>& witness = pair.witness;
  const auto [a, b, to_b] = model_.blocks.placed(pair.a, pair.b);
  const typename PairCache<D>::State before = witness.state;
  bool has_met = false;
  const bool describes = is_described<kind>(pair);
  if (describes ? find_contact(a, b, to_b, model_.settings.detect, witness, contact)
                : touch(a, b, to_b, witness)) {
    if (!describes && kind == StiffnessKind::potential) witness.state = PairCache<D>::overlapping;
    has_met = before < PairCache<D>::touching;
  } else {
    if (!pair.bonded) {
      if (before >= PairCache<D>::touching) sums.released += release_shear(k);
      if (before == PairCache<D>::unknown && refresh(a, b, to_b, witness) <= rounding_of_touch(pair))
        witness.state = PairCache<D>::unknown;
      return Found::apart;
    }
    witness.pair = initial_pair(a, b, to_b, witness);  // two vertices define no contact plane
    describe_contact<D>(a, b, to_b, witness, model_.settings.detect, contact);
  }
  if (before == PairCache<D>::unknown && contact.gap >= -rounding_of_touch(pair)) {
    // Stacked flush: the first detection uses strict inclusion (eq. 11). Rounding alone would select the
    // pair, so the pair of minimum depth becomes the initial one once the blocks overlap.
    witness.state = PairCache<D>::unknown;
    if (!pair.bonded) return Found::apart;
  }
  return has_met ? Found::met : Found::in_contact;
}

template <int D>
void ContactList<D>::put_in_order(std::size_t first_of_chunk, const PairSums& sums) {
  const auto sort = [&](Array<std::uint32_t>& pairs, std::uint32_t count) {
    const auto begin = pairs.begin() + std::ptrdiff_t(first_of_chunk);
    std::sort(begin, begin + count);
  };
  sort(found_in_chunks_, sums.contacts);
  sort(met_in_chunks_, sums.met);
}

template <int D>
void ContactList<D>::end(std::span<const PairSums> chunks) {
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const auto first = found_in_chunks_.begin() + std::ptrdiff_t(c * pairs_per_chunk);
    touching_.insert(touching_.end(), first, first + chunks[c].contacts);
    peak_overlap_ = std::max(peak_overlap_, chunks[c].peak_overlap);
  }
  found_ = true;
}

template <int D>
std::span<const std::uint32_t> ContactList<D>::touching_in(std::size_t chunk) const {
  const std::size_t begin = chunk * pairs_per_chunk;
  const auto first = std::lower_bound(touching_.begin(), touching_.end(), begin);
  return {first, std::lower_bound(first, touching_.end(), begin + pairs_per_chunk)};
}

template <int D>
void ContactList<D>::describe(const Candidate<D>& pair, Contact<D>& contact) const {
  const PlacedBlocks<D> at = model_.blocks.placed(pair.a, pair.b);
  PotentialPair<D> found = pair_in_contact(at.a, at.b, at.to_b, pair.witness);
  describe_contact(at.a, at.b, at.to_b, found, model_.settings.detect, contact);
}

template <int D>
void ContactList<D>::add_fresh(std::int32_t slot, std::size_t slots) {
  new_blocks_.resize(slots);
  new_blocks_[std::size_t(slot)] = true;
  any_fresh_ = true;
}

/// Contacts are intact if they exist when the first step of a block begins (Wang et al. 2021, section 2.5).
template <int D>
void ContactList<D>::bond_fresh() {
  const Blocks<D>& blocks = model_.blocks;
  new_blocks_.resize(blocks.slot_count());
  for (Candidate<D>& pair : neighbors_.pairs()) {
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    const bool is_fresh = new_blocks_[a] || new_blocks_[b];
    if (!is_fresh || !model_.law_of(pair).bonds()) continue;
    const PlacedBlocks<D> at = blocks.placed(pair.a, pair.b);
    Contact<D> contact;
    pair.witness.pair = initial_pair(at.a, at.b, at.to_b, pair.witness);
    describe_contact(at.a, at.b, at.to_b, pair.witness.pair, model_.settings.detect, contact);
    pair.bonded = std::abs(contact.gap) <= touch_reach * std::min(blocks.radius[a], blocks.radius[b]);
  }
}

template <int D>
bool ContactList<D>::bonds(std::int32_t a, std::int32_t b) const {
  if (!model_.law_between(std::size_t(a), std::size_t(b)).bonds()) return false;
  const std::optional<std::size_t> pair = neighbors_.pair_between(a, b);
  return pair && neighbors_.pairs()[*pair].bonded;
}

template <int D>
void ContactList<D>::add_shear(std::int32_t a, std::int32_t b, const Vector<D>& force,
                               const Vector<D>& normal) {
  const std::optional<std::size_t> pair = neighbors_.pair_between(a, b);
  if (!pair || neighbors_.shear().empty() || !model_.law_of(neighbors_.pairs()[*pair]).resists_shear())
    return;
  ShearSpring<D>& spring = neighbors_.shear()[*pair];
  const Shear<D> together = spring.force + halfspace::shear_of(force, normal);
  remember(spring, together, preloaded, normal);
}

template <int D>
void ContactList<D>::end_bonds_without_spring() {
  if (!model_.materials.laws().any([](const ContactLaw& law) { return law.has_no_spring() && law.bonds(); }))
    return;
  for (Candidate<D>& pair : neighbors_.pairs()) {
    if (pair.bonded && model_.law_of(pair).has_no_spring()) pair.bonded = 0;
  }
}

template <int D>
void ContactList<D>::end_fresh() {
  new_blocks_.resize(model_.blocks.slot_count());
  std::fill(new_blocks_.begin(), new_blocks_.end(), std::uint8_t(0));
  any_fresh_ = false;
}

template <int D>
bool ContactList<D>::names_pairs() const {
  return std::is_sorted(touching_.begin(), touching_.end(), std::less_equal<>()) &&
         (touching_.empty() || touching_.back() < neighbors_.pairs().size());
}

/// Contacts are sorted as their pairs are.
template <int D>
std::optional<std::size_t> ContactList<D>::contact_between(std::int32_t a, std::int32_t b) const {
  const std::pair wanted(std::min(a, b), std::max(a, b));
  const auto blocks_of = [&](std::uint32_t k) {
    const Candidate<D>& pair = neighbors_.pairs()[k];
    return std::pair(pair.a, pair.b);
  };
  const auto found =
      std::lower_bound(touching_.begin(), touching_.end(), wanted,
                       [&](std::uint32_t k, const auto& blocks) { return blocks_of(k) < blocks; });
  if (found == touching_.end() || blocks_of(*found) != wanted) return {};
  return std::size_t(found - touching_.begin());
}

template <int D>
bool ContactList<D>::is_consistent() const {
  const std::size_t slots = model_.blocks.slot_count();
  if (!neighbors_.is_consistent(model_.blocks) || !is_nonnegative(peak_overlap_)) return false;
  if (new_blocks_.size() > slots || (any_fresh_ && new_blocks_.size() != slots)) return false;
  if (found_ && neighbors_.list_length() != slots) return false;
  const Array<Candidate<D>>& pairs = neighbors_.pairs();
  const auto wants_spring = [&](const Candidate<D>& pair) { return model_.law_of(pair).resists_shear(); };
  const bool is_list_in_use = found_ || !neighbors_.needs_rebuild();
  if (is_list_in_use && !neighbors_.has_springs() && std::any_of(pairs.begin(), pairs.end(), wants_spring))
    return false;
  return names_pairs() && all(touching_, [&](std::uint32_t k) { return has_a_plane(pairs[k].witness.pair); });
}

template class ContactList<2>;
template class ContactList<3>;

#define HALFSPACE_FIND(KIND)                                                                     \
  template Found ContactList<2>::find<StiffnessKind::KIND>(std::size_t, Contact<2>&, PairSums&); \
  template Found ContactList<3>::find<StiffnessKind::KIND>(std::size_t, Contact<3>&, PairSums&);
HALFSPACE_SPRING_KINDS(HALFSPACE_FIND)
#undef HALFSPACE_FIND

}  // namespace halfspace
