// Sweeps of contacts in groups of four, against the conditions of the impulse problem itself.

#include "world/hard_contact/contact_groups.h"

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <random>

#include "catch.h"

namespace {

using namespace halfspace;

/// Random contacts of moving blocks with each other and with one that is fixed. The last block has more
/// contacts than a lane looks ahead.
template <int D>
struct RandomProblem {
  static constexpr int blocks = 24, contacts = 20, of_last = 20;
  ImpulseProblem<D> problem{std::pmr::get_default_resource()};
  std::mt19937_64 random;

  explicit RandomProblem(unsigned seed) : random(seed) {
    for (int i = 0; i < blocks; ++i) {
      BlockMotion<D> motion;
      InverseMass<D> inverse;
      if (i > 0) {
        motion.velocity = random_vector<Vector<D>>();
        motion.spin = random_vector<Angular<D>>();
        inverse.of_mass = uniform(0.5, 2);
        InertiaTensor<D> root;
        for (auto& part : root.reshaped()) part = uniform(-1, 1);
        inverse.of_inertia = InertiaTensor<D>::Identity() + root * root.transpose();
      }
      problem.motions.push_back(motion);
      problem.inverse_masses.push_back(inverse);
    }
    for (int c = 0; c < contacts; ++c) {
      const int a = int(uniform(0, blocks - 1)), b = int(uniform(0, blocks - 2));
      add(a, b < a ? b : b + 1);
    }
    for (int c = 0; c < of_last; ++c) add(blocks - 1, c % 2 == 0 ? 0 : 1 + c % (blocks - 2));
  }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); }
  template <class V>
  V random_vector() {
    V vector;
    for (auto& part : vector.reshaped()) part = uniform(-1, 1);
    return vector;
  }

  void add(int a, int b) {
    ImpulseContact<D> contact;
    contact.a = a;
    contact.b = b;
    contact.first_row = std::int32_t(problem.rows.size());
    contact.normal_count = 1 + int(uniform(0, D == 2 ? 2 : 5));
    contact.inverse_mass_a = problem.inverse_masses[std::size_t(a)].of_mass;
    contact.inverse_mass_b = problem.inverse_masses[std::size_t(b)].of_mass;
    contact.tan_friction = 0.3;
    const int kind = int(uniform(0, 3));  // smooth, rough, with a couple
    contact.friction_count = kind == 0 ? 0 : D == 2 ? 1 : 1 + kind;
    const Vector<D> normal = random_vector<Vector<D>>().normalized();
    const Vector<D> arm_of_a = random_vector<Vector<D>>(), arm_of_b = random_vector<Vector<D>>();
    const auto add_at = [&](const Vector<D>& from_middle, const Vector<D>& direction) {
      add_row(contact, direction, moment(Vector<D>(arm_of_a + from_middle), direction),
              moment(Vector<D>(arm_of_b + from_middle), direction));
    };
    for (int i = 0; i < contact.normal_count; ++i) add_at(random_vector<Vector<D>>(), normal);
    if (kind > 0) {
      if constexpr (D == 2) {
        add_at(Vector<2>::Zero(), perpendicular(normal));
      } else {
        const Vector<3> along = cross_product(normal, random_vector<Vector<3>>()).normalized();
        add_at(Vector<3>::Zero(), along);
        add_at(Vector<3>::Zero(), cross_product(normal, along));
        if (kind == 2) add_row(contact, Vector<3>::Zero(), 0.5 * normal, 0.5 * normal);
      }
    }
    problem.contacts.push_back(contact);
  }
  void add_row(const ImpulseContact<D>& contact, const Vector<D>& direction, const Angular<D>& turn_a,
               const Angular<D>& turn_b) {
    const InverseMass<D>&a = problem.inverse_masses[std::size_t(contact.a)],
          &b = problem.inverse_masses[std::size_t(contact.b)];
    ImpulseRow<D> row;
    row.direction = direction;
    row.turn_a = turn_a;
    row.turn_b = turn_b;
    row.response_a = a.of_inertia * row.turn_a;
    row.response_b = b.of_inertia * row.turn_b;
    row.inverse_mass = direction.squaredNorm() * (a.of_mass + b.of_mass) + row.turn_a.dot(row.response_a) +
                       row.turn_b.dot(row.response_b);
    row.target = row.slip = 0;
    row.impulse = 0;
    problem.rows.push_back(row);
  }
};

