// halfspace/definition.h: a world answers what it was given, to the bit, also after changes, in a restored
// world and in one that is given the answers.

#include <cmath>
#include <cstring>

#include "capi/action_world.h"
#include "capi/unchanged.h"
#include "catch.h"
#include "halfspace/definition.h"

namespace halfspace_test {
namespace {

template <class Struct>
bool are_same(const Struct& a, const Struct& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <class Def, class Get>
Def got(Get get) {
  Def def;
  std::memset(&def, 0xee, sizeof def);
  REQUIRE(get(&def, sizeof def) == HS_OK);
  return def;
}

hs_world_def definition_of(const World& world) {
  return got<hs_world_def>(
      [&](hs_world_def* def, std::size_t size) { return hs_world_get_def(world.get(), def, size); });
}
hs_law_def default_law_of(const World& world) {
  return got<hs_law_def>(
      [&](hs_law_def* law, std::size_t size) { return hs_world_get_default_law(world.get(), law, size); });
}
hs_law_def law_of(const World& world, std::int32_t a, std::int32_t b) {
  return got<hs_law_def>(
      [&](hs_law_def* law, std::size_t size) { return hs_world_get_law(world.get(), a, b, law, size); });
}
hs_elasticity_def elasticity_of(const World& world, std::int32_t material) {
  return got<hs_elasticity_def>([&](hs_elasticity_def* elasticity, std::size_t size) {
    return hs_world_get_elasticity(world.get(), material, elasticity, size);
  });
}

std::vector<double> densities_of(const World& world) {
  std::int64_t count = -1;
  REQUIRE(hs_world_get_densities(world.get(), nullptr, 0, &count) >= HS_OK);
  std::vector<double> densities(static_cast<std::size_t>(count));
  REQUIRE(hs_world_get_densities(world.get(), densities.data(), count, nullptr) == HS_OK);
  return densities;
}

std::vector<hs_action_def> actions_on(const World& world, hs_block block) {
  std::int64_t count = -1;
  REQUIRE(hs_world_get_actions(world.get(), block, nullptr, sizeof(hs_action_def), 0, &count) >= HS_OK);
  std::vector<hs_action_def> actions(static_cast<std::size_t>(count));
  REQUIRE(hs_world_get_actions(world.get(), block, actions.data(), sizeof(hs_action_def), count, nullptr) ==
          HS_OK);
  return actions;
}

/// No member has its default.
hs_world_def chosen_def(int dimension) {
  hs_world_def def = world_def(dimension);
  for (int k = 0; k < dimension; ++k) def.gravity[k] = 0.1 + k;
  def.time_step = 1e-3;
  def.safety = 0.3;
  def.local_damping = 0.7;
  def.mass_damping = 0.9;
  def.skin = 0.2;
  def.parallel_angle = 0.03;
  def.vertex_zone = 0.04;
  def.potential_length = 0.6;
  def.fast_blocks = HS_FAST_REFUSE;
  def.sleep_tolerance = 1e-4;
  def.impulse_tolerance = 1e-7;
  def.max_impulse_iterations = 77;
  def.locate_impacts = 1;
  return def;
}

/// All numbers are given that a law per area may have. Its tangent, and its strengths over a factor, do not
/// lead back to the bits that were given.
hs_law_def chosen_law() {
  hs_law_def law = law_def(1, 0);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  for (std::size_t at = offsetof(hs_law_def, normal_stiffness); at < sizeof law; at += sizeof(double)) {
    const double number = 1 / static_cast<double>(at);
    std::memcpy(reinterpret_cast<char*>(&law) + at, &number, sizeof number);
  }
  law.shear_stiffness = law.restitution = 0;
  return law;
}

hs_elasticity_def chosen_elasticity(int dimension) {
  hs_elasticity_def elasticity = elasticity_def(4.7e10, 1e-5);
  elasticity.poisson_ratio = 0.21;
  elasticity.plane = dimension == 2 ? HS_PLANE_STRESS : HS_PLANE_STRAIN;
  return elasticity;
}

}  // namespace

TEST_CASE("a world returns its definition, with what was set since") {
  const Context context = make_context();
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    const hs_world_def defaults = world_def(dimension);
    CHECK(are_same(definition_of(make_world(context.get(), defaults)), defaults));
    hs_world_def def = chosen_def(dimension);
    const World world = make_world(context.get(), def);
    CHECK(are_same(definition_of(world), def));
    CHECK(are_same(definition_of(make_world(context.get(), definition_of(world))), def));
    const double gravity[3] = {3, -2, dimension == 3 ? 1.0 : 0.0};
    std::memcpy(def.gravity, gravity, sizeof gravity);
    def.local_damping = 0.1;
    def.mass_damping = 0.2;
    def.time_step = 2e-3;
    require_ok(hs_world_set_gravity(world.get(), gravity), context.get());
    require_ok(hs_world_set_damping(world.get(), 0.1, 0.2), context.get());
    require_ok(hs_world_set_time_step(world.get(), 2e-3), context.get());
    CHECK(are_same(definition_of(world), def));
    CHECK(are_same(definition_of(restored(context.get(), saved(world.get()))), def));
  }
}

TEST_CASE("a world returns materials and laws as they were given") {
  const Context context = make_context();
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    const World world = make_world(context.get(), world_def(dimension));
    hs_law_def default_law;
    REQUIRE(hs_law_def_init(&default_law, sizeof default_law) == HS_OK);
    CHECK(are_same(default_law_of(world), default_law));
    CHECK(densities_of(world).empty());
    for (const double density : {2700.1, 7850.3}) {
      std::int32_t material = -1;
      require_ok(hs_world_add_material(world.get(), density, &material), context.get());
    }
    CHECK(densities_of(world) == std::vector<double>{2700.1, 7850.3});
    CHECK(elasticity_of(world, 0).young_modulus == 0);
    const hs_elasticity_def elasticity = chosen_elasticity(dimension);
    const hs_law_def law = chosen_law();
    require_ok(hs_world_set_elasticity(world.get(), 1, &elasticity), context.get());
    require_ok(hs_world_set_law(world.get(), 1, 0, &law), context.get());
    require_ok(hs_world_set_strength_factor(world.get(), 1.7), context.get());
    default_law.friction_angle = 0.4;
    require_ok(hs_world_set_default_law(world.get(), &default_law), context.get());
    const World copy = restored(context.get(), saved(world.get()));
    for (const World* each : {&world, &copy}) {
      CHECK(are_same(elasticity_of(*each, 1), elasticity));
      CHECK(are_same(law_of(*each, 0, 1), law));
      CHECK(are_same(law_of(*each, 1, 0), law));
      CHECK(are_same(law_of(*each, 1, 1), default_law));
      CHECK(are_same(default_law_of(*each), default_law));
    }
  }
}

