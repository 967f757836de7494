// halfspace/water.h against Archimedes and the definition of effective stress, and its energy.

#include <cmath>

#include "capi/loads.h"
#include "capi/snapshot_worlds.h"
#include "capi/unchanged.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double g = 9.81;

struct Sea {
  Context context = make_context();
  World world;

  explicit Sea(int dimension, double time_step = 0) {
    hs_world_def def = world_def(dimension);
    def.time_step = time_step;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 600, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e6);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    const hs_law_def law = law_def(1e7, 0.5);
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  }
  /// A box of 2 by 1, in space by 2, whose vertical axis is the last one.
  hs_block add_box(int dimension, double height, std::int32_t kind, double angle = 0) {
    const Shape shape = dimension == 2 ? make_shape(context.get(), box(-1, -0.5, 1, 0.5))
                                       : make_polyhedron(context.get(), box_3d({-1, -1, -0.5}, {1, 1, 0.5}));
    const hs_pose pose = dimension == 2 ? pose_at({0, height, 0}, {0, 0, 1}, angle)
                                        : pose_at({0, 0, height}, {1, 2, 3}, angle);
    return add_block(context.get(), world.get(), shape, kind, pose);
  }
};

double height_of(const hs_world* world, hs_block block, int dimension) {
  return state_of(world, block).pose.position[dimension - 1];
}

struct Loads {
  Points3 forces, torques;
};

Loads loads_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_blocks(world, nullptr, 0, &count);
  Loads loads{Points3(std::size_t(count)), Points3(std::size_t(count))};
  if (hs_world_get_water_loads(world, mutable_view_of(loads.forces), mutable_view_of(loads.torques)) != HS_OK)
    throw std::runtime_error("no loads of water");
  return loads;
}

}  // namespace

TEST_CASE("a block comes to rest with the draught of Archimedes") {
  const int dimension = GENERATE(2, 3);
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  Sea sea(dimension);
  const hs_block raft = sea.add_box(dimension, 0.3, kind);
  set_water(sea.context.get(), sea.world.get(), dimension == 2 ? Points3{{0, 0, 0}} : Points3{{5, 5, 0}});
  hs_relaxation_def def = relaxation_def(200000, 1e-9);
  require_ok(hs_world_relax(sea.world.get(), &def, nullptr, 0), sea.context.get());
  CAPTURE(dimension, kind);
  // 600 of 1000 parts are under water; the affine block is compressed by less than its weight over its
  // modulus.
  const double strain = kind == HS_BLOCK_RIGID ? 0 : 600 * g / 1e6;
  CHECK(height_of(sea.world.get(), raft, dimension) == Approx(-0.1).margin(1e-6 + strain));
}

TEST_CASE("the energy of a block that bobs and rolls in water does not drift") {
  const int dimension = GENERATE(2, 3);
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  Sea sea(dimension, 5e-4);
  sea.add_box(dimension, 0.35, kind, 0.5);
  set_water(sea.context.get(), sea.world.get(),
            dimension == 2 ? Points3{{-1, 0, 0}, {0.2, 0.1, 0}, {1, 0, 0}} : Points3{{0, 0, 0}});
  const double before = report_of(sea.world.get()).water_energy;
  double largest = 0, kinetic = 0;
  for (int i = 0; i < 200; ++i) {  // 20 s, some ten periods
    require_ok(hs_world_step(sea.world.get(), 200), sea.context.get());
    const hs_world_report report = report_of(sea.world.get());
    largest = std::max(largest, std::abs(report.energy.residual));
    kinetic = std::max(kinetic, report.energy.kinetic);
  }
  CAPTURE(dimension, kind, kinetic, largest);
  CHECK(before > 0);
  CHECK(kinetic > 100);
  CHECK(largest < 1e-4 * kinetic);
}

