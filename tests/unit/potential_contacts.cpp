// Contacts of blocks in space whose law is of potentials: they are not described on the way.

#include <algorithm>
#include <cmath>

#include "bare_law.h"
#include "block/deformation.h"
#include "catch.h"
#include "contacts_3d.h"
#include "force/potential/line_of_action.h"
#include "narrow_phase/space/separation.h"
#include "world/world.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

/// A block on top of a fixed one, whose poses are given from outside.
struct TwoInWorld {
  World<3> world{WorldSettings<3>(), memory};
  std::int32_t upper;

  TwoInWorld(const Shape<3>& below, const Shape<3>& above, StiffnessKind kind) {
    world.add_material(1000);
    set_law(kind);
    world.add_block(below, BlockKind::fixed, 0, Vector<3>::Zero(), {});
    upper = world.add_block(above, BlockKind::rigid, 0, {0, 0, 10}, {});
  }

  void set_law(StiffnessKind kind) {
    ContactLaw law = test::bare_law();
    law.stiffness_kind = kind;
    law.normal_stiffness = law.shear_stiffness = 1e6;
    law.tan_friction = 0.6;
    world.set_default_law(law);
  }

  void put(const Vector<3>& position, double elapsed) {
    world.set_pose(upper, position, {});
    world.detect();
    world.evaluate_forces_for_host(elapsed);
  }
};

}  // namespace

TEST_CASE("a brick that spins under potentials is braked at the mean distance of what it shares") {
  const Vector<3> size(1, 0.5, 0.25);
  const Shape<3> plate = shape_of(completed(box({4, 4, 1}))), brick = shape_of(completed(box(size)));
  for (const double sense : {-1.0, 1.0}) {
    TwoInWorld two(plate, brick, StiffnessKind::potential);
    two.world.set_velocity(two.upper, Vector<3>::Zero(), Vector<3>(0, 0, sense));
    two.put({0.3, -0.2, 0.5 + size.z() / 2 - 1e-3}, 1);
    const double pressed = two.world.blocks().force[std::size_t(two.upper)].z();
    const double x = size.x() * size.x() / 12, y = size.y() * size.y() / 12;
    const double radius = mean_distance(x + y, x * y);
    CHECK(pressed > 0);
    CHECK(two.world.blocks().torque[std::size_t(two.upper)].z() == Approx(-sense * 0.6 * pressed * radius));
  }
}

TEST_CASE("in space, what blocks share spreads about any line as their overlap does, seen along it") {
  Random random(142);
  PotentialRoom<3> room(memory);
  int overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    const Shape<3> a = random_block(random, random.integer(4, 24)),
                   b = random_block(random, random.integer(4, 24));
    const Vector<3> to_b = random_vector(random, -0.8, 0.8), normal = random_direction(random);
    const Polyhedron part = intersection_by_cutting(a, b, to_b);
    if (part.is_empty()) continue;
    const Shape<3> body(part, memory);
    if (body.volume() < 1e-5) continue;
    const Eigen::Matrix3d moment = second_moment_of(body);
    // Seen along the line, the body is a figure with the moments of its shadow, which only counts across the
    // line.
    const Eigen::Matrix3d shadow = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    const Eigen::Matrix3d seen = shadow * moment * shadow / body.volume();
    ++overlapping;
    const PotentialForce<3> potential = potential_force(a.outline(), b.outline(), to_b, room);
    // Rounding puts corners off by some 1e-16, and so the distance in a thin body by as much over its volume.
    CHECK(mean_distance_from_line(potential.spread, normal) ==
          Approx(mean_distance(Tensor<3>(seen))).epsilon(1e-7).margin(1e-13 / body.volume()));
  }
  CHECK(overlapping > 100);
}

