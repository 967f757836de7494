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

/// The state of a pair that has been looked at: `met` when it was not in contact before.
enum class Found { apart, in_contact, met };

/// Pairs that one worker goes through at once.
constexpr std::size_t pairs_per_chunk = 256;

/// Sums over a chunk of pairs.
struct PairSums {
  std::uint32_t contacts = 0;
  std::uint32_t met = 0;  // of them: not in contact before
  double released = 0;    // energy of shear springs whose contact has ended
  double peak_overlap = 0;
  double max_penetration_ratio = 0;
  ContactEnergy energy{};
  std::int32_t last_block = -1;  // of those that its loads act on
};

/// The contacts of a world: which of the neighbour list's pairs touch. A contact is not kept: it follows from
/// its pair, and in a packing most pairs have none.
template <int D>
class ContactList {
 public:
  ContactList(Model<D>& model, Memory* memory)
      : model_(model),
        neighbors_(memory),
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

  /// Described anew from the present poses and the remembered pair: reading contacts costs time, but stepping
  /// no memory for them.
  Contact<D> contact(std::size_t c) const {
    Contact<D> contact;
    describe(pair_of(c), contact);
    return contact;
  }
  /// Describes the contact of a pair that is known to have one.
  void describe(const Candidate<D>& pair, Contact<D>& contact) const;

  /// Adds a force on b to the shear spring of a pair of the list, if its law has one.
  void add_shear(std::int32_t a, std::int32_t b, const Vector<D>& force, const Vector<D>& normal);

  /// The one between two blocks, in either order, if there is any.
  std::optional<std::size_t> contact_between(std::int32_t a, std::int32_t b) const;

  bool are_found() const { return found_; }
  /// Contacts are forgotten, and found anew by find() of each pair, chunk by chunk. Is the pair in contact,
  /// or held together by its bond? Then the contact is described, if that is wanted.
  Found find(std::size_t k, Contact<D>& contact, PairSums& sums);
  /// Keeps a pair in contact, when its description is final.
  void keep(std::size_t k, std::size_t first_of_chunk, const Contact<D>& contact, PairSums& sums) {
    found_in_chunks_[first_of_chunk + sums.contacts++] = std::uint32_t(k);
    note_overlap(k, contact, sums);
  }
  void note_overlap(std::size_t k, const Contact<D>& contact, PairSums& sums) const {
    if (is_always_described(neighbors_.pairs()[k]))
      sums.peak_overlap = std::max(sums.peak_overlap, -contact.gap);
  }
  /// Keeps a pair that has met. Through what, is found out when all other contacts are known.
  void keep_met(std::size_t k, std::size_t first_of_chunk, PairSums& sums) {
    found_in_chunks_[first_of_chunk + sums.contacts++] = std::uint32_t(k);
    met_in_chunks_[first_of_chunk + sums.met++] = std::uint32_t(k);
  }
  /// The pairs of a chunk that have met, in ascending order.
  std::span<const std::uint32_t> met_in(std::size_t chunk, const PairSums& sums) const {
    return {met_in_chunks_.begin() + std::ptrdiff_t(chunk * pairs_per_chunk), sums.met};
  }
  /// Was a pair in contact when it was last looked at, or is it bonded?
  static bool was_in_contact(const Candidate<D>& pair) {
    return pair.bonded || pair.witness.state >= PairCache<D>::touching;
  }
  /// Keeps a pair that stays as it is, if it was in contact.
  void keep_as_it_was(std::size_t k, std::size_t first_of_chunk, PairSums& sums) {
    const Candidate<D>& pair = neighbors_.pairs()[k];
    if (!was_in_contact(pair)) return;
    found_in_chunks_[first_of_chunk + sums.contacts++] = std::uint32_t(k);
    sums.last_block = std::max(sums.last_block, pair.b);
  }
  /// When all chunks have been gone through.
  void end(std::span<const PairSums> chunks);
  /// The contacts in a chunk of pairs.
  std::span<const std::uint32_t> touching_in(std::size_t chunk) const;
  void forget() {
    touching_.clear();
    found_ = false;
  }

  /// Is a contact described as it is found? In space that costs as much as a force by springs, and potentials
  /// read nothing of it. It is wanted all the same when blocks are first seen, and when another law has
  /// bonded them. In the plane it is cheap, and a pair has to be brought up to date on the way: there a
  /// description moves it on by one edge at most.
  bool is_described(const Candidate<D>& pair) const;
  /// How far rounding alone lets a pair overlap, or stand apart, that was meant to touch.
  double rounding_of_touch(const Candidate<D>& pair) const;

  /// A block whose first step has not begun.
  void add_fresh(std::int32_t slot, std::size_t slots);
  void make_room_for_block() { make_room_for_one(new_blocks_); }
  void make_room_for_blocks(std::size_t slots) {
    if (new_blocks_.capacity() < slots) new_blocks_.reserve(std::max(slots, 2 * new_blocks_.capacity()));
  }
  bool has_new_blocks() const { return any_fresh_; }
  /// Bonds what fresh blocks touch; contacts are known. Bonded pairs count as contacts from then on.
  void bond_fresh();
  void end_fresh();
  /// Does a law hold two blocks together, in either order? They are a pair of the list.
  bool bonds(std::int32_t a, std::int32_t b) const;
  /// Bonds of pairs without a spring are kept where their points are, from the first step on.
  void end_bonds_without_spring();

  /// Takes room for a contact at every pair of a list that is to be taken into use.
  void fit_room() {
    refit(touching_, neighbors_.room());
    found_in_chunks_.resize(neighbors_.room());
    met_in_chunks_.resize(neighbors_.room());
    neighbors_.reserve_index();
  }

  /// The largest of all contacts found so far that were described, which those of potentials in space are
  /// not.
  double peak_overlap() const { return peak_overlap_; }

  /// All that a step of a changed world writes to before it moves the blocks, but for the pairs.
  auto state() {
    return std::tuple_cat(neighbors_.skins(),
                          std::tie(touching_, new_blocks_, any_fresh_, peak_overlap_, found_));
  }

  /// Do contacts name pairs in the list?
  bool names_pairs() const;
  /// False for what no list can be, after reading a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(new_blocks_, any_fresh_, neighbors_, touching_, peak_overlap_, found_);
    if constexpr (Archive::reads) fit_room();  // steps ask for no memory
  }

 private:
  void release_shear(std::size_t k, PairSums& sums);
  std::optional<std::size_t> pair_between(std::int32_t a, std::int32_t b) const;
  /// Potentials in space have no contact described, but at first sight.
  bool is_always_described(const Candidate<D>& pair) const {
    return D == 2 || !model_.materials.laws().knows_potential() || !model_.law_of(pair).is_potential();
  }

  Model<D>& model_;
  NeighborList<D> neighbors_;
  Array<std::uint32_t> touching_;         // the pair of each contact
  Array<std::uint32_t> found_in_chunks_;  // the same while they are found, each chunk where its pairs begin
  Array<std::uint32_t> met_in_chunks_;    // those of them that have met
  Array<std::uint8_t> new_blocks_;        // of each block: its first step has not begun
  std::int32_t any_fresh_ = 0;
  double peak_overlap_ = 0;
  std::int32_t found_ = 0;  // contacts belong to the present poses
};

extern template class ContactList<2>;
extern template class ContactList<3>;

}  // namespace halfspace
