#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "block/inertia.h"
#include "geometry/tolerances.h"
#include "geometry/vector.h"
#include "world/hard_contact/contact_islands.h"
#include "world/hard_contact/slip_reversal.h"
#include "world/motion/block_motion.h"

namespace halfspace {

/// The inverses of a block's mass and inertia; 0 unless it moves freely.
template <int D>
struct InverseMass {
  double of_mass = 0;
  InertiaTensor<D> of_inertia = InertiaTensor<D>::Zero();
};

/// One component of a contact: the velocity of b against a along it is direction . (v_b - v_a) + turn_b . w_b
/// - turn_a . w_a, and an impulse acts on both blocks along the same.
template <int D>
struct ImpulseRow {
  double velocity(const BlockMotion<D>& a, const BlockMotion<D>& b) const {
    return direction.dot(b.velocity - a.velocity) + turn_b.dot(b.spin) - turn_a.dot(a.spin);
  }

  /// Sets what follows from the masses of both blocks.
  void set_masses(const InverseMass<D>& a, const InverseMass<D>& b) {
    response_a = a.of_inertia * turn_a;
    response_b = b.of_inertia * turn_b;
    inverse_mass =
        (a.of_mass + b.of_mass) * direction.squaredNorm() + turn_a.dot(response_a) + turn_b.dot(response_b);
  }

  Vector<D> direction;
  Angular<D> turn_a;      // torque on a over the impulse, reversed
  Angular<D> turn_b;      // on b
  Angular<D> response_a;  // spin over the impulse
  Angular<D> response_b;
  double inverse_mass;  // effective: velocity along the row over the impulse
  double target;        // velocity along the row when the contact bears; at least this for normals
  double slip;          // of friction: velocity along the row at the beginning of the half step, or 0
  double impulse;
};

/// The most friction rows of a contact.
template <int D>
constexpr std::size_t max_friction_rows = D == 2 ? 1 : 3;

/// Normal rows, one per point, and friction rows: none, 1 in the plane, 2 in space and, for a patch of some
/// size, its couple over the patch's radius, so that all have one unit and one bound: an ellipsoid of slip
/// and twist (Howe and Cutkosky 1996).
template <int D>
struct ImpulseContact {
  std::int32_t a;
  std::int32_t b;
  std::int32_t first_row;
  std::int32_t normal_count;
  std::int32_t friction_count;
  double inverse_mass_a;
  double inverse_mass_b;
  double tan_friction;

  /// A block that impulses move, where there is any.
  std::int32_t free_block() const { return inverse_mass_a > 0 ? a : b; }
  /// The velocity along a row over an impulse along another one, and the reverse.
  double coupling(const ImpulseRow<D>& row, const ImpulseRow<D>& other) const {
    return (inverse_mass_a + inverse_mass_b) * row.direction.dot(other.direction) +
           row.turn_a.dot(other.response_a) + row.turn_b.dot(other.response_b);
  }
  /// At least the largest eigenvalue of the tensor of inverse masses (Gershgorin): friction that slides, with
  /// this in place of the inverse mass of each row, opposes the slip, and does not overshoot.
  double sliding_inverse_mass(std::span<const ImpulseRow<D>> friction) const {
    double largest = 0;
    for (const ImpulseRow<D>& row : friction) {
      double sum = 0;
      for (const ImpulseRow<D>& other : friction)
        sum += &row == &other ? row.inverse_mass : std::abs(coupling(row, other));
      largest = std::max(largest, sum);
    }
    return largest;
  }
};

/// A velocity problem with unilateral contacts and Coulomb friction: find impulses with u >= target, p >= 0
/// and p (u - target) = 0 for each normal row; friction rows stop sliding while their sum is within
/// tan(friction angle) times the sum of the contact's normal impulses, and else oppose it (Moreau 1988).
template <int D>
struct ImpulseProblem {
  explicit ImpulseProblem(Memory* memory)
      : contacts(memory),
        islands(memory),
        rows(memory),
        start(memory),
        motions(memory),
        inverse_masses(memory),
        is_slow(memory) {}

  /// After contacts have changed.
  void find_islands() { islands.find(contacts, motions.size()); }

