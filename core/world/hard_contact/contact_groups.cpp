#include "world/hard_contact/contact_groups.h"

#include <algorithm>

#include "geometry/tolerances.h"
#include "simd/four_lanes.h"
#include "world/hard_contact/manifold.h"

namespace halfspace {
namespace {

template <class Four>
[[gnu::always_inline]] inline Four lanes(const OfFour& numbers) {
  return load_four<Four>(numbers.data());
}

/// The symmetric tensor xx, yy, zz, xy, yz, xz times a vector.
template <class Four, std::size_t size>
[[gnu::always_inline]] inline void multiply(const OfFour (&tensor)[size], const Four* vector, Four* product) {
  if constexpr (size == 1) {
    product[0] = lanes<Four>(tensor[0]) * vector[0];
  } else {
    const Four xy = lanes<Four>(tensor[3]), yz = lanes<Four>(tensor[4]), xz = lanes<Four>(tensor[5]);
    product[0] = lanes<Four>(tensor[0]) * vector[0] + xy * vector[1] + xz * vector[2];
    product[1] = xy * vector[0] + lanes<Four>(tensor[1]) * vector[1] + yz * vector[2];
    product[2] = xz * vector[0] + yz * vector[1] + lanes<Four>(tensor[2]) * vector[2];
  }
}

}  // namespace

/// The motions of four blocks.
template <int D>
template <class Four>
struct ContactGroups<D>::Motions {
  Four velocity[D];
  Four spin[angular];

  [[gnu::always_inline]] void load(const double* motions, const std::int32_t* blocks) {
    Four rows[4];
    for (int i = 0; i < 4; ++i) rows[i] = load_four<Four>(motions + stride * std::size_t(blocks[i]));
    transpose(rows);
    for (int i = 0; i < D; ++i) velocity[i] = rows[i];
    if constexpr (D == 2) {
      spin[0] = rows[2];
    } else {
      for (int i = 0; i < 4; ++i) rows[i] = load_four<Four>(motions + stride * std::size_t(blocks[i]) + 4);
      transpose(rows);
      for (int i = 0; i < 3; ++i) spin[i] = rows[i];
    }
  }
  [[gnu::always_inline]] void store(double* motions, const std::int32_t* blocks) const {
    const Four none = all_four<Four>(0);
    Four rows[4] = {velocity[0], velocity[1], D == 2 ? spin[0] : velocity[D - 1], none};
    transpose(rows);
    for (int i = 0; i < 4; ++i) store_four(motions + stride * std::size_t(blocks[i]), rows[i]);
    if constexpr (D == 3) {
      Four turns[4] = {spin[0], spin[1], spin[2], none};
      transpose(turns);
      for (int i = 0; i < 4; ++i) store_four(motions + stride * std::size_t(blocks[i]) + 4, turns[i]);
    }
  }
  /// Adds an impulse along a row.
  [[gnu::always_inline]] void push(const Row& row, const OfFour (&turn)[angular], const OfFour& inverse_mass,
                                   const OfFour (&inverse_inertia)[tensor], const Four& impulse) {
    const Four change = impulse * lanes<Four>(inverse_mass);
    for (int i = 0; i < D; ++i) velocity[i] = velocity[i] + change * lanes<Four>(row.direction[i]);
    Four torque[angular], turned[angular];
    for (std::size_t i = 0; i < angular; ++i) torque[i] = impulse * lanes<Four>(turn[i]);
    multiply(inverse_inertia, torque, turned);
    for (std::size_t i = 0; i < angular; ++i) spin[i] = spin[i] + turned[i];
  }
  /// The velocity of b against this along a row.
  [[gnu::always_inline]] Four velocity_of(const Motions& b, const Row& row) const {
    Four sum = all_four<Four>(0);
    for (int i = 0; i < D; ++i) sum = sum + (b.velocity[i] - velocity[i]) * lanes<Four>(row.direction[i]);
    for (std::size_t i = 0; i < angular; ++i)
      sum = sum + (b.spin[i] * lanes<Four>(row.turn_b[i]) - spin[i] * lanes<Four>(row.turn_a[i]));
    return sum;
  }
};

/// The motions of both blocks of each contact of a group.
template <int D>
template <class Four>
struct ContactGroups<D>::Pairs {
  Motions<Four> a, b;