TEST_CASE("a contact of potentials is described where it is least deep, however far the blocks have moved") {
  Random random(141);
  constexpr double depth = 0.01;
  int compared = 0, turned = 0;
  for (int round = 0; round < 20; ++round) {
    const Shape<3> dome = random_block(random, 24),
                   grain = block_of(scaled(random_cloud(random, 12, 1, 1), 0.2));
    TwoInWorld two(dome, grain, StiffnessKind::potential);
    const Vector<3> from = random_direction(random),
                    across = cross_product(from, random_direction(random)).normalized();
    Vector<3> first_normal = Vector<3>::Zero();
    double distance = 2;
    for (int step = 0; step <= 100; ++step) {
      const Vector<3> way = std::cos(0.02 * step) * from + std::sin(0.02 * step) * across;
      const auto gap = [&] {
        return find_separation(dome.outline(), grain.outline(), Vector<3>(distance * way)).gap;
      };
      while (gap() <= 0) distance += 10 * depth;
      while (gap() > -depth) distance -= 0.1 * depth;
      two.put(distance * way, 0);
      REQUIRE(two.world.state().contacts.count() == 1);
      // Read now and then, not in every step.
      if (step % 10 != 0) continue;
      const Contact<3> contact = two.world.state().contacts.contact(0);
      const Separation<3> shallowest =
          pair_of_largest_gap(dome.outline(), grain.outline(), Vector<3>(distance * way));
      // Deeper where it is of a face beside edges that pass each other beyond their ends, or beside a tilted
      // region that is followed: by the cosine of the angle to which that may be.
      const double cosine = std::cos(DetectOptions().region_angle());
      CHECK(contact.gap == Approx(shallowest.gap).epsilon(1 / cosine - 1));
      CHECK(contact.normal.dot(shallowest.normal) >= cosine);
      ++compared;
      if (step == 0) first_normal = contact.normal;
      turned += first_normal.dot(contact.normal) < 0.5;
      if (step < 100) continue;
      two.set_law(StiffnessKind::per_contact);
      two.put(distance * way, 0);
      const Vector<3> force = two.world.blocks().force[std::size_t(two.upper)];
      CHECK(force.normalized().dot(contact.normal) == Approx(1));
      CHECK(force.norm() <= -1e6 * contact.gap);  // a corner is softer than a face
    }
  }
  CHECK(turned > compared / 3);
}

TEST_CASE("blocks that have moved under potentials are pushed by springs once their law is one of these") {
  const Shape<3> cube = shape_of(completed(box({2, 2, 2}))), brick = shape_of(completed(box({1, 1, 1})));
  TwoInWorld two(cube, brick, StiffnessKind::potential);
  // Over the edge and down the side, so that they are seen to touch by a point that both still have.
  const double contact = 1.5, depth = 1e-3, down_to = 0.2;
  double x = 0, z = contact - depth;
  two.put({x, 0, z}, 0);
  while (x < contact - depth) {
    x = std::min(x + 0.25 * (contact - x), contact - depth);
    two.put({x, 0, z}, 0);
  }
  while (z > down_to) {
    z = std::max(z - 0.25 * (contact - z), down_to);
    two.put({x, 0, z}, 0);
  }
  two.set_law(StiffnessKind::per_contact);
  two.put({x, 0, z}, 0);
  const Vector<3> force = two.world.blocks().force[std::size_t(two.upper)];
  CHECK(force.x() == Approx(1e6 * depth));
  CHECK(force.y() == 0);
  CHECK(force.z() == 0);
}

TEST_CASE("in space, a contact of potentials that ends gives up what its shear spring held") {
  const Shape<3> plate = shape_of(completed(box({4, 4, 1}))), brick = shape_of(completed(box({1, 1, 1})));
  TwoInWorld two(plate, brick, StiffnessKind::potential);
  const double speed = 1e-3, elapsed = 1e-3;
  const int steps = 3;
  two.world.set_velocity(two.upper, {speed, 0, 0}, Vector<3>::Zero());
  for (int step = 0; step < steps; ++step) two.put({step * speed * elapsed, 0, 1 - 1e-3}, elapsed);
  const double slip = steps * speed * elapsed, held = 0.5 * 1e6 * slip * slip;
  CHECK(two.world.state().ledger.entries().friction_loss == Approx(0).margin(1e-9 * held));
  two.put({0, 0, 1 + 1e-3}, elapsed);
  CHECK(two.world.state().ledger.entries().friction_loss == Approx(held));
  CHECK(two.world.state().ledger.entries().strain == 0);
}
