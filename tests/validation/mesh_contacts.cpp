// Meshes that touch: equal bars, weight on a floor; and what contacts do to the
// ledger. Case D03 of the project's list.

#include "catch.h"
#include "validation/mesh.h"

namespace {

using namespace halfspace_test;

constexpr int32_t of_mesh = HS_BLOCK_MESH;

/// The force on a body by its contacts.
Node contact_force(const MeshScene& scene, hs_body body) {
  Node force = Node::Zero();
  for (const hs_contact& contact : scene.contacts()) {
    const auto is_mine = [&](hs_block block) {
      hs_body of = 0;
      scene.check(hs_world_get_body_of_block(scene.world(), block, &of, nullptr));
      return of == body;
    };
    if (is_mine(contact.block_b)) force += Node(contact.force[0], contact.force[1], contact.force[2]);
    if (is_mine(contact.block_a)) force -= Node(contact.force[0], contact.force[1], contact.force[2]);
  }
  return force;
}

}  // namespace

/// D03. A wave runs through both bars and back: then they part, with their velocities exchanged.
TEST_CASE("equal bars of each kind of cell exchange their velocities", "[mesh]") {
  for (const int32_t kind : all_cell_kinds) {
    INFO(name_of_cell(kind));
    const int dimension = dimension_of(kind);
    MeshScene scene(mesh_world_def(dimension), area_law(2e12), 2500, {10e9, 0});
    const MeshWords bar = brick(dimension, {1, 0.1, 0.1}, {20, 2, 2}, [&](int) { return kind; });
    const hs_body striker = scene.add_mesh(bar, {-1, 0, 0}, {1, 0, 0}),
                  target = scene.add_mesh(bar, {1e-9, 0, 0});
    double begun = 0, ended = 0, impulse = 0;
    while (scene.report().time < 1.5e-3) {
      scene.step();
      const double force = contact_force(scene, target).x();
      impulse += force * scene.report().time_step;
      if (force > 0 && begun == 0) begun = scene.report().time;
      if (force > 0) ended = scene.report().time;
    }
    const hs_body_state first = scene.body_state(striker), second = scene.body_state(target);
    std::printf(
        "bars of %-10s touch for %.4f ms, velocities %.4f and %.4f m/s, residual %.1e of the energy\n",
        name_of_cell(kind), 1e3 * (ended - begun), first.momentum[0] / first.mass,
        second.momentum[0] / second.mass, scene.energy().residual / (0.5 * first.mass));
    CHECK(ended - begun == Approx(1e-3).epsilon(0.05));  // 2 L / c, and what the springs take
    CHECK(first.momentum[0] + second.momentum[0] == Approx(first.mass).epsilon(1e-12));
    CHECK(impulse == Approx(second.momentum[0]).epsilon(1e-9));
    CHECK(second.momentum[0] / second.mass == Approx(1).margin(0.03));
    CHECK(std::abs(scene.energy().residual) < 3e-3 * 0.5 * first.mass);
  }
}

