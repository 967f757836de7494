#include "counted_scenes.h"

#include <dlfcn.h>

#include <cmath>

#include "capi/mesh_words.h"
#include "settled_scenes.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::brick;
using halfspace_test::MeshWords;
using halfspace_test::require_ok;
using halfspace_test::World;

constexpr std::int64_t wait_with_springs = 200, wait_without = 200;  // steps

/// Largest speed at rest, over that of a fall by a block's size. Springs go on to vibrate a little. Without
/// them, only blocks as slow as this are held, and keep their impulses from step to step without any
/// iteration.
constexpr double rest_with_springs = 1e-3, rest_without = 1e-7;

double fall(double size) { return std::sqrt(9.81 * size); }

/// A law that the library refuses is one that it lacks.
World empty_world(hs_context* context, int dimension, double time_step, const hs_law_def& law) {
  try {
    return make_world(context, dimension, time_step, law);
  } catch (const std::runtime_error& refusal) {
    throw NotOffered(refusal.what());
  }
}

/// With a time step of 0, that which the library finds.
World world_of(hs_context* context, const Scene& scene, const hs_law_def& law, double time_step) {
  World world = empty_world(context, scene.dimension, time_step, law);
  for (const Block& block : scene.blocks) add_block(context, world.get(), scene.dimension, block, nullptr);
  return world;
}

/// As stiff on a face as 1e7 N/m per contact.
hs_law_def springs(std::int32_t stiffness_kind, double size) {
  double stiffness = 1e7;
  if (stiffness_kind != HS_STIFFNESS_PER_CONTACT) stiffness /= size * size;
  if (stiffness_kind == HS_STIFFNESS_POTENTIAL) stiffness *= size / 2;
  return law_of(stiffness_kind, stiffness);
}

CountedScene with_springs(const std::string& law, std::int32_t stiffness_kind, const Scene& scene) {
  return {
      law + "-" + scene.name, rest_with_springs * fall(scene.size), wait_with_springs,
      [=](hs_context* context) { return world_of(context, scene, springs(stiffness_kind, scene.size), 0); }};
}

/// 60 steps a second for blocks of 1 m; for others as many while they fall by their size.
CountedScene without_springs(const Scene& scene) {
  return {"none-" + scene.name, rest_without * fall(scene.size), wait_without, [=](hs_context* context) {
            return world_of(context, scene, law_of(HS_STIFFNESS_NONE, 1), std::sqrt(scene.size) / 60);
          }};
}

/// A flat body, two cells high, on a fixed block.
World body_on_floor(hs_context* context, const MeshWords& words, double cell) {
  if (!dlsym(RTLD_DEFAULT, "hs_mesh_create")) throw NotOffered("there are no meshes");
  const int dimension = words.dimension;
  World world = empty_world(context, dimension, 0, law_of(HS_STIFFNESS_PER_AREA, 1e10));
  hs_elasticity_def elasticity{};
  require_ok(hs_elasticity_def_init(&elasticity, sizeof elasticity), context);
  elasticity.damping_time = 0.1 * cell / 600;  // waves run at 600 m/s
  require_ok(hs_world_set_elasticity(world.get(), 0, &elasticity), context);
  add_block(context, world.get(), dimension,
            {HS_BLOCK_FIXED, box_of(dimension, {-1, -1, -1}, {2, dimension == 2 ? 0. : 2., 0})}, nullptr);
  hs_body_def def{};
  require_ok(hs_body_def_init(&def, sizeof def), context);
  hs_body body = 0;
  require_ok(
      hs_world_add_mesh(world.get(), halfspace_test::make_mesh(context, words).get(), &def, nullptr, &body),
      context);
  return world;
}

CountedScene mesh(const char* name, const MeshWords& words, double cell) {
  return {name, rest_with_springs * fall(cell), wait_with_springs,
          [=](hs_context* context) { return body_on_floor(context, words, cell); }};
}

}  // namespace

std::vector<CountedScene> counted_scenes() {
  // Small, as valgrind takes 50 times as long, and large enough for most blocks to have others on all sides.
  const Scene heap = polygons(10, 20), wall_of_bricks = bricks(20, 10, 0.25),
              wall_of_cubes = cubes(16, 8, 0.25), packing = polyhedra(5, 5);
  std::vector<CountedScene> scenes;
  for (const Scene& scene : {heap, wall_of_bricks, wall_of_cubes, packing})
    scenes.push_back(with_springs("contact", HS_STIFFNESS_PER_CONTACT, scene));
  for (const Scene& scene : {wall_of_cubes, polyhedra(4, 4)})  // a contact of those takes ten times as long
    scenes.push_back(with_springs("area", HS_STIFFNESS_PER_AREA, scene));
  for (const Scene& scene : {wall_of_cubes, packing})
    scenes.push_back(with_springs("potential", HS_STIFFNESS_POTENTIAL, scene));
  for (const Scene& scene : {heap, wall_of_bricks, wall_of_cubes, packing})
    scenes.push_back(without_springs(scene));
  scenes.push_back(
      mesh("mesh-quads", brick(2, {1, 0.02, 0}, {100, 2, 0}, [](int) { return HS_CELL_QUAD; }), 0.01));
  scenes.push_back(mesh("mesh-tetrahedra",
                        brick(3, {1, 1, 0.25}, {8, 8, 2}, [](int) { return HS_CELL_TETRAHEDRON; }), 0.125));
  return scenes;
}

}  // namespace halfspace_benchmark
