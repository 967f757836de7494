// halfspace/mesh.h: what a mesh and a body of it say of themselves, and how bodies come and go.

#include <cmath>
#include <cstring>
#include <limits>

#include "capi/meshes.h"
#include "catch.h"

namespace halfspace_test {
namespace {

struct ElasticWorld {
  explicit ElasticWorld(int dimension) : world(make_world(context.get(), world_def(dimension))) {
    for (const double density : {1000.0, 3000.0}) {
      std::int32_t material = -1;
      require_ok(hs_world_add_material(world.get(), density, &material), context.get());
      const hs_elasticity_def elasticity = elasticity_def(1e8);
      require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    }
  }
  hs_body add(const MeshWords& words, const hs_body_def& def) {
    return add_body(context.get(), world.get(), words, def);
  }
  std::vector<hs_block> blocks() const {
    std::int64_t count = 0;
    (void)hs_world_get_blocks(world.get(), nullptr, 0, &count);
    std::vector<hs_block> blocks(std::size_t(count), 0);
    require_ok(hs_world_get_blocks(world.get(), blocks.data(), count, nullptr), context.get());
    return blocks;
  }

  Context context = make_context();
  World world;
};

bool same(const Points3& a, const Points3& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point3)) == 0;
}

constexpr NodeGetter node_getters[] = {hs_world_get_node_positions, hs_world_get_node_velocities,
                                       hs_world_get_node_forces};

}  // namespace

TEST_CASE("a mesh says what it is") {
  const Context context = make_context();
  const auto properties_of = [&](int dimension) {
    hs_mesh_properties properties{};
    const Mesh mesh = make_mesh(context.get(), bar(dimension));
    require_ok(hs_mesh_get_properties(mesh.get(), &properties, sizeof properties), context.get());
    return properties;
  };
  const hs_mesh_properties flat = properties_of(2);
  CHECK(flat.dimension == 2);
  CHECK(flat.node_count == 6);
  CHECK(flat.cell_count == 3);
  CHECK(flat.surface_face_count == 6);
  CHECK(flat.volume == Approx(2));
  const hs_mesh_properties solid = properties_of(3);
  CHECK(solid.dimension == 3);
  CHECK(solid.node_count == 13);
  CHECK(solid.cell_count == 4);
  // Cube 5, prisms 2 bottoms, 1 top and 1 + 2 sides, tetrahedron 3.
  CHECK(solid.surface_face_count == 14);
  CHECK(solid.volume == Approx(2 + 0.5 * 0.6 / 3));
}

TEST_CASE("in 2D the third coordinate of nodes is not read") {
  ElasticWorld s(2);
  MeshWords words = bar(2);
  for (Point3& node : words.nodes) node.z = std::numeric_limits<double>::quiet_NaN();
  const hs_body body = s.add(words, body_def());
  for (const Point3& node : of_nodes(hs_world_get_node_positions, s.world.get(), body)) CHECK(node.z == 0);
}

TEST_CASE("a body has the mesh's nodes in its order, the pose and velocity given, and outlives the mesh") {
  for (const int dimension : {2, 3}) {
    ElasticWorld s(dimension);
    const MeshWords words = bar(dimension);
    hs_body_def def = body_def(pose_at({3, -1, dimension == 2 ? 0.0 : 2.0}, {0, 0, 1}, 0.7));
    def.velocity[0] = 4;
    def.velocity[1] = -5;
    const hs_body body = s.add(words, def);
    const Points3 places = of_nodes(hs_world_get_node_positions, s.world.get(), body);
    const Points3 velocities = of_nodes(hs_world_get_node_velocities, s.world.get(), body);
    REQUIRE(places.size() == words.nodes.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Point3& p = words.nodes[i];
      CHECK(places[i].x == Approx(3 + std::cos(0.7) * p.x - std::sin(0.7) * p.y).margin(1e-14));
      CHECK(places[i].y == Approx(-1 + std::sin(0.7) * p.x + std::cos(0.7) * p.y).margin(1e-14));
      CHECK(places[i].z == Approx(dimension == 2 ? 0 : 2 + p.z));
      CHECK(velocities[i].x == 4);
      CHECK(velocities[i].y == -5);
      CHECK(velocities[i].z == 0);
    }
    const hs_body_state state = state_of_body(s.world.get(), body);
    const double mass = 1000 * (dimension == 2 ? 2 : 2.1);
    CHECK(state.node_count == std::int64_t(places.size()));
    CHECK(state.cell_count == std::int64_t(words.kinds.size()));
    CHECK(state.mass == Approx(mass));
    CHECK(state.momentum[0] == Approx(4 * mass));
    CHECK(state.momentum[1] == Approx(-5 * mass));
    CHECK(state.kinetic_energy == Approx(0.5 * 41 * mass));
    CHECK(state.strain_energy == Approx(0).margin(1e-12));
    double of_blocks = 0;
    for (const hs_block block : s.blocks()) {
      of_blocks += state_of(s.world.get(), block).mass;
      CHECK(state_of(s.world.get(), block).velocity[0] == Approx(4));
    }
    CHECK(of_blocks == Approx(mass));
    std::vector<hs_cell_state> cells(words.kinds.size());
    REQUIRE(hs_world_get_cells(s.world.get(), body, cells.data(), std::int64_t(cells.size()), nullptr) ==
            HS_OK);
    for (const hs_cell_state& cell : cells)
      for (const double strain : cell.strain) CHECK(strain == Approx(0).margin(1e-15));
  }
}