TEST_CASE("the force of water is the gradient of its energy, also at corners and steps of the table") {
  const int dimension = GENERATE(2, 3);
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  const Points3 tables[] = {{{-0.5, 0.2, 0}, {0.1, 0.4, 0}, {0.1, -0.1, 0}, {0.6, -0.3, 0}},
                            {{0, 0, 0.1}, {1, 0, 0.3}, {0, 1, -0.2}}};
  for (int i = 0; i < 8; ++i) {
    Sea sea(dimension);
    const hs_block raft = sea.add_box(dimension, 0.1 * i - 0.4, kind, 0.4 * i);
    set_water(sea.context.get(), sea.world.get(), tables[dimension - 2]);
    const Loads loads = loads_of(sea.world.get());
    const hs_pose pose = state_of(sea.world.get(), raft).pose;
    const double force[3] = {loads.forces[0].x, loads.forces[0].y, loads.forces[0].z};
    for (int axis = 0; axis < dimension; ++axis) {
      constexpr double step = 1e-5;
      double energy[2];
      for (const int side : {0, 1}) {
        hs_pose moved = pose;
        moved.position[axis] += side == 0 ? -step : step;
        require_ok(hs_world_set_pose(sea.world.get(), raft, &moved), sea.context.get());
        energy[side] = report_of(sea.world.get()).water_energy;
      }
      CAPTURE(dimension, kind, i, axis);
      CHECK(force[axis] == Approx((energy[0] - energy[1]) / (2 * step)).margin(1e-3));
      require_ok(hs_world_set_pose(sea.world.get(), raft, &pose), sea.context.get());
    }
  }
}

TEST_CASE("the force of water below a height map is the gradient of its energy") {
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  // Cells within the block, and others beyond it; the block also reaches beyond the border.
  const double heights[] = {0.1, 0.3, -0.2, 0.4, 0.2, -0.1, 0.3, 0, -0.3, 0.2, 0.1, 0.4};
  Points3 map;
  for (const double y : {-0.4, 0.1, 0.7}) {
    for (const double x : {-0.8, -0.3, 0.2, 3.0}) map.push_back({x, y, heights[map.size()]});
  }
  for (int i = 0; i < 8; ++i) {
    Sea sea(3);
    const hs_block raft = sea.add_box(3, 0.1 * i - 0.4, kind, 0.4 * i);
    set_water_map(sea.context.get(), sea.world.get(), map, 4);
    const Point3 force = loads_of(sea.world.get()).forces[0];
    const hs_pose pose = state_of(sea.world.get(), raft).pose;
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double step = 1e-5;
      double energy[2];
      for (const int side : {0, 1}) {
        hs_pose moved = pose;
        moved.position[axis] += side == 0 ? -step : step;
        require_ok(hs_world_set_pose(sea.world.get(), raft, &moved), sea.context.get());
        energy[side] = report_of(sea.world.get()).water_energy;
      }
      CAPTURE(kind, i, axis);
      const double component = axis == 0 ? force.x : axis == 1 ? force.y : force.z;
      CHECK(component == Approx((energy[0] - energy[1]) / (2 * step)).margin(1e-3));
    }
  }
}

TEST_CASE("a height map that is plane is a plane, and is saved") {
  Sea by_plane(3, 1e-3), by_map(3, 1e-3);
  by_plane.add_box(3, 0.1, HS_BLOCK_RIGID, 0.5);
  by_map.add_box(3, 0.1, HS_BLOCK_RIGID, 0.5);
  const auto height = [](double x, double y) { return 0.1 + 0.2 * x - 0.3 * y; };
  Points3 map;
  for (const double y : {-9.0, -0.6, 0.2, 9.0}) {
    for (const double x : {-9.0, -0.5, 0.1, 0.4, 9.0}) map.push_back({x, y, height(x, y)});
  }
  set_water(by_plane.context.get(), by_plane.world.get(),
            {{0, 0, height(0, 0)}, {1, 0, height(1, 0)}, {0, 1, height(0, 1)}});
  set_water_map(by_map.context.get(), by_map.world.get(), map, 5);
  const Loads expected = loads_of(by_plane.world.get()), loads = loads_of(by_map.world.get());
  const double scale = expected.forces[0].z;
  CHECK(scale > 1e3);
  CHECK(loads.forces[0].x == Approx(expected.forces[0].x).margin(1e-12 * scale));
  CHECK(loads.forces[0].y == Approx(expected.forces[0].y).margin(1e-12 * scale));
  CHECK(loads.forces[0].z == Approx(scale).epsilon(1e-12));
  CHECK(loads.torques[0].x == Approx(expected.torques[0].x).margin(1e-12 * scale));
  CHECK(loads.torques[0].y == Approx(expected.torques[0].y).margin(1e-12 * scale));
  CHECK(loads.torques[0].z == Approx(expected.torques[0].z).margin(1e-12 * scale));
  const World copy = restored(by_map.context.get(), saved(by_map.world.get()));
  require_ok(hs_world_step(by_map.world.get(), 50), by_map.context.get());
  require_ok(hs_world_step(copy.get(), 50), by_map.context.get());
  CHECK(saved(copy.get()) == saved(by_map.world.get()));
}