TEST_CASE("a world that is given what another one returns is the same to the bit") {
  const Context context = make_context();
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    const World world = make_world(context.get(), chosen_def(dimension));
    const World other = make_world(context.get(), definition_of(world));
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2700.1, &material), context.get());
    const hs_law_def law = chosen_law();
    const hs_elasticity_def elasticity = chosen_elasticity(dimension);
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    require_ok(hs_world_set_law(world.get(), 0, 0, &law), context.get());
    require_ok(hs_world_set_elasticity(world.get(), 0, &elasticity), context.get());

    require_ok(hs_world_add_material(other.get(), densities_of(world)[0], &material), context.get());
    const hs_law_def default_law = default_law_of(world), own = law_of(world, 0, 0);
    const hs_elasticity_def of_material = elasticity_of(world, 0);
    require_ok(hs_world_set_default_law(other.get(), &default_law), context.get());
    require_ok(hs_world_set_law(other.get(), 0, 0, &own), context.get());
    require_ok(hs_world_set_elasticity(other.get(), 0, &of_material), context.get());
    CHECK(saved(world.get()) == saved(other.get()));
  }
}

TEST_CASE("a world returns tables and actions as they were given") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    ActionWorld s(dimension);
    const std::vector<double> times = {0, 0.1, 0.1};
    const Points3 rows = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const std::int32_t table = s.add_table(times, rows);
    hs_action_def motion = action_def(HS_ACTION_VELOCITY, table);
    motion.start = 0.3;
    motion.scale[0] = 0.7;
    hs_action_def later = action_def(HS_ACTION_VELOCITY);
    later.scale[1] = later.scale[2] = 0;
    hs_action_def force = action_def(HS_ACTION_FORCE, table), carried = force;
    force.place = HS_PLACE_FIXED;
    force.point[1] = 0.25;
    carried.place = HS_PLACE_CARRIED;
    carried.point[0] = 4.5;
    carried.point[1] = 0.25;
    hs_action_def servo = action_def(HS_ACTION_SERVO);
    servo.max_speed = 0.1;
    const hs_action_def body_force = action_def(HS_ACTION_ACCELERATION);
    s.act(s.prescribed, motion);
    s.act(s.rigid, force);
    s.act(0, body_force);
    s.act(s.rigid, carried);
    const std::vector<hs_action_def> on_rigid = actions_on(s.world, s.rigid);
    REQUIRE(on_rigid.size() == 2);
    CHECK(are_same(on_rigid[0], force));
    CHECK(are_same(on_rigid[1], carried));
    CHECK(are_same(actions_on(s.world, 0).at(0), body_force));
    CHECK(actions_on(s.world, s.fixed).empty());

    s.act(s.prescribed, later);
    motion.scale[0] = 0;  // the later one moves it along x
    const World copy = restored(s.context.get(), saved(s.world.get()));
    const World* const both[] = {&s.world, &copy};
    for (const World* each : both) {
      const std::vector<hs_action_def> actions = actions_on(*each, s.prescribed);
      REQUIRE(actions.size() == 2);
      CHECK(are_same(actions[0], motion));
      CHECK(are_same(actions[1], later));
      std::int64_t count = 0;
      std::vector<double> got_times(3);
      Points3 got_rows(3);
      REQUIRE(hs_world_get_table(each->get(), table, got_times.data(), mutable_view_of(got_rows), &count) ==
              HS_OK);
      CHECK(count == 3);
      CHECK(got_times == times);
      CHECK(std::memcmp(got_rows.data(), rows.data(), 3 * sizeof rows[0]) == 0);
    }
    s.act(s.prescribed, servo);
    CHECK(are_same(actions_on(s.world, s.prescribed).back(), servo));

    const double velocity[3] = {2, 0, 0}, none[3] = {0, 0, 0};
    require_ok(hs_world_end_actions(s.world.get(), s.rigid), s.context.get());
    require_ok(hs_world_set_velocity(s.world.get(), s.rigid, velocity, none), s.context.get());
    CHECK(actions_on(s.world, s.rigid).empty());
  }
}

