// Forces of potentials that follow a plan, against those found without one.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "block/blocks.h"
#include "catch.h"
#include "contacts_3d.h"
#include "force/potential/space/planned_force.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

/// Two blocks and their plan.
struct PlannedPair {
  Blocks<3> blocks{memory};
  CachedDivisions plans{memory};
  DivisionCache known;
  PotentialRoom<3> room{memory};

  PlannedPair(const Shape<3>& a, const Shape<3>& b) {
    for (const Shape<3>* shape : {&a, &b}) blocks.add(*shape, BlockKind::rigid, 0, 1);
    put(0, Vector<3>::Zero(), {});
    plans.reserve(1);
    plans.serve_pairs(1);
  }

  void put(std::int32_t slot, const Vector<3>& at, const Rotation<3>& turned) {
    blocks.place(slot, at, turned);
  }
  void move(std::int32_t slot, const Vector<3>& way, const Vector<3>& turn) {
    const std::size_t i = std::size_t(slot);
    put(slot, blocks.position[i] + way, blocks.rotation[i].turned_by(turn));
  }

  PotentialForce<3> found() {
    const PlacedBlocks<3> at = blocks.placed(0, 1);
    return potential_force(at.a, at.b, at.to_b, room);
  }
  PotentialForce<3> planned(bool makes_plans = true) {
    if (const auto force = followed()) return *force;
    if (!makes_plans) return found();
    const PlacedBlocks<3> at = blocks.placed(0, 1);
    return force_by_new_plan(at.a, at.b, at.to_b, known, plans, room);
  }
  std::optional<PotentialForce<3>> followed() {
    const PlacedBlocks<3> at = blocks.placed(0, 1);
    return known.knows() ? follow(plans[known], at.a, at.b, at.to_b) : std::nullopt;
  }
};

/// Blocks have a radius of 1 or so, and what they share a surface of 4 pi at most. A plan is believed as long
/// as its corners are off by less than 2^-44 of the blocks' sizes and distance: 2e-13 of volume, energy and
/// force for each unit of area.
constexpr double rounding = 4 * pi * 2e-13;

void check_same(const PotentialForce<3>& force, const PotentialForce<3>& expected) {
  CHECK((force.force - expected.force).norm() <= rounding);
  CHECK(std::abs(force.energy - expected.energy) <= rounding);
  CHECK(std::abs(force.content - expected.content) <= rounding);
  CHECK((force.virial_a - expected.virial_a).norm() <= rounding);
  CHECK((force.virial_b - expected.virial_b).norm() <= rounding);
  CHECK(((force.centroid - expected.centroid) * expected.content).norm() <= rounding);
  CHECK(((force.spread - expected.spread) * expected.content).norm() <= rounding);
}

Vector<3> random_within(Random& random, double size) {
  return size * random.uniform(0, 1) * random_direction(random);
}

/// Blocks that overlap by so much of their radius along the line of their centroids, or little less.
void bring_together(PlannedPair& pair, Random& random, double overlap) {
  const Vector<3> direction = random_direction(random);
  pair.put(0, Vector<3>::Zero(), Rotation<3>().turned_by(random_within(random, 3)));
  pair.put(1, Vector<3>::Zero(), Rotation<3>().turned_by(random_within(random, 3)));
  double deeper = 0, farther = 2.5;
  while (farther - deeper > overlap / 4) {
    const double middle = 0.5 * (deeper + farther);
    pair.put(1, middle * direction, pair.blocks.rotation[1]);
    (pair.found().content > 0 ? deeper : farther) = middle;
  }
  pair.put(1, (deeper - overlap) * direction, pair.blocks.rotation[1]);
}

}  // namespace

TEST_CASE("a plan gives the force that is found without it, as blocks move little by little") {
  Random random(201);
  int asked = 0, followed = 0;
  for (int round = 0; round < 300; ++round) {
    PlannedPair pair(random_block(random, random.integer(4, 24)),
                     random_block(random, random.integer(4, 24)));
    const double overlap = std::pow(10, random.uniform(-5, -0.5));
    bring_together(pair, random, overlap);
    const double way = overlap * std::pow(10, random.uniform(-5, -1));
    for (int step = 0; step < 40; ++step) {
      pair.move(1, random_within(random, way), random_within(random, way));
      pair.move(0, Vector<3>::Zero(), random_within(random, way));
      const bool knew = pair.known.knows();
      asked += knew;
      if (const auto force = pair.followed()) {
        ++followed;
        check_same(*force, pair.found());
      }
      check_same(pair.planned(), pair.found());
    }
  }
  CHECK(asked > 8000);
  CHECK(followed > asked / 2);
}

