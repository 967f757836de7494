#include "capi/meshes.h"
#include "golden/stage.h"

namespace halfspace_test {
namespace {

hs_world_def def_of(int dimension) {
  hs_world_def def = world_def(dimension);
  def.time_step = 1e-4;
  return def;
}

hs_law_def law_of_kind(std::int32_t stiffness_kind) {
  hs_law_def law = law_def(1e7, 0.4);
  law.stiffness_kind = stiffness_kind;
  return law;
}

Shape plate(const Stage& stage, int dimension) {
  return dimension == 2 ? stage.rectangle({-4, -1}, {4, 0}) : stage.cuboid({-4, -4, -1}, {4, 4, 0});
}

hs_pose above(int dimension, double height, double tangent_of_half) {
  return dimension == 2 ? turned_pose({0, height}, tangent_of_half)
                        : turned_pose({0, 0, height}, {1, 2, 3}, tangent_of_half);
}

/// The places and velocities of nodes, and what the report says, several times over.
std::uint64_t run(Stage& stage, const std::vector<hs_body>& bodies) {
  Hash hash;
  for (int i = 0; i < 4; ++i) {
    stage.ok(hs_world_step(stage.world(), 400));
    for (const hs_body body : bodies) {
      for (const auto get : {hs_world_get_node_positions, hs_world_get_node_velocities})
        for (const Point3& p : of_nodes(get, stage.world(), body)) hash.all(p.x, p.y, p.z);
    }
    for (const hs_contact& contact : contacts_of(stage.world())) record(hash, contact);
    record(hash, report_of(stage.world()));
  }
  return hash.value();
}

/// Two bodies of cells of all kinds: one falls onto a plate, the other one onto it.
std::uint64_t fall(int dimension, std::int32_t stiffness_kind) {
  Stage stage(def_of(dimension));
  stage.elastic_material(2500, elasticity_def(1e7, 1e-4));
  stage.law(law_of_kind(stiffness_kind));
  stage.add(plate(stage, dimension), HS_BLOCK_FIXED);
  std::vector<hs_body> bodies;
  for (const double height : {0.6, 2.2}) {
    bodies.push_back(add_body(stage.context(), stage.world(), bar(dimension),
                              body_def(above(dimension, height, 0.1 * height))));
  }
  return run(stage, bodies);
}

/// A row of cubes that bonds hold to a fixed one, until some of them fail.
std::uint64_t row(int dimension) {
  Stage stage(def_of(dimension));
  stage.elastic_material(2500, elasticity_def(1e8, 1e-4));
  stage.law(law_of_kind(HS_STIFFNESS_PER_AREA));
  hs_bond_def bond = bond_def(1e8, 2e5);
  bond.tensile_fracture_energy = 10;
  hs_block before = 0;
  for (int i = 0; i < 6; ++i) {
    const double x = 0.5 * i;
    const Shape cube = dimension == 2 ? stage.rectangle({x, 0}, {x + 0.5, 0.5})
                                      : stage.cuboid({x, 0, 0}, {x + 0.5, 0.5, 0.5});
    const std::int32_t kind = i == 0 ? HS_BLOCK_FIXED : i % 2 ? HS_BLOCK_RIGID : HS_BLOCK_AFFINE;
    const hs_block block = stage.add(cube, kind);
    if (before != 0) stage.ok(hs_world_bond_blocks(stage.world(), before, block, &bond));
    before = block;
  }
  return stage.run(1600);
}

}  // namespace

std::vector<Scene> scenes_of_meshes() {
  std::vector<Scene> scenes;
  for (const int dimension : {2, 3}) {
    const std::string where = dimension == 2 ? "plane: " : "space: ";
    scenes.push_back({where + "meshes, per area", [=] { return fall(dimension, HS_STIFFNESS_PER_AREA); }});
    scenes.push_back({where + "meshes, no spring", [=] { return fall(dimension, HS_STIFFNESS_NONE); }});
    scenes.push_back({where + "row that breaks", [=] { return row(dimension); }});
  }
  return scenes;
}

}  // namespace halfspace_test
