// Rigid blocks without springs beside blocks that deform, are held or are bonded: pairs of rigid blocks keep
// their manifolds and restitution, the others meet in points, and both share the blocks between them.

#include "validation/reacting.h"

namespace {

using namespace halfspace_test;

constexpr double gravity = 9.81;

hs_law_def hard_law(double friction, double restitution = 0) {
  hs_law_def law = law_without_spring(std::atan(friction));
  law.restitution = restitution;
  return law;
}

constexpr Start fixed{HS_BLOCK_FIXED, {}, 0};

/// A floor, with something far from the blocks in question that meets it in points.
enum class Beside { nothing, affine_block, held_block, bonding_law };

struct Mixed : ReactingScene {
  Mixed(double step, const hs_law_def& law, Beside beside = Beside::nothing)
      : ReactingScene(world_def(step, -gravity), law, 1000, {1e9, 0.25}) {
    floor = add(box(-200, -2, 200, 0), fixed);
    if (beside == Beside::affine_block) add(box(100, 0, 101, 1), {HS_BLOCK_AFFINE, {}, 0});
    if (beside == Beside::held_block)
      check(hs_world_hold_block(world(), add(box(100, 0, 101, 1)), HS_AXIS_X));
    if (beside == Beside::bonding_law) {
      hs_law_def bonding = hard_law(0.5);
      bonding.cohesion = 1e3;
      const std::int32_t material = add_material(1000);
      check(hs_world_set_law(world(), 0, material, &bonding));
      add(box(100, 0, 101, 1), {}, material);
    }
  }
  hs_block floor = 0;
};

}  // namespace

TEST_CASE("a block bounces by its restitution, whatever stands beside it", "[impulses]") {
  for (const Beside beside : {Beside::affine_block, Beside::held_block, Beside::bonding_law}) {
    INFO("beside " << int(beside));
    Mixed alone(1e-3, hard_law(0.5, 0.6)), mixed(1e-3, hard_law(0.5, 0.6), beside);
    const hs_block of_alone = alone.add(box(0, 1, 1, 2)), of_mixed = mixed.add(box(0, 1, 1, 2));
    double peak = 0;
    for (int i = 0; i < 1000; ++i) {
      alone.step();
      mixed.step();
      peak = std::max(peak, mixed.velocity(of_mixed).y);
      REQUIRE(mixed.position(of_mixed).y == Approx(alone.position(of_alone).y).epsilon(1e-7));
    }
    CHECK(peak == Approx(0.6 * std::sqrt(2 * gravity)).epsilon(1e-2));
  }
}

TEST_CASE("a tower of rigid blocks stands on one that is held", "[impulses]") {
  Mixed scene(1.0 / 60, hard_law(0.5));
  std::vector<hs_block> tower = {scene.floor};
  for (int i = 0; i < 10; ++i) tower.push_back(scene.add(box(-0.5, i, 0.5, i + 1)));
  scene.check(hs_world_hold_block(scene.world(), tower[1], HS_AXIS_X));
  scene.step(60);
  for (std::size_t i = 1; i < tower.size(); ++i) {
    CHECK(scene.position(tower[i]).y == Approx(double(i) - 0.5).margin(1e-6));
    // Its weight, without the contact below and above.
    CHECK(scene.force_on_block(tower[i]).y() == Approx(1000 * gravity).epsilon(1e-4));
  }
  CHECK(scene.contacts().size() >= 10);
  CHECK(scene.report().max_penetration_ratio < 1e-6);
}

/// The block of the middle is struck from one side and pushes on to the other: by two perfectly inelastic
/// impacts all three move on together.
TEST_CASE("momentum passes through manifolds and points together", "[impulses]") {
  for (const std::int32_t kind : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE}) {
    Mixed scene(1e-5, hard_law(0));
    const hs_block first = scene.add(box(0, 0, 1, 1), {HS_BLOCK_RIGID, {3, 0}, 0});
    const hs_block middle = scene.add(box(1, 0, 2, 1));
    const hs_block last = scene.add(box(2, 0, 3, 1), {kind, {}, 0});
    if (kind == HS_BLOCK_RIGID) scene.check(hs_world_hold_block(scene.world(), last, HS_AXIS_Y));
    scene.step(20);
    const double momentum = scene.velocity(first).x + scene.velocity(middle).x + scene.velocity(last).x;
    CHECK(momentum == Approx(3).epsilon(1e-9));
    CHECK(scene.velocity(first).x == Approx(scene.velocity(middle).x).epsilon(1e-6));
    if (kind == HS_BLOCK_RIGID) CHECK(scene.velocity(last).x == Approx(1).epsilon(1e-6));
    // Elastic waves keep their energy to second order in the step.
    CHECK(std::abs(scene.energy().residual) < 1e-5 * 4500);
  }
}