TEST_CASE("a polyhedron comes to rest with the draught of Archimedes") {
  // A tetrahedron with its apex below: the part under water is a smaller one.
  Sea sea(3);
  const Shape shape = make_hull(sea.context.get(), {{0, 0, -1.5}, {1, 1, 0.5}, {-1, 1, 0.5}, {0, -2, 0.5}});
  const hs_block buoy = add_block(sea.context.get(), sea.world.get(), shape, HS_BLOCK_RIGID,
                                  pose_at({0, 0, 0.3}, {0, 0, 1}, 0.4));
  require_ok(hs_world_hold_block(sea.world.get(), buoy, HS_AXIS_X | HS_AXIS_Y | HS_AXIS_ROTATION),
             sea.context.get());
  set_water(sea.context.get(), sea.world.get(), {{0, 0, 0}});
  const hs_relaxation_def def = relaxation_def(200000, 1e-9);
  require_ok(hs_world_relax(sea.world.get(), &def, nullptr, 0), sea.context.get());
  // Its centroid is a quarter of its height of 2 below its base.
  const double draught = 1.5 - height_of(sea.world.get(), buoy, 3);
  CHECK(draught == Approx(2 * std::cbrt(0.6)).margin(1e-6));
}

TEST_CASE("ponded water presses on a dam, and below its base as far as the table reaches") {
  Sea sea(2);
  const Shape dam = make_shape(sea.context.get(), box(0, 0, 3, 4));
  add_block(sea.context.get(), sea.world.get(), dam, HS_BLOCK_RIGID, pose_at(1.5, 2));
  const double depth = 2.5, reach = 1;
  set_water(sea.context.get(), sea.world.get(), {{reach, depth, 0}, {reach, -1, 0}});
  const Loads loads = loads_of(sea.world.get());
  const double thrust = 1000 * g * depth * depth / 2, uplift = 1000 * g * depth * reach;
  CHECK(loads.forces[0].x == Approx(thrust).epsilon(1e-12));
  CHECK(loads.forces[0].y == Approx(uplift).epsilon(1e-12));
  CHECK(loads.torques[0].z == Approx((2 - depth / 3) * thrust - (1.5 - reach / 2) * uplift).epsilon(1e-12));
}

TEST_CASE("water below a sloping table pushes blocks down its slope, and all displaced water weighs") {
  Sea sea(2);
  sea.add_box(2, -5, HS_BLOCK_RIGID, 0.7);
  set_water(sea.context.get(), sea.world.get(), {{-10, 1, 0}, {10, -1, 0}});
  const Loads loads = loads_of(sea.world.get());
  CHECK(loads.forces[0].x == Approx(2 * 1000 * g * 0.1));
  CHECK(loads.forces[0].y == Approx(2 * 1000 * g));
  CHECK(loads.torques[0].z == Approx(0).margin(1e-8));
}

