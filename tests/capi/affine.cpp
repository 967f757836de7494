// halfspace/affine.h: what a host sets comes back, and worlds of affine blocks are saved, restored and used
// by stages as others.

#include <cstring>

#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double still[9] = {};
constexpr PileOf affine_pile{HS_BLOCK_AFFINE, HS_STIFFNESS_POTENTIAL};

/// One affine block, of an odd shape, that nothing acts on.
struct Alone {
  Context context = make_context();
  World world;
  hs_block block = 0;

  explicit Alone(const hs_pose& pose = pose_at(3, 4)) {
    hs_world_def def = world_def();
    def.gravity[1] = 0;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e8);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    const Shape shape = make_shape(context.get(), {{0, 0}, {2, 0.5}, {1.5, 2}, {0.2, 1.5}});
    hs_block_def block_def;
    require_ok(hs_block_def_init(&block_def, sizeof block_def, shape.get()), context.get());
    block_def.kind = HS_BLOCK_AFFINE;
    block_def.pose = pose;
    block_def.angular_velocity[2] = 2;
    require_ok(hs_world_add_block(world.get(), shape.get(), &block_def, &block), context.get());
  }
};

Points vertices_in(const hs_world* world, hs_block block) {
  Points vertices(16);
  std::int64_t count = 0;
  if (hs_world_get_block_vertices(world, block, mutable_view_of(vertices), &count) != HS_OK)
    throw std::runtime_error("no vertices");
  vertices.resize(std::size_t(count));
  return vertices;
}

/// What the stages tell of a world without a past.
struct Stages {
  std::vector<hs_contact> contacts;
  std::vector<double> force, torque;  // [n][3]

  Stages(hs_world* world, std::size_t blocks) : force(3 * blocks), torque(3 * blocks) {
    const auto view = [&](std::vector<double>& v) {
      return hs_mutable_view{&v[0], &v[1], &v[2], 24, std::int64_t(blocks)};
    };
    REQUIRE(hs_world_detect(world, nullptr) == HS_OK);
    REQUIRE(hs_world_forces(world, 0, view(force), view(torque)) == HS_OK);
    contacts = contacts_of(world);
  }
};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

bool same(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b) { return a == b; }

}  // namespace

TEST_CASE("an affine block begins unstrained, turned and turning as its definition says") {
  const Alone s(pose_at(3, 4, 0.6, 0.8));
  const hs_deformation d = deformation_of(s.world.get(), s.block);
  const double cosine = 0.8 * 0.8 - 0.6 * 0.6, sine = 2 * 0.6 * 0.8;
  const double turned[9] = {cosine, -sine, 0, sine, cosine, 0, 0, 0, 1};
  const double turning[9] = {-2 * sine, -2 * cosine, 0, 2 * cosine, -2 * sine, 0, 0, 0, 0};
  for (int i = 0; i < 9; ++i) {
    CHECK(d.gradient[i] == Approx(turned[i]).margin(1e-15));
    CHECK(d.rate[i] == Approx(turning[i]).margin(1e-15));
    CHECK(std::abs(d.strain[i]) <= 1e-15);
    CHECK(std::abs(d.stress[i]) <= 1e-15 * 1e9);
  }
  CHECK(state_of(s.world.get(), s.block).angular_velocity[2] == Approx(2).epsilon(1e-15));
  CHECK(state_of(s.world.get(), s.block).pose.rotation[2] == Approx(0.6).epsilon(1e-15));
}

TEST_CASE("blocks of other kinds are told as turned, and as not strained") {
  TwoBoxes s;
  const double velocity[3] = {1, 0, 0}, spin[3] = {0, 0, 3};
  REQUIRE(hs_world_set_velocity(s.world.get(), s.box_away, velocity, spin) == HS_OK);
  const hs_pose pose = pose_at(2.5, 3.5, 0.6, 0.8);
  REQUIRE(hs_world_set_pose(s.world.get(), s.box_away, &pose) == HS_OK);
  hs_deformation all[3];
  std::int64_t count = 0;
  REQUIRE(hs_world_get_deformations(s.world.get(), all, 3, &count) == HS_OK);
  REQUIRE(count == 3);
  const hs_deformation one = deformation_of(s.world.get(), s.box_away);
  CHECK(std::memcmp(&one, &all[2], sizeof one) == 0);
  CHECK(one.gradient[0] == Approx(0.28).epsilon(1e-15));
  CHECK(one.gradient[3] == Approx(0.96).epsilon(1e-15));
  CHECK(one.gradient[8] == 1);
  CHECK(one.rate[0] == Approx(-3 * 0.96).epsilon(1e-15));
  CHECK(one.rate[3] == Approx(3 * 0.28).epsilon(1e-15));
  for (const hs_deformation& d : all) {
    for (int i = 0; i < 9; ++i) {
      CHECK(d.strain[i] == 0);
      CHECK(d.stress[i] == 0);
    }
    CHECK(d.strain_energy == 0);
  }
}