  [[gnu::always_inline]] Pairs(const double* motions, const Group& group) {
    a.load(motions, group.a);
    b.load(motions, group.b);
  }
  [[gnu::always_inline]] void store(double* motions, const Group& group) const {
    a.store(motions, group.a);
    b.store(motions, group.b);
  }
  [[gnu::always_inline]] void push(const Group& group, const Row& row, const Four& impulse) {
    a.push(row, row.turn_a, group.inverse_mass_a, group.inverse_inertia_a, all_four<Four>(0) - impulse);
    b.push(row, row.turn_b, group.inverse_mass_b, group.inverse_inertia_b, impulse);
  }
};

/// Pushes all contacts by the impulses that `impulse_of(row, is_normal)` returns.
template <int D>
template <class Four, class ImpulseOf>
[[gnu::always_inline]] inline void ContactGroups<D>::push_all(const Part& part, ImpulseOf impulse_of) {
  for (const Group& group : groups_of(part)) {
    Pairs<Four> pairs(motions_.data(), group);
    for (std::int32_t i = 0; i < group.normal_count + group.friction_count; ++i) {
      Row& row = rows_[std::size_t(group.first_row + i)];
      pairs.push(group, row, impulse_of(row, i < group.normal_count));
    }
    pairs.store(motions_.data(), group);
  }
}

template <int D>
void ContactGroups<D>::take(const ImpulseProblem<D>& problem) {
  motions_.assign(stride * (problem.motions.size() + 1), 0);
  for (std::size_t i = 0; i < problem.motions.size(); ++i) set_motion(i, problem.motions[i]);
  rows_.clear();
  for (Group& group : groups_) fill(problem, group);
}

template <int D>
void ContactGroups<D>::renew(const Part& part, const ImpulseProblem<D>& problem) {
  for_each_contact(part, [&](std::size_t c, std::size_t lane, std::size_t normal, std::size_t friction) {
    const ImpulseContact<D>& contact = problem.contacts[c];
    for (const std::int32_t block : {contact.a, contact.b})
      set_motion(std::size_t(block), problem.motions[std::size_t(block)]);
    const std::span<const ImpulseRow<D>> rows = problem.rows_of(contact);
    const std::size_t normals = std::size_t(contact.normal_count);
    for (const ImpulseRow<D>& row : rows.first(normals)) rows_[normal++].impulse[lane] = row.impulse;
    for (const ImpulseRow<D>& row : rows.subspan(normals)) rows_[friction++].impulse[lane] = row.impulse;
  });
}

template <int D>
void ContactGroups<D>::give(const Part& part, ImpulseProblem<D>& problem) const {
  for_each_contact(part, [&](std::size_t c, std::size_t lane, std::size_t normal, std::size_t friction) {
    const ImpulseContact<D>& contact = problem.contacts[c];
    for (ImpulseRow<D>& row : problem.normals_of(contact)) row.impulse = rows_[normal++].impulse[lane];
    for (ImpulseRow<D>& row : problem.frictions_of(contact)) row.impulse = rows_[friction++].impulse[lane];
    if (contact.inverse_mass_a > 0) problem.motions[std::size_t(contact.a)] = motion(std::size_t(contact.a));
    if (contact.inverse_mass_b > 0) problem.motions[std::size_t(contact.b)] = motion(std::size_t(contact.b));
  });
}

template <int D>
BlockMotion<D> ContactGroups<D>::motion(std::size_t block) const {
  const double* at = motions_.data() + stride * block;
  BlockMotion<D> motion;
  for (int i = 0; i < D; ++i) motion.velocity[i] = at[i];
  for (std::size_t i = 0; i < angular; ++i) motion.spin[Eigen::Index(i)] = at[(D == 2 ? 2 : 4) + i];
  return motion;
}

template <int D>
void ContactGroups<D>::set_motion(std::size_t block, const BlockMotion<D>& motion) {
  double* at = motions_.data() + stride * block;
  for (int i = 0; i < D; ++i) at[i] = motion.velocity[i];
  for (std::size_t i = 0; i < angular; ++i) at[(D == 2 ? 2 : 4) + i] = motion.spin[Eigen::Index(i)];
}

/// Normal impulses one after the other, then friction within the bound that they give. Returns the largest
/// change, as a velocity. If it does not change anything, each row is projected with the present velocities.
template <int D>
template <class Four, bool changes>
[[gnu::always_inline]] inline double ContactGroups<D>::visit(Group& group, bool has_friction) {
  Pairs<Four> pairs(motions_.data(), group);
  const Four none = all_four<Four>(0);
  Four largest = none, load = none;
  const auto change = [&](Row & row, const Four& impulse) __attribute__((always_inline)) {
    const Four by = impulse - lanes<Four>(row.impulse);
    if (changes) {
      store_four(row.impulse.data(), impulse);
      pairs.push(group, row, by);
    }
    largest = max(largest, abs(by) * lanes<Four>(row.inverse_mass));
  };
  const auto excess_of = [&](const Row& row) __attribute__((always_inline)) {
    return pairs.a.velocity_of(pairs.b, row) - lanes<Four>(row.target);
  };
  const auto stopping = [&](const Row& row, const Four& excess) __attribute__((always_inline)) {
    return lanes<Four>(row.impulse) - excess * lanes<Four>(row.mass);
  };
  Row* const rows = rows_.data() + group.first_row;
  for (std::int32_t i = 0; i < group.normal_count; ++i) {
    const Four impulse = max(none, stopping(rows[i], excess_of(rows[i])));
    load = load + impulse;
    change(rows[i], impulse);
  }
  Row* const friction = rows + group.normal_count;
  const Four bound = has_friction ? lanes<Four>(group.tan_friction) * load : none;
  const auto reverse = [&](const Four* excess, Four* impulse) __attribute__((always_inline)) {
    if (!group.slips) return none;
    const Four one = all_four<Four>(1), least = all_four<Four>(min_divisor);
    Four square = none;
    for (std::int32_t k = 0; k < group.friction_count; ++k)
      square = square + lanes<Four>(friction[k].slip) * lanes<Four>(friction[k].slip);
    const Four slip = sqrt(square), inverse_slip = one / max(slip, least);
    const auto row_of = [&](int k) __attribute__((always_inline)) {
      return SlippingRow<Four>{lanes<Four>(friction[k].slip) * inverse_slip,
                               lanes<Four>(friction[k].inverse_mass), lanes<Four>(friction[k].impulse),
                               excess[k]};
    };
    const Four of_translation = lanes<Four>(group.inverse_mass_a) + lanes<Four>(group.inverse_mass_b);
    return reverse_slip<Four>(group.friction_count, slip, row_of, of_translation, bound, impulse, none, one,
                              least);
  };
  if constexpr (D == 2) {
    if (group.friction_count > 0) {
      const Four excess = excess_of(friction[0]);
      Four impulse = stopping(friction[0], excess);
      const Four within = max(none - bound, min(bound, impulse));
      const Four reversed = reverse(&excess, &impulse);
      change(friction[0], select_less(none, reversed, impulse, within));
    }
  } else {
    // Where friction would exceed its bound, all its rows have the same mass, so that it opposes the slip.
    const Four sliding_mass = lanes<Four>(group.sliding_mass);
    Four excess[3], within[3], beyond[3], square = none, square_beyond = none;
    for (std::int32_t k = 0; k < group.friction_count; ++k) {
      excess[k] = excess_of(friction[k]);
      Four left = excess[k];
      for (std::int32_t j = 0; j < k; ++j) {
        const Four by = within[j] - lanes<Four>(friction[j].impulse);
        left = left + lanes<Four>(group.coupling[std::size_t(k + j - 1)]) * by;
      }
      within[k] = stopping(friction[k], left);
      square = square + within[k] * within[k];
      beyond[k] = lanes<Four>(friction[k].impulse) - excess[k] * sliding_mass;
      square_beyond = square_beyond + beyond[k] * beyond[k];
    }
    const Four reversed = reverse(excess, within);
    const Four size = sqrt(square), size_beyond = max(sqrt(square_beyond), all_four<Four>(min_divisor));
    const Four scale = min(all_four<Four>(1), bound / size_beyond);
    for (std::int32_t k = 0; k < group.friction_count; ++k)
      change(friction[k],
             select_less(none, reversed, within[k], select_less(bound, size, beyond[k] * scale, within[k])));
  }
  if (changes) pairs.store(motions_.data(), group);
  return reduce_max(largest);
}

template <int D>
double ContactGroups<D>::unbalanced(const Part& part) {
  return with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    double largest = 0;
    for (Group& group : groups_of(part)) largest = std::max(largest, visit<Four, false>(group));
    return largest;
  });
}

