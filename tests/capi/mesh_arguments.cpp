// halfspace/mesh.h: what hs_mesh_create(), hs_mesh_get_properties() and hs_world_add_mesh() refuse, and that
// nothing has changed afterwards.

#include <cmath>
#include <cstring>
#include <limits>

#include "capi/meshes.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

hs_mesh* const no_mesh = reinterpret_cast<hs_mesh*>(0x10);

/// Checks that a bar which has been spoiled is refused.
template <class Spoil>
void check_refused(int dimension, hs_status status, const std::string& what, const std::string& value,
                   Spoil spoil) {
  const Context context = make_context();
  MeshWords words = bar(dimension);
  spoil(words);
  hs_mesh* mesh = no_mesh;
  check_refusals(context.get(), "hs_mesh_create",
                 {{what, value, [&] { return create_mesh(context.get(), words, &mesh); }, status}});
  CHECK(mesh == no_mesh);
}

/// A world with an elastic material, 0, and one that is not, 1; and a bar for it.
struct Elastic {
  explicit Elastic(int dimension) : world(make_world(context.get(), world_def(dimension))) {
    std::int32_t material = -1;
    for (const double density : {1000.0, 2000.0})
      require_ok(hs_world_add_material(world.get(), density, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e8);
    require_ok(hs_world_set_elasticity(world.get(), 0, &elasticity), context.get());
    mesh = make_mesh(context.get(), bar(dimension));
  }

  hs_status add(const hs_body_def& def, const std::int32_t* materials = nullptr) {
    return hs_world_add_mesh(world.get(), mesh.get(), &def, materials, &body);
  }

  Context context = make_context();
  World world;
  Mesh mesh;
  hs_body body = 77;
};

}  // namespace

TEST_CASE("hs_mesh_create refuses what is missing or out of range") {
  const Context context = make_context();
  hs_context* c = context.get();
  const MeshWords words = bar(2);
  hs_mesh* mesh = no_mesh;
  const hs_view nodes = view_of(words.nodes);
  const std::int32_t *kinds = words.kinds.data(), *named = words.cell_nodes.data();
  const auto with_nodes = [&](hs_view view) {
    return [&, view] { return hs_mesh_create(c, 2, view, kinds, 3, named, 10, &mesh); };
  };
  const auto of_dimension = [&](std::int32_t dimension) {
    return [&, dimension] { return hs_mesh_create(c, dimension, nodes, kinds, 3, named, 10, &mesh); };
  };
  const auto with_counts = [&](std::int64_t cells, std::int64_t nodes_of_cells) {
    return [&, cells, nodes_of_cells] {
      return hs_mesh_create(c, 2, nodes, kinds, cells, named, nodes_of_cells, &mesh);
    };
  };
  const double *x = nodes.x, *y = nodes.y;
  constexpr std::int64_t too_many = (std::int64_t(1) << 28) + 1;
  check_refusals(
      c, "hs_mesh_create",
      {{"dimension", "4", of_dimension(4)},
       {"dimension", "-1", of_dimension(-1)},
       {"nodes.count", "-1", with_nodes({x, y, nullptr, 24, -1})},
       {"nodes.count", "268435457", with_nodes({x, y, nullptr, 24, too_many})},
       {"nodes.x", "NULL", with_nodes({nullptr, y, nullptr, 24, 6})},
       {"nodes.y", "NULL", with_nodes({x, nullptr, nullptr, 24, 6})},
       {"nodes.stride", "9", with_nodes({x, y, nullptr, 9, 6})},
       {"nodes.count", "0", with_nodes({})},
       {"cell_count", "-1", with_counts(-1, 10)},
       {"cell_count", "268435457", with_counts(too_many, 10)},
       {"cell_count", "0", with_counts(0, 0)},
       {"cell_node_count", "-2", with_counts(3, -2)},
       {"cell_node_count", "268435457", with_counts(3, too_many)},
       {"cell_node_count", "0", with_counts(3, 0)},
       {"cell_node_count", "9", with_counts(3, 9)},
       {"cell_node_count", "10", with_counts(2, 10)},
       {"cell_kinds", "NULL", [&] { return hs_mesh_create(c, 2, nodes, nullptr, 3, named, 10, &mesh); }},
       {"cell_nodes", "NULL", [&] { return hs_mesh_create(c, 2, nodes, kinds, 3, nullptr, 10, &mesh); }},
       {"mesh", "NULL", [&] { return hs_mesh_create(c, 2, nodes, kinds, 3, named, 10, nullptr); }}});
  CHECK(hs_mesh_create(nullptr, 2, nodes, kinds, 3, named, 10, &mesh) == HS_ERROR_ARGUMENT);
  CHECK(mesh == no_mesh);
  hs_mesh_destroy(nullptr);

  const MeshWords solid = bar(3);
  hs_view flat = view_of(solid.nodes);
  flat.z = nullptr;
  check_refusals(c, "hs_mesh_create", {{"nodes.z", "NULL", [&] {
                                          return hs_mesh_create(c, 3, flat, solid.kinds.data(), 4,
                                                                solid.cell_nodes.data(), 24, &mesh);
                                        }}});
}

