#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>

#include "force/spring/spring.h"
#include "narrow_phase/contact.h"
#include "threads/threads.h"
#include "world/contacts/neighbor_list.h"
#include "world/model/model.h"

namespace halfspace {

/// The result of detection for a pair; `met`: in contact, but not before.
enum class Found { apart, in_contact, met };

/// Pairs that a worker processes at a time.
constexpr std::size_t pairs_per_chunk = 256;

/// Sums over a chunk of pairs.
struct PairSums {
  std::uint32_t contacts = 0;
  std::uint32_t met = 0;  // of these, not in contact before
  double released = 0;    // energy of shear springs whose contact has ended
  double peak_overlap = 0;
  double max_penetration_ratio = 0;
  ContactEnergy energy{};
  std::int32_t last_block = -1;  // largest slot that the contacts load; -1: none
};

/// The contacts of a world, as pairs of the neighbour list. Contacts are not stored: each is computed from
/// its pair, and most pairs of a packing do not touch.
template <int D>
class ContactList {
 public:
  ContactList(Model<D>& model, Threads* threads, Memory* memory)
      : model_(model),
        neighbors_(threads, memory),
        touching_(memory),
        found_in_chunks_(memory),
        met_in_chunks_(memory),
        new_blocks_(memory) {}

  std::size_t count() const { return touching_.size(); }
  const Candidate<D>& pair_of(std::size_t contact) const { return neighbors_.pairs()[touching_[contact]]; }
  ShearSpring<D>& shear_of(std::size_t contact) { return neighbors_.shear()[touching_[contact]]; }
  const Array<std::uint32_t>& touching() const { return touching_; }
  NeighborList<D>& neighbors() { return neighbors_; }
  const NeighborList<D>& neighbors() const { return neighbors_; }

  /// Computed from the current poses and the cached pair on each call, so that steps need no memory for
  /// contacts.
  Contact<D> contact(std::size_t c) const {
    Contact<D> contact;
    describe(pair_of(c), contact);
    return contact;
  }
  /// Computes the contact of a pair that is in contact.
  void describe(const Candidate<D>& pair, Contact<D>& contact) const;

  /// Adds a force on b to the shear spring of a pair of the list, if its law has one.
  void add_shear(std::int32_t a, std::int32_t b, const Vector<D>& force, const Vector<D>& normal);

  /// The contact between two blocks, in either order, if any.
  std::optional<std::size_t> contact_between(std::int32_t a, std::int32_t b) const;

  bool are_found() const { return found_; }
  /// Tests a pair under a law of this kind; a bonded pair is always in contact. Computes the contact if
  /// is_described(). Called for each pair, chunk by chunk, after forget().
  template <StiffnessKind kind>
  Found find(std::size_t k, Contact<D>& contact, PairSums& sums);
  /// Records a pair in contact.
  void keep(std::size_t k, std::size_t first_of_chunk, PairSums& sums) {
    found_in_chunks_[first_of_chunk + sums.contacts++] = std::uint32_t(k);
  }
  /// Records the overlap of a contact with its final description.
  template <StiffnessKind kind>
  static void note_overlap(const Contact<D>& contact, PairSums& sums) {
    if (is_always_described<kind>) sums.peak_overlap = std::max(sums.peak_overlap, -contact.gap);
  }
  /// Records a pair that has met. Its entry face is determined once all other contacts are known.
  void note_met(std::size_t k, std::size_t first_of_chunk, PairSums& sums) {
    met_in_chunks_[first_of_chunk + sums.met++] = std::uint32_t(k);
  }
  /// The pairs of a chunk that have met, in ascending order.
  std::span<const std::uint32_t> met_in(std::size_t chunk, const PairSums& sums) const {
    if (sums.met == 0) return {};  // the array may be empty
    return {met_in_chunks_.begin() + std::ptrdiff_t(chunk * pairs_per_chunk), sums.met};
  }
  /// True for a pair that was in contact at its last detection, or is bonded.
  static bool was_in_contact(const Candidate<D>& pair) {
    return pair.bonded || pair.witness.state >= PairCache<D>::touching;
  }
  /// Records a pair in contact that detection skips.
  void keep_as_it_was(std::size_t k, std::size_t first_of_chunk, PairSums& sums) {
    keep(k, first_of_chunk, sums);
    sums.last_block = std::max(sums.last_block, neighbors_.pairs()[k].b);
  }
  /// Sorts the contacts of a chunk, and those that have met, in the order of the pairs.
  void put_in_order(std::size_t first_of_chunk, const PairSums& sums);
  /// Collects the contacts of all chunks.
  void end(std::span<const PairSums> chunks);
  /// The contacts in a chunk of pairs.
  std::span<const std::uint32_t> touching_in(std::size_t chunk) const;
  void forget() {
    touching_.clear();
    found_ = false;
  }

