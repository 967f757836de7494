#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "world/hard_contact/conjugate_direction.h"
#include "world/hard_contact/impulse_problem.h"

namespace halfspace {

/// A number of each of four contacts.
using OfFour = std::array<double, 4>;

/// The contacts of an impulse problem in groups of four, for sweeps of projected Gauss-Seidel in SIMD lanes.
/// No block that impulses move has two contacts in a group. Each lane goes through a quarter of the contacts,
/// nearly in their order: so a sweep carries impulses along a row of blocks as far as it would with one
/// contact at a time, which a sweep by colours (Catto 2024) does not. A group has contacts of one island. The
/// groups do not depend on the machine's lanes.
template <int D>
class ContactGroups {
 public:
  explicit ContactGroups(Memory* memory)
      : groups_(memory), rows_(memory), islands_(memory), motions_(memory), is_placed_(memory) {}

  /// The groups of an island, or all.
  struct Part {
    std::size_t first, end;
  };

  /// Makes the groups of these contacts, and takes the memory for problems of the same contacts.
  void arrange(const ImpulseProblem<D>& problem);
  /// Copies a problem of the contacts that were arranged, with its motions and impulses.
  void take(const ImpulseProblem<D>& problem);
  /// Copies the motions and impulses of the same problem anew.
  void renew(const Part& part, const ImpulseProblem<D>& problem);
  /// Copies motions and impulses back.
  void give(const Part& part, ImpulseProblem<D>& problem) const;
  const Part& island(std::size_t number) const { return islands_[number]; }
  Part all() const { return {0, groups_.size()}; }

  /// Adds the present impulses to the motions. Returns the largest velocity by a normal one.
  double begin(const Part& part);
  /// Returns the largest change, as a velocity. Without friction, its impulses become none.
  double sweep(const Part& part, bool is_backwards, bool has_friction = true);
  /// The largest velocity that one projection of a contact alone would change.
  double unbalanced(const Part& part);

  // Acceleration by conjugate directions.
  void restart_acceleration(const Part& part);
  /// The change of the impulses since the last acceleration, in the metric of the inverse masses.
  double squared_change(const Part& part) const;
  void accelerate(const Part& part, const ConjugateDirection& direction);

  BlockMotion<D> motion(std::size_t block) const;
  void set_motion(std::size_t block, const BlockMotion<D>& motion);

 private:
  static constexpr std::size_t angular = D == 2 ? 1 : 3, tensor = D == 2 ? 1 : 6;
  static constexpr std::size_t stride = D == 2 ? 4 : 8;     // of a block's motion
  static constexpr std::size_t couplings = D == 2 ? 0 : 3;  // of friction rows with those before

  struct Row {
    OfFour direction[D];
    OfFour turn_a[angular];
    OfFour turn_b[angular];
    OfFour inverse_mass;
    OfFour mass;  // 0 in a lane that has no such row
    OfFour target;
    OfFour slip;
    OfFour impulse;
    OfFour before;  // impulses at the last acceleration
    OfFour search;  // direction of the acceleration
  };
  struct Group {
    std::int32_t contact[4];  // -1: none
    std::int32_t a[4];
    std::int32_t b[4];
    std::int32_t first_row;
    std::int32_t normal_count;
    std::int32_t friction_count;
    bool slips;  // some contact, at the beginning
    OfFour inverse_mass_a;
    OfFour inverse_mass_b;
    OfFour inverse_inertia_a[tensor];
    OfFour inverse_inertia_b[tensor];
    OfFour tan_friction;
    std::array<OfFour, couplings> coupling;  // velocity along friction row 1 over an impulse of 0; 2, 0; 2, 1
    OfFour sliding_mass;                     // of all friction rows; 0 without any
  };
  template <class Four>
  struct Motions;
  template <class Four>
  struct Pairs;

  /// The contacts that a lane has still to go through.
  struct Lane {
    const std::int32_t* next;
    const std::int32_t* end;
  };
  std::size_t arrange(const ImpulseProblem<D>& problem, std::span<const std::int32_t> contacts);
  std::int32_t next_of(const Lane& lane, const ImpulseProblem<D>& problem, const Group& group) const;
  static bool shares_block(const ImpulseContact<D>& contact, const ImpulseProblem<D>& problem,
                           const Group& group);
  void fill(const ImpulseProblem<D>& problem, Group& group);
  template <class Four, class ImpulseOf>
  [[gnu::always_inline]] void push_all(const Part& part, ImpulseOf impulse_of);
  template <class Four, bool changes>
  [[gnu::always_inline]] double visit(Group& group, bool has_friction = true);
  /// Calls `visit(contact, lane, first normal row, first friction row)`.
  template <class Visit>
  void for_each_contact(const Part& part, Visit visit) const {
    for (const Group& group : groups_of(part)) {
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (group.contact[lane] >= 0)
          visit(std::size_t(group.contact[lane]), lane, std::size_t(group.first_row),
                std::size_t(group.first_row + group.normal_count));
      }
    }
  }
  std::span<const Group> groups_of(const Part& part) const {
    return {groups_.data() + part.first, part.end - part.first};
  }
  std::span<Group> groups_of(const Part& part) {
    return {groups_.data() + part.first, part.end - part.first};
  }
  std::size_t first_row_of(std::size_t group) const {
    return group < groups_.size() ? std::size_t(groups_[group].first_row) : rows_.size();
  }
  std::span<const Row> rows_of(const Part& part) const {
    const std::size_t first = first_row_of(part.first);
    return {rows_.data() + first, first_row_of(part.end) - first};
  }
  std::span<Row> rows_of(const Part& part) {
    const std::size_t first = first_row_of(part.first);
    return {rows_.data() + first, first_row_of(part.end) - first};
  }

  Array<Group> groups_;
  Array<Row> rows_;
  Array<Part> islands_;
  Array<double> motions_;          // of each block, and of one more, which lanes without a contact have
  Array<std::uint8_t> is_placed_;  // each contact, while they are arranged
};

/// The manifolds of a part as rows of AcceleratedSweeps.
template <int D>
struct ManifoldRows {
  double sweep(bool is_backwards) { return groups.sweep(part, is_backwards, has_friction); }
  double squared_change() const { return groups.squared_change(part); }
  void accelerate(const ConjugateDirection& direction) { groups.accelerate(part, direction); }
  void restart_acceleration() { groups.restart_acceleration(part); }

  ContactGroups<D>& groups;
  typename ContactGroups<D>::Part part;
  bool has_friction = true;
};

extern template class ContactGroups<2>;
extern template class ContactGroups<3>;

}  // namespace halfspace