TEST_CASE("a deformation set comes back to the bit, and the vertices are where it takes them") {
  const Alone s;
  const Points before = vertices_in(s.world.get(), s.block);
  const double gradient[9] = {1.25, 0.5, 0, -0.25, 0.75, 0, 0, 0, 1};
  const double rate[9] = {1, -2, 0, 3, 4, 0, 0, 0, 0};
  REQUIRE(hs_world_set_deformation(s.world.get(), s.block, gradient, rate) == HS_OK);
  const hs_deformation d = deformation_of(s.world.get(), s.block);
  CHECK(std::memcmp(d.gradient, gradient, sizeof gradient) == 0);
  CHECK(std::memcmp(d.rate, rate, sizeof rate) == 0);
  const Points after = vertices_in(s.world.get(), s.block);
  REQUIRE(after.size() == before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double x = before[i].x - 3, y = before[i].y - 4;
    CHECK(after[i].x == Approx(3 + 1.25 * x + 0.5 * y).margin(1e-14));
    CHECK(after[i].y == Approx(4 - 0.25 * x + 0.75 * y).margin(1e-14));
  }
  // Green's strain, (F^T F - 1) / 2.
  CHECK(d.strain[0] == 0.5 * (1.25 * 1.25 + 0.25 * 0.25 - 1));
  CHECK(d.strain[1] == 0.5 * (1.25 * 0.5 - 0.25 * 0.75));
  CHECK(d.strain[4] == 0.5 * (0.5 * 0.5 + 0.75 * 0.75 - 1));
  // Its centroid and velocity stay.
  CHECK(state_of(s.world.get(), s.block).pose.position[0] == 3);
}

TEST_CASE("a step that would press a block flat to rounding is unstable and not taken") {
  const Alone s;
  hs_world_report report;
  REQUIRE(hs_world_get_report(s.world.get(), &report, sizeof report) == HS_OK);
  const double thin = 0x1p-35, share = 1 - 0x1p-20;
  const double gradient[9] = {thin, 0, 0, 0, 1, 0, 0, 0, 1};
  const double rate[9] = {-share * thin / report.time_step, 0, 0, 0, 0, 0, 0, 0, 0};
  REQUIRE(hs_world_set_deformation(s.world.get(), s.block, gradient, rate) == HS_OK);
  CHECK(hs_world_step(s.world.get(), 1) == HS_ERROR_UNSTABLE);
  CHECK(std::memcmp(deformation_of(s.world.get(), s.block).gradient, gradient, sizeof gradient) == 0);
}

TEST_CASE("setting velocities leaves how a block strains, setting the same spin all of its rate") {
  const Alone s;
  const double gradient[9] = {1.25, 0.5, 0, -0.25, 0.75, 0, 0, 0, 1};
  const double rate[9] = {1, -2, 0, 3, 4, 0, 0, 0, 0}, velocity[3] = {5, 6, 0};
  REQUIRE(hs_world_set_deformation(s.world.get(), s.block, gradient, rate) == HS_OK);
  const Points velocities = {{5, 6}};
  REQUIRE(hs_world_set_velocities(s.world.get(), view_of(velocities), {}) == HS_OK);
  const hs_block_state state = state_of(s.world.get(), s.block);
  CHECK(state.velocity[1] == 6);
  CHECK(std::memcmp(deformation_of(s.world.get(), s.block).rate, rate, sizeof rate) == 0);
  const double spin[3] = {0, 0, state.angular_velocity[2] + 2};
  REQUIRE(hs_world_set_velocity(s.world.get(), s.block, velocity, spin) == HS_OK);
  CHECK(state_of(s.world.get(), s.block).angular_velocity[2] == Approx(spin[2]).epsilon(1e-14));
  const hs_deformation now = deformation_of(s.world.get(), s.block);
  // 2 rad/s more, of each column of the gradient.
  const double expected[9] = {1 + 2 * 0.25, -2 - 2 * 0.75, 0, 3 + 2 * 1.25, 4 + 2 * 0.5, 0, 0, 0, 0};
  for (int i = 0; i < 9; ++i) CHECK(now.rate[i] == Approx(expected[i]).margin(1e-14));
}

