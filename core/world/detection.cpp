#include <algorithm>
#include <limits>

#include "geometry/deformed_outline.h"
#include "narrow_phase/pair.h"
#include "world/world.h"

namespace halfspace {
namespace {

/// Blocks that a joint has cut apart touch to rounding only: what lies nearer than this share of the smaller
/// one's radius was one face.
constexpr double bond_reach = 1e-6;

/// How far rounding alone lets blocks overlap, or stand apart, that were meant to touch: both reach up to so
/// far from the origin. A corner turned by hand is off by up to 3 sqrt(2) roundings of that, two from a face
/// and one from the vertex on it count, and less than four more come from the centroids, from which vertices
/// are measured, and from the normal and the gap.
double rounding_of_touch(double reach_of_a, double reach_of_b) {
  constexpr double roundings = 3 * 3 * 1.41421356237309505 + 4;
  constexpr double rounding = 0.5 * std::numeric_limits<double>::epsilon();
  return roundings * rounding * std::max(reach_of_a, reach_of_b);
}

}  // namespace

/// Intact contacts are those that are there when a block's first step begins (Wang et al. 2021, section 2.5).
template <int D>
void World<D>::make_bonds() {
  fresh_.resize(blocks_.slot_count());
  if (laws_.any([](const SpringLaw& law) { return law.bonds(); })) {
    detect();
    for (Candidate<D>& pair : candidates_.pairs()) {
      const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
      const bool is_fresh = fresh_[a] || fresh_[b];
      if (!is_fresh || !law_of(pair).bonds()) continue;
      const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
      Contact<D> contact;
      pair.memory.pair = initial_pair(at.a, at.b, at.to_b, pair.memory);
      describe_contact(at.a, at.b, at.to_b, pair.memory.pair, settings_.detect, contact);
      pair.bonded = std::abs(contact.gap) <= bond_reach * std::min(blocks_.radius[a], blocks_.radius[b]);
    }
    forget_contacts();  // bonded pairs count as such from now on
    edit();
  }
  std::fill(fresh_.begin(), fresh_.end(), std::uint8_t(0));
  any_fresh_ = false;
}

/// A contact that has ended gives up what its shear spring held.
template <int D>
void World<D>::release_shear(std::size_t candidate) {
  if (candidates_.shear().empty()) return;
  ShearSpring<D>& shear = candidates_.shear()[candidate];
  if (shear.energy > 0) ledger_.friction_loss += shear.energy;
  shear = {};
}

/// In space a description costs as much as a force by springs, and potentials read nothing of it. It is
/// wanted all the same when blocks are first seen, and when another law has bonded them. In the plane it is
/// cheap, and a pair has to be brought up to date on the way: there a description moves it on by one edge at
/// most.
template <int D>
bool World<D>::is_described(const Candidate<D>& pair) const {
  return D == 2 || !laws_.knows_potential() || pair.memory.state == PairMemory<D>::unknown || pair.bonded ||
         !law_of(pair).is_potential();
}

template <int D>
double World<D>::rounding_of_touch(const Candidate<D>& pair) const {
  const auto reach = [&](std::int32_t block) {
    return blocks_.position[std::size_t(block)].norm() + blocks_.radius[std::size_t(block)];
  };
  return halfspace::rounding_of_touch(reach(pair.a), reach(pair.b));
}

/// True when the candidate is in contact, or held together by its bond; then the contact is described, if
/// that is wanted.
template <int D>
bool World<D>::find_contact(std::size_t k, Contact<D>& contact) {
  Candidate<D>& pair = candidates_.pairs()[k];
  PairMemory<D>& memory = pair.memory;
  const auto [a, b, to_b] = blocks_.placed(pair.a, pair.b);
  const typename PairMemory<D>::State before = memory.state;

  const bool describes = is_described(pair);
  if (describes ? halfspace::find_contact(a, b, to_b, settings_.detect, memory, contact)
                : touch(a, b, to_b, memory)) {
    if (!describes) memory.state = PairMemory<D>::overlapping;
    if (before < PairMemory<D>::touching) {
      if (describes && made_ > 0) describe_entrance(pair, contact);
      note_meeting(pair);
    }
  } else {
    if (!pair.bonded) {
      if (before >= PairMemory<D>::touching) release_shear(k);
      if (before == PairMemory<D>::unknown && refresh(a, b, to_b, memory) <= rounding_of_touch(pair))
        memory.state = PairMemory<D>::unknown;
      return false;
    }
    memory.pair = initial_pair(a, b, to_b, memory);  // a contact has no two vertices
    describe_contact<D>(a, b, to_b, memory, settings_.detect, contact);
  }
  if (before == PairMemory<D>::unknown && contact.gap >= -rounding_of_touch(pair)) {
    // Neatly stacked: at first sight the strict form of inclusion holds (eq. 11). Which pair they touch
    // through rounding alone would decide, so the pair of least depth will be the initial one, once they
    // overlap.
    memory.state = PairMemory<D>::unknown;
    return pair.bonded;
  }
  return true;
}

/// A contact that is known to be one.
template <int D>
void World<D>::describe(const Candidate<D>& pair, Contact<D>& contact) const {
  const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
  PotentialPair<D> found = pair_in_contact(at.a, at.b, at.to_b, pair.memory);
  describe_contact(at.a, at.b, at.to_b, found, settings_.detect, contact);
}

template <int D>
Contact<D> World<D>::contact(std::size_t c) const {
  Contact<D> contact;
  describe(candidate_of(c), contact);
  return contact;
}

template <int D>
std::size_t World<D>::most_edges() const {
  int most = 0;
  for (std::size_t slot = 0; slot < blocks_.slot_count(); ++slot) {
    if (blocks_.lives(slot)) most = std::max(most, blocks_.outline(std::int32_t(slot)).edge_count());
  }
  return std::size_t(most);
}

/// How many doubles the largest block takes that is deformed.
template <int D>
std::size_t World<D>::most_components() const {
  std::size_t most = 0;
  for (std::size_t slot = 0; slot < blocks_.slot_count(); ++slot) {
    if (blocks_.lives(slot)) most = std::max(most, component_count(blocks_.own_outline(std::int32_t(slot))));
  }
  return most;
}

template <int D>
void World<D>::fit_rooms() {
  impact_room_.resize(2 * most_components());
  const bool is_damped = laws_.any([](const SpringLaw& law) { return law.is_damped(); });
  dashpot_load_.resize(is_damped ? blocks_.slot_count() : 0);
  if (!laws_.knows_potential()) return;
  potential_room_.reserve(most_edges());
  if constexpr (D == 3) candidates_.reserve_plans();
}

/// With room for a contact at every candidate: detection then asks for no memory. When there is none, nothing
/// has changed: the contacts known are still those of the list in use, and there is still room for all of it.
template <int D>
void World<D>::renew_candidates() {
  const bool with_shear = laws_.any([](const SpringLaw& law) { return law.resists_shear(); });
  candidates_.search_again(blocks_, settings_.skin, with_shear);
  refit(touching_, candidates_.room());
  refit(forces_, candidates_.room());
  fit_rooms();
  candidates_.renew(blocks_, with_shear);
  forget_contacts();
}

template <int D>
void World<D>::forget_contacts() {
  touching_.clear();
  forces_.clear();
  detected_ = false;
}

/// Potentials in space have no contact described, but at first sight.
template <int D>
void World<D>::remember_overlap(const Candidate<D>& pair, const Contact<D>& contact) {
  if (D == 2 || !laws_.knows_potential() || !law_of(pair).is_potential())
    peak_overlap_ = std::max(peak_overlap_, -contact.gap);
}

/// Calls `on_contact(candidate, contact)` for each contact as it is found, described if that is wanted. A
/// contact is not kept: it follows from its candidate, and in a packing most candidates have none.
template <int D>
template <class OnContact>
void World<D>::find_contacts(OnContact on_contact) {
  forget_contacts();
  Contact<D> contact;
  const std::size_t pairs = candidates_.pairs().size();
  for (std::size_t k = 0; k < pairs; ++k) {
    if (!find_contact(k, contact)) continue;
    touching_.push_back(std::uint32_t(k));
    remember_overlap(candidates_.pairs()[k], contact);
    on_contact(k, contact);
  }
  detected_ = true;
}

/// For contacts that are to be found.
template <int D>
void World<D>::renew_used_up_candidates() {
  if (!detected_ && candidates_.used_up()) renew_candidates();
}

template <int D>
void World<D>::detect() {
  if (detected_) return;
  renew_used_up_candidates();
  find_contacts([](std::size_t, const Contact<D>&) {});
}

template <int D>
void World<D>::evaluate_forces(double elapsed) {
  renew_used_up_candidates();
  std::fill(blocks_.force.begin(), blocks_.force.end(), Vector<D>::Zero());
  std::fill(blocks_.torque.begin(), blocks_.torque.end(), Angular<D>::Zero());
  std::fill(dashpot_load_.begin(), dashpot_load_.end(), DashpotLoad());
  for (Deformation<D>& deformation : blocks_.deformations().all())
    deformation.virial = deformation.dashpot_virial = Tensor<D>::Zero();
  Evaluation evaluation{elapsed, laws_.knows_potential() ? potential_length() : 0};
  if (detected_) {
    forces_.clear();
    Contact<D> contact;
    for (const std::uint32_t k : touching_) {
      const Candidate<D>& pair = candidates_.pairs()[k];
      if (!law_of(pair).is_potential()) describe(pair, contact);
      load_blocks(k, contact, evaluation);
    }
  } else {
    find_contacts([&](std::size_t k, const Contact<D>& contact) { load_blocks(k, contact, evaluation); });
  }
  const ContactEnergy& energy = evaluation.energy;
  ledger_.strain = energy.strain;
  ledger_.friction_loss += energy.friction_loss;
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