TEST_CASE("a plan is not believed where blocks are elsewhere") {
  Random random(202);
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    PlannedPair pair(random_block(random, random.integer(4, 16)),
                     random_block(random, random.integer(4, 16)));
    bring_together(pair, random, 0.2);
    pair.planned();
    if (!pair.known.knows()) continue;
    for (int jump = 0; jump < 40; ++jump) {
      const double way = std::pow(10, random.uniform(-2, 0.3));
      pair.move(1, random_within(random, way), random_within(random, way));
      if (const auto force = pair.followed()) {
        check_same(*force, pair.found());
      } else {
        ++refused;
      }
    }
  }
  CHECK(refused > 5000);
}

TEST_CASE("a plan made where much lies in one place is not believed once that parts") {
  Random random(206);
  std::vector<Cloud> shapes{octahedron(1, 1, 1), wedge(1, 1, 1), wedge(2, 0.5, 0.5)};
  for (const Vector<3>& size :
       {Vector<3>(1, 2, 3), Vector<3>(2, 1, 1), Vector<3>(1, 2, 1), Vector<3>(1, 1, 2), Vector<3>(1, 1, 1),
        Vector<3>(4, 0.125, 0.125), Vector<3>(4, 4, 0.25)}) {
    const Polyhedron cuboid = box(size);
    shapes.emplace_back(cuboid.vertices.begin(), cuboid.vertices.end());
  }
  int followed = 0, refused = 0;
  for (const Cloud& a : shapes) {
    for (const Cloud& b : shapes) {
      for (int round = 0; round < 100; ++round) {
        PlannedPair pair(block_of(a), block_of(b));
        Vector<3> turn = Vector<3>::Zero(), at;
        turn[random.integer(0, 2)] = pi / 12 * random.integer(0, 6);
        for (int axis = 0; axis < 3; ++axis) at[axis] = 0.25 * random.integer(0, 4);
        const Rotation<3> turned = Rotation<3>().turned_by(turn);
        pair.put(1, at, turned);
        pair.planned();
        if (!pair.known.knows()) continue;
        for (int move = 0; move < 10; ++move) {
          Vector<3> way = Vector<3>::Zero(), spin = Vector<3>::Zero();
          (random.integer(0, 1) ? way : spin)[random.integer(0, 2)] = std::pow(10, random.uniform(-7, 0));
          pair.put(1, at + way, turned.turned_by(spin));
          if (const auto force = pair.followed()) {
            ++followed;
            // Of blocks of up to 4 m and 36 m^2.
            const PotentialForce<3> found = pair.found();
            CHECK((force->force - found.force).norm() <= 8 * rounding);
            CHECK(std::abs(force->energy - found.energy) <= 8 * rounding);
            CHECK(std::abs(force->content - found.content) <= 8 * rounding);
          } else {
            ++refused;
          }
        }
      }
    }
  }
  CHECK(followed > 1000);
  CHECK(refused > 1000);
}

TEST_CASE("a plan whose corners have come together is not believed") {
  const Shape<3> large = shape_of(completed(box({2, 2, 2}))), small = shape_of(completed(box({1, 1, 1})));
  for (const double overlap : {1e-9, 1e-6, 1e-3, 0.1}) {
    PlannedPair pair(large, small);
    pair.put(1, {0.1, 0.07, 1.5 - overlap}, {});
    pair.planned();
    REQUIRE(pair.followed());
    // Upside down inside the large one, where the face that had gone in is flush with its top.
    for (int step = -60; step <= 60; ++step) {
      pair.put(1, {0.1, 0.07, 0.5 + 1e-15 * step}, Rotation<3>().turned_by({pi, 0, 0}));
      if (const auto force = pair.followed()) check_same(*force, pair.found());
    }
  }
}