  /// True when detection also computes the contact. In 3D that costs as much as a spring force, and potential
  /// laws need it only at the first detection and for pairs bonded by another law; laws per area, too, but
  /// for their own bonds. In 2D it is cheap, and potential laws always need it because it updates the cached
  /// pair, by at most one edge per detection.
  template <StiffnessKind kind>
  static bool is_described(const Candidate<D>& pair) {
    return is_always_described<kind> || pair.witness.state == PairCache<D>::unknown || pair.bonded;
  }
  /// Bound of the gap or overlap that rounding causes for two blocks placed exactly in touch.
  double rounding_of_touch(const Candidate<D>& pair) const;

  /// Marks a block as new until its first step.
  void add_fresh(std::int32_t slot, std::size_t slots);
  void make_room_for_block() { make_room_for_one(new_blocks_); }
  void make_room_for_blocks(std::size_t slots) {
    if (new_blocks_.capacity() < slots) new_blocks_.reserve(std::max(slots, 2 * new_blocks_.capacity()));
  }
  bool has_new_blocks() const { return any_fresh_; }
  /// Bonds new blocks to those that they touch. Bonded pairs count as contacts. Precondition: contacts are
  /// found.
  void bond_fresh();
  void end_fresh();
  /// True when a contact law bonds two blocks, in either order.
  bool bonds(std::int32_t a, std::int32_t b) const;
  /// Clears the bonds of pairs without springs: from the first step on, each HardContact has its own.
  void end_bonds_without_spring();

  /// Reserves memory for a contact of every pair, including those of the next list.
  void fit_room() {
    refit(touching_, neighbors_.room());
    found_in_chunks_.resize(neighbors_.room());
    met_in_chunks_.resize(neighbors_.room());
    neighbors_.reserve_index();
  }

  /// Maximum overlap so far, m. Excludes potential laws in 3D, which find none.
  double peak_overlap() const { return peak_overlap_; }
  void note_overlap(double depth) { peak_overlap_ = std::max(peak_overlap_, depth); }

  bool is_in_contact(std::size_t k) const {
    return std::binary_search(touching_.begin(), touching_.end(), std::uint32_t(k));
  }
  bool is_new(std::size_t slot) const { return slot < new_blocks_.size() && new_blocks_[slot]; }

  // Taking over the contacts of another world, after its list: a mark per block, and the pairs in contact.
  void add_new_mark(bool is_new) { new_blocks_.push_back(is_new); }
  void add_contact(std::size_t k) { touching_.push_back(std::uint32_t(k)); }
  void end_taking_over(const ContactList& from) {
    any_fresh_ = from.any_fresh_;
    found_ = from.found_;
    fit_room();
  }

  /// State that a step after an edit writes before it moves the blocks, except the pairs.
  auto state() {
    return std::tuple_cat(neighbors_.skins(),
                          std::tie(touching_, new_blocks_, any_fresh_, peak_overlap_, found_));
  }

  /// True when all contacts refer to pairs of the list.
  bool names_pairs() const;
  /// Validates the state read from a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(new_blocks_, any_fresh_, neighbors_, touching_, peak_overlap_, found_);
    if constexpr (Archive::reads) fit_room();  // steps allocate nothing
  }

 private:
  /// Forgets the shear of a pair whose contact ends. Returns its energy.
  double release_shear(std::size_t k);
  /// False for laws per area, and for potential laws in 3D, which compute contacts only at the first
  /// detection.
  template <StiffnessKind kind>
  static constexpr bool is_always_described = kind != StiffnessKind::per_area &&
                                              (D == 2 || kind != StiffnessKind::potential);

  Model<D>& model_;
  NeighborList<D> neighbors_;
  Array<std::uint32_t> touching_;         // the pair of each contact
  Array<std::uint32_t> found_in_chunks_;  // the same during detection; each chunk has the range of its pairs
  Array<std::uint32_t> met_in_chunks_;    // likewise, pairs that have met
  Array<std::uint8_t> new_blocks_;        // per block: 1 until its first step
  std::int32_t any_fresh_ = 0;
  double peak_overlap_ = 0;
  std::int32_t found_ = 0;  // 1: contacts are those of the current poses
};

extern template class ContactList<2>;
extern template class ContactList<3>;

}  // namespace halfspace
