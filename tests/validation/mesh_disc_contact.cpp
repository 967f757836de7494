// A meshed disc between rigid plates, against Hertz's line contact. Case D05 of the project's list.

#include "catch.h"
#include "validation/disc.h"

namespace {

using namespace halfspace_test;

/// Numbers from 0 to 1 in so many steps, which grow from the first one on as a hyperbolic sine does.
std::vector<double> growing(int steps, double growth) {
  std::vector<double> places;
  for (int i = 0; i <= steps; ++i) places.push_back(std::sinh(growth * i / steps) / std::sinh(growth));
  return places;
}

/// The half of a disc whose cells are finest where its round side meets a plate: eight in the half width.
MeshWords graded_half_disc(double radius) {
  constexpr int corner = 6;  // cells between the diameter and pi / 4
  const std::vector<double> near = growing(32, 3.5), deep = growing(24, 3.4);
  std::vector<double> angles, shares;
  for (int i = 0; i < corner; ++i) angles.push_back(pi / 4 * i / corner);
  for (std::size_t i = near.size(); i-- > 1;) angles.push_back(pi / 2 - pi / 4 * near[i]);
  for (const double place : near) angles.push_back(pi / 2 + pi / 4 * place);
  for (int i = 1; i <= corner; ++i) angles.push_back(pi * 3 / 4 + pi / 4 * i / corner);
  for (std::size_t i = deep.size(); i-- > 0;) shares.push_back(1 - deep[i]);
  return half_disc(radius, angles, corner, shares);
}

/// Where on the circle a contact is, and how wide the edge is that it presses.
struct Pressed {
  double x = 0, width = 0;
};

Pressed pressed_edge(const MeshScene& scene, const MeshWords& words, const Nodes& nodes, double radius,
                     const hs_contact& contact) {
  int32_t cell = -1;
  hs_body body = 0;
  for (const hs_block block : {contact.block_a, contact.block_b})
    if (cell < 0) scene.check(hs_world_get_body_of_block(scene.world(), block, &body, &cell));
  double left = HUGE_VAL, right = -HUGE_VAL;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t node = std::size_t(words.cell_nodes[4 * std::size_t(cell) + k]);
    if (words.nodes[node].norm() < radius * (1 - 1e-9)) continue;
    left = std::min(left, nodes[node].x());
    right = std::max(right, nodes[node].x());
  }
  return {(left + right) / 2, right - left};
}

}  // namespace

/// D05. Two plates press the disc; of its upper half the diameter is moved to the upper plate. The law is per
/// area, so stiff that its springs give way by 0.2 % of what the disc does. A half width is that of the half
/// ellipse of pressure with the second moment that is seen: its mean square of x is a^2 / 4.
TEST_CASE("a meshed disc that is pressed has the contact of Hertz", "[mesh]") {
  const double radius = 0.5, load = 1e6, stiffness = 5e12;
  const Elastic elastic{1e9, 0.25};
  const double modulus = elastic.young / (1 - square_of(elastic.poisson));
  const double wanted_width = std::sqrt(4 * load * radius / (pi * modulus));
  const double wanted_pressure = 2 * load / (pi * wanted_width);
  const double approach = load / (pi * modulus) * (2 * std::log(4 * radius / wanted_width) - 1);
  CHECK(wanted_width == Approx(0.02443).epsilon(1e-3));
  CHECK(wanted_pressure == Approx(2.606e7).epsilon(1e-3));
  CHECK(approach == Approx(2.331e-3).epsilon(1e-3));

  MeshScene scene(mesh_world_def(2), area_law(stiffness), 2000, elastic);
  const MeshWords words = graded_half_disc(radius);
  const hs_body body = scene.add_mesh(words);
  scene.add(box(-1, radius, 1, radius + 1), {HS_BLOCK_FIXED, {}, 0});
  const std::vector<int32_t> diameter =
      scene.nodes_where(body, [](const Node& node) { return node.y() < 1e-9; });
  scene.hold(body, scene.nodes_where(body, [](const Node& node) { return std::abs(node.x()) < 1e-9; }),
             HS_AXIS_X);
  constexpr int steps = 2000;
  scene.hold(body, diameter, HS_AXIS_Y, {0, approach / (steps * scene.report().time_step), 0});
  scene.step(steps);
  scene.hold(body, diameter, HS_AXIS_Y);
  const hs_balance balance = relax(scene, 1e-5);

  const Nodes nodes = scene.positions(body);
  const double moved = nodes[std::size_t(diameter[0])].y();
  double force = 0, moment = 0, force_inside = 0, width_inside = 0;
  for (const hs_contact& contact : scene.contacts()) {
    const Pressed edge = pressed_edge(scene, words, nodes, radius, contact);
    force += contact.normal_force;
    moment += contact.normal_force * square_of(edge.x);
    if (std::abs(edge.x) > 0.25 * wanted_width) continue;
    force_inside += contact.normal_force;
    width_inside += edge.width;
  }
  const double width = 2 * std::sqrt(moment / force);
  // Over the middle quarter the half ellipse has 0.99 of its peak on average.
  const double pressure = force_inside / width_inside / 0.99;
  std::printf(
      "disc: pressed by %.4g m bears %.4g N/m, half width %.5f m, wanted %.5f, pressure %.4g Pa, wanted "
      "%.4g; "
      "%lld steps\n",
      moved, force, width, wanted_width, pressure, wanted_pressure, static_cast<long long>(balance.steps));
  CHECK(moved == Approx(approach).epsilon(1e-6));
  CHECK(force == Approx(load).epsilon(0.03));
  CHECK(width == Approx(wanted_width).epsilon(0.05));
  CHECK(pressure == Approx(wanted_pressure).epsilon(0.05));
}
