#include <algorithm>

#include "detect/pair.h"
#include "world/world.h"

namespace halfspace {
namespace {

/// Blocks that a joint has cut apart touch to rounding only: what lies nearer than this share of the smaller one's radius was one face.
constexpr double bond_reach = 1e-6;

}  // namespace

/// Intact contacts are those that are there when a block's first step begins (Wang et al. 2021, section 2.5).
template <int D>
bool World<D>::bonds_at_birth(const Candidate& candidate, const Contact<D>& contact) const {
  const auto is_fresh = [&](std::int32_t slot) { return std::find(fresh_.begin(), fresh_.end(), slot) != fresh_.end(); };
  const std::size_t a = std::size_t(candidate.a), b = std::size_t(candidate.b);
  const double reach = bond_reach * std::min(blocks_.radius[a], blocks_.radius[b]);
  return std::abs(contact.gap) <= reach && laws_.between(blocks_.material[a], blocks_.material[b]).bonds() &&
         (is_fresh(candidate.a) || is_fresh(candidate.b));
}

/// A contact that has ended gives up what its shear spring held.
template <int D>
void World<D>::release_shear(std::size_t candidate) {
  if (candidates_.shear().empty()) return;
  ShearSpring& shear = candidates_.shear()[candidate];
  if (shear.energy > 0) ledger_.friction_loss += shear.energy;
  shear = {};
}

template <int D>
void World<D>::add_contact(std::size_t candidate, const Contact<D>& contact) {
  contacts_.push_back(contact);
  candidate_.push_back(std::uint32_t(candidate));
}

template <int D>
void World<D>::detect_candidate(std::size_t k, Contact<D>& contact) {
  Candidate& pair = candidates_.pairs()[k];
  const Outline<D> a = blocks_.outline(pair.a);
  const Outline<D> b = blocks_.outline(pair.b);
  const Vector<D> to_b = blocks_.position[std::size_t(pair.b)] - blocks_.position[std::size_t(pair.a)];
  const bool first_time = pair.memory.state == PairMemory::unknown;
  const bool was_touching = pair.memory.state == PairMemory::touching;

  if (still_separated(a, b, to_b, pair.memory)) {
    if (!pair.bonded) return;
    contact.type = ContactType::none;
  } else {
    judge_pair(a, b, to_b, settings_.detect, [] {}, pair.memory, contact);
  }
  if (first_time && contact.gap == 0) {
    // Neatly stacked: the strict form of inclusion holds at first sight, so that an initial contact pair is left behind (eq. 11).
    pair.memory.state = PairMemory::separated;
    contact.type = ContactType::none;
  }
  if (first_time && !fresh_.empty() && bonds_at_birth(pair, contact)) pair.bonded = true;
  if (pair.bonded && contact.type == ContactType::none) {
    describe_contact(a, b, to_b, pair.memory.pair, settings_.detect, contact);
  }
  if (contact.type != ContactType::none) {
    add_contact(k, contact);
  } else if (was_touching) {
    release_shear(k);
  }
}

/// With room for a contact at every candidate: detection then asks for no memory.
template <int D>
void World<D>::rebuild_candidates() {
  const bool with_shear = laws_.any([](const SpringLaw& law) { return law.resists_shear(); });
  candidates_.rebuild(blocks_, settings_.skin, with_shear);
  const std::size_t most = candidates_.pairs().size();
  make_room(contacts_, most);
  make_room(candidate_, most);
  make_room(forces_, most);
}

template <int D>
void World<D>::detect() {
  if (detected_) return;
  if (candidates_.used_up()) rebuild_candidates();
  contacts_.clear();
  candidate_.clear();
  Contact<D> contact;
  const std::size_t pairs = candidates_.pairs().size();
  for (std::size_t k = 0; k < pairs; ++k) detect_candidate(k, contact);
  detected_ = true;
}

/// Contacts are not saved: detection at the same poses finds the same ones.
template <int D>
void World<D>::rederive() {
  if (!detected_) return;
  detected_ = false;
  detect();
}

template class World<2>;

}  // namespace halfspace