TEST_CASE("cells may be of different materials") {
  ElasticWorld s(2);
  const Mesh mesh = make_mesh(s.context.get(), bar(2));
  const hs_body_def def = body_def();
  const std::int32_t materials[] = {1, 0, 1};
  hs_body body = 0;
  REQUIRE(hs_world_add_mesh(s.world.get(), mesh.get(), &def, materials, &body) == HS_OK);
  CHECK(state_of_body(s.world.get(), body).mass == Approx(3000 + 500 + 1500));
  for (const hs_block block : s.blocks()) {
    hs_body of = 0;
    std::int32_t cell = -1;
    REQUIRE(hs_world_get_body_of_block(s.world.get(), block, &of, &cell) == HS_OK);
    CHECK(of == body);
    REQUIRE(cell >= 0);
    REQUIRE(cell < 3);
    CHECK(state_of(s.world.get(), block).material == materials[cell]);
  }
  const hs_block rigid = add_block(s.context.get(), s.world.get(), box(9, 9, 10, 10), HS_BLOCK_RIGID);
  std::int32_t cell = 7;
  REQUIRE(hs_world_get_body_of_block(s.world.get(), rigid, &body, &cell) == HS_OK);
  CHECK(body == 0);
  CHECK(cell == -1);
  CHECK(hs_world_get_body_of_block(s.world.get(), rigid, &body, nullptr) == HS_OK);
}

TEST_CASE("lists of nodes and cells say when there is too little room, and write no more than fits") {
  ElasticWorld s(3);
  const hs_body body = s.add(bar(3), body_def());
  hs_world* w = s.world.get();
  for (const auto get : node_getters) {
    const Points3 all = of_nodes(get, w, body);
    Points3 few(6, {-7, -7, -7});
    const hs_mutable_view room{&few[0].x, &few[0].y, &few[0].z, sizeof(Point3), 5};
    std::int64_t count = -1;
    CHECK(get(w, body, room, &count) == HS_NOTE_TRUNCATED);
    CHECK(count == 13);
    CHECK(std::memcmp(few.data(), all.data(), 5 * sizeof(Point3)) == 0);
    CHECK(few[5].x == -7);
    CHECK(get(w, body, {}, nullptr) == HS_NOTE_TRUNCATED);
    Points3 more(20);
    CHECK(get(w, body, mutable_view_of(more), nullptr) == HS_OK);
  }
  hs_cell_state cells[4];
  std::memset(static_cast<void*>(cells), 0xee, sizeof cells);
  const hs_cell_state untouched = cells[2];
  std::int64_t count = -1;
  CHECK(hs_world_get_cells(w, body, nullptr, 0, &count) == HS_NOTE_TRUNCATED);
  CHECK(count == 4);
  CHECK(hs_world_get_cells(w, body, cells, 2, nullptr) == HS_NOTE_TRUNCATED);
  CHECK(std::memcmp(&cells[2], &untouched, sizeof untouched) == 0);
  CHECK(hs_world_get_cells(w, body, cells, 4, &count) == HS_OK);
}

