// Bodies of any size, density and stiffness: refused, or such that they can be stepped, read and saved.

#include <cmath>

#include "capi/meshes.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

struct Extreme {
  double size, density, modulus, damping_time = 0, speed = 0;
};

/// A world, and a bar for it; null where that cannot be made.
struct ExtremeBar {
  ExtremeBar(int dimension, const Extreme& e) : world(make_world(context.get(), world_def(dimension))) {
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), e.density, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(e.modulus, e.damping_time);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    def.velocity[0] = e.speed;
    hs_mesh* made = nullptr;
    if (create_mesh(context.get(), bar(dimension, e.size), &made) == HS_OK) mesh.reset(made);
  }
  hs_status add() { return hs_world_add_mesh(world.get(), mesh.get(), &def, nullptr, &body); }

  Context context = make_context();
  World world;
  Mesh mesh;
  hs_body_def def = body_def();
  hs_body body = 77;
};

/// Whether what can be read of a body is of numbers, and the world can be saved.
bool is_sound(const ExtremeBar& s) {
  const hs_body_state state = state_of_body(s.world.get(), s.body);
  bool is_finite = std::isfinite(state.mass) && std::isfinite(state.kinetic_energy);
  for (const auto get : {hs_world_get_node_positions, hs_world_get_node_velocities})
    for (const Point3& p : of_nodes(get, s.world.get(), s.body))
      is_finite = is_finite && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  return is_finite && restored(s.context.get(), saved(s.world.get()));
}

}  // namespace

TEST_CASE("masses and stiffnesses beyond what can be computed with are refused") {
  for (const int dimension : {2, 3}) {
    for (const Extreme& e :
         {Extreme{1, 1e-302, 1e8}, {1e-40, 1e-250, 1}, {1e40, 1e75, 1}, {1, 1e-299, 1e75}}) {
      INFO(dimension << "D, size " << e.size << ", density " << e.density << ", modulus " << e.modulus);
      ExtremeBar s(dimension, e);
      REQUIRE(s.mesh);
      check_unchanged(s, "hs_world_add_mesh",
                      {{"mesh", "beyond what can be computed with", [&] { return s.add(); }}});
    }
  }
}

TEST_CASE("a body of any size, density, stiffness and speed within the limits is refused or can be stepped") {
  Random random(3);
  int made = 0;
  for (int i = 0; i < 600; ++i) {
    const int dimension = 2 + i % 2;
    const auto any = [&](double most) { return std::pow(10, uniform_between(random, -most, most)); };
    Extreme e = {any(dimension == 2 ? 74 : 50), any(74), any(74)};
    if (i % 3 == 0) e.damping_time = any(20);
    if (i % 5 != 0) e.speed = any(75);
    INFO(dimension << "D, size " << e.size << ", density " << e.density << ", modulus " << e.modulus
                   << ", damping time " << e.damping_time << ", speed " << e.speed);
    ExtremeBar s(dimension, e);
    if (!s.mesh) continue;
    const hs_status status = s.add();
    CHECK((status == HS_OK || status == HS_ERROR_ARGUMENT));
    if (status != HS_OK) continue;
    ++made;
    CHECK(is_sound(s));
    const hs_status stepped = hs_world_step(s.world.get(), 3);
    CHECK((stepped == HS_OK || stepped == HS_ERROR_STATE || stepped == HS_ERROR_UNSTABLE ||
           stepped == HS_ERROR_TOO_FAST || stepped == HS_ERROR_INVERTED));
    hs_balance balance;
    CHECK(hs_world_get_balance(s.world.get(), &balance, sizeof balance) == HS_OK);
    CHECK(is_sound(s));
  }
  std::printf("bodies of any size: %d of 600 made\n", made);
  CHECK(made > 200);
}

}  // namespace halfspace_test
