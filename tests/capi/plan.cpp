// halfspace/plan.h: what a world says of itself, and that measuring leaves no trace in it.

#include "capi/meshes.h"
#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {
namespace {

hs_world_plan plan_of(hs_world* world, std::int64_t steps = 0) {
  hs_world_plan plan{};
  if (hs_world_get_plan(world, steps, &plan, sizeof plan) != HS_OK) throw std::runtime_error("no plan");
  return plan;
}

/// The parts that are active when two boxes have this law.
std::int32_t parts_of(const hs_law_def& law, const hs_world_def& def = world_def()) {
  TwoBoxes s(0, def);
  require_ok(hs_world_set_default_law(s.world.get(), &law), s.context.get());
  return plan_of(s.world.get()).parts;
}

hs_law_def bare_law() {
  hs_law_def law = law_def(1e8, 0);
  law.normal_damping = law.shear_damping = 0;
  return law;
}

}  // namespace

TEST_CASE("a plan names the parts that laws and settings ask for, and no others") {
  CHECK(parts_of(bare_law()) == 0);
  hs_law_def law = bare_law();
  law.friction_angle = 0.5;
  CHECK(parts_of(law) == HS_PART_FRICTION);
  law = bare_law();
  law.cohesion = 1;
  CHECK(parts_of(law) == (HS_PART_FRICTION | HS_PART_BONDS));
  law = bare_law();
  law.normal_damping = 0.1;
  CHECK(parts_of(law) == HS_PART_CONTACT_DAMPING);
  law = bare_law();
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  CHECK(parts_of(law) == HS_PART_AREA);
  law.stiffness_kind = HS_STIFFNESS_POTENTIAL;
  CHECK(parts_of(law) == HS_PART_POTENTIAL);
  law = bare_law();
  law.stiffness_kind = HS_STIFFNESS_NONE;
  CHECK(parts_of(law) == HS_PART_HARD_CONTACTS);
  law.friction_angle = 0.5;
  CHECK(parts_of(law) == (HS_PART_FRICTION | HS_PART_HARD_CONTACTS));
  law.friction_angle = 0;
  law.cohesion = 1;
  CHECK(parts_of(law) == (HS_PART_FRICTION | HS_PART_BONDS | HS_PART_HARD_CONTACTS));
  hs_world_def def = world_def();
  def.local_damping = 0.1;
  CHECK(parts_of(bare_law(), def) == HS_PART_LOCAL_DAMPING);
  def = world_def();
  def.mass_damping = 0.1;
  CHECK(parts_of(bare_law(), def) == HS_PART_MASS_DAMPING);

  const TwoBoxes s;
  const hs_elasticity_def elasticity = elasticity_def(1e8);
  require_ok(hs_world_set_elasticity(s.world.get(), s.material, &elasticity), s.context.get());
  CHECK((plan_of(s.world.get()).parts & HS_PART_STRAIN) == 0);
  add_block(s.context.get(), s.world.get(), box(9, 9, 10, 10), HS_BLOCK_AFFINE);
  CHECK((plan_of(s.world.get()).parts & HS_PART_STRAIN) != 0);
  CHECK(plan_of(s.world.get()).affine_count == 1);
}

TEST_CASE("a plan counts the cells and nodes of meshes, and bonds") {
  const TwoBoxes s;
  const hs_world_plan before = plan_of(s.world.get());
  CHECK(before.body_count + before.cell_count + before.node_count + before.bond_count == 0);
  const hs_elasticity_def elasticity = elasticity_def(1e8);
  require_ok(hs_world_set_elasticity(s.world.get(), s.material, &elasticity), s.context.get());
  for (const double x : {20., 30.}) add_body(s.context.get(), s.world.get(), bar(2), body_def(pose_at(x, 0)));
  const hs_world_plan with = plan_of(s.world.get());
  CHECK(with.body_count == 2);
  CHECK(with.cell_count == 2 * 3);
  CHECK(with.node_count == 2 * 6);
  CHECK(with.mesh_bytes > before.mesh_bytes);
  CHECK(with.block_bytes - before.block_bytes > with.mesh_bytes - before.mesh_bytes);
}

TEST_CASE("without friction pairs keep no shear spring") {
  TwoBoxes with(0.5), without(0);
  CHECK(plan_of(with.world.get()).pair_bytes > plan_of(without.world.get()).pair_bytes);
  CHECK(plan_of(with.world.get()).block_bytes == plan_of(without.world.get()).block_bytes);
}

