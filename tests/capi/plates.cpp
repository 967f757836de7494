// Shear on a face in space: it acts in the middle of the face, twists by the mean distance from it, and does
// the same to a block in the plane as to the extruded one in space.

#include <cmath>

#include "capi/snapshot_worlds.h"
#include "catch.h"
#include "rectangle.h"

namespace halfspace_test {
namespace {

constexpr double g = 9.81, density = 1000, pi = 3.14159265358979323846;

/// A fixed floor up to z = 0, in the plane y = 0, and the law between it and a block on it, whose weight
/// sinks in by this part of its height.
struct Floor {
  Context context = make_context();
  World world;
  int dimension;

  Floor(int of_dimension, std::int32_t kind, double friction, double damping, double base, double sink,
        double slope = 0, double time_step = 0)
      : dimension(of_dimension) {
    hs_world_def def = world_def(dimension);
    def.gravity[0] = g * std::sin(slope);
    def.gravity[dimension - 1] = -g * std::cos(slope);
    if (dimension == 3) def.gravity[1] = 0;
    def.time_step = time_step;
    def.potential_length = 1;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), density, &material), context.get());
    const double per_area = density * g / sink;
    hs_law_def law =
        law_def(kind == HS_STIFFNESS_PER_CONTACT ? per_area * base : per_area, std::atan(friction));
    law.stiffness_kind = kind;
    law.normal_damping = law.shear_damping = damping;
    if (kind == HS_STIFFNESS_POTENTIAL) {
      law.normal_stiffness = per_area / 2;
      law.shear_stiffness = per_area * base;
    }
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  }

  void add_floor() { add({{-20, 0, -20}, {20, 0, -20}, {20, 0, 0}, {-20, 0, 0}}, 20, HS_BLOCK_FIXED); }

  /// A polygon in the plane y = 0, in space extruded along y by half the depth to both sides.
  hs_block add(const Points3& polygon, double depth, std::int32_t kind = HS_BLOCK_RIGID) {
    Points points;
    Points3 extruded;
    for (const Point3& p : polygon) {
      points.push_back({p.x, p.z});
      for (const double y : {-depth / 2, depth / 2}) extruded.push_back({p.x, y, p.z});
    }
    const Shape shape =
        dimension == 2 ? make_shape(context.get(), points) : make_hull(context.get(), extruded);
    return add_block(context.get(), world.get(), shape, block_def(context.get(), shape, kind));
  }
  /// On the floor, in either order.
  hs_block add_above(const Points3& polygon, double depth, bool floor_first = true) {
    if (floor_first) add_floor();
    const hs_block block = add(polygon, depth);
    if (!floor_first) add_floor();
    return block;
  }
  hs_block add_box(double length, double depth, double height, bool floor_first = true) {
    const double x = length / 2;
    return add_above({{-x, 0, 0}, {x, 0, 0}, {x, 0, height}, {-x, 0, height}}, depth, floor_first);
  }
  void run_for(double seconds) { run(context.get(), world.get(), seconds); }
  hs_block_state state(hs_block block) const { return state_of(world.get(), block); }
};

int any_spring_law() {
  return GENERATE(int(HS_STIFFNESS_PER_CONTACT), int(HS_STIFFNESS_PER_AREA), int(HS_STIFFNESS_POTENTIAL));
}

}  // namespace

TEST_CASE("a block on a steep slope stands where friction holds it, whatever the damping") {
  const int kind = any_spring_law();
  const double damping = GENERATE(0.02, 0.1, 0.5);
  CAPTURE(kind, damping);
  // Its pressure is 0 at the uphill end of its base, and a roll moves it sideways.
  Floor floor(3, kind, 1.3, damping, 1, 1e-4, pi / 4);
  const hs_block block = floor.add_box(1, 1, 0.5);
  const hs_relaxation_def relaxation = relaxation_def(100000, 1e-8);
  require_ok(hs_world_relax(floor.world.get(), &relaxation, nullptr, 0), floor.context.get());
  const double roll[] = {1e-6, 0, 0}, still[] = {0, 0, 0};
  require_ok(hs_world_set_velocity(floor.world.get(), block, still, roll), floor.context.get());
  const hs_block_state before = floor.state(block);
  floor.run_for(4);
  const hs_block_state after = floor.state(block);
  for (int k = 0; k < 3; ++k) {
    CHECK(after.pose.position[k] == Approx(before.pose.position[k]).margin(1e-4));
    CHECK(std::abs(after.velocity[k]) < 1e-5);
  }
}

