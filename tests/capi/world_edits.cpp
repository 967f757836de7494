#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "catch.h"
#include "world_fixture.h"

// A world may be read and changed at any time: what was read leaves no trace, and what belonged to the state
// before is gone.

namespace halfspace_test {
namespace {

constexpr double radian_per_degree = 3.14159265358979323846 / 180;

hs_world_def damped_world() {
  hs_world_def def = world_def();
  def.local_damping = 0.3;
  return def;
}

/// A 1 m block that stands out from a fixed wall at its left, held by the bond alone.
struct Cantilever {
  Cantilever(int32_t stiffness_kind, double stiffness)
      : context(make_context()), world(make_world(context.get(), damped_world())) {
    int32_t rock = 0;
    require_ok(hs_world_add_material(world.get(), 2500, &rock), context.get());
    law = law_def(stiffness, 30 * radian_per_degree);
    set_law(stiffness_kind);
    wall = add_block(context.get(), world.get(), box(-1, 0, 0, 1), HS_BLOCK_FIXED);
    block = add_block(context.get(), world.get(), box(0, 0, 1, 1), HS_BLOCK_RIGID);
  }

  hs_block_state state() const { return state_of(world.get(), block); }
  hs_world_report report() const { return report_of(world.get()); }
  void set_law(int32_t stiffness_kind) {
    law.stiffness_kind = stiffness_kind;
    law.cohesion = law.tensile_strength = stiffness_kind == HS_STIFFNESS_POTENTIAL ? 0 : 1e9;
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  }

  Context context;
  World world;
  hs_law_def law;
  hs_block wall = 0, block = 0;
};

}  // namespace

TEST_CASE("a bonded cantilever stands by the moment of its joint") {
  // Springs over a joint of 1 m: shear k turns into a sag w/k, and the joint's bending stiffness is k/4 with
  // a spring at each end of it, k/12 when spread. The weight w acts at 0.5 m: it tilts by w/2 over that.
  const double stiffness = 1e9, weight = 2500 * 9.81;
  for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    Cantilever c(kind, stiffness);
    double time = 0;
    while (time < 1) {
      require_ok(hs_world_step(c.world.get(), 1000), c.context.get());
      time = c.report().time;
    }
    const double bending = kind == HS_STIFFNESS_PER_CONTACT ? stiffness / 4 : stiffness / 12;
    const double tilt = -0.5 * weight / bending;
    // Small angles: relative errors of the order of the tilt, and what still rings after a second of damping.
    CHECK(c.state().angle == Approx(tilt).epsilon(1e-3));
    CHECK(c.state().pose.position[1] == Approx(0.5 - weight / stiffness + 0.5 * tilt).epsilon(1e-6));
    // The step is half the stable one for four contacts, a quarter of that for one: q = 1/4, and Verlet's
    // ledger swings by q^2.
    const double set_free = weight * (0.5 - c.state().pose.position[1]);
    CHECK(std::abs(c.report().energy.residual) < set_free / 16);
  }
}

TEST_CASE("reading a world before its first step does not prevent its bonds") {
  Cantilever undisturbed(HS_STIFFNESS_PER_CONTACT, 1e9), read(HS_STIFFNESS_PER_CONTACT, 1e9);
  read.report();
  require_ok(hs_world_detect(read.world.get(), nullptr), read.context.get());
  read.report();
  for (Cantilever* c : {&undisturbed, &read})
    require_ok(hs_world_step(c->world.get(), 500), c->context.get());
  CHECK(undisturbed.state().pose.position[1] == read.state().pose.position[1]);
  CHECK(undisturbed.state().angle == read.state().angle);
}

TEST_CASE("potentials hold nothing together, but a bond ends by a step, not by reading") {
  for (const bool steps : {false, true}) {
    Cantilever c(HS_STIFFNESS_PER_CONTACT, 1e9);
    require_ok(hs_world_step(c.world.get(), 500), c.context.get());
    c.set_law(HS_STIFFNESS_POTENTIAL);
    c.report();
    if (steps) require_ok(hs_world_step(c.world.get(), 1), c.context.get());
    c.set_law(HS_STIFFNESS_PER_CONTACT);
    run(c.context.get(), c.world.get(), 0.5);
    // A free fall of half a second is 1.2 m; the local damping takes 0.3 of the weight.
    const double fallen = 0.5 - c.state().pose.position[1];
    if (steps) {
      CHECK(fallen > 0.8);
    } else {
      CHECK(fallen < 1e-3);
    }
  }
}