TEST_CASE("a point that a block carries is returned where it is now") {
  ActionWorld s(2);
  hs_action_def carried = action_def(HS_ACTION_FORCE);
  carried.place = HS_PLACE_CARRIED;
  carried.point[0] = 4.5;
  s.act(s.rigid, carried);
  const hs_pose turned = pose_at(7, 1, std::sqrt(0.5), std::sqrt(0.5));  // by 90 degrees
  require_ok(hs_world_set_pose(s.world.get(), s.rigid, &turned), s.context.get());
  const hs_action_def now = actions_on(s.world, s.rigid).at(0);
  CHECK(now.point[0] == Approx(7));
  CHECK(now.point[1] == Approx(1.5));
  CHECK(now.point[2] == 0);
}

TEST_CASE("getters of a world's definition write what fits, and refuse bad arguments") {
  ActionWorld s(2);
  const hs_world* w = s.world.get();
  const hs_action_def force = action_def(HS_ACTION_FORCE);
  for (int i = 0; i < 3; ++i) s.act(s.rigid, force);
  struct Longer {  // of a caller from the future
    hs_action_def known;
    double later[2];
  };
  Longer some[2];
  std::memset(some, 0xee, sizeof some);
  std::int64_t count = 0;
  CHECK(hs_world_get_actions(w, s.rigid, &some[0].known, sizeof some[0], 2, &count) == HS_NOTE_TRUNCATED);
  CHECK(count == 3);
  for (const Longer& each : some) {
    CHECK(each.known.struct_size == sizeof(Longer));
    CHECK(each.known.kind == HS_ACTION_FORCE);
    CHECK(each.later[1] == 0);
  }
  struct {  // of a caller from the past, and what lies behind it
    std::uint32_t struct_size;
    std::int32_t stiffness_kind;
    double behind = 0.5;
  } shorter;
  require_ok(hs_world_get_default_law(w, reinterpret_cast<hs_law_def*>(&shorter), 8), s.context.get());
  CHECK(shorter.struct_size == 8);
  CHECK(shorter.stiffness_kind == HS_STIFFNESS_PER_CONTACT);
  CHECK(shorter.behind == 0.5);

  double density = 0, time = 0;
  Points3 row(1);
  hs_world_def def;
  hs_law_def law;
  hs_elasticity_def elasticity;
  const auto get_actions = [&](hs_action_def* out, std::size_t size, std::int64_t capacity) {
    return [=, &s] { return hs_world_get_actions(w, s.rigid, out, size, capacity, nullptr); };
  };
  check_unchanged(s, "hs_world_get_def",
                  {{"def", "NULL", [&] { return hs_world_get_def(w, nullptr, sizeof def); }},
                   {"size", "7", [&] { return hs_world_get_def(w, &def, 7); }}});
  check_unchanged(s, "hs_world_get_densities",
                  {{"densities", "NULL", [&] { return hs_world_get_densities(w, nullptr, 1, nullptr); }},
                   {"capacity", "-1", [&] { return hs_world_get_densities(w, &density, -1, nullptr); }}});
  check_unchanged(
      s, "hs_world_get_elasticity",
      {{"material", "1", [&] { return hs_world_get_elasticity(w, 1, &elasticity, sizeof elasticity); },
        HS_ERROR_STALE_ID},
       {"elasticity", "NULL", [&] { return hs_world_get_elasticity(w, 0, nullptr, sizeof elasticity); }},
       {"size", "0", [&] { return hs_world_get_elasticity(w, 0, &elasticity, 0); }}});
  check_unchanged(s, "hs_world_get_default_law",
                  {{"law", "NULL", [&] { return hs_world_get_default_law(w, nullptr, sizeof law); }},
                   {"size", "7", [&] { return hs_world_get_default_law(w, &law, 7); }}});
  check_unchanged(
      s, "hs_world_get_law",
      {{"material_a", "-1", [&] { return hs_world_get_law(w, -1, 0, &law, sizeof law); }, HS_ERROR_STALE_ID},
       {"material_b", "1", [&] { return hs_world_get_law(w, 0, 1, &law, sizeof law); }, HS_ERROR_STALE_ID},
       {"law", "NULL", [&] { return hs_world_get_law(w, 0, 0, nullptr, sizeof law); }}});
  check_unchanged(
      s, "hs_world_get_table",
      {{"table", "1", [&] { return hs_world_get_table(w, 1, &time, mutable_view_of(row), nullptr); },
        HS_ERROR_STALE_ID},
       {"times", "NULL", [&] { return hs_world_get_table(w, 0, nullptr, mutable_view_of(row), nullptr); }},
       {"values.count", "-1", [&] {
          return hs_world_get_table(w, 0, &time, {nullptr, nullptr, nullptr, 8, -1}, nullptr);
        }}});
  check_unchanged(
      s, "hs_world_get_actions",
      {{"actions", "NULL", get_actions(nullptr, sizeof(hs_action_def), 1)},
       {"capacity", "-1", get_actions(nullptr, sizeof(hs_action_def), -1)},
       {"size", "7", get_actions(nullptr, 7, 0)},
       {"block", "no living block",
        [&] { return hs_world_get_actions(w, s.gone, nullptr, sizeof(hs_action_def), 0, nullptr); },
        HS_ERROR_STALE_ID}});
}

}  // namespace halfspace_test
