// Rigid blocks without springs that stand, and blocks that only seem to.

#include <cmath>

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

}  // namespace

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