/// u >= 0, p >= 0 and u p = 0 for normal rows; friction is within its bound, and at it against the slip.
template <int D>
void check_conditions(ImpulseProblem<D> solved, const ImpulseProblem<D>& start) {
  std::copy(start.motions.begin(), start.motions.end(), solved.motions.begin());
  for (const ImpulseContact<D>& contact : solved.contacts)
    for (const ImpulseRow<D>& row : solved.rows_of(contact)) solved.apply(contact, row, row.impulse);
  constexpr double rounding = 1e-8;
  for (const ImpulseContact<D>& contact : solved.contacts) {
    for (const ImpulseRow<D>& row : solved.normals_of(contact)) {
      const double opening = solved.velocity_along(contact, row);
      CHECK(row.impulse >= 0);
      CHECK(opening > -rounding);
      CHECK(std::min(row.impulse, opening) < rounding);
    }
    if (contact.friction_count == 0) continue;
    const double bound = solved.friction_bound(contact);
    double size = 0, slip = 0, power = 0;
    for (const ImpulseRow<D>& row : solved.frictions_of(contact)) {
      const double velocity = solved.velocity_along(contact, row);
      size += row.impulse * row.impulse;
      slip += velocity * velocity;
      power += row.impulse * velocity;
    }
    CHECK(std::sqrt(size) <= bound + rounding);
    CHECK(power == Approx(-bound * std::sqrt(slip)).margin(rounding));
  }
}

template <int D>
void sweep_to_the_end(unsigned seed) {
  INFO(D << "D, seed " << seed);
  RandomProblem<D> random(seed);
  ContactGroups<D> groups(std::pmr::get_default_resource());
  random.problem.find_islands();
  groups.arrange(random.problem);
  groups.take(random.problem);
  CHECK(groups.begin(groups.all()) == 0);
  double change = 1;
  for (int i = 0; i < 100000 && change > 1e-12; ++i) change = groups.sweep(groups.all(), i % 2 == 1);
  CHECK(change < 1e-10);
  ImpulseProblem<D> solved = random.problem;
  groups.give(groups.all(), solved);
  check_conditions(solved, random.problem);

  // Taken up again, nothing is left to do.
  std::copy(random.problem.motions.begin(), random.problem.motions.end(), solved.motions.begin());
  groups.renew(groups.all(), solved);
  CHECK(groups.begin(groups.all()) > 0);
  CHECK(groups.sweep(groups.all(), false) < 1e-10);
}

}  // namespace

TEST_CASE("sweeps of contacts in groups end where the impulse problem is solved") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    sweep_to_the_end<2>(seed);
    sweep_to_the_end<3>(seed);
  }
}

TEST_CASE("islands of contacts end at blocks that impulses do not move") {
  ImpulseProblem<2> problem(std::pmr::get_default_resource());
  problem.motions.resize(7);
  const double moving = 1, fixed = 0;
  const auto add = [&](std::int32_t a, double mass_a, std::int32_t b, double mass_b) {
    problem.contacts.push_back({a, b, 0, 0, 0, mass_a, mass_b, 0});
  };
  // Block 0 is the floor. Blocks 1, 3 and 5 form an island, 2 and 4 another one, 6 touches nothing.
  add(0, fixed, 3, moving);
  add(0, fixed, 4, moving);
  add(1, moving, 5, moving);
  add(2, moving, 4, moving);
  add(3, moving, 5, moving);
  problem.find_islands();
  ContactIslands& islands = problem.islands;
  REQUIRE(islands.count() == 2);
  const auto is = [](std::span<const std::int32_t> contacts, std::initializer_list<std::int32_t> expected) {
    return std::equal(contacts.begin(), contacts.end(), expected.begin(), expected.end());
  };
  CHECK(is(islands.contacts_of(0), {0, 2, 4}));
  CHECK(is(islands.contacts_of(1), {1, 3}));
  for (std::size_t i = 0; i < islands.count(); ++i)
    for (const std::int32_t c : islands.contacts_of(i)) CHECK(islands.of_contact(std::size_t(c)) == i);
  for (const std::int32_t block : {1, 3, 5}) CHECK(islands.of_block(block) == 0);
  for (const std::int32_t block : {2, 4}) CHECK(islands.of_block(block) == 1);
  CHECK(islands.of_block(6) == -1);
}