TEST_CASE("nodes that are held keep their velocity along the axes held, and go free again") {
  ElasticWorld s(2);
  hs_world* w = s.world.get();
  const hs_body body = s.add(bar(2), body_def());
  const std::int32_t left[] = {0, 3};
  const double up[3] = {0, 0.5, 0};
  REQUIRE(hs_world_hold_nodes(w, body, left, 2, HS_AXIS_Y, up) == HS_OK);
  REQUIRE(hs_world_step(w, 10) == HS_OK);
  Points3 velocities = of_nodes(hs_world_get_node_velocities, w, body);
  CHECK(velocities[0].y == 0.5);
  CHECK(velocities[3].y == 0.5);
  CHECK(velocities[1].y < 0.5);
  const double time = report_of(w).time;
  CHECK(of_nodes(hs_world_get_node_positions, w, body)[3].y == Approx(1 + 0.5 * time).epsilon(1e-12));
  // Held along x as well, they go on along y, until they are let go.
  REQUIRE(hs_world_hold_nodes(w, body, left, 2, HS_AXIS_X, up) == HS_OK);
  REQUIRE(hs_world_step(w, 10) == HS_OK);
  velocities = of_nodes(hs_world_get_node_velocities, w, body);
  CHECK(velocities[0].x == 0);
  CHECK(velocities[0].y == 0.5);
  REQUIRE(hs_world_hold_nodes(w, body, left, 2, 0, nullptr) == HS_OK);
  REQUIRE(hs_world_step(w, 10) == HS_OK);
  velocities = of_nodes(hs_world_get_node_velocities, w, body);
  CHECK(velocities[0].y != 0.5);
}

TEST_CASE("a body that has come and gone leaves no trace in the others") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    const hs_body_def def = body_def(pose_at({0, 0, 0}, {0, 0, 1}, 0.3)), aside = body_def(pose_at(0, 9));
    ElasticWorld alone(dimension), before(dimension), after(dimension);
    const hs_body body = alone.add(bar(dimension), def);
    const hs_body first = before.add(bar(dimension), aside);
    const hs_body second = before.add(bar(dimension), def);
    CHECK(first == body);
    CHECK(second != first);
    require_ok(hs_world_remove_body(before.world.get(), first), before.context.get());
    after.add(bar(dimension), def);
    const hs_body last = after.add(bar(dimension), aside);
    require_ok(hs_world_remove_body(after.world.get(), last), after.context.get());
    CHECK(after.add(bar(dimension), aside) != last);
    const std::pair<ElasticWorld*, hs_body> worlds[] = {{&alone, body}, {&before, second}, {&after, body}};
    const std::int32_t corner = 0;
    const double still[3] = {0, 0, 0};
    for (const auto& [s, which] : worlds) {
      REQUIRE(hs_world_set_time_step(s->world.get(), 1e-5) == HS_OK);
      REQUIRE(hs_world_hold_nodes(s->world.get(), which, &corner, 1, 3, still) == HS_OK);
      REQUIRE(hs_world_step(s->world.get(), 50) == HS_OK);
    }
    for (const auto get : node_getters) {
      const Points3 expected = of_nodes(get, alone.world.get(), body);
      CHECK(same(of_nodes(get, before.world.get(), second), expected));
      CHECK(same(of_nodes(get, after.world.get(), body), expected));
    }
  }
}

TEST_CASE("a step that would turn a cell inside out is refused, and names body and cell") {
  ElasticWorld s(2);
  const hs_body body = s.add(bar(2), body_def());
  const std::int32_t corner = 2;
  const double across[3] = {-1e4, 1e4, 0};
  REQUIRE(hs_world_hold_nodes(s.world.get(), body, &corner, 1, 3, across) == HS_OK);
  hs_status status = HS_OK;
  for (int i = 0; i < 100000 && status == HS_OK; ++i) status = hs_world_step(s.world.get(), 1);
  CHECK(status == HS_ERROR_INVERTED);
  const std::string text = hs_context_last_error(s.context.get());
  CHECK(text.find("cell ") != std::string::npos);
  CHECK(text.find("would be inverted") != std::string::npos);
  for (const Point3& p : of_nodes(hs_world_get_node_positions, s.world.get(), body))
    CHECK((std::isfinite(p.x) && std::isfinite(p.y)));
  const World copy = restored(s.context.get(), saved(s.world.get()));
  CHECK(hs_world_step(copy.get(), 1) == HS_ERROR_INVERTED);
}

}  // namespace halfspace_test
