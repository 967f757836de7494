// halfspace/mesh.h: every argument of the functions of a body that can be wrong, that nothing has changed
// afterwards, and what the blocks of a mesh do not take.

#include <cstring>
#include <limits>

#include "capi/meshes.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
const double zero[3] = {0, 0, 0};

/// A bar over a fixed block, and one that has been removed.
struct Bars {
  explicit Bars(int dimension)
      : dimension(dimension), world(make_world(context.get(), world_def(dimension))) {
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 1000, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e8);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    gone = add_body(context.get(), world.get(), bar(dimension), body_def());
    body = add_body(context.get(), world.get(), bar(dimension), body_def());
    require_ok(hs_world_remove_body(world.get(), gone), context.get());
    const Shape shape = dimension == 2 ? make_shape(context.get(), box(-1, -2, 3, -1))
                                       : make_polyhedron(context.get(), box_3d({-1, -2, -1}, {3, -1, 3}));
    hs_block_def def;
    require_ok(hs_block_def_init(&def, sizeof def, shape.get()), context.get());
    def.kind = HS_BLOCK_FIXED;
    require_ok(hs_world_add_block(world.get(), shape.get(), &def, &fixed), context.get());
    hs_block all[64];
    std::int64_t count = 0;
    require_ok(hs_world_get_blocks(world.get(), all, 64, &count), context.get());
    for (std::int64_t i = 0; i < count; ++i)
      if (all[i] != fixed) blocks.push_back(all[i]);
    nodes = std::int64_t(bar(dimension).nodes.size());
  }

  int dimension;
  Context context = make_context();
  World world;
  hs_body body = 0, gone = 0;
  hs_block fixed = 0;
  std::vector<hs_block> blocks;  // of the body
  std::int64_t nodes = 0;
};

std::string hexadecimal(std::uint64_t id) {
  char text[32];
  std::snprintf(text, sizeof text, "%llx", static_cast<unsigned long long>(id));
  return text;
}

struct NamedGetter {
  const char* function;
  const char* argument;
  NodeGetter get;
};
constexpr NamedGetter node_getters[] = {
    {"hs_world_get_node_positions", "positions", hs_world_get_node_positions},
    {"hs_world_get_node_velocities", "velocities", hs_world_get_node_velocities},
    {"hs_world_get_node_forces", "forces", hs_world_get_node_forces}};

}  // namespace