TEST_CASE("a pull of .99 of friction holds, and one of 1.01 slides by the rest") {
  const int kind = any_spring_law();
  const int dimension = GENERATE(2, 3);
  const double damping = GENERATE(0.05, 0.5), sink = GENERATE(1e-4, 1e-3);
  CAPTURE(kind, dimension, damping, sink);
  const double friction = 0.5, height = 0.5;
  Floor floor(dimension, kind, friction, damping, 1, sink);
  const hs_block block = floor.add_box(1, 1, height);
  const double limit = friction * g * floor.state(block).mass;
  const auto pull_up_to = [&](double from, double to, double seconds) {
    constexpr int parts = 50;
    for (int i = 1; i <= parts; ++i) {
      const double force[] = {(from + (to - from) * i / parts) * limit, 0, 0}, torque[] = {0, 0, 0};
      require_ok(hs_world_set_applied_force(floor.world.get(), block, force, torque), floor.context.get());
      floor.run_for(seconds / parts);
    }
  };
  floor.run_for(1);
  pull_up_to(0, 0.99, 2);
  const double held = floor.state(block).pose.position[0];
  floor.run_for(1);
  CHECK(floor.state(block).pose.position[0] == Approx(held).margin(0.01 * sink * height));
  pull_up_to(0.99, 1.01, 0.1);
  const double start = report_of(floor.world.get()).time, before = floor.state(block).velocity[0];
  floor.run_for(1);
  const double speeding =
      (floor.state(block).velocity[0] - before) / (report_of(floor.world.get()).time - start);
  CHECK(speeding == Approx(0.01 * friction * g).epsilon(0.01));
}

TEST_CASE("a plate with uneven pressure that is pulled through its middle does not yaw") {
  const int kind = GENERATE(int(HS_STIFFNESS_PER_CONTACT), int(HS_STIFFNESS_PER_AREA));
  const bool floor_first = GENERATE(true, false);
  CAPTURE(kind, floor_first);
  const double height = 0.1, sink = 1e-5;
  Floor floor(3, kind, 0.5, 0.3, 1, sink);
  const hs_block plate = floor.add_box(1, 1, height, floor_first);
  const double weight = floor.state(plate).mass * g, pull = 0.2 * weight;
  const auto load = [&](double along_y) {
    const double force[] = {0, along_y, 0}, torque[] = {-along_y * height / 2, 0.1 * weight, 0};
    require_ok(hs_world_set_applied_force(floor.world.get(), plate, force, torque), floor.context.get());
    floor.run_for(0.5);
    return floor.state(plate);
  };
  const hs_block_state tilted = load(0), pulled = load(pull);
  const double slip = pulled.pose.position[1] - tilted.pose.position[1];
  CHECK(slip > 0.05 * sink * height);
  CHECK(std::abs(pulled.pose.rotation[2] - tilted.pose.rotation[2]) < 1e-4 * slip);
}

TEST_CASE("a plate that spins is stopped by the torque of even pressure") {
  const int kind = any_spring_law();
  const double width = GENERATE(1.0, 0.5, 0.05);
  const bool floor_first = GENERATE(true, false);
  CAPTURE(kind, width, floor_first);
  const double friction = 0.4, spin = 5;
  Floor floor(3, kind, friction, 0.3, width, 1e-6);
  const hs_block plate = floor.add_box(1, width, 0.1, floor_first);
  floor.run_for(0.1);
  const double still[] = {0, 0, 0}, about_z[] = {0, 0, spin};
  require_ok(hs_world_set_velocity(floor.world.get(), plate, still, about_z), floor.context.get());
  floor.run_for(0.02);  // until the shear spring slides
  const double start = report_of(floor.world.get()).time,
               spin_at_start = floor.state(plate).angular_velocity[2];
  floor.run_for(0.1);
  const double slowing =
      (spin_at_start - floor.state(plate).angular_velocity[2]) / (report_of(floor.world.get()).time - start);
  const double gyration_squared = (1 + width * width) / 12;
  CHECK(slowing * gyration_squared / (friction * g) ==
        Approx(mean_distance_of_rectangle(1, width)).epsilon(0.03));
}

TEST_CASE("a prism lands on an edge in space as the polygon does in the plane") {
  const int kind = any_spring_law();
  const double damping = GENERATE(0.1, 1.0);
  CAPTURE(kind, damping);
  hs_block_state landed[2];
  for (const int dimension : {2, 3}) {
    Floor floor(dimension, kind, 5, damping, 1, 1e-4, 0, 4e-5);
    // A hexagon rolls over its corner at the origin onto the next face.
    Points3 hexagon;
    const double tilt = 5 * pi / 180, side = 1;
    const Point3 middle{side * std::cos(pi / 3 + tilt), 0, side * std::sin(pi / 3 + tilt)};
    for (int i = 0; i < 6; ++i) {
      const double angle = i * pi / 3 + 4 * pi / 3 + tilt;
      hexagon.push_back({middle.x + side * std::cos(angle), 0, middle.z + side * std::sin(angle)});
    }
    const hs_block block = floor.add_above(hexagon, 1);
    floor.run_for(0.6);
    landed[dimension - 2] = floor.state(block);
  }
  const double spin = landed[0].angular_velocity[2];
  CHECK(landed[1].angular_velocity[1] == Approx(-spin).epsilon(1e-3).margin(1e-3));
  CHECK(landed[1].pose.position[0] == Approx(landed[0].pose.position[0]).margin(1e-4));
  CHECK(landed[1].pose.position[2] == Approx(landed[0].pose.position[1]).margin(1e-4));
  CHECK(std::abs(landed[1].pose.position[1]) < 1e-9);
}

}  // namespace halfspace_test
