// Faces of rigid blocks without springs: slip and twist, bricks that meet at edges and corners, blocks that
// are pressed without weight, and other units.

#include <algorithm>
#include <array>
#include <cmath>

#include "capi/rigid_world.h"
#include "catch.h"
#include "rectangle.h"

namespace halfspace_test {
namespace {

constexpr double pi = 3.14159265358979323846;

/// The loss of spin, rad/s², of a plate that turns on a floor, over that by a friction force at 1 m.
double slowing_over_friction(const Points3& plate, double gyration_squared) {
  constexpr double friction = 0.4, spin = 5;
  RigidWorld rigid(friction, g, 1. / 240);
  rigid.add(corners_of_box({-9, -9, -1}, {9, 9, 0}), HS_BLOCK_FIXED);
  const hs_block block = rigid.add(plate);
  rigid.step(10);
  const double still[] = {0, 0, 0}, about_z[] = {0, 0, spin};
  require_ok(hs_world_set_velocity(rigid.world.get(), block, still, about_z), rigid.context.get());
  rigid.step(24);
  const double slowing = (spin - rigid.state(block).angular_velocity[2]) / 0.1;
  return slowing * gyration_squared / (friction * g);
}

}  // namespace

TEST_CASE("a plate without springs that spins is stopped by the torque of even pressure") {
  for (const double width : {1.0, 0.5, 0.05}) {
    INFO("a rectangle of 1 m x " << width << " m");
    const Points3 plate = corners_of_box({-0.5, -width / 2, 0}, {0.5, width / 2, 0.1});
    CHECK(slowing_over_friction(plate, (1 + width * width) / 12) ==
          Approx(mean_distance_of_rectangle(1, width)).epsilon(0.03));
  }
  Points3 disc;
  constexpr int sides = 24;
  for (int i = 0; i < sides; ++i)
    for (const double z : {0.0, 0.1})
      disc.push_back({std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides), z});
  // Of the polygon, whose corners are on the circle.
  const double gyration_squared = (2 + std::cos(2 * pi / sides)) / 6;
  CHECK(slowing_over_friction(disc, gyration_squared) == Approx(2. / 3).epsilon(0.03));
}

/// Slip and twist have one bound, an ellipsoid: friction against slip is less by what twist takes.
TEST_CASE("a plate that slips and spins is slowed by less than the whole friction in each") {
  constexpr double friction = 0.4;
  RigidWorld rigid(friction, g, 1. / 960);
  rigid.add(corners_of_box({-9, -9, -1}, {9, 9, 0}), HS_BLOCK_FIXED);
  const hs_block block = rigid.add(corners_of_box({-0.5, -0.5, 0}, {0.5, 0.5, 0.1}));
  rigid.step(10);
  const double radius = mean_distance_of_rectangle(1, 1), slip = 2;
  const double velocity[] = {slip, 0, 0}, about_z[] = {0, 0, slip / radius};  // slip and twist of one size
  require_ok(hs_world_set_velocity(rigid.world.get(), block, velocity, about_z), rigid.context.get());
  rigid.step(1);
  const double slowing = (slip - rigid.state(block).velocity[0]) * 960;
  CHECK(slowing == Approx(friction * g / std::sqrt(2)).epsilon(0.01));
}