TEST_CASE("functions that read a body refuse what is missing") {
  Bars s(2);
  hs_world* w = s.world.get();
  const hs_body b = s.body;
  hs_body_state state;
  hs_cell_state cells[3];
  check_unchanged(s, "hs_world_get_body_state",
                  {{"state", "NULL", [&] { return hs_world_get_body_state(w, b, nullptr, sizeof state); }}});
  check_unchanged(s, "hs_world_get_cells",
                  {{"cells", "NULL", [&] { return hs_world_get_cells(w, b, nullptr, 3, nullptr); }},
                   {"capacity", "-1", [&] { return hs_world_get_cells(w, b, cells, -1, nullptr); }}});
  check_unchanged(
      s, "hs_world_get_body_of_block",
      {{"body", "NULL", [&] { return hs_world_get_body_of_block(w, s.fixed, nullptr, nullptr); }}});
  double v[3];
  for (const auto& [function, argument, get] : node_getters) {
    const std::string name = argument;
    const auto with = [&, get = get](hs_mutable_view view) {
      return [&, get, view] { return get(w, b, view, nullptr); };
    };
    check_unchanged(s, function,
                    {{name + ".count", "-1", with({v, v, nullptr, 8, -1})},
                     {name + ".x", "NULL", with({nullptr, v, nullptr, 8, 1})},
                     {name + ".y", "NULL", with({v, nullptr, nullptr, 8, 1})},
                     {name + ".stride", "9", with({v, v, nullptr, 9, 1})},
                     {name + ".stride", "0", with({v, v, nullptr, 0, 2})}});
    CHECK(get(nullptr, b, {}, nullptr) == HS_ERROR_ARGUMENT);
  }
  CHECK(hs_world_get_body_state(nullptr, b, &state, sizeof state) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_cells(nullptr, b, cells, 3, nullptr) == HS_ERROR_ARGUMENT);
  hs_body body = 0;
  CHECK(hs_world_get_body_of_block(nullptr, s.fixed, &body, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_remove_body(nullptr, b) == HS_ERROR_ARGUMENT);

  Bars solid(3);
  for (const auto& [function, argument, get] : node_getters) {
    check_unchanged(solid, function,
                    {{std::string(argument) + ".z", "NULL", [&, get = get] {
                        return get(solid.world.get(), solid.body, {v, v, nullptr, 8, 1}, nullptr);
                      }}});
  }
}

TEST_CASE("functions that move a body's nodes refuse bad numbers and nodes that it has not") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    Bars s(dimension);
    hs_world* w = s.world.get();
    const hs_body b = s.body;
    Points3 velocities(std::size_t(s.nodes), {1, 0, 0});
    const hs_view good = view_of(velocities);
    const std::string last = std::to_string(s.nodes - 1);
    const auto set = [&](hs_view view) {
      return [&, view] { return hs_world_set_node_velocities(w, b, view); };
    };
    check_unchanged(s, "hs_world_set_node_velocities",
                    {{"velocities.count", "5", set({good.x, good.y, good.z, good.stride, 5})},
                     {"velocities.count", "0", set({})},
                     {"velocities.count", "-1", set({good.x, good.y, good.z, good.stride, -1})},
                     {"velocities.x", "NULL", set({nullptr, good.y, good.z, good.stride, good.count})},
                     {"velocities.stride", "12", set({good.x, good.y, good.z, 12, good.count})}});
    for (const double bad : {nan, inf, 1e76}) {
      velocities.back().y = bad;
      check_unchanged(s, "hs_world_set_node_velocities",
                      {{"velocities[" + last + "]",
                        bad == 1e76  ? "e+7"
                        : bad == inf ? "inf"
                                     : "nan",
                        set(good)}});
    }

    const std::int32_t nodes[] = {0, 1}, negative[] = {0, -1}, beyond[] = {std::int32_t(s.nodes), 0};
    const double not_a_number[3] = {0, nan, 0}, infinite[3] = {-inf, 0, 0}, large[3] = {0, 1e76, 0};
    const auto hold = [&](const std::int32_t* named, std::int64_t count, std::int32_t axes,
                          const double* velocity) {
      return [=] { return hs_world_hold_nodes(w, b, named, count, axes, velocity); };
    };
    const std::int32_t all_axes = dimension == 2 ? 3 : 7;
    check_unchanged(s, "hs_world_hold_nodes",
                    {{"nodes", "NULL", hold(nullptr, 2, 1, zero)},
                     {"count", "-1", hold(nodes, -1, 1, zero)},
                     {"nodes[1]", "-1", hold(negative, 2, 1, zero)},
                     {"nodes[0]", std::to_string(s.nodes), hold(beyond, 2, 1, zero)},
                     {"axes", "-1", hold(nodes, 2, -1, zero)},
                     {"axes", std::to_string(all_axes + 1), hold(nodes, 2, all_axes + 1, zero)},
                     {"velocity", "NULL", hold(nodes, 2, HS_AXIS_X, nullptr)},
                     {"velocity[1]", "nan", hold(nodes, 2, HS_AXIS_Y, not_a_number)},
                     {"velocity[0]", "-inf", hold(nodes, 2, HS_AXIS_X, infinite)},
                     {"velocity[1]", "1e+76", hold(nodes, 2, all_axes, large)}});
    const auto push = [&](const std::int32_t* named, std::int64_t count, const double* force) {
      return [=] { return hs_world_set_node_force(w, b, named, count, force); };
    };
    check_unchanged(s, "hs_world_set_node_force",
                    {{"nodes", "NULL", push(nullptr, 2, zero)},
                     {"count", "-7", push(nodes, -7, zero)},
                     {"nodes[1]", "-1", push(negative, 2, zero)},
                     {"nodes[0]", std::to_string(s.nodes), push(beyond, 2, zero)},
                     {"force", "NULL", push(nodes, 2, nullptr)},
                     {"force[1]", "nan", push(nodes, 2, not_a_number)},
                     {"force[0]", "-inf", push(nodes, 2, infinite)},
                     {"force[1]", "1e+76", push(nodes, 2, large)}});
    std::vector<std::int32_t> every_cell;
    hs_body_state state;
    require_ok(hs_world_get_body_state(w, b, &state, sizeof state), s.context.get());
    for (std::int32_t i = 0; i < state.cell_count; ++i) every_cell.push_back(i);
    const std::int32_t no_cell[] = {0, -1}, past[] = {std::int32_t(state.cell_count), 0};
    const auto cut = [&](const std::int32_t* named, std::int64_t count) {
      return [=] { return hs_world_remove_cells(w, b, named, count, {}); };
    };
    check_unchanged(s, "hs_world_remove_cells",
                    {{"cells", "NULL", cut(nullptr, 2)},
                     {"count", "-3", cut(every_cell.data(), -3)},
                     {"cells[1]", "-1", cut(no_cell, 2)},
                     {"cells[0]", std::to_string(state.cell_count), cut(past, 2)},
                     {"cells", "all", cut(every_cell.data(), state.cell_count), HS_ERROR_STATE}});
    const double lopsided[9] = {0, 1, 0, 2, 0, 0, 0, 0, 0}, no_stress[9] = {0, 0, 0, 0, nan};
    const double huge[9] = {1e70, 0, 0, 0, 1e70}, calm[9] = {};
    double steep[27] = {};
    steep[9 + 1] = 5;
    const auto stress_by = [&](const double* stress, const double* gradient) {
      return [=] { return hs_world_set_body_stress(w, b, stress, gradient); };
    };
    check_unchanged(s, "hs_world_set_body_stress",
                    {{"stress", "NULL", stress_by(nullptr, nullptr)},
                     {"stress[1]", "1", stress_by(lopsided, nullptr)},
                     {"stress[4]", "nan", stress_by(no_stress, nullptr)},
                     {"gradient[10]", "5", stress_by(calm, steep)},
                     {"stress", "1e+06", stress_by(huge, nullptr)}});
    CHECK(hs_world_remove_cells(nullptr, b, nodes, 1, {}) == HS_ERROR_ARGUMENT);
    CHECK(hs_world_set_body_stress(nullptr, b, huge, nullptr) == HS_ERROR_ARGUMENT);
    CHECK(hs_world_set_node_velocities(nullptr, b, good) == HS_ERROR_ARGUMENT);
    CHECK(hs_world_hold_nodes(nullptr, b, nodes, 2, 1, zero) == HS_ERROR_ARGUMENT);
    CHECK(hs_world_set_node_force(nullptr, b, nodes, 2, zero) == HS_ERROR_ARGUMENT);
  }
}

