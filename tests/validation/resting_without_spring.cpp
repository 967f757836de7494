// Blocks that rest and slide by a law without a spring.

#include "catch.h"
#include "validation/reacting.h"

namespace {

using namespace halfspace_test;

constexpr double gravity = 10;

hs_world_def heavy_world(int dimension, double mass_damping) {
  hs_world_def def = mesh_world_def(dimension, mass_damping);
  def.gravity[dimension - 1] = -gravity;
  return def;
}

/// A body of squares on a floor that is a mesh, or one block.
struct Floor {
  Floor(double friction_angle, double mass_damping, bool floor_is_mesh, int32_t kind)
      : scene(heavy_world(2, mass_damping), law_without_spring(friction_angle), 2000, {1e8, 0.25}) {
    if (floor_is_mesh) {
      const hs_body floor =
          scene.add_mesh(brick(2, {8, 1, 1}, {9, 1, 1}, [&](int) { return kind; }), {-4, -1, 0});
      scene.hold(floor, scene.nodes_where(floor, [](const Node& node) { return node.y() < -0.5; }),
                 HS_AXIS_X + HS_AXIS_Y);
    } else {
      scene.add(box(-4, -1, 4, 0), {HS_BLOCK_FIXED, {}, 0});
    }
    body = scene.add_mesh(brick(2, {1, 0.5, 1}, {6, 3, 1}, [&](int) { return kind; }), {-2.5, 0, 0});
  }

  ReactingScene scene;
  hs_body body = 0;
};

}  // namespace

TEST_CASE("a damped block rests with its weight and touches nothing anew", "[mesh][reaction]") {
  for (const bool floor_is_mesh : {false, true}) {
    for (const int32_t kind : {HS_CELL_QUAD, HS_CELL_TRIANGLE}) {
      Floor floor(30 * degree, 20, floor_is_mesh, kind);
      while (floor.scene.report().time < 1.5) floor.scene.step();
      const std::int64_t touches = floor.scene.report().touch_count;
      double squared = 0;
      int steps = 0;
      for (; floor.scene.report().time < 2; ++steps) {
        floor.scene.step();
        squared += square_of(
            floor.scene.force_on(floor.body).y() / (gravity * floor.scene.body_state(floor.body).mass) - 1);
      }
      std::printf("a body of %s on a floor that is %s: force over weight off by %.1e rms\n",
                  name_of_cell(kind), floor_is_mesh ? "a mesh" : "one block", std::sqrt(squared / steps));
      CHECK(std::sqrt(squared / steps) < 1e-3);
      CHECK(floor.scene.report().touch_count == touches);
    }
  }
}

TEST_CASE("a sliding block is braked by friction alone", "[mesh][reaction]") {
  for (const bool floor_is_mesh : {false, true}) {
    for (const int32_t kind : {HS_CELL_QUAD, HS_CELL_TRIANGLE}) {
      INFO(name_of_cell(kind) << (floor_is_mesh ? " on a mesh" : " on a block"));
      constexpr double friction = 0.3;
      Floor floor(std::atan(friction), 0, floor_is_mesh, kind);
      relax(floor.scene, 1e-6);
      const Nodes nodes = floor.scene.positions(floor.body);
      floor.scene.set_velocities(floor.body, Nodes(nodes.size(), Node(2, 0, 0)));
      const hs_body_state before = floor.scene.body_state(floor.body);
      const hs_world_report begun = floor.scene.report();
      while (floor.scene.report().time < begun.time + 0.3) floor.scene.step();
      const hs_body_state after = floor.scene.body_state(floor.body);
      const double weight_impulse = gravity * before.mass * (floor.scene.report().time - begun.time);
      const double shear = before.momentum[0] - after.momentum[0];
      const double normal = after.momentum[1] - before.momentum[1] + weight_impulse;
      CHECK(shear / normal == Approx(friction).epsilon(1e-3));
      const double lost = begun.energy.kinetic - floor.scene.report().energy.kinetic;
      CHECK(std::abs(floor.scene.report().energy.residual - begun.energy.residual) < 2e-3 * lost);
    }
  }
}

TEST_CASE("relaxation sees the forces of contacts without springs", "[mesh][reaction]") {
  Floor floor(0, 0, true, HS_CELL_QUAD);
  const hs_balance balance = relax(floor.scene, 1e-6);
  CHECK(balance.mean <= 1e-6);
  CHECK(floor.scene.contacts().size() >= 7);
}

