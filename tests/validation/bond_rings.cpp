// Blocks that meet at a corner within a bonded body are no contact, as long as bonds lead around the corner.

#include <random>

#include "catch.h"
#include "validation/bonds.h"

namespace {

using namespace halfspace_test;

const hs_law_def stiff = spring_law(1e9);

}  // namespace

TEST_CASE("in a bonded body that is shaken nothing touches at its corners", "[bonds]") {
  const int32_t cell = GENERATE(from_range(std::begin(all_cell_kinds), std::end(all_cell_kinds)));
  const int dimension = dimension_of(cell);
  INFO(name_of_cell(cell));
  MeshScene scene(mesh_world_def(dimension), stiff, 2000, {1e9, 0.2});
  const hs_body body =
      scene.add_mesh(taken_apart(brick(dimension, {1, 1, 1}, {3, 3, 3}, [&](int) { return cell; })));
  CHECK(bond_all(scene, strong_bond(1e10)) > 0);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-1, 1);
  Nodes velocities = scene.positions(body);
  for (Node& velocity : velocities)
    velocity = {speed(random), speed(random), dimension == 3 ? speed(random) : 0};
  scene.set_velocities(body, velocities);
  for (int i = 0; i < 20; ++i) {
    scene.step(10);
    CHECK(scene.contacts().empty());
  }
}

TEST_CASE("blocks that met at a corner touch when the bonds around it have broken", "[bonds]") {
  MeshScene scene(mesh_world_def(2), stiff, 2000, {1e9, 0.2});
  const hs_block low = scene.add(box(0, 0, 1, 1), {HS_BLOCK_RIGID, {1, 1}, 0});
  const hs_block high = scene.add(box(1, 1, 2, 2), {HS_BLOCK_RIGID, {-1, -1}, 0});
  scene.add(box(1, 0, 2, 1), {HS_BLOCK_RIGID, {3, -3}, 0});
  scene.add(box(0, 1, 1, 2), {HS_BLOCK_RIGID, {-3, 3}, 0});
  hs_bond_def bond = bond_def(1e9);
  bond.tensile_strength = bond.cohesion = 1e3;
  CHECK(bond_all(scene, bond) == 4);
  scene.step();
  CHECK_FALSE(scene.contact_between(low, high));
  while (scene.report().time < 1 && !scene.contact_between(low, high)) scene.step();
  CHECK(scene.contact_between(low, high));
  const double touched = scene.report().time;
  while (scene.report().time < touched + 0.05) scene.step();
  // They push each other along y, and slide past.
  CHECK(scene.velocity(low).y < 0.5);
  CHECK(scene.velocity(high).y > -0.5);
}

/// A crack that is there from the start: bonds lead around its tip, but its two faces press each other.
TEST_CASE("faces that are not bonded touch, also where a ring of bonds ends them", "[bonds]") {
  MeshScene scene(mesh_world_def(2), stiff, 2000, {1e9, 0.2});
  scene.add(box(-1, -1, 1, 0), {HS_BLOCK_FIXED, {}, 0});
  const hs_block left = scene.add(box(-1, 0, 0, 1), {HS_BLOCK_RIGID, {1, 0}, 0}, scene.add_material(2000));
  const hs_block right = scene.add(box(0, 0, 1, 1), {HS_BLOCK_RIGID, {-1, 0}, 0}, scene.add_material(2000));
  const hs_bond_def bond = strong_bond(1e9);
  for (const int32_t material : {1, 2})
    scene.check(hs_world_bond_materials(scene.world(), 0, material, &bond, nullptr));
  CHECK(bonds_of(scene).size() == 2);
  scene.step(3);
  CHECK(scene.contact_between(left, right));
}