TEST_CASE("the block that limits the step is the one without which it is longer") {
  TwoBoxes s;
  const hs_block light = add_block(s.context.get(), s.world.get(), box(3, 5, 3.1, 5.1), HS_BLOCK_RIGID);
  const hs_world_plan before = plan_of(s.world.get());
  CHECK(before.limiting_block == light);
  CHECK(before.limiting_neighbor == 0);
  CHECK(before.stable_time_step == report_of(s.world.get()).stable_time_step);
  require_ok(hs_world_remove_block(s.world.get(), light), s.context.get());
  const hs_world_plan after = plan_of(s.world.get());
  CHECK(after.limiting_block != light);
  CHECK(after.stable_time_step > 2 * before.stable_time_step);

  require_ok(hs_world_remove_block(s.world.get(), s.box_away), s.context.get());
  const hs_world_plan alone = plan_of(s.world.get());
  CHECK(alone.limiting_block == s.box_on_floor);
  CHECK(alone.limiting_neighbor == s.floor);
}

TEST_CASE("the limit is that of the thinnest element, or of the stiffest bond") {
  TwoBoxes s;
  const hs_elasticity_def elasticity = elasticity_def(1e12);
  require_ok(hs_world_set_elasticity(s.world.get(), s.material, &elasticity), s.context.get());
  add_body(s.context.get(), s.world.get(), bar(2), body_def(pose_at(20, 0)));
  MeshWords thin;
  thin.nodes = {{0, 0, 0}, {1, 0, 0}, {1.05, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1.05, 1, 0}};
  thin.add_cell(HS_CELL_QUAD, {0, 1, 4, 3}).add_cell(HS_CELL_QUAD, {1, 2, 5, 4});
  const hs_body body = add_body(s.context.get(), s.world.get(), thin, body_def(pose_at(30, 0)));
  const hs_world_plan by_element = plan_of(s.world.get());
  CHECK(by_element.limiting_body == body);
  CHECK(by_element.limiting_cell == 1);
  CHECK(by_element.limiting_bond == -1);

  const hs_block blocks[] = {add_block(s.context.get(), s.world.get(), box(40, 0, 41, 1), HS_BLOCK_RIGID),
                             add_block(s.context.get(), s.world.get(), box(41, 0, 42, 1), HS_BLOCK_RIGID)};
  const hs_bond_def bond = bond_def(1e20, 1e6);
  require_ok(hs_world_bond_blocks(s.world.get(), blocks[0], blocks[1], &bond), s.context.get());
  const hs_world_plan by_bond = plan_of(s.world.get(), 5);
  CHECK(by_bond.limiting_body == 0);
  CHECK(by_bond.limiting_bond == 0);
  CHECK(by_bond.limiting_cell == -1);
  CHECK(by_bond.limiting_block + by_bond.limiting_neighbor == blocks[0] + blocks[1]);
  CHECK(by_bond.stable_time_step < 1e-2 * by_element.stable_time_step);
  CHECK(by_bond.bond_seconds > 0);
  CHECK(by_bond.hard_contact_seconds == 0);
}

TEST_CASE("cells that have been removed are not counted") {
  const TwoBoxes s;
  const hs_elasticity_def elasticity = elasticity_def(1e8);
  require_ok(hs_world_set_elasticity(s.world.get(), s.material, &elasticity), s.context.get());
  const hs_body body = add_body(s.context.get(), s.world.get(), bar(2), body_def(pose_at(20, 0)));
  const std::int32_t gone = 2;
  Points3 released(6);
  require_ok(hs_world_remove_cells(s.world.get(), body, &gone, 1, mutable_view_of(released)),
             s.context.get());
  CHECK(plan_of(s.world.get()).cell_count == 2);
}

TEST_CASE("a world in which nothing moves has no limit and no times") {
  const TwoBoxes s;
  for (const hs_block block : {s.box_on_floor, s.box_away})
    require_ok(hs_world_remove_block(s.world.get(), block), s.context.get());
  const hs_world_plan plan = plan_of(s.world.get(), 10);
  CHECK(plan.stable_time_step == 0);
  CHECK(plan.limiting_block == 0);
  CHECK(plan.fixed_count == 1);
  CHECK(plan.measured_steps == 0);
}

TEST_CASE("measuring steps a copy: the world goes on as if it had not been asked") {
  TwoBoxes asked, unasked;
  REQUIRE(hs_world_step(asked.world.get(), 7) == HS_OK);
  REQUIRE(hs_world_step(unasked.world.get(), 7) == HS_OK);
  const hs_world_plan plan = plan_of(asked.world.get(), 100);
  CHECK(plan.measured_steps == 100);
  CHECK(plan.pair_seconds > 0);
  CHECK(plan.motion_seconds > 0);
  CHECK(saved(asked.world.get()) == saved(unasked.world.get()));
  REQUIRE(hs_world_step(asked.world.get(), 100) == HS_OK);
  REQUIRE(hs_world_step(unasked.world.get(), 100) == HS_OK);
  CHECK(saved(asked.world.get()) == saved(unasked.world.get()));
}

}  // namespace halfspace_test