template <int D>
double ContactGroups<D>::sweep(const Part& part, bool is_backwards, bool has_friction) {
  return with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    double largest = 0;
    const std::span<Group> groups = groups_of(part);
    for (std::size_t i = 0; i < groups.size(); ++i)
      largest = std::max(largest,
                         visit<Four, true>(groups[is_backwards ? groups.size() - 1 - i : i], has_friction));
    return largest;
  });
}

template <int D>
double ContactGroups<D>::begin(const Part& part) {
  restart_acceleration(part);
  return with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    Four fastest = all_four<Four>(0);
    push_all<Four>(
        part, [&](const Row& row, bool is_normal) __attribute__((always_inline)) {
          const Four impulse = lanes<Four>(row.impulse);
          if (is_normal) fastest = max(fastest, impulse * lanes<Four>(row.inverse_mass));
          return impulse;
        });
    return reduce_max(fastest);
  });
}

template <int D>
void ContactGroups<D>::restart_acceleration(const Part& part) {
  for (Row& row : rows_of(part)) {
    row.before = row.impulse;
    row.search.fill(0);
  }
}

template <int D>
double ContactGroups<D>::squared_change(const Part& part) const {
  return with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    Four sum = all_four<Four>(0);
    for (const Row& row : rows_of(part)) {
      const Four change = lanes<Four>(row.impulse) - lanes<Four>(row.before);
      sum = sum + change * change * lanes<Four>(row.inverse_mass);
    }
    return reduce(sum);
  });
}

template <int D>
void ContactGroups<D>::accelerate(const Part& part, const ConjugateDirection& direction) {
  with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    const Four ratio = all_four<Four>(direction.ratio());
    push_all<Four>(
        part, [&](Row & row, bool) __attribute__((always_inline)) {
          const Four more = ratio * lanes<Four>(row.search), impulse = lanes<Four>(row.impulse);
          const Four search =
              direction.is_shorter() ? more + impulse - lanes<Four>(row.before) : all_four<Four>(0);
          store_four(row.search.data(), search);
          store_four(row.impulse.data(), impulse + more);
          store_four(row.before.data(), impulse + more);
          return more;
        });
  });
}

template class ContactGroups<2>;
template class ContactGroups<3>;

}  // namespace halfspace