TEST_CASE("contacts in a column under water carry effective stress") {
  const int dimension = GENERATE(2, 3);
  Sea sea(dimension);
  std::int32_t rock = -1;
  require_ok(hs_world_add_material(sea.world.get(), 2600, &rock), sea.context.get());
  sea.add_box(dimension, -0.5, HS_BLOCK_FIXED);
  const Shape shape = dimension == 2
                          ? make_shape(sea.context.get(), box(-1, -0.5, 1, 0.5))
                          : make_polyhedron(sea.context.get(), box_3d({-1, -1, -0.5}, {1, 1, 0.5}));
  for (int i = 0; i < 4; ++i) {
    hs_block_def def = block_def(sea.context.get(), shape, HS_BLOCK_RIGID);
    def.material = rock;
    def.pose = pose_at(0, 0);
    def.pose.position[dimension - 1] = 0.5 + i;
    add_block(sea.context.get(), sea.world.get(), shape, def);
  }
  set_water(sea.context.get(), sea.world.get(), dimension == 2 ? Points3{{0, 10, 0}} : Points3{{0, 0, 10}});
  hs_relaxation_def def = relaxation_def(200000, 1e-8);
  require_ok(hs_world_relax(sea.world.get(), &def, nullptr, 0), sea.context.get());
  const std::vector<hs_contact> contacts = contacts_of(sea.world.get());
  REQUIRE(contacts.size() == 4);
  const double volume = dimension == 2 ? 2 : 4;
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(contacts[i].normal_force == Approx(double(4 - i) * volume * 1600 * g).epsilon(1e-6));
}

TEST_CASE("a mesh bears water at its surface only, and floats as a block does") {
  const int dimension = GENERATE(2, 3);
  Sea sea(dimension);
  MeshWords words = bar(dimension);
  const hs_body body = add_body(sea.context.get(), sea.world.get(), words, body_def(pose_at(0, -8)));
  // Deep under water all of its volume is displaced.
  set_water(sea.context.get(), sea.world.get(), dimension == 2 ? Points3{{0, 0, 0}} : Points3{{0, 0, 5}});
  const Loads loads = loads_of(sea.world.get());
  double sum[3] = {};
  for (const Point3& force : loads.forces) sum[0] += force.x, sum[1] += force.y, sum[2] += force.z;
  hs_body_state state = state_of_body(sea.world.get(), body);
  CHECK(sum[dimension - 1] == Approx(1000 * g * state.mass / 600));
  CHECK(sum[0] == Approx(0).margin(1e-8 * sum[dimension - 1]));
  // Its energy does not drift.
  double largest = 0, kinetic = 0;
  for (int i = 0; i < 50; ++i) {
    require_ok(hs_world_step(sea.world.get(), 20), sea.context.get());
    const hs_world_report report = report_of(sea.world.get());
    largest = std::max(largest, std::abs(report.energy.residual));
    kinetic = std::max(kinetic, report.energy.kinetic);
  }
  CHECK(kinetic > 1);
  CHECK(largest < 1e-3 * kinetic);
}

TEST_CASE("a prescribed block that is pushed under water takes the work of Archimedes") {
  Sea sea(2, 1e-3);
  const hs_block plunger = sea.add_box(2, 0.5, HS_BLOCK_PRESCRIBED);
  set_water(sea.context.get(), sea.world.get(), {{0, 0, 0}});
  const double down[3] = {0, -1, 0}, still[3] = {};
  require_ok(hs_world_set_velocity(sea.world.get(), plunger, down, still), sea.context.get());
  const double before = report_of(sea.world.get()).energy.outer_work;
  require_ok(hs_world_step(sea.world.get(), 1000), sea.context.get());  // by its height
  const hs_world_report report = report_of(sea.world.get());
  CHECK(report.energy.outer_work - before == Approx(1000 * g * 0.5 * 2).epsilon(1e-6));
  CHECK(report.energy.residual == Approx(0).margin(1e-6 * report.water_energy));
}

