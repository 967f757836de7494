// Every definition and report that the library fills, and the sizes by which it knows which version of the
// struct a caller has.

#include <cstring>
#include <vector>

#include "capi/meshes.h"
#include "capi/refusals.h"

namespace halfspace_test {
namespace {

/// A caller from the future has a longer struct: what this library does not know is zero, nothing behind it
/// is touched. Returns what it knows.
template <class Struct, class Fill>
Struct filled_longer(Fill fill) {
  std::vector<unsigned char> longer(sizeof(Struct) + 64, 0xee);
  REQUIRE(fill(reinterpret_cast<Struct*>(longer.data()), sizeof(Struct) + 32) == HS_OK);
  for (std::size_t i = sizeof(Struct); i < sizeof(Struct) + 32; ++i) CHECK(int(longer[i]) == 0);
  for (std::size_t i = sizeof(Struct) + 32; i < longer.size(); ++i) CHECK(int(longer[i]) == 0xee);
  Struct known;
  std::memcpy(&known, longer.data(), sizeof known);
  return known;
}

/// Checks hs_..._init(def, size) for a struct that begins with struct_size.
template <class Def, class Init>
void check_init(Init init) {
  CHECK(init(nullptr, sizeof(Def)) == HS_ERROR_ARGUMENT);

  Def def;
  std::memset(&def, 0xee, sizeof def);
  const Def untouched = def;
  for (std::size_t size : {std::size_t(0), std::size_t(1), std::size_t(4), ~std::size_t(0)}) {
    CHECK(init(&def, size) == HS_ERROR_ARGUMENT);
    CHECK(std::memcmp(&def, &untouched, sizeof def) == 0);
  }
  REQUIRE(init(&def, sizeof def) == HS_OK);
  CHECK(def.struct_size == sizeof(Def));
  CHECK(filled_longer<Def>(init).struct_size == sizeof(Def) + 32);
}

/// Checks a getter of a report. Its first version was of the size given: no caller has a smaller one.
template <class Report, class Get>
void check_report(hs_context* context, const char* function, std::size_t first_version, Get get) {
  Report report;
  std::memset(&report, 0xee, sizeof report);
  const Report untouched = report;
  std::vector<Refusal> refusals;
  for (std::size_t size : {std::size_t(0), std::size_t(8), first_version - 1, std::size_t(1) << 17})
    refusals.push_back({"size", std::to_string(size), [&, size] { return get(&report, size); }});
  check_refusals(context, function, refusals);
  CHECK(std::memcmp(&report, &untouched, sizeof report) == 0);

  REQUIRE(get(&report, sizeof report) == HS_OK);
  CHECK(std::memcmp(&report, &untouched, sizeof report) != 0);
  const Report of_longer = filled_longer<Report>(get);
  CHECK(std::memcmp(&report, &of_longer, sizeof report) == 0);

  // A caller of the first version gets that, and nothing behind it is touched.
  Report first = untouched, expected = untouched;
  std::memcpy(static_cast<void*>(&expected), &report, first_version);
  REQUIRE(get(&first, first_version) == HS_OK);
  CHECK(std::memcmp(&first, &expected, sizeof first) == 0);
}

}  // namespace

TEST_CASE("hs_context_def_init") { check_init<hs_context_def>(hs_context_def_init); }
TEST_CASE("hs_bolt_def_init") { check_init<hs_bolt_def>(hs_bolt_def_init); }
TEST_CASE("hs_water_def_init") { check_init<hs_water_def>(hs_water_def_init); }
TEST_CASE("hs_motion_def_init") { check_init<hs_motion_def>(hs_motion_def_init); }
TEST_CASE("hs_pair_options_init") { check_init<hs_pair_options>(hs_pair_options_init); }
TEST_CASE("hs_world_def_init") {
  for (const int32_t dimension : {2, 3}) {
    check_init<hs_world_def>(
        [&](hs_world_def* def, std::size_t size) { return hs_world_def_init(def, size, dimension); });
  }
  hs_world_def def{};
  for (const int32_t dimension : {-1, 0, 1, 4})
    CHECK(hs_world_def_init(&def, sizeof def, dimension) == HS_ERROR_ARGUMENT);
  CHECK(def.struct_size == 0);
}
TEST_CASE("hs_law_def_init") { check_init<hs_law_def>(hs_law_def_init); }
TEST_CASE("hs_action_def_init") { check_init<hs_action_def>(hs_action_def_init); }
TEST_CASE("hs_elasticity_def_init") { check_init<hs_elasticity_def>(hs_elasticity_def_init); }
TEST_CASE("hs_body_def_init") { check_init<hs_body_def>(hs_body_def_init); }
TEST_CASE("hs_bond_def_init") { check_init<hs_bond_def>(hs_bond_def_init); }
TEST_CASE("hs_relaxation_def_init") { check_init<hs_relaxation_def>(hs_relaxation_def_init); }
TEST_CASE("hs_strength_def_init") { check_init<hs_strength_def>(hs_strength_def_init); }

TEST_CASE("hs_block_def_init") {
  const Context context = make_context();
  const Shape shape = make_shape(context.get(), box(1, 2, 5, 4));
  check_init<hs_block_def>(
      [&](hs_block_def* def, std::size_t size) { return hs_block_def_init(def, size, shape.get()); });
  hs_block_def def;
  CHECK(hs_block_def_init(&def, sizeof def, nullptr) == HS_ERROR_ARGUMENT);
  REQUIRE(hs_block_def_init(&def, sizeof def, shape.get()) == HS_OK);
  CHECK(def.pose.position[0] == 3);
  CHECK(def.pose.position[1] == 3);
  CHECK(def.pose.rotation[3] == 1);
}

TEST_CASE("hs_shape_get_properties: sizes of its report") {
  const Context context = make_context();
  const Shape shape = make_shape(context.get(), box(1, 2, 5, 4));
  check_report<hs_shape_properties>(context.get(), "hs_shape_get_properties", 128,
                                    [&](hs_shape_properties* properties, std::size_t size) {
                                      return hs_shape_get_properties(shape.get(), properties, size);
                                    });
}

TEST_CASE("hs_world_get_report: sizes of its report") {
  const TwoBoxes scene;
  check_report<hs_world_report>(scene.context.get(), "hs_world_get_report", 160,
                                [&](hs_world_report* report, std::size_t size) {
                                  return hs_world_get_report(scene.world.get(), report, size);
                                });
}

TEST_CASE("hs_world_get_plan: sizes of its report") {
  const TwoBoxes scene;
  check_report<hs_world_plan>(scene.context.get(), "hs_world_get_plan", sizeof(hs_world_plan),
                              [&](hs_world_plan* plan, std::size_t size) {
                                return hs_world_get_plan(scene.world.get(), 0, plan, size);
                              });
}

TEST_CASE("sizes of the reports on meshes and bodies") {
  const TwoBoxes scene;
  hs_context* c = scene.context.get();
  const hs_elasticity_def elasticity = elasticity_def(1e8);
  require_ok(hs_world_set_elasticity(scene.world.get(), 0, &elasticity), c);
  const Mesh mesh = make_mesh(c, bar(2));
  check_report<hs_mesh_properties>(c, "hs_mesh_get_properties", sizeof(hs_mesh_properties),
                                   [&](hs_mesh_properties* properties, std::size_t size) {
                                     return hs_mesh_get_properties(mesh.get(), properties, size);
                                   });
  const hs_body body = add_body(c, scene.world.get(), bar(2), body_def(pose_at(0, 5)));
  check_report<hs_body_state>(c, "hs_world_get_body_state", sizeof(hs_body_state),
                              [&](hs_body_state* state, std::size_t size) {
                                return hs_world_get_body_state(scene.world.get(), body, state, size);
                              });
}

TEST_CASE("sizes of the reports on bonds, balance and strength") {
  const TwoBoxes scene;
  hs_context* c = scene.context.get();
  hs_world* w = scene.world.get();
  require_ok(hs_world_remove_block(w, scene.box_away), c);
  check_report<hs_bond_report>(
      c, "hs_world_get_bond_report", sizeof(hs_bond_report),
      [&](hs_bond_report* report, std::size_t size) { return hs_world_get_bond_report(w, report, size); });
  check_report<hs_balance>(
      c, "hs_world_get_balance", sizeof(hs_balance),
      [&](hs_balance* balance, std::size_t size) { return hs_world_get_balance(w, balance, size); });
  check_report<hs_balance>(c, "hs_world_relax", sizeof(hs_balance),
                           [&](hs_balance* balance, std::size_t size) {
                             const World copy = restored(c, saved(w));
                             const hs_relaxation_def def = relaxation_def(1, 1e9);
                             return hs_world_relax(copy.get(), &def, balance, size);
                           });
  check_report<hs_strength_report>(c, "hs_world_find_strength_factor", sizeof(hs_strength_report),
                                   [&](hs_strength_report* report, std::size_t size) {
                                     hs_strength_def def;
                                     require_ok(hs_strength_def_init(&def, sizeof def), c);
                                     def.max_steps = 1;
                                     return hs_world_find_strength_factor(w, &def, report, size, nullptr);
                                   });
}

TEST_CASE(
    "the defaults of bodies, bonds, relaxation and the search for strength are those the headers state") {
  const hs_body_def body = body_def();
  CHECK(body.material == 0);
  for (const double zero :
       {body.pose.position[0], body.pose.position[1], body.pose.position[2], body.pose.rotation[0],
        body.pose.rotation[1], body.pose.rotation[2], body.velocity[0], body.velocity[1], body.velocity[2]})
    CHECK(zero == 0);
  CHECK(body.pose.rotation[3] == 1);

  hs_bond_def bond;
  REQUIRE(hs_bond_def_init(&bond, sizeof bond) == HS_OK);
  CHECK(bond.normal_stiffness == 1e11);
  for (const double zero : {bond.shear_stiffness, bond.tensile_strength, bond.cohesion, bond.friction_angle,
                            bond.residual_cohesion, bond.tensile_fracture_energy, bond.shear_fracture_energy})
    CHECK(zero == 0);

  CHECK(bond.residual_friction_angle < 0);  // the friction angle

  hs_relaxation_def relaxation;
  REQUIRE(hs_relaxation_def_init(&relaxation, sizeof relaxation) == HS_OK);
  CHECK(relaxation.measure == HS_UNBALANCED_MEAN);
  CHECK(relaxation.ratio == 1e-5);
  CHECK(relaxation.max_steps == 1000000);
  CHECK(relaxation.local_damping == 0.1);
  CHECK(relaxation.is_adaptive == 1);
  CHECK(relaxation.hold_bonds == 1);

  hs_strength_def strength;
  REQUIRE(hs_strength_def_init(&strength, sizeof strength) == HS_OK);
  CHECK(strength.low == 0.5);
  CHECK(strength.high == 5);
  CHECK(strength.resolution == 0.005);
  CHECK(strength.ratio == 1e-5);
  CHECK(strength.max_displacement == 0.1);
  CHECK(strength.max_steps == 100000);
}

TEST_CASE("the defaults are those the headers state") {
  hs_pair_options options;
  REQUIRE(hs_pair_options_init(&options, sizeof options) == HS_OK);
  CHECK(options.parallel_angle == 0.01);
  CHECK(options.vertex_zone == 1e-6);
  CHECK(options.margin == 0);
  CHECK(options.without_region == 0);

  hs_law_def law;
  REQUIRE(hs_law_def_init(&law, sizeof law) == HS_OK);
  CHECK(law.stiffness_kind == HS_STIFFNESS_PER_CONTACT);
  CHECK(law.normal_stiffness == 1e9);
  for (double zero : {law.shear_stiffness, law.friction_angle, law.cohesion, law.tensile_strength}) {
    CHECK(zero == 0);
  }
  CHECK(law.normal_damping == 0.1);
  CHECK(law.shear_damping == 0.1);

  hs_elasticity_def elasticity;
  REQUIRE(hs_elasticity_def_init(&elasticity, sizeof elasticity) == HS_OK);
  CHECK(elasticity.plane == HS_PLANE_STRAIN);
  CHECK(elasticity.young_modulus == 1e9);
  CHECK(elasticity.poisson_ratio == 0.25);
  CHECK(elasticity.damping_time == 0);

  hs_world_def in_space;
  REQUIRE(hs_world_def_init(&in_space, sizeof in_space, 3) == HS_OK);
  CHECK(in_space.dimension == 3);
  CHECK(in_space.gravity[0] == 0);
  CHECK(in_space.gravity[1] == 0);
  CHECK(in_space.gravity[2] == -9.81);

  hs_world_def world;
  REQUIRE(hs_world_def_init(&world, sizeof world, 2) == HS_OK);
  CHECK(world.dimension == 2);
  CHECK(world.gravity[1] == -9.81);
  CHECK(world.safety == 0.5);
  CHECK(world.skin == 0.1);
  CHECK(world.parallel_angle == 0.01);
  CHECK(world.vertex_zone == 1e-6);
  for (double zero :
       {world.gravity[0], world.gravity[2], world.time_step, world.local_damping, world.mass_damping}) {
    CHECK(zero == 0);
  }
}

}  // namespace halfspace_test