TEST_CASE("a stress set is told again, whatever the block's deformation") {
  const Alone s;
  const double gradient[9] = {0.9, 0.3, 0, -0.4, 1.1, 0, 0, 0, 1};
  const double stress[9] = {-3e6, 5e5, 0, 5e5, -1e6, 0, 0, 0, 0};
  REQUIRE(hs_world_set_deformation(s.world.get(), s.block, gradient, still) == HS_OK);
  REQUIRE(hs_world_set_stress(s.world.get(), s.block, stress) == HS_OK);
  const hs_deformation d = deformation_of(s.world.get(), s.block);
  for (int i = 0; i < 9; ++i) CHECK(std::abs(d.stress[i] - stress[i]) <= 1e-15 * 1e8 * 8);
  CHECK(std::memcmp(d.gradient, gradient, sizeof gradient) == 0);
}

TEST_CASE("surface loads add up, keep their direction, and can be taken off") {
  const Alone s(pose_at(0, 0, 1, 0));  // upside down: the load does not turn with it
  const double traction[3] = {100, -50, 0};
  REQUIRE(hs_world_add_surface_load(s.world.get(), s.block, 0, traction) == HS_OK);
  REQUIRE(hs_world_add_surface_load(s.world.get(), s.block, 0, traction) == HS_OK);
  REQUIRE(hs_world_step(s.world.get(), 10) == HS_OK);
  const hs_block_state loaded = state_of(s.world.get(), s.block);
  const double time = report_of(s.world.get()).time, length = std::hypot(2, 0.5);
  CHECK(loaded.velocity[0] == Approx(2 * 100 * length / loaded.mass * time).epsilon(1e-12));
  CHECK(loaded.velocity[1] == Approx(-2 * 50 * length / loaded.mass * time).epsilon(1e-12));
  REQUIRE(hs_world_clear_surface_loads(s.world.get(), s.block) == HS_OK);
  REQUIRE(hs_world_step(s.world.get(), 10) == HS_OK);
  CHECK(state_of(s.world.get(), s.block).velocity[0] == loaded.velocity[0]);
}

/// What a material's elasticity becomes does not change how blocks are strained, but how they are stressed.
TEST_CASE("a material made stiffer stresses its blocks more") {
  const Alone s;
  const double gradient[9] = {1.01, 0, 0, 0, 1, 0, 0, 0, 1};
  REQUIRE(hs_world_set_deformation(s.world.get(), s.block, gradient, still) == HS_OK);
  const hs_deformation before = deformation_of(s.world.get(), s.block);
  const hs_elasticity_def stiffer = elasticity_def(4e8);
  REQUIRE(hs_world_set_elasticity(s.world.get(), 0, &stiffer) == HS_OK);
  const hs_deformation after = deformation_of(s.world.get(), s.block);
  CHECK(std::memcmp(before.strain, after.strain, sizeof before.strain) == 0);
  for (int i = 0; i < 9; ++i) CHECK(after.stress[i] == 4 * before.stress[i]);
  CHECK(after.strain_energy == 4 * before.strain_energy);
  // The energy that this took is outer work: the ledger stays even.
  const hs_world_report report = report_of(s.world.get());
  CHECK(report.block_strain_energy == after.strain_energy);
  CHECK(std::abs(report.energy.residual) <= 1e-15 * after.strain_energy);
}