TEST_CASE("a changed table is external work, and without a table there is no water") {
  Sea sea(2);
  sea.add_box(2, 0, HS_BLOCK_RIGID);
  const double none = report_of(sea.world.get()).energy.outer_work;
  set_water(sea.context.get(), sea.world.get(), {{0, 0.5, 0}});
  const hs_world_report wet = report_of(sea.world.get());
  CHECK(wet.water_energy == Approx(1000 * g * 0.5 * 2));
  CHECK(wet.energy.outer_work - none == Approx(wet.water_energy));
  CHECK(wet.energy.residual == Approx(0).margin(1e-9));
  set_water(sea.context.get(), sea.world.get(), {});
  const hs_world_report dry = report_of(sea.world.get());
  CHECK(dry.water_energy == 0);
  CHECK(dry.energy.outer_work == Approx(none).margin(1e-9));
  CHECK(loads_of(sea.world.get()).forces[0].y == 0);
}

TEST_CASE("water refuses what is no table, and a snapshot continues with the same bits") {
  Sea sea(2);
  sea.add_box(2, 0, HS_BLOCK_RIGID, 0.3);
  hs_world* w = sea.world.get();
  const auto call = [&](const Points3& table, double density, double factor) {
    return [&sea, table, density, factor] {
      const hs_water_def def = water_def(density, factor);
      return hs_world_set_water(sea.world.get(), &def, view_of(table));
    };
  };
  check_unchanged(sea, "hs_world_set_water",
                  {{"def", "NULL", [&] { return hs_world_set_water(w, nullptr, {}); }},
                   {"def.density", "-1", call({{0, 0, 0}}, -1, 1)},
                   {"def.factor", "nan", call({{0, 0, 0}}, 1000, std::nan(""))},
                   {"table[1]", "(0, 1)", call({{1, 0, 0}, {0, 1, 0}}, 1000, 1)},
                   {"table[0]", "nan", call({{std::nan(""), 0, 0}}, 1000, 1)},
                   {"table", "steeper", call({{0, 0, 0}, {1e-9, 1, 0}}, 1000, 1)}});
  Sea space(3);
  space.add_box(3, 0, HS_BLOCK_RIGID);
  const auto in_space = [&](const Points3& table) {
    return [&space, table] {
      const hs_water_def def = water_def();
      return hs_world_set_water(space.world.get(), &def, view_of(table));
    };
  };
  check_unchanged(space, "hs_world_set_water",
                  {{"table.count", "2", in_space({{0, 0, 0}, {1, 0, 0}})},
                   {"table", "steeper", in_space({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}})}});
  const auto by_map = [](Sea& s, const Points3& table, std::int32_t columns) {
    return [&s, table, columns] {
      hs_water_def def = water_def();
      def.columns = columns;
      return hs_world_set_water(s.world.get(), &def, view_of(table));
    };
  };
  const Points3 square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  Points3 turned = square, bent = square, steep = square;
  std::swap(turned[0], turned[1]);
  bent[3].y = 1.5;
  steep[3].z = 1e7;
  check_unchanged(sea, "hs_world_set_water", {{"def.columns", "2", by_map(sea, square, 2)}});
  check_unchanged(space, "hs_world_set_water",
                  {{"def.columns", "-1", by_map(space, square, -1)},
                   {"def.columns", "1", by_map(space, square, 1)},
                   {"table.count", "4", by_map(space, square, 3)},
                   {"table.count", "4", by_map(space, square, 4)},
                   {"table.count", "0", by_map(space, {}, 2)},
                   {"table[1]", "(0, 0, 0)", by_map(space, turned, 2)},
                   {"table[3]", "(1, 1.5, 0)", by_map(space, bent, 2)},
                   {"table", "steeper", by_map(space, steep, 2)}});
  set_water(sea.context.get(), w, {{-1, 0, 0}, {1, 0.2, 0}});
  require_ok(hs_world_step(w, 100), sea.context.get());
  const World copy = restored(sea.context.get(), saved(w));
  require_ok(hs_world_step(w, 100), sea.context.get());
  require_ok(hs_world_step(copy.get(), 100), sea.context.get());
  CHECK(saved(copy.get()) == saved(w));
}

}  // namespace halfspace_test