/// Strength counts for contacts that are there from the start: two bars of equal cells hold until the pull on
/// their common face reaches it.
TEST_CASE("bars that are glued hold up to their strength", "[mesh][reaction]") {
  for (const double share : {0.9, 1.1}) {
    constexpr double strength = 1e5;
    hs_law_def law = law_without_spring();
    law.tensile_strength = strength;
    law.cohesion = 1e9;
    ReactingScene scene(mesh_world_def(2, 60), law, 2000, {1e8, 0});
    const MeshWords bar = brick(2, {2, 1, 1}, {4, 2, 1}, [](int) { return HS_CELL_QUAD; });
    const hs_body fixed = scene.add_mesh(bar, {-2, 0, 0}), pulled = scene.add_mesh(bar);
    scene.hold(fixed, scene.nodes_where(fixed, [](const Node& node) { return node.x() < -1.99; }),
               HS_AXIS_X + HS_AXIS_Y);
    for (int part = 1; part <= 100; ++part) {
      const double force = share * strength * part / 100;
      for (const double height : {0.0, 0.5, 1.0}) {
        scene.push(pulled,
                   scene.nodes_where(
                       pulled,
                       [&](const Node& node) { return node.x() > 1.9 && std::abs(node.y() - height) < 0.1; }),
                   {force * (height == 0.5 ? 0.5 : 0.25), 0, 0});
      }
      scene.step(30);
    }
    scene.step(1000);
    CHECK((scene.body_state(pulled).centroid[0] < 1.1) == (share < 1));
  }
}

TEST_CASE("rigid and affine blocks rest on blocks and meshes", "[reaction]") {
  for (const int32_t kind : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE}) {
    for (const bool floor_is_mesh : {false, true}) {
      INFO((kind == HS_BLOCK_RIGID ? "rigid" : "affine") << (floor_is_mesh ? " on a mesh" : " on a block"));
      hs_world_def def = heavy_world(2, 5);
      if (kind == HS_BLOCK_RIGID && !floor_is_mesh) def.time_step = 1e-3;  // nothing vibrates
      ReactingScene scene(def, law_without_spring(30 * degree), 2000, {1e8, 0.25});
      if (floor_is_mesh) {
        const hs_body floor =
            scene.add_mesh(brick(2, {8, 1, 1}, {9, 1, 1}, [](int) { return HS_CELL_QUAD; }), {-4, -1, 0});
        scene.hold(floor, scene.nodes_where(floor, [](const Node& node) { return node.y() < -0.5; }),
                   HS_AXIS_X + HS_AXIS_Y);
      } else {
        scene.add(box(-4, -1, 4, 0), {HS_BLOCK_FIXED, {}, 0});
      }
      const hs_block block = scene.add_at(box(0, 0, 1, 1), {0.13, 0.8}, 0.3, {kind, {}, 0});
      const double energy = scene.energy_present();
      while (scene.report().time < 4) scene.step();
      CHECK(scene.force_on_block(block).y() == Approx(gravity * scene.state(block).mass).epsilon(1e-3));
      CHECK(scene.state(block).pose.position[1] == Approx(0.5).margin(2e-3));
      CHECK(scene.energy_present() < energy);
    }
  }
}

