// halfspace/bolt.h against an oscillator, and the work of yield and rupture.

#include <cmath>

#include "capi/loads.h"
#include "capi/snapshot_worlds.h"
#include "capi/unchanged.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// Two boxes far apart, without gravity.
struct Pair {
  Context context = make_context();
  World world;
  hs_block first = 0, second = 0;
  int dimension;

  explicit Pair(int of_dimension, std::int32_t first_kind = HS_BLOCK_RIGID,
                std::int32_t second_kind = HS_BLOCK_RIGID, double time_step = 0)
      : dimension(of_dimension) {
    hs_world_def def = world_def(dimension);
    for (double& component : def.gravity) component = 0;
    def.time_step = time_step;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 1000, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e9);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    const Shape shape = shape_of_box(context.get(), dimension);
    first = add_block(context.get(), world.get(), shape, first_kind, pose_at(0, 0));
    second = add_block(context.get(), world.get(), shape, second_kind, pose_at(3, 0));
  }
  double mass() const { return dimension == 2 ? 250 : 125; }
  void pull(hs_block block, double speed) {
    const double velocity[3] = {speed, 0, 0}, still[3] = {};
    require_ok(hs_world_set_velocity(world.get(), block, velocity, still), context.get());
  }
  void step(std::int64_t steps) { require_ok(hs_world_step(world.get(), steps), context.get()); }
  hs_bolt bolt() const { return bolts_of(world.get()).at(0); }
};

/// Momentum, and angular momentum about the origin along z.
struct Momenta {
  double linear[3] = {};
  double angular = 0;

  void add(const hs_block_state& state, double inertia) {
    for (int i = 0; i < 3; ++i) linear[i] += state.mass * state.velocity[i];
    const auto& [x, y, z] = state.pose.position;
    angular +=
        state.mass * (x * state.velocity[1] - y * state.velocity[0]) + inertia * state.angular_velocity[2];
  }
};

}  // namespace

TEST_CASE("two blocks on a bolt oscillate with the frequency of theory") {
  const int dimension = GENERATE(2, 3);
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  Pair s(dimension, kind, HS_BLOCK_RIGID, 1e-5);
  const double stiffness = 1e5, pretension = 100;
  hs_bolt_def def = bolt_def(s.first, {0, 0, 0}, s.second, {3, 0, 0}, stiffness);
  def.is_tension_only = 0;
  def.pretension = pretension;
  add_bolt(s.context.get(), s.world.get(), def);
  CHECK(s.bolt().tension == Approx(pretension));
  const double frequency = std::sqrt(2 * stiffness / s.mass());
  const double amplitude = pretension / stiffness;
  for (int i = 1; i <= 5; ++i) {
    s.step(4000);
    const double elongation = amplitude * std::cos(frequency * report_of(s.world.get()).time);
    CHECK(s.bolt().elongation == Approx(elongation).margin(1e-4 * amplitude));
  }
  const hs_world_report report = report_of(s.world.get());
  CHECK(report.energy.outer_work == Approx(pretension * pretension / (2 * stiffness)));
  CHECK(std::abs(report.energy.residual) < 1e-4 * report.energy.outer_work);
  CHECK(report.bolt_strain_energy == Approx(s.bolt().strain_energy));
}

TEST_CASE("a bolt conserves momentum and angular momentum") {
  const int dimension = GENERATE(2, 3);
  Pair s(dimension, HS_BLOCK_RIGID, HS_BLOCK_RIGID, 1e-4);
  hs_bolt_def def = bolt_def(s.first, {0.1, 0.2, 0}, s.second, {2.9, -0.1, 0}, 1e5);
  def.pretension = 3000;
  def.yield_force = 3500;
  add_bolt(s.context.get(), s.world.get(), def);
  s.step(5000);
  Momenta momenta;
  const double inertia = s.mass() * 2 * 0.25 / 12;
  double scale = 0;
  for (const hs_block block : {s.first, s.second}) {
    const hs_block_state state = state_of(s.world.get(), block);
    momenta.add(state, inertia);
    scale += s.mass() * std::hypot(state.velocity[0], state.velocity[1]);
  }
  REQUIRE(scale > 10);
  CHECK(std::abs(momenta.linear[0]) < 1e-12 * scale);
  CHECK(std::abs(momenta.linear[1]) < 1e-12 * scale);
  CHECK(std::abs(momenta.angular) < 1e-11 * scale);
}

