// A bar whose end has the impedance of its material lets waves out (Lysmer and Kuhlemeyer 1969).

#include "validation/actions.h"
#include "validation/mesh.h"

namespace {

using namespace halfspace_test;

constexpr double density = 2500, modulus = 1e10, wave_speed = 2000, length_of_bar = 20;

}  // namespace

TEST_CASE("a bar with a viscous end reflects less than 2 % of a wave") {
  MeshScene scene(world_def(0, 0), area_law(1e8), density, {modulus, 0});
  const hs_body bar = scene.add_mesh(
      brick(2, {length_of_bar, 1, 0}, {100, 1, 0}, [](int) { return std::int32_t(HS_CELL_QUAD); }));
  const auto nodes_at = [&](double x) {
    return scene.nodes_where(bar, [&](const Node& node) { return std::abs(node.x() - x) < 1e-9; });
  };
  // Half of the end belongs to each of its nodes.
  const double impedance = density * wave_speed / 2;
  const double viscosity[9] = {impedance, 0, 0, 0, 0, 0, 0, 0, 0};
  const std::vector<int32_t> end = nodes_at(length_of_bar), begin = nodes_at(0), middle = nodes_at(10);
  REQUIRE((end.size() == 2 && begin.size() == 2 && middle.size() == 2));
  scene.check(hs_world_set_node_viscosity(scene.world(), bar, end.data(), 2, viscosity));
  // A pulse of 4 ms, which is 8 m long.
  const hs_action_def push = action_def(HS_ACTION_FORCE, add_table(scene, {{0}, {0.002, 5e5}, {0.004, 0}}));
  const Nodes scales(2, Node(1, 0, 0));
  scene.check(hs_world_add_node_action(scene.world(), bar, begin.data(), view_of(scales), &push));
  double incoming = 0, reflected = 0;
  while (scene.report().time < 0.019) {
    scene.step(10);
    const double time = scene.report().time;
    const double speed = std::abs(scene.velocities(bar)[std::size_t(middle[0])].x());
    // It passes the middle at 5 to 9 ms. What the end reflects returns at 15 to 19 ms.
    if (time < 0.0095) incoming = std::max(incoming, speed);
    if (time > 0.0145) reflected = std::max(reflected, speed);
  }
  std::printf("a bar with a viscous end reflects %.2f %% of a wave\n", 100 * reflected / incoming);
  // The cells round off the tip of the pulse.
  CHECK(incoming == Approx(1e6 / (density * wave_speed)).epsilon(0.05));
  CHECK(reflected < 0.02 * incoming);
}