/// Edges of one box cross edges of the other in the plane of their common face: all of these places count, so
/// that none is lost and found again in turns.
TEST_CASE("boxes that stand turned on each other come to rest on all places where they meet", "[reaction]") {
  hs_world_def def = heavy_world(3, 0);
  def.time_step = 1e-3;
  ReactingScene scene(def, law_without_spring(30 * degree), 2000, {1e8, 0.25});
  const hs_block floor = scene.add_hull(cuboid({20, 20, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
  double weight = 0;
  for (int i = 0; i < 3; ++i) {
    const hs_block block =
        scene.add_hull(cuboid({1, 0.7, 0.8}), {{0, 0, 0.41 + 0.81 * i}, turn_about({0, 0, 1}, 0.3 * i)});
    weight += gravity * scene.state(block).mass;
  }
  scene.step(500);
  const hs_world_report settled = scene.report();
  scene.step(1000);
  const hs_world_report report = scene.report();
  std::int32_t points = 0;
  for (const hs_contact& contact : scene.contacts()) points += contact.point_count;
  CHECK(report.contact_count == 3);
  CHECK(points == 4 + 8 + 8);
  CHECK(report.touch_count == settled.touch_count);
  CHECK(report.iteration_count - settled.iteration_count < 10 * 1000);
  CHECK(-scene.force_on_block(floor).z() == Approx(weight).epsilon(1e-6));
  CHECK(scene.report().energy.kinetic < 1e-12 * weight);
  // A blow takes the speed at which it is met, not that at the middle or the ends of its step.
  CHECK(std::abs(scene.report().energy.residual) < 2e-3 * report.impact_loss);
}

/// Viscous stress is formed with velocities before the kicks at its time: its loss is booked by them.
TEST_CASE("viscous bodies come to rest on each other with their energy accounted for", "[mesh][reaction]") {
  ReactingScene scene(heavy_world(2, 0), law_without_spring(30 * degree), 2000,
                      {1e8, 0.25, HS_PLANE_STRAIN, 5e-4});
  scene.add(box(-4, -1, 4, 0), {HS_BLOCK_FIXED, {}, 0});
  const MeshWords body = brick(2, {1, 1, 1}, {3, 3, 1}, [](int) { return HS_CELL_QUAD; });
  for (int i = 0; i < 3; ++i) scene.add_mesh(body, {0, double(i), 0});
  while (scene.report().time < 0.5) scene.step();
  CHECK(scene.report().block_damping_loss > 1);
  CHECK(std::abs(scene.report().energy.residual) < 1e-3 * scene.report().block_damping_loss);
}

/// Rigid blocks without springs know no other motion than that of limit equilibrium: a block on a slope stays
/// until the angle is that of friction, or that at which its weight passes the edge it stands on.
TEST_CASE("a block stands on a slope up to the angle of friction, or that of its corner", "[reaction]") {
  struct Limit {
    double height, friction, angle;
  };
  const Limit limit = GENERATE(Limit{1, 30, 30}, Limit{4, 60, 14.036243467926479});
  const int dimension = GENERATE(2, 3);
  for (const double off : {-2e-4, 2e-4}) {
    INFO(limit.height << " high, in " << dimension << "D, " << off);
    const double angle = limit.angle * (1 + off) * degree;
    hs_world_def def = mesh_world_def(dimension);
    def.time_step = 1e-3;
    def.gravity[0] = gravity * std::sin(angle);
    def.gravity[dimension - 1] = -gravity * std::cos(angle);
    ReactingScene scene(def, law_without_spring(limit.friction * degree), 2000, {});
    hs_block block = 0;
    if (dimension == 2) {
      scene.add(box(-4, -1, 4, 0), {HS_BLOCK_FIXED, {}, 0});
      block = scene.add(box(-0.5, 0, 0.5, limit.height));
    } else {
      scene.add_hull(cuboid({8, 8, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
      block = scene.add_hull(cuboid({1, 1, limit.height}), {{0, 0, 0.5 * limit.height}});
    }
    scene.step(4000);
    const double moved = std::abs(scene.state(block).pose.position[0]);
    CHECK((off < 0 ? moved < 1e-6 : moved > 1e-3));
  }
}

TEST_CASE("a tower of blocks stands at once", "[reaction]") {
  for (const int dimension : {2, 3}) {
    hs_world_def def = heavy_world(dimension, 0);
    def.time_step = 1e-3;
    SolidScene scene(def, law_without_spring(30 * degree));
    std::vector<hs_block> tower;
    const auto add = [&](double width, double middle, int32_t kind) {
      if (dimension == 2)
        return scene.add(box(-width / 2, middle - 0.5, width / 2, middle + 0.5), {kind, {}, 0});
      return scene.add_hull(cuboid({width, width, 1}), {{0, 0, middle}, {0, 0, 0, 1}, kind});
    };
    add(8, -0.5, HS_BLOCK_FIXED);
    for (int i = 0; i < 10; ++i) tower.push_back(add(1, i + 0.5, HS_BLOCK_RIGID));
    scene.step(500);
    hs_world_report report;
    scene.check(hs_world_get_report(scene.world(), &report, sizeof report));
    double moved = 0;
    for (std::size_t i = 0; i < tower.size(); ++i) {
      const Triple place = scene.place_of(tower[i]);
      moved = std::max(moved, std::abs(place[std::size_t(dimension) - 1] - (double(i) + 0.5)));
    }
    std::printf("a tower of ten, %dD: moved by %.1e, %.1f iterations per step\n", dimension, moved,
                double(report.iteration_count) / 500);
    CHECK(moved < 1e-6);
    CHECK(report.iteration_count < 50 * 500);
  }
}

TEST_CASE("a block carries another that is ten billion times heavier", "[reaction]") {
  for (const double ratio : {1e2, 1e10}) {
    hs_world_def def = heavy_world(2, 0);
    def.time_step = 1e-3;
    SolidScene scene(def, law_without_spring(30 * degree), 1000);
    const int32_t heavy = scene.add_material(1000 * ratio);
    scene.add(box(-4, -1, 4, 0), {HS_BLOCK_FIXED, {}, 0});
    scene.add(box(-0.5, 0, 0.5, 1));
    const hs_block upper = scene.add(box(-0.5, 1, 0.5, 2), {}, heavy);
    scene.step(500);
    CAPTURE(ratio);
    CHECK(std::abs(1.5 - scene.position(upper).y) < 1e-6);
    CHECK(scene.report().max_penetration_ratio == 0);
  }
}
