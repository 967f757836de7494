// halfspace/world.h and law.h: every argument of every function that can be wrong, and that nothing has
// changed afterwards.

#include <cmath>
#include <cstring>
#include <limits>

#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double half_pi = 1.5707963267948966;
const double zero[3] = {0, 0, 0};
const double not_a_number[3] = {0, nan, 0};
const double infinite[3] = {-inf, 0, 0};
const double spinning_nan[3] = {0, 0, nan};

}  // namespace

TEST_CASE("hs_world_create refuses every bad setting") {
  const Context context = make_context();
  hs_world* const sentinel = reinterpret_cast<hs_world*>(0x10);
  hs_world* world = sentinel;
  using D = hs_world_def;
  const std::vector<Spoiled<D>> spoiled = {
      {"struct_size", "0", [](D& d) { d.struct_size = 0; }},
      {"struct_size", "3", [](D& d) { d.struct_size = 3; }},
      {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
      {"dimension", "4", [](D& d) { d.dimension = 4; }},
      {"dimension", "-1", [](D& d) { d.dimension = -1; }},
      {"gravity[0]", "nan", [](D& d) { d.gravity[0] = nan; }},
      {"gravity[1]", "inf", [](D& d) { d.gravity[1] = inf; }},
      {"time_step", "-1", [](D& d) { d.time_step = -1; }},
      {"time_step", "nan", [](D& d) { d.time_step = nan; }},
      {"time_step", "inf", [](D& d) { d.time_step = inf; }},
      {"safety", "0", [](D& d) { d.safety = 0; }},
      {"safety", "1.5", [](D& d) { d.safety = 1.5; }},
      {"safety", "nan", [](D& d) { d.safety = nan; }},
      {"local_damping", "-0.1", [](D& d) { d.local_damping = -0.1; }},
      {"local_damping", "1", [](D& d) { d.local_damping = 1; }},
      {"local_damping", "nan", [](D& d) { d.local_damping = nan; }},
      {"mass_damping", "-2", [](D& d) { d.mass_damping = -2; }},
      {"mass_damping", "nan", [](D& d) { d.mass_damping = nan; }},
      {"mass_damping", "inf", [](D& d) { d.mass_damping = inf; }},
      {"skin", "0", [](D& d) { d.skin = 0; }},
      {"skin", "1.1", [](D& d) { d.skin = 1.1; }},
      {"skin", "nan", [](D& d) { d.skin = nan; }},
      {"parallel_angle", "0.6", [](D& d) { d.parallel_angle = 0.6; }},
      {"parallel_angle", "nan", [](D& d) { d.parallel_angle = nan; }},
      {"vertex_zone", "-0.5", [](D& d) { d.vertex_zone = -0.5; }},
      {"vertex_zone", "nan", [](D& d) { d.vertex_zone = nan; }},
      {"fast_blocks", "2", [](D& d) { d.fast_blocks = 2; }},
      {"potential_length", "-1", [](D& d) { d.potential_length = -1; }},
      {"potential_length", "inf", [](D& d) { d.potential_length = inf; }},
      {"sleep_tolerance", "-1", [](D& d) { d.sleep_tolerance = -1; }},
      {"sleep_tolerance", "inf", [](D& d) { d.sleep_tolerance = inf; }},
  };
  for (const auto& s : spoiled) {
    hs_world_def def = world_def();
    s.spoil(def);
    check_refusals(
        context.get(), "hs_world_create",
        {{s.member, s.value, [&] { return hs_world_create(context.get(), &def, &world); }, s.status}});
  }
  const hs_world_def def = world_def();
  CHECK(hs_world_create(nullptr, &def, &world) == HS_ERROR_ARGUMENT);
  check_refusals(context.get(), "hs_world_create",
                 {{"def", "NULL", [&] { return hs_world_create(context.get(), nullptr, &world); }},
                  {"world", "NULL", [&] { return hs_world_create(context.get(), &def, nullptr); }}});
  CHECK(world == sentinel);
}

TEST_CASE("materials and laws refuse every bad number") {
  TwoBoxes s;
  hs_world* w = s.world.get();
  std::int32_t material = -7;
  const auto add = [&](double density) {
    return [&, density] { return hs_world_add_material(w, density, &material); };
  };
  CHECK(hs_world_add_material(nullptr, 1, &material) == HS_ERROR_ARGUMENT);
  check_unchanged(s, "hs_world_add_material",
                  {{"density", "0", add(0)},
                   {"density", "-1", add(-1)},
                   {"density", "nan", add(nan)},
                   {"density", "inf", add(inf)},
                   {"material", "NULL", [&] { return hs_world_add_material(w, 1, nullptr); }}});
  CHECK(material == -7);

  using D = hs_law_def;
  const std::vector<Spoiled<D>> spoiled = {
      {"struct_size", "0", [](D& d) { d.struct_size = 0; }},
      {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
      {"stiffness_kind", "99", [](D& d) { d.stiffness_kind = 99; }},
      {"stiffness_kind", "-1", [](D& d) { d.stiffness_kind = -1; }},
      {"normal_stiffness", "0", [](D& d) { d.normal_stiffness = 0; }},
      {"normal_stiffness", "nan", [](D& d) { d.normal_stiffness = nan; }},
      {"normal_stiffness", "inf", [](D& d) { d.normal_stiffness = inf; }},
      {"shear_stiffness", "-1", [](D& d) { d.shear_stiffness = -1; }},
      {"shear_stiffness", "nan", [](D& d) { d.shear_stiffness = nan; }},
      {"shear_stiffness", "inf", [](D& d) { d.shear_stiffness = inf; }},
      {"friction_angle", "-0.1", [](D& d) { d.friction_angle = -0.1; }},
      {"friction_angle", "1.57", [](D& d) { d.friction_angle = half_pi; }},
      {"friction_angle", "nan", [](D& d) { d.friction_angle = nan; }},
      {"cohesion", "-1", [](D& d) { d.cohesion = -1; }},
      {"cohesion", "nan", [](D& d) { d.cohesion = nan; }},
      {"cohesion", "inf", [](D& d) { d.cohesion = inf; }},
      {"tensile_strength", "-1", [](D& d) { d.tensile_strength = -1; }},
      {"tensile_strength", "nan", [](D& d) { d.tensile_strength = nan; }},
      {"tensile_strength", "inf", [](D& d) { d.tensile_strength = inf; }},
      {"normal_damping", "-1", [](D& d) { d.normal_damping = -1; }},
      {"normal_damping", "nan", [](D& d) { d.normal_damping = nan; }},
      {"normal_damping", "inf", [](D& d) { d.normal_damping = inf; }},
      {"shear_damping", "-1", [](D& d) { d.shear_damping = -1; }},
      {"shear_damping", "nan", [](D& d) { d.shear_damping = nan; }},
      {"shear_damping", "inf", [](D& d) { d.shear_damping = inf; }},
      {"cohesion", "5", [](D& d) { d.stiffness_kind = HS_STIFFNESS_POTENTIAL, d.cohesion = 5; }},
      {"tensile_strength", "6",
       [](D& d) { d.stiffness_kind = HS_STIFFNESS_POTENTIAL, d.tensile_strength = 6; }},
  };
  for (const auto& bad : spoiled) {
    hs_law_def law = law_def(1e6, 0.3);
    bad.spoil(law);
    check_unchanged(s, "hs_world_set_default_law",
                    {{bad.member, bad.value, [&] { return hs_world_set_default_law(w, &law); }}});
    check_unchanged(s, "hs_world_set_law",
                    {{bad.member, bad.value, [&] { return hs_world_set_law(w, 0, 0, &law); }}});
  }
  const hs_law_def law = law_def(1e6, 0.3);
  CHECK(hs_world_set_default_law(nullptr, &law) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_law(nullptr, 0, 0, &law) == HS_ERROR_ARGUMENT);
  check_unchanged(s, "hs_world_set_default_law",
                  {{"law", "NULL", [&] { return hs_world_set_default_law(w, nullptr); }}});
  check_unchanged(s, "hs_world_set_law",
                  {{"law", "NULL", [&] { return hs_world_set_law(w, 0, 0, nullptr); }},
                   {"material_a", "-1", [&] { return hs_world_set_law(w, -1, 0, &law); }, HS_ERROR_STALE_ID},
                   {"material_b", "1", [&] { return hs_world_set_law(w, 0, 1, &law); }, HS_ERROR_STALE_ID}});
}

TEST_CASE("hs_world_add_block refuses every bad definition") {
  TwoBoxes s;
  const Shape shape = make_shape(s.context.get(), box(0, 0, 1, 1));
  hs_block block = 77;
  using D = hs_block_def;
  const std::vector<Spoiled<D>> spoiled = {
      {"struct_size", "0", [](D& d) { d.struct_size = 0; }},
      {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
      {"kind", "4", [](D& d) { d.kind = 4; }},
      {"kind", "-1", [](D& d) { d.kind = -1; }},
      {"material", "1", [](D& d) { d.material = 1; }, HS_ERROR_STALE_ID},
      {"material", "-1", [](D& d) { d.material = -1; }, HS_ERROR_STALE_ID},
      {"pose", "nan", [](D& d) { d.pose.position[0] = nan; }},
      {"pose", "inf", [](D& d) { d.pose.position[1] = inf; }},
      {"rotation", "0", [](D& d) { d.pose.rotation[3] = 0; }},
      {"rotation", "2", [](D& d) { d.pose.rotation[3] = 2; }},
      {"rotation", "nan", [](D& d) { d.pose.rotation[2] = nan; }},
      {"velocity", "nan", [](D& d) { d.velocity[0] = nan; }},
      {"velocity", "inf", [](D& d) { d.velocity[1] = inf; }},
      {"angular_velocity", "nan", [](D& d) { d.angular_velocity[2] = nan; }},
      {"angular_velocity", "inf", [](D& d) { d.angular_velocity[2] = inf; }},
  };
  hs_world* w = s.world.get();
  for (const auto& bad : spoiled) {
    hs_block_def def;
    REQUIRE(hs_block_def_init(&def, sizeof def, shape.get()) == HS_OK);
    bad.spoil(def);
    check_unchanged(s, "hs_world_add_block",
                    {{bad.member, bad.value, [&] { return hs_world_add_block(w, shape.get(), &def, &block); },
                      bad.status}});
  }
  hs_block_def def;
  REQUIRE(hs_block_def_init(&def, sizeof def, shape.get()) == HS_OK);
  CHECK(hs_world_add_block(nullptr, shape.get(), &def, &block) == HS_ERROR_ARGUMENT);
  check_unchanged(s, "hs_world_add_block",
                  {{"shape", "NULL", [&] { return hs_world_add_block(w, nullptr, &def, &block); }},
                   {"def", "NULL", [&] { return hs_world_add_block(w, shape.get(), nullptr, &block); }},
                   {"block", "NULL", [&] { return hs_world_add_block(w, shape.get(), &def, nullptr); }}});
  CHECK(block == 77);
}

TEST_CASE("functions of one block refuse bad numbers, what is missing, and what the block is not") {
  TwoBoxes s;
  hs_world* w = s.world.get();
  const hs_block rigid = s.box_on_floor, fixed = s.floor;
  const hs_pose good = pose_at(0, 0);
  double two[2] = {0, 0};
  hs_block_state state;
  const auto pose = [&](double x, double w_of_q) {
    return [&, x, w_of_q] {
      const hs_pose p = pose_at(x, 0, 0, w_of_q);
      return hs_world_set_pose(w, rigid, &p);
    };
  };
  check_unchanged(s, "hs_world_set_pose",
                  {{"pose", "NULL", [&] { return hs_world_set_pose(w, rigid, nullptr); }},
                   {"pose->position[0]", "nan", pose(nan, 1)},
                   {"pose->position[0]", "inf", pose(inf, 1)},
                   {"pose->rotation", "1.5", pose(0, 1.5)},
                   {"pose->rotation", "nan", pose(0, nan)}});
  check_unchanged(
      s, "hs_world_set_velocity",
      {{"velocity", "NULL", [&] { return hs_world_set_velocity(w, rigid, nullptr, zero); }},
       {"angular_velocity", "NULL", [&] { return hs_world_set_velocity(w, rigid, zero, nullptr); }},
       {"velocity[1]", "nan", [&] { return hs_world_set_velocity(w, rigid, not_a_number, zero); }},
       {"velocity[0]", "inf", [&] { return hs_world_set_velocity(w, rigid, infinite, zero); }},
       {"angular_velocity[2]", "nan", [&] { return hs_world_set_velocity(w, rigid, zero, spinning_nan); }},
       {"block", "fixed", [&] { return hs_world_set_velocity(w, fixed, zero, zero); }, HS_ERROR_STATE}});
  check_unchanged(
      s, "hs_world_set_applied_force",
      {{"force", "NULL", [&] { return hs_world_set_applied_force(w, rigid, nullptr, zero); }},
       {"torque", "NULL", [&] { return hs_world_set_applied_force(w, rigid, zero, nullptr); }},
       {"force[1]", "nan", [&] { return hs_world_set_applied_force(w, rigid, not_a_number, zero); }},
       {"force[0]", "inf", [&] { return hs_world_set_applied_force(w, rigid, infinite, zero); }},
       {"torque[2]", "nan", [&] { return hs_world_set_applied_force(w, rigid, zero, spinning_nan); }},
       {"block", "rigid", [&] { return hs_world_set_applied_force(w, fixed, zero, zero); }, HS_ERROR_STATE}});
  check_unchanged(s, "hs_world_get_block_state",
                  {{"state", "NULL", [&] { return hs_world_get_block_state(w, rigid, nullptr); }}});
  check_unchanged(s, "hs_world_get_block_vertices",
                  {{"vertices.count", "-1",
                    [&] {
                      return hs_world_get_block_vertices(w, rigid, {two, two, nullptr, 8, -1}, nullptr);
                    }},
                   {"vertices.x", "NULL",
                    [&] {
                      return hs_world_get_block_vertices(w, rigid, {nullptr, two, nullptr, 8, 1}, nullptr);
                    }},
                   {"vertices.stride", "9", [&] {
                      return hs_world_get_block_vertices(w, rigid, {two, two, nullptr, 9, 1}, nullptr);
                    }}});
  CHECK(hs_world_set_pose(nullptr, rigid, &good) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_velocity(nullptr, rigid, zero, zero) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_applied_force(nullptr, rigid, zero, zero) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_block_state(nullptr, rigid, &state) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_block_vertices(nullptr, rigid, {}, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_remove_block(nullptr, rigid) == HS_ERROR_ARGUMENT);
}

TEST_CASE("a stale or invented id is refused by every function that takes one") {
  TwoBoxes s;
  hs_world* w = s.world.get();
  const hs_block removed = s.box_away;
  REQUIRE(hs_world_remove_block(w, removed) == HS_OK);
  const hs_block successor = add_block(s.context.get(), w, box(2, 3, 3, 4), HS_BLOCK_RIGID);
  CHECK(successor != removed);
  REQUIRE(hs_world_detect(w, nullptr) == HS_OK);
  const hs_pose good = pose_at(0, 0);
  hs_block_state state;
  for (hs_block bad : {hs_block(0), removed, hs_block(~0ull), hs_block(99), s.floor + (hs_block(1) << 32)}) {
    char id[32];
    std::snprintf(id, sizeof id, "%llx", static_cast<unsigned long long>(bad));
    const auto stale = [&](const char* function, const char* argument, std::function<hs_status()> call) {
      check_unchanged(s, function, {{argument, id, call, HS_ERROR_STALE_ID}});
    };
    stale("hs_world_remove_block", "block", [&] { return hs_world_remove_block(w, bad); });
    stale("hs_world_get_block_state", "block", [&] { return hs_world_get_block_state(w, bad, &state); });
    stale("hs_world_get_block_vertices", "block",
          [&] { return hs_world_get_block_vertices(w, bad, {}, nullptr); });
    stale("hs_world_set_pose", "block", [&] { return hs_world_set_pose(w, bad, &good); });
    stale("hs_world_set_velocity", "block", [&] { return hs_world_set_velocity(w, bad, zero, zero); });
    stale("hs_world_set_applied_force", "block",
          [&] { return hs_world_set_applied_force(w, bad, zero, zero); });
    stale("hs_world_set_shear_force", "block_a",
          [&] { return hs_world_set_shear_force(w, bad, s.floor, zero); });
    stale("hs_world_set_shear_force", "block_b",
          [&] { return hs_world_set_shear_force(w, s.floor, bad, zero); });
  }
  CHECK(hs_world_get_block_state(w, successor, &state) == HS_OK);
}

TEST_CASE("bulk functions refuse bad arrays as a whole") {
  TwoBoxes s;
  hs_world* w = s.world.get();
  hs_block ids[3] = {1, 2, 3};
  hs_block_state states[3];
  std::vector<hs_pose> poses = poses_of(w);
  REQUIRE(poses.size() == 3);
  double v[9] = {0, 0, 0, 1, 1, 0, 2, 2, 0};
  double v_nan[9] = {0, 0, 0, 1, 1, 0, 2, nan, 0};
  double spin[9] = {};
  double spin_inf[9] = {0, 0, 0, 0, 0, inf, 0, 0, 0};
  const auto view = [](const double* p, std::int64_t count, std::int64_t stride = 24) {
    return hs_view{p, p + 1, p + 2, stride, count};
  };
  const auto out = [](double* p, std::int64_t count, std::int64_t stride = 24) {
    return hs_mutable_view{p, p + 1, p + 2, stride, count};
  };
  const hs_view none{};
  const hs_mutable_view no_room{};

  check_unchanged(s, "hs_world_get_blocks",
                  {{"blocks", "NULL", [&] { return hs_world_get_blocks(w, nullptr, 3, nullptr); }},
                   {"capacity", "-1", [&] { return hs_world_get_blocks(w, ids, -1, nullptr); }}});
  check_unchanged(s, "hs_world_get_poses",
                  {{"poses", "NULL", [&] { return hs_world_get_poses(w, nullptr, 3, nullptr); }},
                   {"capacity", "-2", [&] { return hs_world_get_poses(w, poses.data(), -2, nullptr); }}});
  std::vector<hs_pose> moved = poses;
  moved[0].position[0] += 1;  // good, but must not be used, as the last is not
  moved[2].position[1] = nan;
  check_unchanged(s, "hs_world_set_poses",
                  {{"poses", "NULL", [&] { return hs_world_set_poses(w, nullptr, 3); }},
                   {"count", "2", [&] { return hs_world_set_poses(w, moved.data(), 2); }},
                   {"count", "-1", [&] { return hs_world_set_poses(w, moved.data(), -1); }},
                   {"poses[2]", "nan", [&] { return hs_world_set_poses(w, moved.data(), 3); }}});
  check_unchanged(
      s, "hs_world_get_velocities",
      {{"velocities.x", "NULL",
        [&] {
          return hs_world_get_velocities(w, {nullptr, v, nullptr, 8, 3}, no_room);
        }},
       {"velocities.count", "-1", [&] { return hs_world_get_velocities(w, out(v, -1), no_room); }},
       {"velocities.stride", "20", [&] { return hs_world_get_velocities(w, out(v, 3, 20), no_room); }},
       {"angular_velocities.z", "NULL",
        [&] {
          return hs_world_get_velocities(w, out(v, 3), {spin, spin, nullptr, 8, 3});
        }},
       {"angular_velocities.count", "-1",
        [&] { return hs_world_get_velocities(w, out(v, 3), out(spin, -1)); }}});
  check_unchanged(
      s, "hs_world_set_velocities",
      {{"velocities.count", "2", [&] { return hs_world_set_velocities(w, view(v, 2), none); }},
       {"velocities.stride", "1", [&] { return hs_world_set_velocities(w, view(v, 3, 1), none); }},
       {"velocities.y", "NULL",
        [&] {
          return hs_world_set_velocities(w, {v, nullptr, nullptr, 8, 3}, none);
        }},
       {"velocities[2]", "nan", [&] { return hs_world_set_velocities(w, view(v_nan, 3), none); }},
       {"angular_velocities.count", "1",
        [&] { return hs_world_set_velocities(w, view(v, 3), view(spin, 1)); }},
       {"angular_velocities[1]", "inf",
        [&] { return hs_world_set_velocities(w, view(v, 3), view(spin_inf, 3)); }}});
  check_unchanged(s, "hs_world_get_block_states",
                  {{"states", "NULL", [&] { return hs_world_get_block_states(w, nullptr, 3, nullptr); }},
                   {"capacity", "-1", [&] { return hs_world_get_block_states(w, states, -1, nullptr); }}});
  check_unchanged(
      s, "hs_world_set_applied_forces",
      {{"forces.count", "2", [&] { return hs_world_set_applied_forces(w, view(v, 2), none); }},
       {"forces.stride", "1", [&] { return hs_world_set_applied_forces(w, view(v, 3, 1), none); }},
       {"forces[2]", "nan", [&] { return hs_world_set_applied_forces(w, view(v_nan, 3), none); }},
       {"torques.count", "1", [&] { return hs_world_set_applied_forces(w, view(v, 3), view(spin, 1)); }},
       {"torques[1]", "inf", [&] { return hs_world_set_applied_forces(w, view(v, 3), view(spin_inf, 3)); }}});
  CHECK(hs_world_get_block_states(nullptr, states, 3, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_applied_forces(nullptr, view(v, 3), none) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_blocks(nullptr, ids, 3, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_poses(nullptr, poses.data(), 3, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_poses(nullptr, poses.data(), 3) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_velocities(nullptr, out(v, 3), no_room) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_velocities(nullptr, view(v, 3), none) == HS_ERROR_ARGUMENT);
}

TEST_CASE("stages, steps, reports and contacts refuse bad input") {
  TwoBoxes s;
  hs_world* w = s.world.get();
  double f[9];
  const hs_mutable_view forces{f, f + 1, f + 2, 24, 3};
  const hs_mutable_view none{};
  const auto evaluate = [&](double elapsed, hs_mutable_view v) {
    return [&, elapsed, v] { return hs_world_forces(w, elapsed, v, none); };
  };
  check_unchanged(s, "hs_world_forces", {{"hs_world_detect", "", evaluate(0, forces), HS_ERROR_STATE}});
  REQUIRE(hs_world_detect(w, nullptr) == HS_OK);
  hs_contact contact;
  check_unchanged(s, "hs_world_forces",
                  {{"elapsed", "-1", evaluate(-1, forces)},
                   {"elapsed", "nan", evaluate(nan, forces)},
                   {"elapsed", "inf", evaluate(inf, forces)},
                   {"forces.count", "-1", evaluate(0, {f, f + 1, nullptr, 24, -1})},
                   {"forces.x", "NULL", evaluate(0, {nullptr, f + 1, nullptr, 24, 3})},
                   {"forces.stride", "0", evaluate(0, {f, f + 1, nullptr, 0, 3})},
                   {"torques.z", "NULL", [&] {
                      return hs_world_forces(w, 0, forces, {f, f, nullptr, 8, 3});
                    }}});
  check_unchanged(s, "hs_world_step", {{"steps", "-1", [&] { return hs_world_step(w, -1); }}});
  check_unchanged(
      s, "hs_world_get_report",
      {{"report", "NULL", [&] { return hs_world_get_report(w, nullptr, sizeof(hs_world_report)); }}});
  hs_world_plan plan;
  check_unchanged(s, "hs_world_get_plan",
                  {{"steps", "-1", [&] { return hs_world_get_plan(w, -1, &plan, sizeof plan); }},
                   {"plan", "NULL", [&] { return hs_world_get_plan(w, 1, nullptr, sizeof plan); }}});
  check_unchanged(s, "hs_world_get_contacts",
                  {{"contacts", "NULL", [&] { return hs_world_get_contacts(w, nullptr, 1, nullptr); }},
                   {"capacity", "-1", [&] { return hs_world_get_contacts(w, &contact, -1, nullptr); }}});
  const auto id = [](hs_block block) {
    char text[32];
    std::snprintf(text, sizeof text, "%#llx", static_cast<unsigned long long>(block));
    return std::string(text);
  };
  check_unchanged(
      s, "hs_world_set_shear_force",
      {{"shear_force[1]", "nan",
        [&] { return hs_world_set_shear_force(w, s.floor, s.box_on_floor, not_a_number); }},
       {"shear_force[0]", "inf",
        [&] { return hs_world_set_shear_force(w, s.floor, s.box_on_floor, infinite); }},
       {"contact", id(s.box_away), [&] { return hs_world_set_shear_force(w, s.floor, s.box_away, zero); },
        HS_ERROR_STALE_ID},
       {"contact", id(s.floor), [&] { return hs_world_set_shear_force(w, s.floor, s.floor, zero); },
        HS_ERROR_STALE_ID}});
  hs_world_report report;
  CHECK(hs_world_detect(nullptr, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_forces(nullptr, 0, forces, none) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_step(nullptr, 1) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_report(nullptr, &report, sizeof report) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_plan(nullptr, 0, &plan, sizeof plan) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_contacts(nullptr, nullptr, 0, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_shear_force(nullptr, 1, 2, zero) == HS_ERROR_ARGUMENT);
}

TEST_CASE("a world that cannot derive a time step says so, and is none the worse") {
  const Context context = make_context();
  const World world = make_world(context.get(), world_def());
  CHECK(hs_world_step(world.get(), 0) == HS_OK);
  const hs_status status = hs_world_step(world.get(), 1);
  CHECK(status == HS_ERROR_STATE);
  CHECK(std::string(hs_context_last_error(context.get())).find("time step") != std::string::npos);
  CHECK(report_of(world.get()).steps == 0);
}

}  // namespace halfspace_test