TEST_CASE("cells that are no mesh are refused, by their number and what is wrong with them") {
  using M = MeshWords&;
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    const auto argument = [&](const char* what, const char* value, auto spoil) {
      check_refused(dimension, HS_ERROR_ARGUMENT, what, value, spoil);
    };
    const auto geometry = [&](const char* what, const char* value, auto spoil) {
      check_refused(dimension, HS_ERROR_GEOMETRY, what, value, spoil);
    };
    argument("cell_kinds[1]", "5", [](M m) { m.kinds[1] = 5; });
    argument("cell_kinds[0]", "-1", [](M m) { m.kinds[0] = -1; });
    argument("cell_kinds[2]", dimension == 2 ? "3" : "1",  // of the other dimension
             [&](M m) { m.kinds[2] = dimension == 2 ? HS_CELL_PRISM : HS_CELL_QUAD; });
    argument("cell 0", "node -1", [](M m) { m.cell_nodes[3] = -1; });
    argument("cell 1", "node 13", [](M m) { m.cell_nodes[m.dimension == 2 ? 5 : 9] = 13; });
    argument("nodes[5]", "nan", [](M m) { m.nodes[5].y = nan; });
    argument("nodes[0]", "inf", [](M m) { m.nodes[0].x = -inf; });
    argument("nodes[2]", "1e+76", [](M m) { m.nodes[2].x = 1e76; });
    geometry("cell 0", "node 0 twice", [](M m) { m.cell_nodes[1] = 0; });
    geometry("nodes", "belongs to no cell", [](M m) { m.nodes.push_back({7, 7, 7}); });
    geometry("cell 0", "inside out or flat", [](M m) { std::swap(m.cell_nodes[0], m.cell_nodes[1]); });
    geometry("cell 0", "inside out or flat", [](M m) { m.nodes[0] = m.nodes[1]; });
    geometry("cell 1", "inside out or flat", [](M m) { m.nodes[2].x = m.nodes[5].x = 1; });
  }
  // A quad that is not convex, and one whose corner is straight.
  for (const double x : {0.4, 0.5})
    check_refused(2, HS_ERROR_GEOMETRY, "cell 0", "inside out or flat", [&](M m) { m.nodes[4] = {x, x, 0}; });
  // A hexahedron that is twisted at one corner.
  check_refused(3, HS_ERROR_GEOMETRY, "cell 0", "inside out or flat", [](M m) { m.nodes[6].z = -0.1; });
  // Three cells at an edge, in space at a face.
  check_refused(2, HS_ERROR_GEOMETRY, "cell 3", "two other cells", [](M m) {
    m.nodes.push_back({0.5, 0.4, 0});
    m.add_cell(HS_CELL_TRIANGLE, {1, 4, 6});
  });
  check_refused(3, HS_ERROR_GEOMETRY, "cell 4", "two other cells", [](M m) {
    m.nodes.push_back({1.4, 0.7, 0.4});
    m.add_cell(HS_CELL_TETRAHEDRON, {7, 10, 11, 13});
  });
}

TEST_CASE("hs_mesh_get_properties refuses what is missing") {
  const Context context = make_context();
  const Mesh mesh = make_mesh(context.get(), bar(2));
  hs_mesh_properties properties;
  check_refusals(context.get(), "hs_mesh_get_properties",
                 {{"properties", "NULL",
                   [&] { return hs_mesh_get_properties(mesh.get(), nullptr, sizeof properties); }}});
  CHECK(hs_mesh_get_properties(nullptr, &properties, sizeof properties) == HS_ERROR_ARGUMENT);
}