TEST_CASE("after a placement no contact keeps the force of another") {
  Cantilever c(HS_STIFFNESS_PER_CONTACT, 1e9);
  require_ok(hs_world_step(c.world.get(), 100), c.context.get());
  const hs_pose elsewhere = pose_at(50, 50);
  require_ok(hs_world_set_pose(c.world.get(), c.block, &elsewhere), c.context.get());
  int64_t count = -1;
  CHECK(hs_world_get_contacts(c.world.get(), nullptr, 0, &count) == HS_OK);
  CHECK(count == 0);
  const hs_pose overlapping = pose_at(0.4999, 0.5);
  require_ok(hs_world_set_pose(c.world.get(), c.block, &overlapping), c.context.get());
  require_ok(hs_world_detect(c.world.get(), nullptr), c.context.get());
  hs_contact contact;
  require_ok(hs_world_get_contacts(c.world.get(), &contact, 1, &count), c.context.get());
  REQUIRE(count == 1);
  CHECK(contact.normal_force == 0);
}

TEST_CASE("a shear force needs contacts that belong to the present laws") {
  Cantilever c(HS_STIFFNESS_PER_CONTACT, 1e9);
  require_ok(hs_world_step(c.world.get(), 1), c.context.get());
  const hs_law_def law = law_def(1e9, 0.5);
  require_ok(hs_world_set_default_law(c.world.get(), &law), c.context.get());
  const double force[3] = {1, 0, 0};
  CHECK(hs_world_set_shear_force(c.world.get(), c.wall, c.block, force) == HS_ERROR_STATE);
}

TEST_CASE("forces asked for by a host are booked as outer work") {
  Cantilever c(HS_STIFFNESS_PER_CONTACT, 1e9);
  require_ok(hs_world_step(c.world.get(), 500), c.context.get());
  const double before = c.report().energy.residual;
  double f[2][3], t[2][3];
  const hs_mutable_view forces{&f[0][0], &f[0][1], nullptr, sizeof f[0], 2};
  const hs_mutable_view torques{&t[0][0], &t[0][1], &t[0][2], sizeof t[0], 2};
  require_ok(hs_world_forces(c.world.get(), 0.01, forces, torques), c.context.get());
  CHECK(c.report().energy.residual == Approx(before).margin(1e-9 * c.report().energy.strain));
}

TEST_CASE("a snapshot damaged so that its checksum holds is refused or runs, and never leads astray") {
  Cantilever c(HS_STIFFNESS_PER_CONTACT, 1e9);
  require_ok(hs_world_step(c.world.get(), 100), c.context.get());
  const std::vector<unsigned char> bytes = saved(c.world.get());
  const size_t size = bytes.size();
  constexpr size_t header = 32, checksum_at = 24;
  int refused = 0, tried = 0;
  for (size_t word = header; word + 4 <= size; word += 4) {
    std::vector<unsigned char> damaged = bytes;
    const uint32_t large = 0x70000000;
    std::memcpy(&damaged[word], &large, sizeof large);
    uint64_t sum = 0xcbf29ce484222325u;
    for (size_t i = header; i < size; ++i) sum = (sum ^ damaged[i]) * 0x100000001b3u;
    std::memcpy(&damaged[checksum_at], &sum, sizeof sum);
    hs_world* restored = nullptr;
    const hs_status status = hs_world_restore(c.context.get(), damaged.data(), size, &restored);
    ++tried;
    refused += status == HS_ERROR_FORMAT;
    if (status != HS_OK) continue;
    const World owner(restored);
    (void)hs_world_step(restored, 5);  // which may be unstable
    hs_contact contacts[4];
    int64_t count = 0;
    CHECK(hs_world_get_contacts(restored, contacts, 4, &count) >= HS_OK);
  }
  std::printf("damaged snapshots: %d tried, %d refused\n", tried, refused);
  CHECK(refused > 0);
}

}  // namespace halfspace_test