/// The blocks of a body take up its weight together, and what they pass on to the nodes is all of it.
TEST_CASE("a body of each kind of cell rests on a floor with its weight", "[mesh]") {
  for (const int32_t kind : all_cell_kinds) {
    INFO(name_of_cell(kind));
    const int dimension = dimension_of(kind);
    hs_world_def def = mesh_world_def(dimension, 60);
    def.gravity[dimension - 1] = -10;
    MeshScene scene(def, area_law(1e10, 0.5), 2000, {1e8, 0.25});
    const hs_body body = scene.add_mesh(brick(dimension, {1, 1, 1}, {3, 3, 3}, [&](int) { return kind; }));
    if (dimension == 2) {
      scene.add(box(-1, -1, 2, 0), {HS_BLOCK_FIXED, {}, 0});
    } else {
      scene.add_hull(cuboid({4, 4, 1}), {{0.5, 0.5, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED, {}, {}});
    }
    scene.step(std::int64_t(0.5 / scene.report().time_step));
    const hs_body_state state = scene.body_state(body);
    const double weight = 10 * state.mass;
    CHECK(contact_force(scene, body)[dimension - 1] == Approx(weight).epsilon(1e-4));
    CHECK(state.kinetic_energy < 1e-6 * weight);
    double unbalanced = 0;
    for (const Node& force : scene.forces(body)) unbalanced = std::max(unbalanced, force.norm());
    CHECK(unbalanced < 1e-3 * weight);
    const double sunk = 0.5 - state.centroid[dimension - 1];
    std::printf("body of %-10s rests, sunk by %.3e m, unbalanced by %.1e of its weight\n", name_of_cell(kind),
                sunk, unbalanced / weight);
    // The column shortens by weight / 2 E on average at half its height, less where it may not spread: E / (1
    // - nu^2) and more; the springs by weight / k.
    CHECK(sunk == Approx(weight / 1e10 + weight / 3 / 1e8).epsilon(0.15));
    CHECK(std::abs(scene.energy().residual) < 1e-3 * weight);
  }
}

TEST_CASE("a body does not touch itself where its cells share a node", "[mesh]") {
  MeshScene scene(mesh_world_def(2), area_law(1e12), 2000, {1e9, 0.25});
  const hs_body body = scene.add_mesh(brick(2, {1, 1, 0}, {4, 4, 0}, [](int) { return HS_CELL_TRIANGLE; }));
  scene.step(100);
  CHECK(scene.contacts().empty());
  CHECK(scene.body_state(body).kinetic_energy == 0);
}

/// A snapshot goes on with the same bits, and a body that is taken out leaves the others as they are.
TEST_CASE("a world of meshes is saved, restored, and loses a body", "[mesh]") {
  hs_world_def def = mesh_world_def(2);
  def.gravity[1] = -10;
  def.time_step = 2e-5;
  MeshScene scene(def, area_law(1e10, 0.5), 2000, {1e9, 0.25});
  const MeshWords square =
      brick(2, {1, 1, 0}, {2, 2, 0}, [](int i) { return i % 2 ? HS_CELL_TRIANGLE : HS_CELL_QUAD; });
  const hs_body lower = scene.add_mesh(square), upper = scene.add_mesh(square, {0.3, 1.001, 0});
  scene.add(box(-1, -1, 2, 0), {HS_BLOCK_FIXED, {}, 0});
  scene.step(2000);
  std::size_t size = 0;
  CHECK(hs_world_save(scene.world(), nullptr, 0, &size) == HS_NOTE_TRUNCATED);
  std::vector<unsigned char> bytes(size);
  scene.check(hs_world_save(scene.world(), bytes.data(), size, &size));
  hs_world* restored = nullptr;
  scene.check(hs_world_restore(scene.context(), bytes.data(), size, &restored));
  const World twin(restored);
  scene.step(500);
  scene.check(hs_world_step(restored, 500));
  hs_body_state ours = scene.body_state(upper), theirs;
  scene.check(hs_world_get_body_state(restored, upper, &theirs, sizeof theirs));
  CHECK(std::memcmp(&ours, &theirs, sizeof ours) == 0);

  scene.check(hs_world_remove_body(scene.world(), lower));
  hs_body_state gone;
  CHECK(hs_world_get_body_state(scene.world(), lower, &gone, sizeof gone) == HS_ERROR_STALE_ID);
  ours = scene.body_state(upper);
  scene.step(100);
  CHECK(scene.body_state(upper).momentum[1] / ours.mass - ours.momentum[1] / ours.mass ==
        Approx(-10 * 100 * 2e-5));
  for (const hs_contact& contact : scene.contacts()) {
    hs_block_state a, b;
    scene.check(hs_world_get_block_state(scene.world(), contact.block_a, &a));
    scene.check(hs_world_get_block_state(scene.world(), contact.block_b, &b));
    CHECK((a.kind == of_mesh) != (b.kind == of_mesh));
  }
}
