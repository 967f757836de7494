// Bodies of any size, density and stiffness, under any load: refused, or such that they can be stepped, read,
// saved and restored.

#include "capi/extremes.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

struct Extreme {
  double size, density, modulus, damping_time = 0, speed = 0;
};

/// A world, and a bar for it; null where that cannot be made.
struct ExtremeBar {
  ExtremeBar(const hs_world_def& settings, const Extreme& e) : world(make_world(context.get(), settings)) {
    require_ok(hs_world_add_material(world.get(), e.density, &material), context.get());
    if (make_elastic(e.modulus, e.damping_time) != HS_OK) return;
    def.velocity[0] = e.speed;
    hs_mesh* made = nullptr;
    if (create_mesh(context.get(), bar(settings.dimension, e.size), &made) == HS_OK) mesh.reset(made);
  }
  hs_status make_elastic(double modulus, double damping_time) {
    const hs_elasticity_def elasticity = elasticity_def(modulus, damping_time);
    return hs_world_set_elasticity(world.get(), material, &elasticity);
  }
  hs_status add() { return hs_world_add_mesh(world.get(), mesh.get(), &def, nullptr, &body); }

  Context context = make_context();
  World world;
  std::int32_t material = -1;
  Mesh mesh;
  hs_body_def def = body_def();
  hs_body body = 77;
};

/// All that can be read of a body is of numbers.
void check_body(const ExtremeBar& s) {
  check_finite(s.world.get());
  const hs_body_state state = state_of_body(s.world.get(), s.body);
  CHECK(std::isfinite(state.mass));
  for (const auto get : {hs_world_get_node_positions, hs_world_get_node_velocities}) {
    for (const Point3& p : of_nodes(get, s.world.get(), s.body))
      CHECK((std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)));
  }
}

hs_world_def any_settings(int dimension, Random& random) {
  hs_world_def def = world_def(dimension);
  if (random() % 2) def.time_step = any_number(random);
  if (random() % 2) def.gravity[1] = -any_number(random);
  if (random() % 4 == 0) def.mass_damping = any_number(random);
  if (random() % 4 == 0) def.local_damping = 0.8;
  return def;
}

Extreme any_extreme(int dimension, Random& random) {
  const double most = dimension == 2 ? 74 : 50;
  Extreme e = {any_size(random, -most, most), any_number(random), any_number(random)};
  if (random() % 3 == 0) e.damping_time = any_number(random);
  if (random() % 2) e.speed = -any_number(random);
  return e;
}

/// A fixed block of its size that the bar touches, by a law of any stiffness.
void put_beside(ExtremeBar& s, int dimension, double size, Random& random) {
  hs_law_def law = law_def(any_number(random), 0.5);
  law.stiffness_kind = std::int32_t(random() % 3);
  require_ok(hs_world_set_default_law(s.world.get(), &law), s.context.get());
  const double half = 0.5 * size;
  const Shape shape = dimension == 2 ? make_shape(s.context.get(), box(-half, -half, half, half))
                                     : make_polyhedron(s.context.get(), cube(size));
  hs_block_def block;
  require_ok(hs_block_def_init(&block, sizeof block, shape.get()), s.context.get());
  block.kind = HS_BLOCK_FIXED;
  block.pose = pose_at(-0.49 * size, half);
  hs_block id = 0;
  (void)hs_world_add_block(s.world.get(), shape.get(), &block, &id);
}

void load_and_hold(ExtremeBar& s, Random& random) {
  const std::int32_t pushed[] = {2}, held[] = {0, 3};
  const double force[3] = {any_number(random), -any_number(random), 0};
  const double velocity[3] = {0, random() % 2 ? any_number(random) : 0, 0};
  if (random() % 2) CHECK(hs_world_set_node_force(s.world.get(), s.body, pushed, 1, force) == HS_OK);
  if (random() % 2) CHECK(hs_world_hold_nodes(s.world.get(), s.body, held, 2, HS_AXIS_Y, velocity) == HS_OK);
}

}  // namespace

TEST_CASE("masses and stiffnesses beyond what can be computed with are refused") {
  for (const int dimension : {2, 3}) {
    const std::pair<Extreme, std::string> faulty[] = {{{1, 1e-302, 1e8}, "1e-302"},
                                                      {{1e-40, 1e-250, 1}, "1e-250"},
                                                      {{1e40, 1e75, 1}, "1e+75"},
                                                      {{1, 1e-299, 1e75}, "1e-299"}};
    for (const auto& [e, value] : faulty) {
      INFO(dimension << "D, size " << e.size << ", density " << e.density << ", modulus " << e.modulus);
      ExtremeBar s(world_def(dimension), e);
      REQUIRE(s.mesh);
      check_unchanged(s, "hs_world_add_mesh",
                      {{"beyond what can be computed with", value, [&] { return s.add(); }}});
    }
  }
}