  double velocity_along(const ImpulseContact<D>& contact, const ImpulseRow<D>& row) const {
    return row.velocity(motions[std::size_t(contact.a)], motions[std::size_t(contact.b)]);
  }
  /// Calls `visit(block)` for each block of an island that impulses move, once for each of its contacts.
  template <class Visit>
  void for_each_free_block(std::size_t island, Visit visit) const {
    for (const std::int32_t c : islands.contacts_of(island)) {
      const ImpulseContact<D>& contact = contacts[std::size_t(c)];
      if (contact.inverse_mass_a > 0) visit(contact.a);
      if (contact.inverse_mass_b > 0) visit(contact.b);
    }
  }
  /// Are all blocks of an island slow, and those that it touches?
  bool all_slow(std::size_t island) const {
    const std::span<const std::int32_t> of_island = islands.contacts_of(island);
    return std::all_of(of_island.begin(), of_island.end(), [&](std::int32_t c) {
      const ImpulseContact<D>& contact = contacts[std::size_t(c)];
      return is_slow[std::size_t(contact.a)] && is_slow[std::size_t(contact.b)];
    });
  }
  /// Do the blocks of most of its contacts move faster against each other than this, if it is above 0, at the
  /// beginning?
  bool max_slip(std::size_t island, double speed) const {
    const std::span<const std::int32_t> of_island = islands.contacts_of(island);
    const auto fast = std::count_if(of_island.begin(), of_island.end(), [&](std::int32_t c) {
      const ImpulseContact<D>& contact = contacts[std::size_t(c)];
      const BlockMotion<D>&a = start[std::size_t(contact.a)], &b = start[std::size_t(contact.b)];
      const std::span<const ImpulseRow<D>> of_contact = rows_of(contact);
      return std::any_of(of_contact.begin(), of_contact.end(),
                         [&](const ImpulseRow<D>& row) { return std::abs(row.velocity(a, b)) > speed; });
    });
    return speed > 0 && 2 * std::size_t(fast) > of_island.size();
  }
  bool can_move(const ImpulseContact<D>& contact) const {
    return contact.inverse_mass_a > 0 || contact.inverse_mass_b > 0;
  }
  void apply(const ImpulseContact<D>& contact, const ImpulseRow<D>& row, double impulse) {
    BlockMotion<D>&a = motions[std::size_t(contact.a)], &b = motions[std::size_t(contact.b)];
    a.velocity -= (impulse * contact.inverse_mass_a) * row.direction;
    a.spin -= impulse * row.response_a;
    b.velocity += (impulse * contact.inverse_mass_b) * row.direction;
    b.spin += impulse * row.response_b;
  }
  /// Gives a row an impulse instead of the one it has.
  void set_impulse(const ImpulseContact<D>& contact, ImpulseRow<D>& row, double impulse) {
    if (impulse == row.impulse) return;
    apply(contact, row, impulse - row.impulse);
    row.impulse = impulse;
  }
  /// The velocity along a row beyond its target.
  double excess(const ImpulseContact<D>& contact, const ImpulseRow<D>& row) const {
    return velocity_along(contact, row) - row.target;
  }
  /// The impulse that brings a row to its target while all others stay.
  double stopping_impulse(const ImpulseContact<D>& contact, const ImpulseRow<D>& row) const {
    return row.impulse - excess(contact, row) / row.inverse_mass;
  }
  /// The friction of a contact after one projection. Its rows are stopped one after the other: at once they
  /// would overshoot where they are coupled, as at the corner of a face. Where that would exceed the bound,
  /// all have one inverse mass, so that a solution opposes the velocity of sliding. Returns its size before
  /// it is limited to the bound; infinite where the slip is reversed.
  double project_friction(const ImpulseContact<D>& contact, double bound,
                          std::array<double, max_friction_rows<D>>& impulse) {
    const std::span<ImpulseRow<D>> rows = frictions_of(contact);
    std::array<double, max_friction_rows<D>> beyond{};
    double stopping = 0, slip = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      beyond[k] = excess(contact, rows[k]);
      double left = beyond[k];
      for (std::size_t j = 0; j < k; ++j)
        left += contact.coupling(rows[k], rows[j]) * (impulse[j] - rows[j].impulse);
      impulse[k] = rows[k].impulse - left / rows[k].inverse_mass;
      stopping += impulse[k] * impulse[k];
      slip += rows[k].slip * rows[k].slip;
    }
    stopping = std::sqrt(stopping);
    slip = std::sqrt(slip);
    const auto row_of = [&](int k) {
      const ImpulseRow<D>& row = rows[std::size_t(k)];
      return SlippingRow<double>{row.slip / slip, row.inverse_mass, row.impulse, beyond[std::size_t(k)]};
    };
    const double of_translation = contact.inverse_mass_a + contact.inverse_mass_b;
    if (slip > 0 && reverse_slip(int(rows.size()), slip, row_of, of_translation, bound, impulse.data(), 0.0,
                                 1.0, min_divisor) > 0)
      return HUGE_VAL;
    if (D == 2 || stopping <= bound) return limit(impulse, stopping, bound);
    const double inverse_mass = contact.sliding_inverse_mass(rows);
    double size = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      impulse[k] = rows[k].impulse - beyond[k] / inverse_mass;
      size += impulse[k] * impulse[k];
    }
    limit(impulse, std::sqrt(size), bound);
    return stopping;
  }
  std::span<ImpulseRow<D>> normals_of(const ImpulseContact<D>& contact) {
    return {rows.data() + contact.first_row, std::size_t(contact.normal_count)};
  }
  std::span<ImpulseRow<D>> frictions_of(const ImpulseContact<D>& contact) {
    return {rows.data() + contact.first_row + contact.normal_count, std::size_t(contact.friction_count)};
  }
  std::span<ImpulseRow<D>> rows_of(const ImpulseContact<D>& contact) {
    return {rows.data() + contact.first_row, std::size_t(contact.normal_count + contact.friction_count)};
  }
  std::span<const ImpulseRow<D>> rows_of(const ImpulseContact<D>& contact) const {
    return {rows.data() + contact.first_row, std::size_t(contact.normal_count + contact.friction_count)};
  }
  /// The largest friction impulse at the present normal impulses.
  double friction_bound(const ImpulseContact<D>& contact) {
    return contact.tan_friction * normal_impulse(contact);
  }
  double normal_impulse(const ImpulseContact<D>& contact) {
    double sum = 0;
    for (const ImpulseRow<D>& row : normals_of(contact)) sum += row.impulse;
    return sum;
  }
  Vector<D> friction_impulse(const ImpulseContact<D>& contact) {
    Vector<D> sum = Vector<D>::Zero();
    for (const ImpulseRow<D>& row : frictions_of(contact)) sum += row.impulse * row.direction;
    return sum;
  }

  /// Does a contact bear, with friction below its bound?
  bool sticks(const ImpulseContact<D>& contact) {
    double square = 0;
    for (const ImpulseRow<D>& row : frictions_of(contact)) square += row.impulse * row.impulse;
    const double bound = friction_bound(contact);
    return bound > 0 && square < bound * bound;
  }

  /// Limits friction of this size, which is returned, to the bound.
  static double limit(std::array<double, max_friction_rows<D>>& impulse, double size, double bound) {
    if (size > bound) {
      for (double& part : impulse) part *= std::max(0.0, bound) / size;
    }
    return size;
  }

  double slow_slip = 0;  // m/s: slower slip is stopped, and its reversal is not followed
  Array<ImpulseContact<D>> contacts;
  ContactIslands islands;
  Array<ImpulseRow<D>> rows;
  Array<BlockMotion<D>> start;           // of each block, at the beginning of the half step
  Array<BlockMotion<D>> motions;         // with the impulses
  Array<InverseMass<D>> inverse_masses;  // of each block
  Array<std::uint8_t> is_slow;           // each block: it may stand
};

/// The most rows that the contacts of a problem may have: a patch has a couple only where it has some size.
template <int D>
std::size_t max_rows(const ImpulseProblem<D>& problem) {
  std::size_t rows = 0;
  for (const ImpulseContact<D>& contact : problem.contacts)
    rows += std::size_t(contact.normal_count) + max_friction_rows<D>;
  return rows;
}

}  // namespace halfspace
