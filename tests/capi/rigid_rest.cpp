// Rigid blocks without springs that stand, and blocks that only seem to.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "capi/rigid_world.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double frame = 1. / 60;

/// A floor and a cube on it, whose sides are 1 m.
struct CubeOnFloor : RigidWorld {
  hs_block floor, cube;

  explicit CubeOnFloor(double friction, std::int32_t kind_of_floor = HS_BLOCK_FIXED)
      : RigidWorld(friction, g, frame),
        floor(add(corners_of_box({-9, -9, -1}, {9, 9, 0}), kind_of_floor)),
        cube(add(corners_of_box({0, 0, 0}, {1, 1, 1}))) {}
  void push(double force) {
    const double along_x[] = {force, 0, 0}, still[] = {0, 0, 0};
    require_ok(hs_world_set_applied_force(world.get(), cube, along_x, still), context.get());
  }
  void move_floor(double velocity, double spin = 0) {
    const double along_x[] = {velocity, 0, 0}, about_z[] = {0, 0, spin};
    require_ok(hs_world_set_velocity(world.get(), floor, along_x, about_z), context.get());
  }
};

/// A card house: in each storey pairs of cards that lean on each other, and plates across their tops.
struct CardHouse : RigidWorld {
  static constexpr double lean = 0.3, length = 1, thickness = 0.05, half_width = 0.4;
  std::vector<hs_block> cards;

  CardHouse(int storeys, std::int32_t max_impulse_iterations)
      : RigidWorld(0.6, g, frame, 3, 1, max_impulse_iterations) {
    add(corners_of_box({-20, -5, -1}, {20, 5, 0}), HS_BLOCK_FIXED);
    const double foot = length * std::sin(lean), height = length * std::cos(lean),
                 across = thickness / std::cos(lean), span = 2 * foot + 2 * across;
    double z = 0;
    for (int count = storeys; count > 0; --count) {
      for (int k = 0; k < count; ++k) {
        const double middle = (k - 0.5 * (count - 1)) * span;
        for (const double side : {-1., 1.}) {
          const double bottom = middle + side * foot, top = middle;
          Points3 corners;
          for (const double y : {-half_width, half_width}) {
            for (const double x : {bottom, bottom + side * across}) corners.push_back({x, y, z});
            for (const double x : {top, top + side * across}) corners.push_back({x, y, z + height});
          }
          cards.push_back(add(corners));
        }
      }
      z += height;
      for (int k = 0; k + 1 < count; ++k) {
        const double middle = (k - 0.5 * (count - 2)) * span;
        cards.push_back(add(corners_of_box({middle - span / 2, -half_width, z},
                                           {middle + span / 2, half_width, z + thickness})));
      }
      z += thickness;
    }
  }
  double largest_way(int steps) {
    std::vector<hs_block_state> before;
    for (const hs_block card : cards) before.push_back(state(card));
    step(steps);
    double way = 0;
    for (std::size_t i = 0; i < cards.size(); ++i) {
      const hs_block_state after = state(cards[i]);
      const double *from = before[i].pose.position, *to = after.pose.position;
      way = std::max(way, std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]));
    }
    return way;
  }
};

}  // namespace

TEST_CASE("no cap on sweeps lets a card house fall") {
  for (const std::int32_t sweeps : {1, 4}) {
    INFO(sweeps << " sweeps");
    CHECK(CardHouse(5, sweeps).largest_way(100) < 1e-3);
  }
}

/// Sweeps alone hold no such house, and active sets do not settle what moves beside it.
TEST_CASE("a card house stands beside blocks that are in motion") {
  const std::int32_t sweeps = GENERATE(4, 200);
  CardHouse house(3, sweeps);
  std::vector<hs_block> loose;
  for (int i = 0; i < 18; ++i) {
    const double x = 6 + 0.5 * (i % 3), y = 0.5 * (i / 3 % 3) - 0.5, z = 0.5 * (i / 9);
    loose.push_back(house.add(corners_of_box({x, y, z}, {x + 0.4, y + 0.35, z + 0.3})));
  }
  CHECK(house.largest_way(10) < 1e-3);
  for (int kick = 0; kick < 10; ++kick) {
    for (std::size_t i = 0; i < loose.size(); ++i) {
      const double turn = double(i + 5 * std::size_t(kick));
      const double velocity[] = {std::cos(turn), std::sin(turn), 1.5}, spin[] = {1, 2, 3};
      require_ok(hs_world_set_velocity(house.world.get(), loose[i], velocity, spin), house.context.get());
    }
    CHECK(house.largest_way(20) < 1e-4);
  }
}

