// Worlds whose parts do not fit together, as a damaged snapshot with a right checksum gives them, are seen to
// be none.

#include <cmath>
#include <limits>
#include <memory>

#include "catch.h"
#include "polyhedra.h"
#include "world/world.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// Two cubes on a plate, after a step, and a free slot.
std::unique_ptr<World<3>> small_world() {
  Memory* const memory = std::pmr::get_default_resource();
  WorldSettings<3> settings;
  settings.gravity = {0, 0, -10};
  settings.time_step = 1e-3;
  auto world = std::make_unique<World<3>>(settings, memory);
  const std::int32_t stone = world->add_material(1000);
  ContactLaw law;
  law.normal_stiffness = law.shear_stiffness = 1e6;
  law.tan_friction = 0.5;
  world->set_default_law(law);
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  world->add_block(cube, BlockKind::fixed, stone, {0, 0, 0}, {});
  for (int i = 1; i < 5; ++i) world->add_block(cube, BlockKind::rigid, stone, {0.1 * i, 0, 0.999 * i}, {});
  world->remove_block(3);
  world->remove_block(4);
  REQUIRE(world->step() == StepResult::ok);
  return world;
}

/// A cube on another one, whose bond is pulled apart in a step.
std::unique_ptr<World<3>> world_of_failed_bond() {
  WorldSettings<3> settings;
  settings.gravity = {0, 0, 10};
  settings.time_step = 1e-3;
  auto world = std::make_unique<World<3>>(settings, std::pmr::get_default_resource());
  const std::int32_t stone = world->add_material(1000);
  const Shape<3> cube = shape_of(completed(box({1, 1, 1})));
  world->add_block(cube, BlockKind::fixed, stone, {0, 0, 0}, {});
  world->add_block(cube, BlockKind::rigid, stone, {0, 0, 1}, {});
  BondLaw law;
  law.normal_stiffness = law.shear_stiffness = 1e6;
  REQUIRE(world->bond_pair(0, 1, law));
  REQUIRE(world->step() == StepResult::ok);
  return world;
}

/// Takes out what the list of neighbours knows of each block, and says that it is used up.
struct ForgetBlocks {
  template <class... Members>
  void operator()(Members&... members) {
    (forget(members), ...);
  }

 private:
  void forget(Array<double>& of_blocks) { of_blocks.clear(); }
  void forget(Array<Vector<3>>& of_blocks) { of_blocks.clear(); }
  void forget(Array<Rotation<3>>& of_blocks) { of_blocks.clear(); }
  void forget(std::int32_t& needs_rebuild) { needs_rebuild = 1; }
  template <class Other>
  void forget(Other&) {}
};

/// Takes out all shear springs.
struct ForgetSprings {
  template <class... Members>
  void operator()(Members&... members) {
    (forget(members), ...);
  }

 private:
  void forget(Array<ShearSpring<3>>& springs) { springs.clear(); }
  template <class Other>
  void forget(Other&) {}
};

/// Of the slots that are free names one twice.
struct RepeatFreeSlot {
  static constexpr bool reads = true;

  template <class... Members>
  void operator()(Members&... members) {
    (repeat(members), ...);
  }

 private:
  // The blocks' materials come first.
  void repeat(Array<std::int32_t>& slots) {
    if (arrays++ == 1) slots.assign(slots.size(), slots.front());
  }
  template <class Other>
  void repeat(Other&) {}

  int arrays = 0;
};

}  // namespace

TEST_CASE("a world whose parts do not fit together is seen to be none") {
  const auto world = small_world();
  REQUIRE(world->state().is_consistent());
  NeighborList<3>& candidates = world->state().contacts.neighbors();
  Blocks<3>& blocks = world->state().model.blocks;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  SECTION("a list of neighbours that does not know the blocks, of a world that is about to step") {
    ForgetBlocks forget;
    candidates.visit(forget);
  }
  SECTION("no shear springs, where a host may set their force") {
    ForgetSprings forget;
    candidates.visit(forget);
  }
  SECTION("a slot that two new blocks would get") {
    RepeatFreeSlot repeat;
    blocks.visit(repeat);
  }
  SECTION("a block nowhere") { blocks.position[1].x() = nan; }
  SECTION("a block of infinite velocity") { blocks.velocity[1].y() = HUGE_VAL; }
  SECTION("a block without mass") { blocks.mass[1] = 0; }
  SECTION("a block that turns the easier the harder it is pushed") { blocks.inertia[1].moments.z() = -1; }
  SECTION("a block whose axes are not at right angles") {
    blocks.rotation[1] = Rotation<3>::from_axes({1, 0, 0}, {1, 0, 0}, {0, 0, 1});
  }
  SECTION("a block without size") { blocks.radius[1] = nan; }
  CHECK(!world->state().is_consistent());
}

TEST_CASE("bonds that do not fit together are seen to be none") {
  const auto world = world_of_failed_bond();
  REQUIRE(world->state().is_consistent());
  Bonds<3>& bonds = world->state().model.blocks.bonds();
  REQUIRE(!bonds.events().empty());
  BondEvent<3>& event = const_cast<BondEvent<3>&>(bonds.events()[0]);

  SECTION("a failure of no bond") { event.bond = 1; }
  SECTION("a failure before all bonds") { event.bond = -1; }
  SECTION("a failure of no point") { event.point = bonds.all()[0].point_count; }
  SECTION("a failure that is none") { event.failure = BondFailure::none; }
  SECTION("a bond that hands over to a contact of blocks that are gone") {
    Bond<3>& bond = bonds.all()[0];
    bond.a = bond.b = -1;
    bond.is_joint = 0;
    bond.hands_over = 1;
  }
  CHECK(!world->state().is_consistent());
}
