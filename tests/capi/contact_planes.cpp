// The contact plane depends on where the blocks are, not on their order: flush blocks end at the same places,
// and friction acts along the floor, however the block on it pitches.

#include <algorithm>
#include <array>
#include <cmath>

#include "capi/polyhedra.h"
#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double gravity = 9.81, density = 2000, friction = 0.5;

/// A row or a tower of cubes with sides of 1 m on a floor. In space y is the depth, and z is up.
struct Cubes {
  Context context = make_context();
  World world;
  int dimension;
  std::vector<hs_block> blocks;

  /// Static penetration of one cube: `sink`. Gravity leans along x by a slope.
  Cubes(int in_dimension, std::int32_t law_kind, double sink, double slope) : dimension(in_dimension) {
    hs_world_def def = world_def(dimension);
    std::fill(def.gravity, def.gravity + 3, 0.0);
    def.gravity[0] = slope * gravity;
    def.gravity[up()] = -gravity;
    if (law_kind == HS_STIFFNESS_NONE) def.time_step = 1. / 240;
    def.potential_length = 1;
    world = make_world(context.get(), def);
    std::int32_t material = 0;
    require_ok(hs_world_add_material(world.get(), density, &material), context.get());
    // By potentials the overlap is pushed from both sides.
    const double stiffness = density * gravity / sink * (law_kind == HS_STIFFNESS_POTENTIAL ? 0.5 : 1);
    hs_law_def law = law_def(stiffness, std::atan(friction));
    law.stiffness_kind = law_kind;
    law.normal_damping = law.shear_damping = law_kind == HS_STIFFNESS_NONE ? 0 : 0.1;
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  }

  int up() const { return dimension - 1; }
  void add(double x0, double z0, double x1, double z1, std::int32_t kind, double depth) {
    const Shape shape =
        dimension == 2 ? make_shape(context.get(), box(x0, z0, x1, z1))
                       : make_polyhedron(context.get(), box_3d({x0, -depth / 2, z0}, {x1, depth / 2, z1}));
    const hs_block_def def = block_def(context.get(), shape, kind);
    blocks.push_back(add_block(context.get(), world.get(), shape, def));
  }
  void add_floor() { add(-10, -1, 30, 0, HS_BLOCK_FIXED, 10); }
  void add_cube(double x, double z) { add(x, z, x + 1, z + 1, HS_BLOCK_RIGID, 1); }

  void run(double duration) {
    const double until = report_of(world.get()).time + duration;
    while (report_of(world.get()).time < until) require_ok(hs_world_step(world.get(), 10), context.get());
  }
  hs_block_state state(std::size_t i) const {
    hs_block_state state;
    require_ok(hs_world_get_block_state(world.get(), blocks[i], &state), context.get());
    return state;
  }
};

/// The places of a tower of four cubes that leans with gravity, from below.
std::vector<double> places_of_tower(int dimension, std::int32_t law, double sink, std::array<int, 5> order) {
  Cubes cubes(dimension, law, sink, 0.1);
  std::array<std::size_t, 5> index{};
  for (const int i : order) {
    index[std::size_t(i)] = cubes.blocks.size();
    i == 0 ? cubes.add_floor() : cubes.add_cube(0, i - 1);
  }
  cubes.run(0.5);
  std::vector<double> places;
  for (const std::size_t i : index) {
    const hs_pose pose = cubes.state(i).pose;
    places.insert(places.end(), pose.position, pose.position + 3);
  }
  return places;
}

}  // namespace

TEST_CASE("a flush tower moves alike in any order of its blocks") {
  for (const int dimension : {2, 3}) {
    for (const std::int32_t law :
         {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL, HS_STIFFNESS_NONE}) {
      for (const double sink : {1e-5, 1e-3}) {
        INFO(dimension << "D, law " << law << ", sink " << sink);
        const std::vector<double> upward = places_of_tower(dimension, law, sink, {0, 1, 2, 3, 4});
        for (const std::array<int, 5>& order : {std::array{4, 3, 2, 1, 0}, std::array{2, 4, 0, 3, 1}}) {
          const std::vector<double> places = places_of_tower(dimension, law, sink, order);
          double difference = 0;
          for (std::size_t i = 0; i < places.size(); ++i)
            difference = std::max(difference, std::abs(places[i] - upward[i]));
          CHECK(difference < 1e-9);
        }
      }
    }
  }
}

TEST_CASE("friction on a plane floor is the friction coefficient times the weight, however a cube pitches") {
  for (const int dimension : {2, 3}) {
    for (const bool floor_first : {true, false}) {
      Cubes cubes(dimension, HS_STIFFNESS_PER_CONTACT, 1e-3, 0);
      if (floor_first) cubes.add_floor();
      cubes.add_cube(0, 0);
      if (!floor_first) cubes.add_floor();
      const std::size_t cube = floor_first ? 1 : 0;
      cubes.run(1);  // it settles
      const double velocity[3] = {6, 0, 0}, spin[3] = {};
      require_ok(hs_world_set_velocity(cubes.world.get(), cubes.blocks[cube], velocity, spin),
                 cubes.context.get());
      cubes.run(0.4);  // it pitches
      const double begin = report_of(cubes.world.get()).time, before = cubes.state(cube).velocity[0];
      cubes.run(0.4);
      const double duration = report_of(cubes.world.get()).time - begin;
      const double deceleration = (before - cubes.state(cube).velocity[0]) / duration;
      INFO(dimension << "D, floor first " << floor_first);
      CHECK(deceleration == Approx(friction * gravity).epsilon(1e-4));
      CHECK(std::abs(report_of(cubes.world.get()).energy.residual) < 1e-5 * 0.5 * density * 36);
    }
  }
}

}  // namespace halfspace_test