TEST_CASE("bricks and pavements rest flush in space, turned by any angle") {
  for (const double turn : {0.0, 0.3, 1.1}) {
    for (const int rows : {2, 3}) {
      for (const int columns : {2, 5}) {
        for (const int courses : {1, 2}) {
          INFO("turned by " << turn << ", " << rows << " x " << columns << ", courses " << courses);
          RigidWorld rigid(0.6, g, 1. / 60);
          rigid.add(corners_of_box({-3, -3, -1}, {9, 9, 0}, turn), HS_BLOCK_FIXED);
          std::vector<hs_block> bricks;
          for (int course = 0; course < courses; ++course) {
            for (int i = 0; i < columns; ++i) {
              for (int k = 0; k < rows; ++k) {
                // Bricks of a course are shifted by a third along y: corners of one meet faces and edges of
                // others.
                const double x = i, y = k + course / 3.0, z = course;
                bricks.push_back(rigid.add(corners_of_box({x, y, z}, {x + 1, y + 1, z + 1}, turn)));
              }
            }
          }
          std::vector<hs_block_state> before;
          for (const hs_block brick : bricks) before.push_back(rigid.state(brick));
          rigid.step(60);
          const hs_world_report report = report_of(rigid.world.get());
          CHECK(std::abs(report.energy.residual) < 1e-6);
          double moved = 0;
          for (std::size_t i = 0; i < bricks.size(); ++i) {
            const hs_pose pose = rigid.state(bricks[i]).pose;
            for (int axis = 0; axis < 3; ++axis)
              moved = std::max(moved, std::abs(pose.position[axis] - before[i].pose.position[axis]));
          }
          CHECK(moved < 1e-8);
        }
      }
    }
  }
}

TEST_CASE("blocks without springs and without weight are pressed against each other") {
  for (const int dimension : {2, 3}) {
    RigidWorld rigid(0.5, 0, 1. / 60, dimension);
    std::vector<hs_block> row;
    for (int i = 0; i < 4; ++i) {
      const std::int32_t kind = i == 0 ? HS_BLOCK_FIXED : HS_BLOCK_RIGID;
      row.push_back(dimension == 2 ? rigid.add_plane_box(i, i + 1, kind)
                                   : rigid.add(corners_of_box({double(i), 0, 0}, {i + 1.0, 1, 1}), kind));
    }
    const double press[] = {-1e4, 0, 0}, torque[] = {0, 0, 0};
    require_ok(hs_world_set_applied_force(rigid.world.get(), row[3], press, torque), rigid.context.get());
    rigid.step(200);
    for (int i = 1; i < 4; ++i) CHECK(rigid.state(row[std::size_t(i)]).pose.position[0] == Approx(i + 0.5));
    for (const hs_contact& contact : contacts_of(rigid.world.get()))
      CHECK(std::abs(contact.force[0]) == Approx(1e4));
  }
}

/// Powers of two change no digit of any product.
TEST_CASE("a wall in space that a brick hits falls alike in other units of length") {
  std::array<std::vector<hs_pose>, 3> ends;
  for (std::size_t unit = 0; unit < 3; ++unit) {
    const double metre = std::ldexp(1, 10 * (int(unit) - 1));
    RigidWorld rigid(0.5, g, 1. / 240, 3, metre);
    rigid.add(corners_of_box({-6, -5, -1}, {8, 5, 0}), HS_BLOCK_FIXED);
    for (int course = 0; course < 4; ++course) {
      const double shift = 0.5 * (course % 2), z = 0.5 * course;
      for (double x = shift; x < 2; x += 1)
        rigid.add(corners_of_box({x, -0.5, z}, {std::min(x + 1, 2.0), 0.5, z + 0.5}));
      if (shift > 0) rigid.add(corners_of_box({0, -0.5, z}, {shift, 0.5, z + 0.5}));
    }
    rigid.add(corners_of_box({-1.5, -0.3, 1}, {-1, 0.2, 1.4}, 0.1), HS_BLOCK_RIGID, {12, 1, 0});
    rigid.step(120);
    ends[unit] = poses_of(rigid.world.get());
    for (hs_pose& pose : ends[unit])
      for (double& part : pose.position) part /= metre;
  }
  for (const std::size_t unit : {0, 2}) {
    for (std::size_t i = 0; i < ends[1].size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) CHECK(ends[unit][i].position[axis] == ends[1][i].position[axis]);
      for (int part = 0; part < 4; ++part) CHECK(ends[unit][i].rotation[part] == ends[1][i].rotation[part]);
    }
  }
}

}  // namespace halfspace_test
