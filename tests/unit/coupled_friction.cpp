// Friction at the corner of a face, where its rows are coupled: each moves the others' velocity by more than
// their own impulses would stop at once.

#include <memory_resource>

#include "catch.h"
#include "world/hard_contact/contact_groups.h"

namespace {

using namespace halfspace;

constexpr std::size_t floor_slot = 0, slab = 1;

/// A slab of 1 x 1 x 0.5 m and 1 kg that a rough floor pushes up at a corner, where friction sticks.
ImpulseProblem<3> pressed_slab() {
  ImpulseProblem<3> problem(std::pmr::get_default_resource());
  problem.motions.assign(2, {});
  problem.motions[slab] = {Vector<3>(1, -0.5, 0), Vector<3>(0.3, 0.2, 2)};
  problem.inverse_masses.assign(2, {});
  problem.inverse_masses[slab] = {1, Vector<3>(9.6, 9.6, 6).asDiagonal()};
  problem.is_slow.assign(2, 0);
  const Vector<3> corner(0.5, 0.5, -0.25);
  const auto add = [&](const Vector<3>& direction, const Vector<3>& turn) {
    ImpulseRow<3> row{};
    row.direction = direction;
    row.turn_a.setZero();
    row.turn_b = turn;
    row.set_masses(problem.inverse_masses[floor_slot], problem.inverse_masses[slab]);
    problem.rows.push_back(row);
  };
  for (const Vector<3>& axis : {Vector<3>(0, 0, 1), Vector<3>(1, 0, 0), Vector<3>(0, 1, 0)})
    add(axis, cross_product(corner, axis));
  add(Vector<3>::Zero(), Vector<3>(0, 0, 0.3849));
  problem.rows.front().target = 1e3;
  problem.contacts.push_back({std::int32_t(floor_slot), std::int32_t(slab), 0, 1, 3, 0, 1, 1e3});
  problem.find_islands();
  return problem;
}

double fastest_slip(const ImpulseProblem<3>& problem) {
  double fastest = 0;
  for (std::size_t k = 1; k < problem.rows.size(); ++k)
    fastest = std::max(fastest, std::abs(problem.velocity_along(problem.contacts[0], problem.rows[k])));
  return fastest;
}

}  // namespace

TEST_CASE("sweeps stop a slab that friction holds by its corner") {
  ImpulseProblem<3> problem = pressed_slab();
  ContactGroups<3> groups(std::pmr::get_default_resource());
  groups.arrange(problem);
  groups.take(problem);
  for (int i = 0; i < 300; ++i) groups.sweep(groups.all(), false);
  groups.give(groups.all(), problem);
  CHECK(fastest_slip(problem) < 1e-9);
}

TEST_CASE("projections stop a slab that friction holds by its corner") {
  ImpulseProblem<3> problem = pressed_slab();
  const ImpulseContact<3>& contact = problem.contacts[0];
  for (int i = 0; i < 300; ++i) {
    std::array<double, 3> impulse{};
    problem.project_friction(contact, 1e3, impulse);
    for (std::size_t k = 0; k < 3; ++k)
      problem.set_impulse(contact, problem.frictions_of(contact)[k], impulse[k]);
  }
  CHECK(fastest_slip(problem) < 1e-9);
}