TEST_CASE("hs_world_add_mesh refuses every bad definition") {
  using D = hs_body_def;
  const std::vector<Spoiled<D>> spoiled = {
      {"struct_size", "0", [](D& d) { d.struct_size = 0; }},
      {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
      {"def.material", "-1", [](D& d) { d.material = -1; }, HS_ERROR_STALE_ID},
      {"def.material", "2", [](D& d) { d.material = 2; }, HS_ERROR_STALE_ID},
      {"material of cell 0", "1", [](D& d) { d.material = 1; }, HS_ERROR_STATE},
      {"def.pose->position[0]", "nan", [](D& d) { d.pose.position[0] = nan; }},
      {"def.pose->position[1]", "inf", [](D& d) { d.pose.position[1] = inf; }},
      {"def.pose->rotation", "2", [](D& d) { d.pose.rotation[3] = 2; }},
      {"def.pose", "100000000000.5", [](D& d) { d.pose.position[1] = 1e11; }},
      {"def.velocity[0]", "nan", [](D& d) { d.velocity[0] = nan; }},
      {"def.velocity[1]", "inf", [](D& d) { d.velocity[1] = inf; }},
      {"def.velocity[1]", "1e+76", [](D& d) { d.velocity[1] = 1e76; }}};
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    Elastic s(dimension);
    for (const auto& bad : spoiled) {
      hs_body_def def = body_def();
      bad.spoil(def);
      check_unchanged(s, "hs_world_add_mesh",
                      {{bad.member, bad.value, [&] { return s.add(def); }, bad.status}});
    }
    CHECK(s.body == 77);
  }
}

TEST_CASE("hs_world_add_mesh refuses what is missing or of another kind") {
  Elastic s(2), other(3);
  hs_world* w = s.world.get();
  const hs_body_def def = body_def();
  const auto add = [&](const hs_mesh* mesh, const hs_body_def* with, hs_body* body) {
    return [=] { return hs_world_add_mesh(w, mesh, with, nullptr, body); };
  };
  const auto of = [&](const std::int32_t* materials) {
    return [&, materials] { return s.add(def, materials); };
  };
  const std::int32_t unknown[] = {0, 0, 2}, negative[] = {0, -1, 0}, rigid[] = {0, 0, 1};
  check_unchanged(s, "hs_world_add_mesh",
                  {{"mesh", "NULL", add(nullptr, &def, &s.body)},
                   {"def", "NULL", add(s.mesh.get(), nullptr, &s.body)},
                   {"body", "NULL", add(s.mesh.get(), &def, nullptr)},
                   {"mesh", "3", add(other.mesh.get(), &def, &s.body)},
                   {"cell_materials[2]", "2", of(unknown), HS_ERROR_STALE_ID},
                   {"cell_materials[1]", "-1", of(negative), HS_ERROR_STALE_ID},
                   {"material of cell 2", "1", of(rigid), HS_ERROR_STATE}});
  CHECK(hs_world_add_mesh(nullptr, s.mesh.get(), &def, nullptr, &s.body) == HS_ERROR_ARGUMENT);
  CHECK(s.body == 77);
}

TEST_CASE("a cell that is too flat to touch anything where it is turned to is refused") {
  // The least triangle that is upright as it is given: turned, rounding makes it flat.
  Elastic s(2);
  MeshWords words;
  words.nodes = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-16, 0}};
  words.add_cell(HS_CELL_TRIANGLE, {0, 1, 2});
  s.mesh = make_mesh(s.context.get(), words);
  int refused = 0;
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.05 * i;
    const hs_status status = s.add(body_def(pose_at(0, 0, std::sin(angle), std::cos(angle))));
    CHECK((status == HS_OK || status == HS_ERROR_GEOMETRY));
    refused += status == HS_ERROR_GEOMETRY;
    CHECK_NOTHROW(restored(s.context.get(), saved(s.world.get())));
  }
  CHECK(refused > 0);
  CHECK(std::string(hs_context_last_error(s.context.get())).find("cell 0") != std::string::npos);
}

}  // namespace halfspace_test