TEST_CASE("in the same places a planned force has the same bits again") {
  Random random(203);
  for (int round = 0; round < 200; ++round) {
    PlannedPair pair(random_block(random, 12), random_block(random, 12));
    bring_together(pair, random, 0.1);
    for (int step = 0; step < 10; ++step) {
      pair.move(1, random_within(random, 0.02), random_within(random, 0.02));
      const PotentialForce<3> in_step = pair.planned(), again = pair.planned(false);
      CHECK(std::memcmp(&in_step, &again, sizeof again) == 0);
    }
  }
}

TEST_CASE("boxes whose faces are flush, or come to be, are planned or not, and pushed the same") {
  const Shape<3> cube = shape_of(completed(box({1, 1, 1}))), half = shape_of(completed(box({0.5, 0.5, 0.5})));
  int followed = 0;
  for (const Shape<3>* upper : {&cube, &half}) {
    for (const double overlap : {0.25, 1e-3, 1e-7}) {
      const double height = upper == &cube ? 1 : 0.75;
      PlannedPair pair(cube, *upper);
      for (int step = 0; step < 200; ++step) {
        const double along = 0.01 * (step / 10), across = step % 3 == 0 ? 0 : 1e-14 * step;
        pair.put(1, {along, across, height - overlap}, Rotation<3>().turned_by({0, 0, step % 2 * 1e-15}));
        followed += pair.followed().has_value();
        check_same(pair.planned(), pair.found());
      }
    }
  }
  CHECK(followed > 300);
}

TEST_CASE("cubes of a wall, whose front and back are flush, have a plan that is followed") {
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  for (const double along : {0.0, 0.25, 0.5}) {
    for (const double turn : {0.0, 0.3}) {
      PlannedPair pair(cube, cube);
      const Rotation<3> turned = Rotation<3>().turned_by({0, 0, turn});
      const Vector<3> at = turned * Vector<3>(along, 0, 1 - 1e-3);
      pair.put(0, Vector<3>::Zero(), turned);
      pair.put(1, at, turned);
      check_same(pair.planned(), pair.found());
      pair.put(1, at + turned * Vector<3>(along > 0 ? 1e-5 : 0, 0, 1e-5), turned);
      const auto force = pair.followed();
      REQUIRE(force);
      check_same(*force, pair.found());
    }
  }
}

TEST_CASE("cubes that all but meet along a face, an edge or at a corner have a plan that is one, or none") {
  Random random(209);
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  int planned = 0, unplanned = 0;
  for (int round = 0; round < 3000; ++round) {
    PlannedPair pair(cube, cube);
    const double little = std::pow(10, random.uniform(-12, -2));
    Vector<3> at;
    for (int axis = 0; axis < 3; ++axis) at[axis] = random.integer(0, 2) ? 1 : 0.25 * random.integer(0, 4);
    pair.put(0, Vector<3>::Zero(), Rotation<3>().turned_by(random_within(random, little)));
    pair.put(1, at + random_within(random, little), Rotation<3>().turned_by(random_within(random, little)));
    const PotentialForce<3> found = pair.found();
    check_same(pair.planned(), found);
    if (!(found.content > 0)) continue;
    (pair.known.knows() ? planned : unplanned) += 1;
    const PlacedBlocks<3> placed = pair.blocks.placed(0, 1);
    if (pair.known.knows()) CHECK(is_plan(pair.plans[pair.known], placed.a, placed.b));
  }
  CHECK(planned > 200);
  CHECK(unplanned > 200);
}

TEST_CASE("blocks some of whose faces all but agree are planned as well") {
  Random random(208);
  const Polyhedron cube = box({1, 1, 1});
  int rounds = 0, planned = 0, followed = 0;
  for (const double height : {1e-1, 1e-2, 1e-3, 1e-4}) {
    Cloud tents = Cloud(cube.vertices.begin(), cube.vertices.end());
    for (int axis = 0; axis < 3; ++axis) {
      Vector<3> top = Vector<3>::Zero();
      top[axis] = 0.5 + height;
      tents.push_back(top);
      tents.push_back(-top);
    }
    for (int round = 0; round < 50; ++round) {
      PlannedPair pair(block_of(tents), block_of(tents));
      bring_together(pair, random, 0.1);
      check_same(pair.planned(), pair.found());
      ++rounds;
      planned += pair.known.knows();
      pair.move(1, random_within(random, 1e-6), random_within(random, 1e-6));
      if (const auto force = pair.followed()) {
        ++followed;
        check_same(*force, pair.found());
      }
    }
  }
  CHECK(planned > 0.95 * rounds);
  CHECK(followed > 0.9 * rounds);
}

