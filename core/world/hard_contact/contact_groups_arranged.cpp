// How contacts come into groups of four.

#include <algorithm>

#include "world/hard_contact/contact_groups.h"

namespace halfspace {
namespace {

/// Contacts among which a lane looks for its next one.
constexpr int contacts_ahead = 4;

void put(const InertiaTensor<2>& tensor, std::size_t lane, OfFour (&to)[1]) { to[0][lane] = tensor(0, 0); }
void put(const InertiaTensor<3>& tensor, std::size_t lane, OfFour (&to)[6]) {
  const double parts[6] = {tensor(0, 0), tensor(1, 1), tensor(2, 2),
                           tensor(0, 1), tensor(1, 2), tensor(0, 2)};
  for (std::size_t i = 0; i < 6; ++i) to[i][lane] = parts[i];
}

template <class Vector, std::size_t size>
void put(const Vector& vector, std::size_t lane, OfFour (&to)[size]) {
  for (std::size_t i = 0; i < size; ++i) to[i][lane] = vector[Eigen::Index(i)];
}

}  // namespace

/// The next contact of a lane whose moving blocks are not those of the other lanes, if possible with as many
/// normals as theirs, or -1. A lane looks a few contacts ahead.
template <int D>
std::int32_t ContactGroups<D>::next_of(const Lane& lane, const ImpulseProblem<D>& problem,
                                       const Group& group) const {
  std::int32_t first = -1;
  int left = contacts_ahead;
  for (const std::int32_t* at = lane.next; at != lane.end && left > 0; ++at) {
    const std::int32_t c = *at;
    if (is_placed_[std::size_t(c)]) continue;
    --left;
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(c)];
    if (shares_block(contact, problem, group)) continue;
    if (group.normal_count == 0 || contact.normal_count == group.normal_count) return c;
    if (first < 0) first = c;
  }
  return first;
}

template <int D>
bool ContactGroups<D>::shares_block(const ImpulseContact<D>& contact, const ImpulseProblem<D>& problem,
                                    const Group& group) {
  const auto is_in = [&](std::int32_t block) {
    return std::any_of(group.contact, group.contact + 4, [&](std::int32_t c) {
      if (c < 0) return false;
      const ImpulseContact<D>& other = problem.contacts[std::size_t(c)];
      return other.a == block || other.b == block;
    });
  };
  return (contact.inverse_mass_a > 0 && is_in(contact.a)) || (contact.inverse_mass_b > 0 && is_in(contact.b));
}

template <int D>
void ContactGroups<D>::arrange(const ImpulseProblem<D>& problem) {
  is_placed_.assign(problem.contacts.size(), 0);
  groups_.clear();
  islands_.clear();
  std::size_t rows = 0;
  for (std::size_t i = 0; i < problem.islands.count(); ++i) {
    const std::size_t first = groups_.size();
    rows += arrange(problem, problem.islands.contacts_of(i));
    islands_.push_back({first, groups_.size()});
  }
  rows_.reserve(rows);
  motions_.reserve(stride * (problem.motions.size() + 1));
}

/// Adds the groups of an island. Returns the most rows that they may have.
template <int D>
std::size_t ContactGroups<D>::arrange(const ImpulseProblem<D>& problem,
                                      std::span<const std::int32_t> contacts) {
  const std::size_t count = contacts.size();
  Lane lanes[4];
  for (std::size_t k = 0; k < 4; ++k)
    lanes[k] = {contacts.data() + k * count / 4, contacts.data() + (k + 1) * count / 4};
  std::size_t rows = 0;
  for (std::size_t placed = 0; placed < count;) {
    Group group{};
    std::fill_n(group.contact, 4, -1);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int32_t c = next_of(lanes[k], problem, group);
      if (c < 0) continue;
      group.contact[k] = c;
      group.normal_count = std::max(group.normal_count, problem.contacts[std::size_t(c)].normal_count);
      is_placed_[std::size_t(c)] = 1;
      ++placed;
      while (lanes[k].next != lanes[k].end && is_placed_[std::size_t(*lanes[k].next)]) ++lanes[k].next;
    }
    rows += std::size_t(group.normal_count) + max_friction_rows<D>;
    groups_.push_back(group);
  }
  return rows;
}

template <int D>
void ContactGroups<D>::fill(const ImpulseProblem<D>& problem, Group& group) {
  group.first_row = std::int32_t(rows_.size());
  group.friction_count = 0;
  group.slips = false;
  for (const std::int32_t c : group.contact) {
    if (c >= 0)
      group.friction_count = std::max(group.friction_count, problem.contacts[std::size_t(c)].friction_count);
  }
  rows_.resize(rows_.size() + std::size_t(group.normal_count + group.friction_count), Row{});
  const std::int32_t nobody = std::int32_t(problem.motions.size());
  for (std::size_t lane = 0; lane < 4; ++lane) {
    group.a[lane] = group.b[lane] = nobody;
    if (group.contact[lane] < 0) continue;
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(group.contact[lane])];
    group.a[lane] = contact.a;
    group.b[lane] = contact.b;
    group.inverse_mass_a[lane] = contact.inverse_mass_a;
    group.inverse_mass_b[lane] = contact.inverse_mass_b;
    put(problem.inverse_masses[std::size_t(contact.a)].of_inertia, lane, group.inverse_inertia_a);
    put(problem.inverse_masses[std::size_t(contact.b)].of_inertia, lane, group.inverse_inertia_b);
    group.tan_friction[lane] = contact.tan_friction;
    const auto fill_row = [&](const ImpulseRow<D>& from, Row& to) {
      put(from.direction, lane, to.direction);
      put(from.turn_a, lane, to.turn_a);
      put(from.turn_b, lane, to.turn_b);
      to.inverse_mass[lane] = from.inverse_mass;
      to.mass[lane] = from.inverse_mass > 0 ? 1 / from.inverse_mass : 0;
      to.target[lane] = from.target;
      to.slip[lane] = from.slip;
      group.slips = group.slips || from.slip != 0;
      to.impulse[lane] = from.impulse;
    };
    const std::span<const ImpulseRow<D>> rows = problem.rows_of(contact);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool is_friction = i >= std::size_t(contact.normal_count);
      const std::size_t place = is_friction ? i + std::size_t(group.normal_count - contact.normal_count) : i;
      fill_row(rows[i], rows_[std::size_t(group.first_row) + place]);
    }
    if constexpr (D == 3) {
      const std::span<const ImpulseRow<D>> friction = rows.subspan(std::size_t(contact.normal_count));
      std::size_t i = 0;
      for (std::size_t k = 1; k < friction.size(); ++k) {
        for (std::size_t j = 0; j < k; ++j)
          group.coupling[i++][lane] = contact.coupling(friction[k], friction[j]);
      }
      const double inverse_mass = contact.sliding_inverse_mass(friction);
      group.sliding_mass[lane] = inverse_mass > 0 ? 1 / inverse_mass : 0;
    }
  }
}

#define HALFSPACE_MEMBERS(D)                                                                               \
  template std::int32_t ContactGroups<D>::next_of(const Lane&, const ImpulseProblem<D>&, const Group&)     \
      const;                                                                                               \
  template bool ContactGroups<D>::shares_block(const ImpulseContact<D>&, const ImpulseProblem<D>&,         \
                                               const Group&);                                              \
  template void ContactGroups<D>::arrange(const ImpulseProblem<D>&);                                       \
  template std::size_t ContactGroups<D>::arrange(const ImpulseProblem<D>&, std::span<const std::int32_t>); \
  template void ContactGroups<D>::fill(const ImpulseProblem<D>&, Group&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