TEST_CASE("components along axes that are not held are not read") {
  Bars s(2);
  const std::int32_t node = 0;
  const double along_x[3] = {2, nan, inf}, along_y[3] = {nan, 3, nan};
  CHECK(hs_world_hold_nodes(s.world.get(), s.body, &node, 1, HS_AXIS_X, along_x) == HS_OK);
  CHECK(hs_world_hold_nodes(s.world.get(), s.body, &node, 1, HS_AXIS_Y, along_y) == HS_OK);
  CHECK(hs_world_hold_nodes(s.world.get(), s.body, &node, 1, 0, nullptr) == HS_OK);
  CHECK(hs_world_hold_nodes(s.world.get(), s.body, nullptr, 0, HS_AXIS_X, zero) == HS_OK);
  const Point3 velocity = of_nodes(hs_world_get_node_velocities, s.world.get(), s.body)[0];
  CHECK(velocity.x == 2);
  CHECK(velocity.y == 3);
}

TEST_CASE("a stale or invented body is refused by every function that takes one") {
  Bars s(2);
  hs_world* w = s.world.get();
  Points3 velocities(6);
  hs_body_state state;
  hs_cell_state cell;
  const std::int32_t node = 0;
  const hs_body later = s.body + (hs_body(1) << 32);
  for (const hs_body bad : {hs_body(0), s.gone, later, hs_body(99), hs_body(~0ull)}) {
    const auto stale = [&](const char* function, std::function<hs_status()> call) {
      check_unchanged(s, function, {{"body", hexadecimal(bad), call, HS_ERROR_STALE_ID}});
    };
    stale("hs_world_remove_body", [&] { return hs_world_remove_body(w, bad); });
    stale("hs_world_get_body_state", [&] { return hs_world_get_body_state(w, bad, &state, sizeof state); });
    for (const auto& [function, argument, get] : node_getters)
      stale(function, [&, get = get] { return get(w, bad, {}, nullptr); });
    stale("hs_world_set_node_velocities",
          [&] { return hs_world_set_node_velocities(w, bad, view_of(velocities)); });
    stale("hs_world_hold_nodes", [&] { return hs_world_hold_nodes(w, bad, &node, 1, 1, zero); });
    stale("hs_world_remove_cells", [&] { return hs_world_remove_cells(w, bad, &node, 1, {}); });
    stale("hs_world_set_body_stress", [&] { return hs_world_set_body_stress(w, bad, zero, nullptr); });
    stale("hs_world_set_node_force", [&] { return hs_world_set_node_force(w, bad, &node, 1, zero); });
    stale("hs_world_get_cells", [&] { return hs_world_get_cells(w, bad, &cell, 1, nullptr); });
  }
  CHECK(hs_world_get_body_state(w, s.body, &state, sizeof state) == HS_OK);
  hs_body body = 7;
  check_unchanged(s, "hs_world_get_body_of_block",
                  {{"block", "0x7b", [&] { return hs_world_get_body_of_block(w, 0x7b, &body, nullptr); },
                    HS_ERROR_STALE_ID}});
  CHECK(body == 7);
}

