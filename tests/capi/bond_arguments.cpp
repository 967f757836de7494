// halfspace/bond.h: every argument of every function that can be wrong, and that nothing has changed
// afterwards.

#include <cstring>
#include <limits>

#include "capi/meshes.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double half_pi = 1.5707963267948966;

/// A row of three boxes that have common faces; the first is fixed, and so is a plate below that has none.
struct Row {
  Context context = make_context();
  World world = make_world(context.get(), world_def());
  hs_block first = 0, second = 0, third = 0, plate = 0;

  Row() {
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
    first = add(box(0, 0, 1, 1), HS_BLOCK_FIXED);
    second = add(box(1, 0, 2, 1), HS_BLOCK_RIGID);
    third = add(box(2, 0, 3, 1), HS_BLOCK_RIGID);
    plate = add(box(-1, -2, 3, -1), HS_BLOCK_FIXED);
  }
  hs_block add(const Points& vertices, std::int32_t kind) {
    return add_block(context.get(), world.get(), vertices, kind);
  }
};

std::string hexadecimal(hs_block id) {
  char text[32];
  std::snprintf(text, sizeof text, "%llx", static_cast<unsigned long long>(id));
  return text;
}

}  // namespace

TEST_CASE("bonds refuse every bad definition") {
  Row s;
  hs_world* w = s.world.get();
  using D = hs_bond_def;
  const std::vector<Spoiled<D>> spoiled = {
      {"struct_size", "0", [](D& d) { d.struct_size = 0; }},
      {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
      {"def.reserved", "3", [](D& d) { d.reserved = 3; }},
      {"def.normal_stiffness", "0", [](D& d) { d.normal_stiffness = 0; }},
      {"def.normal_stiffness", "-1", [](D& d) { d.normal_stiffness = -1; }},
      {"def.normal_stiffness", "nan", [](D& d) { d.normal_stiffness = nan; }},
      {"def.normal_stiffness", "1e+76", [](D& d) { d.normal_stiffness = 1e76; }},
      {"def.shear_stiffness", "-1", [](D& d) { d.shear_stiffness = -1; }},
      {"def.shear_stiffness", "inf", [](D& d) { d.shear_stiffness = inf; }},
      {"def.tensile_strength", "-1", [](D& d) { d.tensile_strength = -1; }},
      {"def.tensile_strength", "nan", [](D& d) { d.tensile_strength = nan; }},
      {"def.tensile_strength", "inf", [](D& d) { d.tensile_strength = inf; }},
      {"def.cohesion", "-2", [](D& d) { d.cohesion = -2; }},
      {"def.cohesion", "nan", [](D& d) { d.cohesion = nan; }},
      {"def.friction_angle", "-0.1", [](D& d) { d.friction_angle = -0.1; }},
      {"def.friction_angle", "1.57", [](D& d) { d.friction_angle = half_pi; }},
      {"def.friction_angle", "nan", [](D& d) { d.friction_angle = nan; }},
      {"def.residual_cohesion", "-1", [](D& d) { d.residual_cohesion = -1; }},
      {"def.residual_cohesion", "6", [](D& d) { d.cohesion = 5, d.residual_cohesion = 6; }},
      {"def.residual_cohesion", "nan", [](D& d) { d.residual_cohesion = nan; }},
      {"def.residual_friction_angle", "2", [](D& d) { d.residual_friction_angle = 2; }},
      {"def.residual_friction_angle", "nan", [](D& d) { d.residual_friction_angle = nan; }},
      {"def.tensile_fracture_energy", "-1", [](D& d) { d.tensile_fracture_energy = -1; }},
      {"def.tensile_fracture_energy", "nan", [](D& d) { d.tensile_fracture_energy = nan; }},
      {"def.shear_fracture_energy", "-1", [](D& d) { d.shear_fracture_energy = -1; }},
      {"def.shear_fracture_energy", "inf", [](D& d) { d.shear_fracture_energy = inf; }},
  };
  for (const auto& bad : spoiled) {
    hs_bond_def def = bond_def(1e8, 1e6);
    bad.spoil(def);
    std::int64_t count = 77;
    check_unchanged(
        s, "hs_world_bond_blocks",
        {{bad.member, bad.value, [&] { return hs_world_bond_blocks(w, s.first, s.second, &def); }}});
    check_unchanged(
        s, "hs_world_bond_materials",
        {{bad.member, bad.value, [&] { return hs_world_bond_materials(w, 0, 0, &def, &count); }}});
    CHECK(count == 77);
  }
}

TEST_CASE("bonds refuse what is missing, stale, the same, apart or at rest for ever") {
  Row s;
  hs_world* w = s.world.get();
  const hs_bond_def def = bond_def(1e8, 1e6);
  const hs_block removed = s.add(box(5, 5, 6, 6), HS_BLOCK_RIGID);
  REQUIRE(hs_world_remove_block(w, removed) == HS_OK);
  const auto bond = [&](hs_block a, hs_block b) {
    return [&, a, b] { return hs_world_bond_blocks(w, a, b, &def); };
  };
  check_unchanged(s, "hs_world_bond_blocks",
                  {{"def", "NULL", [&] { return hs_world_bond_blocks(w, s.first, s.second, nullptr); }},
                   {"block_a", hexadecimal(removed), bond(removed, s.first), HS_ERROR_STALE_ID},
                   {"block_b", hexadecimal(removed), bond(s.first, removed), HS_ERROR_STALE_ID},
                   {"block_a", "0", bond(0, s.first), HS_ERROR_STALE_ID},
                   {"block_a and block_b", hexadecimal(s.second), bond(s.second, s.second)},
                   {"no common face", hexadecimal(s.third), bond(s.first, s.third), HS_ERROR_STATE},
                   {"moves", hexadecimal(s.plate), bond(s.first, s.plate), HS_ERROR_STATE}});
  REQUIRE(hs_world_bond_blocks(w, s.first, s.second, &def) == HS_OK);
  check_unchanged(s, "hs_world_bond_blocks",
                  {{"bonded already", hexadecimal(s.first), bond(s.first, s.second), HS_ERROR_STATE},
                   {"bonded already", hexadecimal(s.first), bond(s.second, s.first), HS_ERROR_STATE}});
  std::int64_t count = 77;
  const auto of_materials = [&](std::int32_t a, std::int32_t b) {
    return [&, a, b] { return hs_world_bond_materials(w, a, b, &def, &count); };
  };
  check_unchanged(s, "hs_world_bond_materials",
                  {{"def", "NULL", [&] { return hs_world_bond_materials(w, 0, 0, nullptr, &count); }},
                   {"material_a", "-1", of_materials(-1, 0), HS_ERROR_STALE_ID},
                   {"material_b", "1", of_materials(0, 1), HS_ERROR_STALE_ID}});
  CHECK(count == 77);
  CHECK(hs_world_bond_blocks(nullptr, s.first, s.second, &def) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_bond_materials(nullptr, 0, 0, &def, &count) == HS_ERROR_ARGUMENT);
}

TEST_CASE("functions that read or hold bonds refuse bad numbers and what is missing") {
  Row s;
  hs_world* w = s.world.get();
  hs_bond bond;
  hs_bond_event event;
  hs_bond_report report;
  check_unchanged(s, "hs_world_hold_bonds",
                  {{"are_held", "2", [&] { return hs_world_hold_bonds(w, 2); }},
                   {"are_held", "-1", [&] { return hs_world_hold_bonds(w, -1); }}});
  check_unchanged(s, "hs_world_get_bonds",
                  {{"bonds", "NULL", [&] { return hs_world_get_bonds(w, nullptr, 1, nullptr); }},
                   {"capacity", "-1", [&] { return hs_world_get_bonds(w, &bond, -1, nullptr); }}});
  check_unchanged(s, "hs_world_get_bond_events",
                  {{"first", "-1", [&] { return hs_world_get_bond_events(w, -1, &event, 1, nullptr); }},
                   {"events", "NULL", [&] { return hs_world_get_bond_events(w, 0, nullptr, 1, nullptr); }},
                   {"capacity", "-1", [&] { return hs_world_get_bond_events(w, 0, &event, -1, nullptr); }}});
  check_unchanged(s, "hs_world_get_bond_report",
                  {{"report", "NULL", [&] { return hs_world_get_bond_report(w, nullptr, sizeof report); }}});
  CHECK(hs_world_hold_bonds(nullptr, 1) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_bonds(nullptr, nullptr, 0, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_bond_events(nullptr, 0, nullptr, 0, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_bond_report(nullptr, &report, sizeof report) == HS_ERROR_ARGUMENT);
}

TEST_CASE("lists of bonds and events say when there is too little room") {
  Row s;
  hs_world* w = s.world.get();
  std::int64_t count = -1;
  CHECK(hs_world_get_bonds(w, nullptr, 0, &count) == HS_OK);
  CHECK(count == 0);
  hs_bond_def def = bond_def(1e8, 0);  // nothing holds: their weight tears them
  CHECK(hs_world_bond_materials(w, 0, 0, &def, &count) == HS_OK);
  CHECK(count == 2);
  CHECK(hs_world_bond_materials(w, 0, 0, &def, &count) == HS_OK);
  CHECK(count == 0);
  hs_bond bonds[2];
  std::memset(static_cast<void*>(bonds), 0xee, sizeof bonds);
  const hs_bond untouched = bonds[1];
  CHECK(hs_world_get_bonds(w, nullptr, 0, &count) == HS_NOTE_TRUNCATED);
  CHECK(count == 2);
  CHECK(hs_world_get_bonds(w, bonds, 1, nullptr) == HS_NOTE_TRUNCATED);
  CHECK(std::memcmp(&bonds[1], &untouched, sizeof untouched) == 0);
  CHECK(bonds[0].block_a == s.first);
  CHECK(bonds[0].block_b == s.second);
  CHECK(bonds[0].is_joint == 1);
  CHECK(bonds[0].point_count == 3);
  CHECK(bonds[0].area == Approx(1));

  run(s.context.get(), w, 0.01);
  const std::vector<hs_bond_event> events = bond_events_of(w);
  REQUIRE(events.size() >= 3);
  hs_bond_event some[2];
  std::memset(static_cast<void*>(some), 0xee, sizeof some);
  const hs_bond_event kept = some[1];
  CHECK(hs_world_get_bond_events(w, 1, some, 1, &count) == HS_NOTE_TRUNCATED);
  CHECK(count == std::int64_t(events.size()) - 1);
  CHECK(std::memcmp(&some[0], &events[1], sizeof events[1]) == 0);
  CHECK(std::memcmp(&some[1], &kept, sizeof kept) == 0);
  CHECK(hs_world_get_bond_events(w, INT64_MAX, some, 1, &count) == HS_OK);
  CHECK(count == 0);
}

TEST_CASE("the bonds of a removed block name none, and never those of the block that comes after it") {
  Row s;
  hs_world* w = s.world.get();
  const hs_bond_def def = bond_def(1e8, 1e6);
  REQUIRE(hs_world_bond_materials(w, 0, 0, &def, nullptr) == HS_OK);
  REQUIRE(hs_world_remove_block(w, s.second) == HS_OK);
  s.second = s.add(box(1, 0, 2, 1), HS_BLOCK_RIGID);  // in the same slot
  for (const hs_bond& bond : bonds_of(w)) {
    CHECK(bond.block_a == 0);
    CHECK(bond.block_b == 0);
    CHECK(bond.is_joint == 0);
    CHECK(bond.area == Approx(1));
  }
  CHECK(hs_world_step(w, 5) == HS_OK);
  CHECK(hs_world_bond_blocks(w, s.first, s.second, &def) == HS_OK);
  hs_bond_report report;
  REQUIRE(hs_world_get_bond_report(w, &report, sizeof report) == HS_OK);
  CHECK(report.bond_count == 3);
  CHECK(report.joint_count == 1);
}

}  // namespace halfspace_test