TEST_CASE("blocks of too many faces for a plan are pushed without one") {
  Random random(207);
  int planned = 0, unplanned = 0;
  for (int round = 0; round < 60; ++round) {
    const int vertices = round == 59 ? 500 : 8 + 2 * round;
    PlannedPair pair(block_of(random_cloud(random, vertices, 1, 1)),
                     block_of(random_cloud(random, vertices, 1, 1)));
    pair.put(1, random.uniform(0.5, 1.8) * random_direction(random), {});
    check_same(pair.planned(), pair.found());
    (pair.known.knows() ? planned : unplanned) += 1;
  }
  CHECK(planned > 4);
  CHECK(unplanned > 10);
}

TEST_CASE("plans are kept one by one, and room that none uses is given free") {
  Random random(204);
  struct Known {
    DivisionCache plan;
    std::vector<PlanCode> codes;
  };
  std::vector<Known> pairs(20);
  CachedDivisions plans(memory);
  plans.reserve(pairs.size());
  plans.serve_pairs(pairs.size());
  int refused = 0;
  for (int step = 0; step < 3000; ++step) {
    Known& pair = pairs[std::size_t(random.integer(0, 19))];
    const std::vector<PlanCode> codes(std::size_t(random.integer(1, 900)), PlanCode(random.integer(0, 1000)));
    if (plans.add(codes, pair.plan)) {
      pair.codes = codes;
    } else {
      ++refused;
    }
    if (step % 3 == 0) plans.tidy(pairs);
    CHECK(plans.are_of(pairs));
    for (const Known& known : pairs) {
      if (!known.plan.knows()) continue;
      const auto plan = plans[known.plan];
      CHECK(std::equal(plan.begin(), plan.end(), known.codes.begin(), known.codes.end()));
    }
  }
  // A plan that two pairs have, or that begins within another's, would be moved under one of them.
  const auto known = [](const Known& pair) { return pair.plan.knows(); };
  Known another = *std::find_if(pairs.begin(), pairs.end(), known);
  const std::int32_t first = another.plan.first();
  for (const std::int32_t wrong : {first, first + 1}) {
    another.plan.remember(wrong);
    pairs.push_back(another);
    CHECK(!plans.are_of(pairs));
    pairs.pop_back();
  }
  CHECK(refused > 0);
  CHECK(refused < 1500);
  for (Known& known : pairs) known.plan = {};
  pairs[0].codes.assign(4000, 1);
  while (plans.add(pairs[0].codes, pairs[0].plan)) {
  }
  plans.tidy(pairs);
  CHECK(plans.size() < 4100);
}

TEST_CASE("what is no plan for two blocks is told, and whatever is taken for one leads nowhere else") {
  Random random(205);
  int plans = 0, taken = 0;
  while (plans < 30) {
    PlannedPair pair(random_block(random, random.integer(4, 10)),
                     random_block(random, random.integer(4, 10)));
    bring_together(pair, random, 0.1);
    pair.planned();
    if (!pair.known.knows()) continue;
    ++plans;
    const PlacedBlocks<3> at = pair.blocks.placed(0, 1);
    const auto made = pair.plans[pair.known];
    const std::vector<PlanCode> plan(made.begin(), made.end());
    CHECK(is_plan(plan, at.a, at.b));
    for (std::size_t length = 0; length < plan.size(); ++length)
      CHECK_FALSE(is_plan(std::span(plan).first(length), at.a, at.b));
    std::vector<PlanCode> longer = plan;
    longer.push_back(0);
    CHECK_FALSE(is_plan(longer, at.a, at.b));
    for (std::size_t k = 0; k < plan.size(); ++k) {
      for (const int code : {-1, 0, 1, plan[k] + 1, plan[k] - 1, 63, 64, INT16_MAX}) {
        std::vector<PlanCode> damaged = plan;
        damaged[k] = PlanCode(code);
        const bool is_in_range = is_plan(damaged, at.a, at.b);
        if (code < 0 || code == INT16_MAX) CHECK_FALSE(is_in_range);
        taken += is_in_range;
        if (is_in_range) follow(damaged, at.a, at.b, at.to_b);
      }
    }
  }
  CHECK(taken > 1000);
}