TEST_CASE("the blocks of a mesh stand in all lists, and take nothing that their nodes do") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    Bars s(dimension);
    hs_world* w = s.world.get();
    const hs_pose pose = pose_at(7, 7);
    const double one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    REQUIRE(s.blocks.size() == (dimension == 2 ? 4 : 10));
    for (const hs_block block : s.blocks) {
      CHECK(state_of(w, block).kind == HS_BLOCK_MESH);
      const auto refuse = [&](const char* function, const char* why, std::function<hs_status()> call) {
        check_unchanged(s, function, {{hexadecimal(block), why, call, HS_ERROR_STATE}});
      };
      refuse("hs_world_set_pose", "of a mesh", [&] { return hs_world_set_pose(w, block, &pose); });
      refuse("hs_world_set_velocity", "of a mesh",
             [&] { return hs_world_set_velocity(w, block, zero, zero); });
      refuse("hs_world_set_applied_force", "of a mesh",
             [&] { return hs_world_set_applied_force(w, block, zero, zero); });
      refuse("hs_world_remove_block", "of a mesh", [&] { return hs_world_remove_block(w, block); });
      refuse("hs_world_set_deformation", "not affine",
             [&] { return hs_world_set_deformation(w, block, one, zero); });
      refuse("hs_world_set_stress", "not affine", [&] { return hs_world_set_stress(w, block, one); });
      refuse("hs_world_add_surface_load", "not affine",
             [&] { return hs_world_add_surface_load(w, block, 0, zero); });
      refuse("hs_world_clear_surface_loads", "not affine",
             [&] { return hs_world_clear_surface_loads(w, block); });
    }
    hs_block_def def;
    const Shape shape = dimension == 2 ? make_shape(s.context.get(), box(0, 0, 1, 1))
                                       : make_polyhedron(s.context.get(), cube());
    REQUIRE(hs_block_def_init(&def, sizeof def, shape.get()) == HS_OK);
    def.kind = HS_BLOCK_MESH;
    hs_block made = 7;
    check_unchanged(s, "hs_world_add_block",
                    {{"def.kind", "4", [&] { return hs_world_add_block(w, shape.get(), &def, &made); }}});
    CHECK(made == 7);
  }
}

TEST_CASE("bulk calls on blocks leave those of a mesh where their nodes are") {
  Bars s(2);
  hs_world* w = s.world.get();
  const Points3 before = of_nodes(hs_world_get_node_positions, w, s.body);
  std::vector<hs_pose> poses = poses_of(w);
  for (hs_pose& pose : poses) pose.position[0] += 5;
  REQUIRE(hs_world_set_poses(w, poses.data(), std::int64_t(poses.size())) == HS_OK);
  const Points3 velocities(poses.size(), {3, 0, 0});
  REQUIRE(hs_world_set_velocities(w, view_of(velocities), {}) == HS_OK);
  for (const hs_block block : s.blocks) {
    CHECK(state_of(w, block).pose.position[0] < 3);
    CHECK(state_of(w, block).velocity[0] == 0);
  }
  CHECK(state_of(w, s.fixed).pose.position[0] == 6);
  const Points3 after = of_nodes(hs_world_get_node_positions, w, s.body);
  CHECK(std::memcmp(before.data(), after.data(), before.size() * sizeof(Point3)) == 0);
}

}  // namespace halfspace_test
