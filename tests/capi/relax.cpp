// halfspace/relax.h and strength.h: every argument that can be wrong, and what the calls leave as it was.

#include <cmath>
#include <cstring>
#include <limits>

#include "capi/meshes.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

hs_strength_def strength_def() {
  hs_strength_def def;
  if (hs_strength_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no strength definition");
  return def;
}

/// A box on a slope of 20 degrees, which friction of 30 degrees holds: it slides where that is 1.59 times
/// weaker.
struct Slope {
  Context context = make_context();
  World world;
  hs_block block = 0;

  Slope() {
    const double slope = 20 * 0.017453292519943295, friction = 30 * 0.017453292519943295;
    hs_world_def def = world_def();
    def.gravity[0] = 9.81 * std::sin(slope);
    def.gravity[1] = -9.81 * std::cos(slope);
    def.local_damping = 0.3;
    def.mass_damping = 2;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
    hs_law_def law = law_def(1e8, friction);
    law.stiffness_kind = HS_STIFFNESS_PER_AREA;
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    add_block(context.get(), world.get(), box(-9, -1, 9, 0), HS_BLOCK_FIXED);
    block = add_block(context.get(), world.get(), box(0, 0, 2, 1), HS_BLOCK_RIGID);
  }
};

}  // namespace

TEST_CASE("hs_world_relax and hs_world_get_balance refuse every bad argument") {
  Slope s;
  hs_world* w = s.world.get();
  using D = hs_relaxation_def;
  const std::vector<Spoiled<D>> spoiled = {
      {"struct_size", "0", [](D& d) { d.struct_size = 0; }},
      {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
      {"def.measure", "2", [](D& d) { d.measure = 2; }},
      {"def.measure", "-1", [](D& d) { d.measure = -1; }},
      {"def.ratio", "0", [](D& d) { d.ratio = 0; }},
      {"def.ratio", "-1", [](D& d) { d.ratio = -1; }},
      {"def.ratio", "nan", [](D& d) { d.ratio = nan; }},
      {"def.ratio", "inf", [](D& d) { d.ratio = inf; }},
      {"def.max_steps", "0", [](D& d) { d.max_steps = 0; }},
      {"def.max_steps", "-5", [](D& d) { d.max_steps = -5; }},
      {"def.local_damping", "-0.1", [](D& d) { d.local_damping = -0.1; }},
      {"def.local_damping", "1", [](D& d) { d.local_damping = 1; }},
      {"def.local_damping", "nan", [](D& d) { d.local_damping = nan; }},
      {"def.is_adaptive", "2", [](D& d) { d.is_adaptive = 2; }},
      {"def.hold_bonds", "-1", [](D& d) { d.hold_bonds = -1; }},
  };
  hs_balance balance;
  std::memset(&balance, 0xee, sizeof balance);
  const hs_balance untouched = balance;
  for (const auto& bad : spoiled) {
    hs_relaxation_def def = relaxation_def(10, 1e-3);
    bad.spoil(def);
    check_unchanged(
        s, "hs_world_relax",
        {{bad.member, bad.value, [&] { return hs_world_relax(w, &def, &balance, sizeof balance); }}});
  }
  const hs_relaxation_def def = relaxation_def(10, 1e-3);
  check_unchanged(s, "hs_world_relax",
                  {{"def", "NULL", [&] { return hs_world_relax(w, nullptr, &balance, sizeof balance); }},
                   {"size", "3", [&] { return hs_world_relax(w, &def, &balance, 3); }}});
  check_unchanged(s, "hs_world_get_balance",
                  {{"balance", "NULL", [&] { return hs_world_get_balance(w, nullptr, sizeof balance); }}});
  CHECK(hs_world_relax(nullptr, &def, &balance, sizeof balance) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_balance(nullptr, &balance, sizeof balance) == HS_ERROR_ARGUMENT);

  const World empty = make_world(s.context.get(), world_def());
  check_refusals(
      s.context.get(), "hs_world_relax",
      {{"time step", "", [&] { return hs_world_relax(empty.get(), &def, &balance, sizeof balance); },
        HS_ERROR_STATE}});
  CHECK(std::memcmp(&balance, &untouched, sizeof balance) == 0);
  REQUIRE(hs_world_get_balance(empty.get(), &balance, sizeof balance) == HS_OK);
  for (const double none : {balance.mean, balance.largest, balance.largest_force}) CHECK(none == 0);
  CHECK(balance.largest_force_block == 0);
}

TEST_CASE("gravity, damping, time step and strength refuse every bad number") {
  Slope s;
  hs_world* w = s.world.get();
  const double not_a_number[3] = {0, nan, 0}, infinite[3] = {inf, 0, 0}, large[3] = {0, -1e76, 0};
  check_unchanged(s, "hs_world_set_gravity",
                  {{"gravity", "NULL", [&] { return hs_world_set_gravity(w, nullptr); }},
                   {"gravity[1]", "nan", [&] { return hs_world_set_gravity(w, not_a_number); }},
                   {"gravity[0]", "inf", [&] { return hs_world_set_gravity(w, infinite); }},
                   {"gravity[1]", "-1e+76", [&] { return hs_world_set_gravity(w, large); }}});
  const auto damp = [&](double local, double mass) {
    return [=] { return hs_world_set_damping(w, local, mass); };
  };
  check_unchanged(s, "hs_world_set_damping",
                  {{"local_damping", "-0.5", damp(-0.5, 0)},
                   {"local_damping", "1", damp(1, 0)},
                   {"local_damping", "nan", damp(nan, 0)},
                   {"mass_damping", "-1", damp(0, -1)},
                   {"mass_damping", "nan", damp(0, nan)},
                   {"mass_damping", "inf", damp(0, inf)}});
  check_unchanged(s, "hs_world_set_time_step",
                  {{"time_step", "-1", [&] { return hs_world_set_time_step(w, -1); }},
                   {"time_step", "nan", [&] { return hs_world_set_time_step(w, nan); }},
                   {"time_step", "inf", [&] { return hs_world_set_time_step(w, inf); }}});
  check_unchanged(s, "hs_world_set_strength_factor",
                  {{"factor", "0", [&] { return hs_world_set_strength_factor(w, 0); }},
                   {"factor", "-2", [&] { return hs_world_set_strength_factor(w, -2); }},
                   {"factor", "nan", [&] { return hs_world_set_strength_factor(w, nan); }},
                   {"factor", "1e+76", [&] { return hs_world_set_strength_factor(w, 1e76); }}});
  const double none[3] = {};
  CHECK(hs_world_set_gravity(nullptr, none) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_damping(nullptr, 0, 0) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_time_step(nullptr, 0) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_strength_factor(nullptr, 1) == HS_ERROR_ARGUMENT);
}

TEST_CASE("hs_world_find_strength_factor refuses every bad argument") {
  Slope s;
  hs_world* w = s.world.get();
  hs_world* const no_world = reinterpret_cast<hs_world*>(0x10);
  hs_world* fallen = no_world;
  hs_strength_report report;
  std::memset(&report, 0xee, sizeof report);
  const hs_strength_report untouched = report;
  using D = hs_strength_def;
  const std::vector<Spoiled<D>> spoiled = {
      {"struct_size", "0", [](D& d) { d.struct_size = 0; }},
      {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
      {"def.reserved", "1", [](D& d) { d.reserved = 1; }},
      {"def.low", "0", [](D& d) { d.low = 0; }},
      {"def.low", "nan", [](D& d) { d.low = nan; }},
      {"def.high", "0.5", [](D& d) { d.high = 0.5; }},
      {"def.high", "nan", [](D& d) { d.high = nan; }},
      {"def.high", "1e+76", [](D& d) { d.high = 1e76; }},
      {"def.resolution", "0", [](D& d) { d.resolution = 0; }},
      {"def.resolution", "inf", [](D& d) { d.resolution = inf; }},
      {"def.ratio", "-1", [](D& d) { d.ratio = -1; }},
      {"def.max_displacement", "0", [](D& d) { d.max_displacement = 0; }},
      {"def.max_displacement", "nan", [](D& d) { d.max_displacement = nan; }},
      {"def.max_steps", "0", [](D& d) { d.max_steps = 0; }},
  };
  const auto find = [&](const hs_strength_def* def, hs_strength_report* into, std::size_t size) {
    return [&, def, into, size] { return hs_world_find_strength_factor(w, def, into, size, &fallen); };
  };
  for (const auto& bad : spoiled) {
    hs_strength_def def = strength_def();
    bad.spoil(def);
    check_unchanged(s, "hs_world_find_strength_factor",
                    {{bad.member, bad.value, find(&def, &report, sizeof report)}});
  }
  const hs_strength_def def = strength_def();
  check_unchanged(s, "hs_world_find_strength_factor",
                  {{"def", "NULL", find(nullptr, &report, sizeof report)},
                   {"report", "NULL", find(&def, nullptr, sizeof report)},
                   {"size", "5", find(&def, &report, 5)}});
  CHECK(hs_world_find_strength_factor(nullptr, &def, &report, sizeof report, &fallen) == HS_ERROR_ARGUMENT);
  const World empty = make_world(s.context.get(), world_def());
  check_refusals(
      s.context.get(), "hs_world_find_strength_factor",
      {{"time step", "",
        [&] { return hs_world_find_strength_factor(empty.get(), &def, &report, sizeof report, &fallen); },
        HS_ERROR_STATE}});
  CHECK(fallen == no_world);
  CHECK(std::memcmp(&report, &untouched, sizeof report) == 0);
}

TEST_CASE("reading the balance leaves no trace in the run") {
  Slope undisturbed, read;
  for (int i = 0; i < 20; ++i) {
    hs_balance balance;
    REQUIRE(hs_world_get_balance(read.world.get(), &balance, sizeof balance) == HS_OK);
    CHECK(balance.steps == 0);
    CHECK(balance.mean >= 0);
    for (const Slope* s : {&undisturbed, &read}) REQUIRE(hs_world_step(s->world.get(), 1) == HS_OK);
  }
  CHECK((saved(undisturbed.world.get()) == saved(read.world.get())));
}

TEST_CASE("after relaxation damping is what it was, and what is at rest does not move") {
  for (const bool ends_early : {true, false}) {
    Slope s;
    hs_world* w = s.world.get();
    const hs_relaxation_def def = relaxation_def(ends_early ? 3 : 100000, 1e-6);
    hs_balance balance;
    const hs_status status = hs_world_relax(w, &def, &balance, sizeof balance);
    CHECK(status == (ends_early ? HS_NOTE_NOT_AT_REST : HS_OK));
    CHECK((balance.mean <= def.ratio) == !ends_early);
    if (ends_early) CHECK(balance.steps == 3);
    CHECK(report_of(w).steps == balance.steps);
    const hs_block_state state = state_of(w, s.block);
    for (int k = 0; k < 3; ++k) {
      CHECK((state.velocity[k] == 0 || ends_early));
      CHECK((state.angular_velocity[k] == 0 || ends_early));
    }
    // A box that nothing drives is braked by the world's mass damping of 2/s alone.
    const double nothing[3] = {0, 0, 0}, gliding[3] = {1, 0, 0};
    const hs_pose above = pose_at(0, 5);
    REQUIRE(hs_world_set_gravity(w, nothing) == HS_OK);
    REQUIRE(hs_world_set_pose(w, s.block, &above) == HS_OK);
    REQUIRE(hs_world_set_velocity(w, s.block, gliding, nothing) == HS_OK);
    REQUIRE(hs_world_set_time_step(w, 1e-3) == HS_OK);
    REQUIRE(hs_world_step(w, 500) == HS_OK);
    CHECK(report_of(w).time_step == 1e-3);
    CHECK(state_of(w, s.block).velocity[0] == Approx(std::exp(-1)).epsilon(1e-3));
  }
}

TEST_CASE(
    "bonds that are held while a world comes to rest may fail afterwards, unless they were held before") {
  for (const bool held_before : {false, true}) {
    const Context context = make_context();
    const World world = make_world(context.get(), world_def());
    hs_world* w = world.get();
    std::int32_t material = -1;
    require_ok(hs_world_add_material(w, 2000, &material), context.get());
    const hs_block wall = add_block(context.get(), w, box(-1, 0, 0, 1), HS_BLOCK_FIXED);
    const hs_block block = add_block(context.get(), w, box(0, 0, 1, 1), HS_BLOCK_RIGID);
    const hs_bond_def weak = bond_def(1e9, 1);
    require_ok(hs_world_bond_blocks(w, wall, block, &weak), context.get());
    if (held_before) require_ok(hs_world_hold_bonds(w, 1), context.get());
    const hs_relaxation_def def = relaxation_def(100000, 1e-6);
    CHECK(hs_world_relax(w, &def, nullptr, 0) == HS_OK);
    CHECK(bond_events_of(w).empty());
    require_ok(hs_world_step(w, 10), context.get());
    CHECK(bond_events_of(w).empty() == held_before);
  }
}

TEST_CASE("strengths that are given after a factor are divided by it as well") {
  const hs_law_def friction = law_def(1e8, 0.5);
  const auto ends = [&](const std::function<void(hs_world*, hs_block, hs_block)>& give) {
    TwoBoxes s(0.1);
    const hs_block beside = add_block(s.context.get(), s.world.get(), box(5, -1, 7, 0), HS_BLOCK_RIGID);
    give(s.world.get(), s.floor, beside);
    require_ok(hs_world_step(s.world.get(), 3), s.context.get());
    return saved(s.world.get());
  };
  const hs_bond_def strong = bond_def(1e9, 4e6), weak = bond_def(1e9, 2e6);
  const auto set = [](hs_world* w, double factor) {
    REQUIRE(hs_world_set_strength_factor(w, factor) == HS_OK);
  };
  // Twice as strong and divided by two, before or after; powers of two round nothing.
  const auto before = ends([&](hs_world* w, hs_block a, hs_block b) {
    REQUIRE(hs_world_set_law(w, 0, 0, &friction) == HS_OK);
    REQUIRE(hs_world_bond_blocks(w, a, b, &strong) == HS_OK);
    set(w, 2);
  });
  const auto after = ends([&](hs_world* w, hs_block a, hs_block b) {
    set(w, 2);
    REQUIRE(hs_world_set_law(w, 0, 0, &friction) == HS_OK);
    REQUIRE(hs_world_bond_blocks(w, a, b, &strong) == HS_OK);
  });
  const auto and_back = ends([&](hs_world* w, hs_block a, hs_block b) {
    set(w, 4);
    REQUIRE(hs_world_set_law(w, 0, 0, &friction) == HS_OK);
    set(w, 0.25);
    REQUIRE(hs_world_bond_blocks(w, a, b, &strong) == HS_OK);
    set(w, 2);
  });
  CHECK((before == after));
  CHECK((before == and_back));
  const auto other = ends([&](hs_world* w, hs_block a, hs_block b) {
    REQUIRE(hs_world_set_law(w, 0, 0, &friction) == HS_OK);
    REQUIRE(hs_world_bond_blocks(w, a, b, &weak) == HS_OK);
    set(w, 2);
  });
  CHECK((before != other));
}

TEST_CASE("a search for strength leaves the world as it is, and gives the copy that fell last") {
  Slope s;
  const hs_relaxation_def at_rest = relaxation_def(100000, 1e-6);
  REQUIRE(hs_world_relax(s.world.get(), &at_rest, nullptr, 0) == HS_OK);
  hs_strength_def def = strength_def();
  def.resolution = 0.05;
  def.max_steps = 20000;
  const std::vector<unsigned char> before = saved(s.world.get());
  hs_strength_report report;
  hs_world* made = nullptr;
  REQUIRE(hs_world_find_strength_factor(s.world.get(), &def, &report, sizeof report, &made) == HS_OK);
  const World fallen(made);
  CHECK((saved(s.world.get()) == before));
  const double expected = std::tan(30 * 0.017453292519943295) / std::tan(20 * 0.017453292519943295);
  CHECK(report.stands_at_low == 1);
  CHECK(report.falls_at_high == 1);
  CHECK(report.factor == Approx(expected).margin(0.05));
  CHECK(report.high - report.low <= 0.05);
  REQUIRE(fallen.get() != nullptr);
  CHECK(state_of(fallen.get(), s.block).velocity[0] > 0);
  CHECK(hs_world_find_strength_factor(s.world.get(), &def, &report, sizeof report, nullptr) == HS_OK);

  // Not one trial falls.
  def.high = 0.6;
  made = reinterpret_cast<hs_world*>(0x10);
  REQUIRE(hs_world_find_strength_factor(s.world.get(), &def, &report, sizeof report, &made) == HS_OK);
  CHECK(made == nullptr);
  CHECK(report.falls_at_high == 0);
  CHECK(report.trials == 2);
}

TEST_CASE("a search for strength ends where there is no number between its bounds") {
  Slope s;
  hs_strength_def def = strength_def();
  def.low = 1;
  def.high = 1 + 8 * std::numeric_limits<double>::epsilon();
  def.resolution = 1e-75;
  def.max_steps = 1;
  def.ratio = 1e75;  // all stand
  hs_strength_report report;
  REQUIRE(hs_world_find_strength_factor(s.world.get(), &def, &report, sizeof report, nullptr) == HS_OK);
  CHECK(report.falls_at_high == 0);
  // Some factor between both is that at which the box begins to slide: it is found to the last bit.
  def = strength_def();
  def.resolution = 1e-75;
  def.max_steps = 2000;
  def.ratio = 1e-3;
  REQUIRE(hs_world_find_strength_factor(s.world.get(), &def, &report, sizeof report, nullptr) == HS_OK);
  CHECK(report.trials < 80);
  if (report.falls_at_high && report.stands_at_low)
    CHECK(std::nextafter(report.low, HUGE_VAL) == report.high);
}

}  // namespace halfspace_test