TEST_CASE("yield and rupture dissipate the work of theory") {
  const int dimension = GENERATE(2, 3);
  Pair s(dimension, HS_BLOCK_FIXED, HS_BLOCK_PRESCRIBED, 1e-4);
  const double stiffness = 1e6, yield = 2e4, limit = 0.1;
  // One end is outside of its block, where a plate would be.
  hs_bolt_def def = bolt_def(s.first, {0, 0, 0}, s.second, {3.5, 0, 0}, stiffness);
  def.yield_force = yield;
  def.rupture_elongation = limit;
  CHECK(hs_world_add_bolt(s.world.get(), &def, nullptr) == HS_OK);
  s.pull(s.second, 0.1);
  s.step(5000);  // 0.05 m
  CHECK(s.bolt().tension == Approx(yield));
  CHECK(s.bolt().plastic_elongation == Approx(0.05 - yield / stiffness).epsilon(1e-9));
  const hs_world_report yielding = report_of(s.world.get());
  CHECK(yielding.bolt_loss == Approx(yield * 0.03));
  CHECK(yielding.bolt_strain_energy == Approx(yield * yield / (2 * stiffness)));
  CHECK(yielding.energy.outer_work == Approx(yield * 0.03 + yield * yield / (2 * stiffness)).epsilon(1e-4));
  s.step(6000);  // 0.11 m
  const hs_world_report ruptured = report_of(s.world.get());
  CHECK(s.bolt().is_ruptured == 1);
  CHECK(s.bolt().tension == 0);
  CHECK(ruptured.bolt_loss == Approx(yield * 0.08 + yield * yield / (2 * stiffness)));
  CHECK(ruptured.bolt_strain_energy == 0);
  CHECK(std::abs(ruptured.energy.residual) < 1e-3 * ruptured.bolt_loss);
}

TEST_CASE("a cable is slack where a strut is compressed") {
  const int is_tension_only = GENERATE(0, 1);
  Pair s(2, HS_BLOCK_FIXED, HS_BLOCK_RIGID, 1e-4);
  hs_bolt_def def = bolt_def(0, {0, 2, 0}, s.second, {3, 0, 0}, 1e5);
  def.is_tension_only = is_tension_only;
  add_bolt(s.context.get(), s.world.get(), def);
  s.pull(s.second, -1);
  s.step(100);
  const hs_bolt bolt = s.bolt();
  CHECK(bolt.block_a == 0);
  CHECK(bolt.elongation < 0);
  CHECK(bolt.tension == Approx(is_tension_only ? 0 : 1e5 * bolt.elongation));
}

TEST_CASE("a bolt limits the stable time step, by the arms of its places") {
  for (const double arm : {0.0, 2.0}) {
    Pair s(2);
    hs_law_def law = law_def(1e3, 0);
    require_ok(hs_world_set_default_law(s.world.get(), &law), s.context.get());
    const double before = report_of(s.world.get()).stable_time_step;
    add_bolt(s.context.get(), s.world.get(), bolt_def(0, {0, 5, 0}, s.second, {3 + arm, 0, 0}, 1e8));
    const double after = report_of(s.world.get()).stable_time_step;
    // 1 / m + arm^2 / I across the arm
    const double mobility = 1 / s.mass() + arm * arm / (s.mass() * 0.5 / 12);
    CHECK(after < 2 / std::sqrt(1e8 * mobility) * 1.0001);
    CHECK(after > 0.3 * 2 / std::sqrt(1e8 * (mobility + 12 / s.mass())));
    CHECK(after < before);
  }
}

TEST_CASE("a bolt refuses every bad definition and stale number") {
  Pair s(2, HS_BLOCK_FIXED, HS_BLOCK_RIGID, 1e-4);
  hs_world* w = s.world.get();
  const hs_block gone = add_block(s.context.get(), w, box(8, 8, 9, 9), HS_BLOCK_RIGID);
  add_bolt(s.context.get(), w, bolt_def(s.second, {3, 0, 0}, gone, {8.5, 8.5, 0}, 1e5));
  REQUIRE(hs_world_remove_block(w, gone) == HS_OK);
  CHECK(bolts_of(w).empty());  // with its block
  using Def = hs_bolt_def;
  const std::vector<Spoiled<Def>> spoiled = {
      {"struct_size", "0", [](Def& d) { d.struct_size = 0; }},
      {"def.is_tension_only", "2", [](Def& d) { d.is_tension_only = 2; }},
      {"def.block_a and def.block_b", "both", [&](Def& d) { d.block_a = s.second; }},
      {"def.block_b", "no living block", [&](Def& d) { d.block_b = gone; }, HS_ERROR_STALE_ID},
      {"neither", "moves", [&](Def& d) { d.block_b = 0; }, HS_ERROR_STATE},
      {"def.place_a[1]", "nan", [](Def& d) { d.place_a[1] = std::nan(""); }},
      {"def.place_a and def.place_b", "(3, 0)", [](Def& d) { d.place_a[0] = 3; }},
      {"def.stiffness", "0", [](Def& d) { d.stiffness = 0; }},
      {"def.stiffness", "inf", [](Def& d) { d.stiffness = HUGE_VAL; }},
      {"def.pretension", "-1", [](Def& d) { d.pretension = -1; }},
      {"def.pretension", "5", [](Def& d) { d.pretension = 5, d.yield_force = 4; }},
      {"def.yield_force", "-4", [](Def& d) { d.yield_force = -4; }},
      {"def.rupture_elongation", "1e-06", [](Def& d) { d.pretension = 1, d.rupture_elongation = 1e-6; }},
  };
  for (const auto& bad : spoiled) {
    hs_bolt_def def = bolt_def(s.first, {0, 0, 0}, s.second, {3, 0, 0}, 1e5);
    bad.spoil(def);
    check_unchanged(
        s, "hs_world_add_bolt",
        {{bad.member, bad.value, [&] { return hs_world_add_bolt(w, &def, nullptr); }, bad.status}});
  }
  check_unchanged(s, "hs_world_remove_bolt",
                  {{"number", "0", [&] { return hs_world_remove_bolt(w, 0); }, HS_ERROR_STALE_ID}});
  CHECK(add_bolt(s.context.get(), w, bolt_def(s.first, {0, 0, 0}, s.second, {3, 0, 0}, 1e5)) == 1);
  REQUIRE(hs_world_remove_bolt(w, 1) == HS_OK);
  CHECK(bolts_of(w).empty());
  hs_block at = 77;
  const double inside[3] = {3.1, 0.1, 0}, outside[3] = {5, 5, 0};
  CHECK(hs_world_get_block_at(w, inside, &at) == HS_OK);
  CHECK(at == s.second);
  CHECK(hs_world_get_block_at(w, outside, &at) == HS_OK);
  CHECK(at == 0);
}