/// After the waves have been damped the floor carries the tower's weight.
TEST_CASE("a tower of rigid blocks settles on a mesh", "[impulses]") {
  hs_world_def def = world_def(0, -gravity);
  def.mass_damping = 20;
  ReactingScene scene(def, hard_law(0.5), 1000, {1e8, 0.25});
  const hs_body floor =
      scene.add_mesh(brick(2, {4, 1, 1}, {4, 2, 1}, [](int) { return HS_CELL_QUAD; }), {-2, -1, 0});
  scene.hold(floor, scene.nodes_where(floor, [](const Node& node) { return node.y() < -0.5; }),
             HS_AXIS_X + HS_AXIS_Y);
  std::vector<hs_block> tower;
  for (int i = 0; i < 5; ++i) tower.push_back(scene.add(box(-0.5, i, 0.5, i + 1)));
  while (scene.report().time < 1) scene.step();
  CHECK(scene.force_on(floor).y() == Approx(-5 * 1000 * gravity).epsilon(1e-3));
  for (std::size_t i = 1; i < tower.size(); ++i) {
    CHECK(scene.position(tower[i]).y - scene.position(tower[i - 1]).y == Approx(1).epsilon(1e-6));
    CHECK(std::abs(scene.position(tower[i]).x) < 1e-6);
  }
}

/// A tower whose base is held beside one that is not: points far away change nothing.
TEST_CASE("a tall stack stands though a held block rests elsewhere on its floor", "[impulses]") {
  Mixed scene(1.0 / 60, hard_law(0.5), Beside::held_block);
  std::vector<hs_block> stack;
  for (int i = 0; i < 100; ++i) stack.push_back(scene.add(box(-0.5, i, 0.5, i + 1)));
  scene.step(60);
  for (std::size_t i = 0; i < stack.size(); ++i)
    CHECK(scene.position(stack[i]).y == Approx(double(i) + 0.5).margin(1e-6));
}

/// Blocks that overlap come apart away from the block that points hold.
TEST_CASE("recovery from penetration moves no block into one that is held", "[impulses]") {
  Mixed scene(1.0 / 60, hard_law(0.5));
  const hs_block base = scene.add(box(-1.5, 0, 1.5, 1));
  scene.check(hs_world_hold_block(scene.world(), base, HS_AXIS_X));
  const hs_block lower = scene.add(box(-0.5, 1, 0.5, 2)), upper = scene.add(box(-0.5, 1.95, 0.5, 11.95));
  scene.step(40);
  CHECK(scene.position(lower).y == Approx(1.5).margin(1e-6));
  CHECK(scene.position(upper).y > 1.998 + 5);
}

/// The host may go on after a refused step, and take away what met in points.
TEST_CASE("a refused step leaves no points behind", "[impulses]") {
  const auto forces_after = [](bool is_refused) {
    hs_world_def def = world_def(1.0 / 60, -gravity);
    def.fast_blocks = HS_FAST_REFUSE;
    ReactingScene scene(def, hard_law(0.5), 1000, {1e6, 0.25});
    scene.add(box(-20, -1, 20, 0), fixed);
    const hs_block soft = scene.add(box(-0.5, 0, 0.5, 1), {HS_BLOCK_AFFINE, {}, 0});
    const hs_block rigid = scene.add(box(4.5, 0, 5.5, 1));
    scene.add(box(11.99, 0, 12.01, 1), fixed);
    const hs_block fast = scene.add(box(9.95, 0.45, 10.05, 0.55), {HS_BLOCK_RIGID, {1e4, 0}, 0});
    if (is_refused) CHECK(hs_world_step(scene.world(), 1) != HS_OK);
    const double at_rest[3] = {0, 0, 0};
    scene.check(hs_world_set_velocity(scene.world(), fast, at_rest, at_rest));
    scene.check(hs_world_remove_block(scene.world(), soft));
    scene.step(2);
    return scene.force_on_block(rigid).y();
  };
  CHECK(forces_after(true) == forces_after(false));
}