TEST_CASE("a restored world of affine blocks and potentials goes on bit for bit") {
  const Context context = make_context(), elsewhere = make_context();
  const Pile pile(context.get(), 30, world_def(), affine_pile);
  const double in_situ[9] = {-1e4, 0, 0, 0, -2e4, 0, 0, 0, 0}, traction[3] = {10, 0, 0};
  REQUIRE(hs_world_set_stress(pile.world.get(), pile.blocks[5], in_situ) == HS_OK);
  REQUIRE(hs_world_add_surface_load(pile.world.get(), pile.blocks[7], 1, traction) == HS_OK);
  run(context.get(), pile.world.get(), 1);
  CHECK(report_of(pile.world.get()).contact_count > 30);
  CHECK(report_of(pile.world.get()).block_damping_loss > 0);
  const std::vector<unsigned char> bytes = saved(pile.world.get());
  const World copy = restored(elsewhere.get(), bytes);
  CHECK(same(saved(copy.get()), bytes));
  World carried = restored(elsewhere.get(), bytes);
  REQUIRE(hs_world_step(pile.world.get(), 200) == HS_OK);
  REQUIRE(hs_world_step(copy.get(), 200) == HS_OK);
  for (int i = 0; i < 200; ++i) {
    REQUIRE(hs_world_step(carried.get(), 1) == HS_OK);
    if (i % 10 == 0) carried = restored(context.get(), saved(carried.get()));
  }
  CHECK(same(saved(copy.get()), saved(pile.world.get())));
  CHECK(same(saved(carried.get()), saved(pile.world.get())));
  const hs_world_report r = report_of(pile.world.get()), q = report_of(copy.get());
  CHECK(std::memcmp(&r, &q, sizeof r) == 0);
}

TEST_CASE("a snapshot of affine blocks that is damaged anywhere is refused") {
  const Alone s;
  REQUIRE(hs_world_step(s.world.get(), 10) == HS_OK);
  const std::vector<unsigned char> good = saved(s.world.get());
  hs_world* const sentinel = reinterpret_cast<hs_world*>(0x10);
  hs_world* made = sentinel;
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::vector<unsigned char> flipped = good;
    flipped[i] ^= static_cast<unsigned char>(1u << (i % 8));
    INFO("one bit flipped in byte " << i);
    CHECK(hs_world_restore(s.context.get(), flipped.data(), flipped.size(), &made) == HS_ERROR_FORMAT);
  }
  CHECK(made == sentinel);
}

/// Affine blocks push each other as rigid ones of the shapes that they are strained to: a host that moves
/// them by itself finds those forces. Outlines taken from the world are rounded at their places, within 8 m
/// of the origin, 1e-15 m; overlaps and the lengths over which blocks meet by a few times as much, which
/// counts where edges meet at a slant of 0.01 or more a hundredfold. A torque has an arm of a block's size,
/// less than 1 m.
TEST_CASE("by stages, affine blocks find the forces of rigid blocks of the same outlines") {
  constexpr int count = 30;
  for (const std::int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL}) {
    const Context context = make_context();
    hs_world_def def = world_def();
    def.potential_length = 1;
    const PileOf of{HS_BLOCK_AFFINE, kind};
    const Pile affine(context.get(), count, def, of), rigid(context.get(), 0, def, of);
    std::mt19937_64 random(7);
    const auto uniform = [&](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    for (std::size_t i = affine.blocks.size() - count; i < affine.blocks.size(); ++i) {
      const double gradient[9] = {
          uniform(1.1, 1.4), uniform(-0.1, 0.1), 0, uniform(-0.1, 0.1), uniform(1.1, 1.4), 0, 0, 0, 1};
      REQUIRE(hs_world_set_deformation(affine.world.get(), affine.blocks[i], gradient, still) == HS_OK);
      add_block(context.get(), rigid.world.get(), vertices_in(affine.world.get(), affine.blocks[i]),
                HS_BLOCK_RIGID);
    }
    const Stages strained(affine.world.get(), affine.blocks.size());
    const Stages stiff(rigid.world.get(), affine.blocks.size());
    REQUIRE(strained.contacts.size() > 20);
    REQUIRE(strained.contacts.size() == stiff.contacts.size());
    double largest = 0;
    for (std::size_t c = 0; c < stiff.contacts.size(); ++c) {
      CHECK(strained.contacts[c].type == stiff.contacts[c].type);
      largest = std::max(largest, stiff.contacts[c].normal_force);
    }
    const double force = largest_difference(strained.force, stiff.force);
    const double torque = largest_difference(strained.torque, stiff.torque);
    std::printf("by stages, law %d, %zu contacts: of forces up to %.3e N, differ by %.1e N and %.1e N m\n",
                kind, stiff.contacts.size(), largest, force, torque);
    const double bound = 5e7 * 100 * 4 * 1e-15;
    CHECK(force <= bound);
    CHECK(torque <= bound);
  }
}

}  // namespace halfspace_test