TEST_CASE("a cube without springs stands without any motion, until friction is overcome") {
  CubeOnFloor rigid(0.5);
  rigid.step(60);
  const double bound = 0.5 * density * g;
  rigid.push(0.99 * bound);
  rigid.step(600);
  CHECK(rigid.state(rigid.cube).pose.position[0] == 0.5);
  CHECK(rigid.state(rigid.cube).velocity[0] == 0);
  rigid.push(1.01 * bound);
  rigid.step(60);
  CHECK(rigid.state(rigid.cube).velocity[0] == Approx(0.01 * 0.5 * g).epsilon(1e-6));
}

TEST_CASE("no shorter step is advised where no contact has a spring") {
  CubeOnFloor rigid(0.5);
  rigid.push(1e75);
  CHECK(hs_world_step(rigid.world.get(), 100) == HS_ERROR_UNSTABLE);
  const std::string message = hs_context_last_error(rigid.context.get());
  INFO(message);
  CHECK(message.find("energy has been created") != std::string::npos);
  CHECK(message.find("reduce the time step") == std::string::npos);
}

TEST_CASE("a cube that friction does not hold is not held", "[rest]") {
  CubeOnFloor rigid(0);
  rigid.step(60);
  const double acceleration = 1e-6 * g;  // within the tolerance of the solver
  rigid.push(acceleration * density);
  rigid.step(600);
  CHECK(rigid.state(rigid.cube).velocity[0] == Approx(acceleration * 10).epsilon(1e-6));
}

TEST_CASE("a cube follows a floor that creeps", "[rest]") {
  CubeOnFloor rigid(0.5, HS_BLOCK_PRESCRIBED);
  rigid.step(60);
  constexpr double creep = 1e-8;
  rigid.move_floor(creep);
  rigid.step(600);
  CHECK(rigid.state(rigid.cube).velocity[0] == Approx(creep).epsilon(1e-3));
  rigid.move_floor(0);
  rigid.step(60);
  CHECK(std::abs(rigid.state(rigid.cube).velocity[0]) < 1e-3 * creep);
}

/// Where the velocity alone sticks, it creeps outwards by half of the square of the turn in each step.
TEST_CASE("a cube keeps its place on a platform that turns", "[rest]") {
  constexpr double spin = 1.2;
  CubeOnFloor rigid(0.6, HS_BLOCK_PRESCRIBED);
  rigid.move_floor(0, spin);
  const double velocity[] = {-0.5 * spin, 0.5 * spin, 0}, about_z[] = {0, 0, spin};
  require_ok(hs_world_set_velocity(rigid.world.get(), rigid.cube, velocity, about_z), rigid.context.get());
  const double radius = std::sqrt(0.5);
  rigid.step(3 * 314);
  const hs_pose pose = rigid.state(rigid.cube).pose;
  CHECK(std::hypot(pose.position[0], pose.position[1]) == Approx(radius).epsilon(1e-10));
}

/// Its manifold is that of the place where it stands, not of one a little before.
TEST_CASE("a cube that is set just beyond an edge falls", "[rest]") {
  RigidWorld rigid(0.5, g, frame);
  rigid.add(corners_of_box({-9, -9, -1}, {0, 9, 0}), HS_BLOCK_FIXED);
  const hs_block cube = rigid.add(corners_of_box({-0.5002, 0, 0}, {0.4998, 1, 1}));
  rigid.step(60);
  CHECK(rigid.state(cube).pose.position[2] == 0.5);
  hs_pose pose = rigid.state(cube).pose;
  pose.position[0] = 4e-4;
  require_ok(hs_world_set_pose(rigid.world.get(), cube, &pose), rigid.context.get());
  rigid.step(600);
  CHECK(rigid.state(cube).pose.position[2] < -1);
}

TEST_CASE("a block takes nothing from a removed one whose slot it has", "[rest]") {
  RigidWorld rigid(0.5, g, frame);
  const hs_block cube = rigid.add(corners_of_box({0, 0, 1}, {1, 1, 2}));
  const hs_block floor = rigid.add(corners_of_box({-9, -9, 0}, {9, 9, 1}), HS_BLOCK_FIXED);
  const hs_block aside = rigid.add(corners_of_box({4, 0, 1}, {5, 1, 2}));
  rigid.step(5);
  for (const hs_block block : {aside, floor})
    require_ok(hs_world_remove_block(rigid.world.get(), block), rigid.context.get());
  rigid.add(corners_of_box({-9, -9, 0}, {9, 9, 1}), HS_BLOCK_FIXED);
  rigid.step(60);
  CHECK(rigid.state(cube).pose.position[2] == Approx(1.5).epsilon(1e-12));
}

}  // namespace halfspace_test