TEST_CASE("a modulus so small that half of it is none is refused") {
  ExtremeBar s(world_def(), {1, 1, 1});
  check_unchanged(s, "hs_world_set_elasticity",
                  {{"elasticity.young_modulus", "4.94066e-324", [&] { return s.make_elastic(5e-324, 0); }}});
}

TEST_CASE("a stiffness that a body cannot be computed with is refused when it comes after the body") {
  for (const int dimension : {2, 3}) {
    ExtremeBar s(world_def(dimension), {1, 1e-270, 1});
    REQUIRE(s.mesh);
    REQUIRE(s.add() == HS_OK);
    REQUIRE(hs_world_step(s.world.get(), 2) == HS_OK);
    check_unchanged(s, "hs_world_set_elasticity",
                    {{"elasticity.young_modulus", "1e+75", [&] { return s.make_elastic(1e75, 0); }}});
    CHECK(hs_world_step(s.world.get(), 2) == HS_OK);
    check_goes_on(s.context.get(), s.world.get(), 2);
  }
}

TEST_CASE("a node that no cell is left of stays where it is, whatever is set for it") {
  for (const int dimension : {2, 3}) {
    ExtremeBar s(world_def(dimension), {1, 2000, 1e8});
    hs_world* w = s.world.get();
    REQUIRE(s.add() == HS_OK);
    const std::int32_t first_cell = 0, its_node = 0;
    const double force[3] = {0, 1e3, 0};
    REQUIRE(hs_world_remove_cells(w, s.body, &first_cell, 1, {}) == HS_OK);
    const Points3 before = of_nodes(hs_world_get_node_positions, w, s.body);
    Points3 velocities(before.size(), Point3{1, 2, 0});
    CHECK(hs_world_hold_nodes(w, s.body, &its_node, 1, 0, nullptr) == HS_OK);
    CHECK(hs_world_set_node_velocities(w, s.body, view_of(velocities)) == HS_OK);
    CHECK(hs_world_set_node_force(w, s.body, &its_node, 1, force) == HS_OK);
    CHECK(hs_world_step(w, 3) == HS_OK);
    check_goes_on(s.context.get(), w, 3);
    const Points3 after = of_nodes(hs_world_get_node_positions, w, s.body);
    CHECK((after[0].x == before[0].x && after[0].y == before[0].y && after[0].z == before[0].z));
    CHECK(after[2].x > before[2].x);
  }
}

TEST_CASE("a body of any size, density, stiffness and load within the limits is refused or can be stepped") {
  Random random(3);
  int made = 0;
  for (int i = 0; i < 600; ++i) {
    const int dimension = 2 + i % 2;
    const hs_world_def settings = any_settings(dimension, random);
    const Extreme e = any_extreme(dimension, random);
    INFO("body " << i << ", " << dimension << "D, size " << e.size << ", density " << e.density
                 << ", modulus " << e.modulus << ", damping time " << e.damping_time << ", speed " << e.speed
                 << ", gravity " << settings.gravity[1] << ", time step " << settings.time_step);
    ExtremeBar s(settings, e);
    if (!s.mesh) continue;
    if (random() % 2) put_beside(s, dimension, e.size, random);
    const std::vector<unsigned char> before = saved(s.world.get());
    const hs_status status = s.add();
    CHECK((status == HS_OK || status == HS_ERROR_ARGUMENT));
    if (status != HS_OK) {
      const bool is_unchanged = saved(s.world.get()) == before;
      CHECK(is_unchanged);
      continue;
    }
    ++made;
    check_body(s);
    load_and_hold(s, random);
    check_goes_on(s.context.get(), s.world.get(), 1);
    check_goes_on(s.context.get(), s.world.get(), 3);
    check_body(s);
    const hs_status stiffened = s.make_elastic(any_number(random), any_number_or_zero(random));
    CHECK((stiffened == HS_OK || stiffened == HS_ERROR_ARGUMENT));
    check_goes_on(s.context.get(), s.world.get(), 2);
    check_body(s);
    check_rest(s.context.get(), s.world.get());
  }
  std::printf("bodies at the ends of numbers: %d of 600 made\n", made);
  CHECK(made > 200);
}

}  // namespace halfspace_test
