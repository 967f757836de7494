#include <algorithm>

#include "detect/pair.h"
#include "world/world.h"

namespace halfspace {
namespace {

/// Blocks that a joint has cut apart touch to rounding only: what lies nearer than this share of the smaller
/// one's radius was one face.
constexpr double bond_reach = 1e-6;

}  // namespace

/// Intact contacts are those that are there when a block's first step begins (Wang et al. 2021, section 2.5).
template <int D>
void World<D>::make_bonds() {
  fresh_.resize(blocks_.slot_count());
  if (laws_.any([](const SpringLaw& law) { return law.bonds(); })) {
    detect();
    for (Candidate& pair : candidates_.pairs()) {
      const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
      const bool is_fresh = fresh_[a] || fresh_[b];
      if (!is_fresh || !laws_.between(blocks_.material[a], blocks_.material[b]).bonds()) continue;
      Contact<D> contact;
      describe_contact(blocks_.outline(pair.a), blocks_.outline(pair.b),
                       blocks_.position[b] - blocks_.position[a], pair.memory.pair, settings_.detect,
                       contact);
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
    judge_pair(a, b, to_b, settings_.detect, pair.memory, contact);
  }
  if (first_time && contact.gap == 0) {
    // Neatly stacked: the strict form of inclusion holds at first sight, so that an initial contact pair is
    // left behind (eq. 11).
    pair.memory.state = PairMemory::separated;
    contact.type = ContactType::none;
  }
  if (pair.bonded && contact.type == ContactType::none) {
    describe_contact(a, b, to_b, pair.memory.pair, settings_.detect, contact);
  }
  if (contact.type != ContactType::none) {
    add_contact(k, contact);
  } else if (was_touching) {
    release_shear(k);
  }
}

/// With room for a contact at every candidate: detection then asks for no memory. When there is none,
/// contacts have to be found again, and nothing else has changed.
template <int D>
void World<D>::renew_candidates() {
  const bool with_shear = laws_.any([](const SpringLaw& law) { return law.resists_shear(); });
  candidates_.search_again(blocks_, settings_.skin, with_shear);
  forget_contacts();
  refit(contacts_, candidates_.room());
  refit(candidate_, candidates_.room());
  refit(forces_, candidates_.room());
  candidates_.renew(blocks_);
}

template <int D>
void World<D>::forget_contacts() {
  contacts_.clear();
  candidate_.clear();
  forces_.clear();
  detected_ = false;
}

template <int D>
void World<D>::detect() {
  if (detected_) return;
  if (candidates_.used_up()) renew_candidates();
  forces_.clear();
  contacts_.clear();
  candidate_.clear();
  Contact<D> contact{};
  const std::size_t pairs = candidates_.pairs().size();
  for (std::size_t k = 0; k < pairs; ++k) detect_candidate(k, contact);
  detected_ = true;
}

template class World<2>;

}  // namespace halfspace