TEST_CASE("a place beside a compound is in its own block, and one in a compound is in a part") {
  const int dimension = GENERATE(2, 3);
  Pair pair(dimension);
  hs_world* const w = pair.world.get();
  const Shape shape = shape_of_box(pair.context.get(), dimension);
  const hs_shape* const shapes[] = {shape.get(), shape.get()};
  const hs_pose poses[] = {pose_at(-5, 0), pose_at(-7, 0)};
  hs_block_def def;
  require_ok(hs_compound_def_init(&def, sizeof def, shapes, poses, 2), pair.context.get());
  hs_block compound = 0, parts[2] = {};
  require_ok(hs_world_add_compound(w, shapes, poses, 2, &def, &compound), pair.context.get());
  require_ok(hs_world_get_compound_parts(w, compound, parts, 2, nullptr), pair.context.get());
  const auto block_at = [&](double x) {
    const double place[3] = {x, 0.1, 0};
    hs_block block = 7;
    require_ok(hs_world_get_block_at(w, place, &block), pair.context.get());
    return block;
  };
  CHECK(block_at(0) == pair.first);
  CHECK(block_at(3) == pair.second);
  CHECK(block_at(-5) == parts[0]);
  CHECK(block_at(-7) == parts[1]);
  CHECK(block_at(-6) == 0);
  // A bolt on a part pulls its compound.
  add_bolt(pair.context.get(), w, bolt_def(parts[0], {-5, 0, 0}, pair.first, {0, 0, 0}, 1e6));
  pair.pull(pair.first, 1);
  pair.step(100);
  const hs_block_state one = state_of(w, pair.first), other = state_of(w, compound);
  CHECK(other.velocity[0] > 0.01);
  const double frequency = std::sqrt(1e6 * (1 / one.mass + 1 / other.mass));
  const double part = one.mass / (one.mass + other.mass);
  CHECK(other.velocity[0] == Approx(part * (1 - std::cos(frequency * report_of(w).time))).epsilon(1e-3));
  CHECK(one.mass * one.velocity[0] + other.mass * other.velocity[0] == Approx(one.mass).epsilon(1e-12));
}

TEST_CASE("blocks on a bolt sleep and wake together, and a snapshot continues with the same bits") {
  hs_world_def def = world_def(2);
  def.sleep_tolerance = 1;
  Context context = make_context();
  const World world = make_world(context.get(), def);
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 1000, &material), context.get());
  hs_law_def law = law_def(1e7, 0.5);
  law.normal_damping = law.shear_damping = 0.5;
  require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  add_block(context.get(), world.get(), box(-5, -1, 9, 0), HS_BLOCK_FIXED);
  const hs_block left = add_block(context.get(), world.get(), box(0, 0, 1, 1), HS_BLOCK_RIGID);
  const hs_block right = add_block(context.get(), world.get(), box(3, 0, 4, 1), HS_BLOCK_RIGID);
  hs_bolt_def bolt = bolt_def(left, {0.5, 0.5, 0}, right, {3.5, 0.5, 0}, 1e6);
  bolt.pretension = 1000;
  add_bolt(context.get(), world.get(), bolt);
  run(context.get(), world.get(), 5);
  CHECK(report_of(world.get()).sleeping_count == 2);
  const World copy = restored(context.get(), saved(world.get()));
  const double push[3] = {-4000, 0, 0}, none[3] = {};
  for (hs_world* w : {world.get(), copy.get()}) {
    require_ok(hs_world_set_applied_force(w, left, push, none), context.get());
    require_ok(hs_world_step(w, 200), context.get());
    CHECK(report_of(w).sleeping_count == 0);
  }
  CHECK(saved(copy.get()) == saved(world.get()));
}

}  // namespace halfspace_test
