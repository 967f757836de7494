// Impacts by a law without a spring: case C6 of the papers, and flush bars, against the theory of waves.

#include "catch.h"
#include "validation/reacting.h"

namespace {

using namespace halfspace_test;

/// C6: a triangle flies at 3 m/s over a gap of 1 m, tip first, against the middle of another one's edge.
struct Triangles {
  Triangles(int parts, double time_step, double edge = 20)
      : scene(def_with(time_step), law_without_spring(), 2700, {40e9, 0.25}) {
    const MeshWords words = pointed_triangle(edge, parts);
    striker = scene.add_mesh(words, {0, 0, 0}, {3, 0, 0});
    struck = scene.add_mesh(words, {1 + edge * std::sqrt(0.75), 0, 0});
  }
  static hs_world_def def_with(double time_step) {
    hs_world_def def = mesh_world_def(2);
    def.time_step = time_step;
    return def;
  }
  void step_until(double time) {
    while (scene.report().time < time) scene.step();
  }

  ReactingScene scene;
  hs_body striker = 0, struck = 0;
};

/// Two bars of squares meet squarely, one at 1 m/s and one at rest. Modulus and density make waves run at
/// 1 km/s. Lengths are 1 m.
struct Bars {
  static constexpr double wave_speed = 1000, density = 1000;

  explicit Bars(int count, int32_t kind = HS_CELL_QUAD)
      : scene(mesh_world_def(dimension_of(kind)), law_without_spring(), density, {1e9, 0}) {
    const double size = 1.0 / count;
    const MeshWords words =
        brick(dimension_of(kind), {1, size, size}, {count, 1, 1}, [&](int) { return kind; });
    area = dimension_of(kind) == 2 ? size : size * size;
    striker = scene.add_mesh(words, {-1.01, 0, 0}, {1, 0, 0});
    struck = scene.add_mesh(words, {0, 0, 0});
  }

  ReactingScene scene;
  hs_body striker = 0, struck = 0;
  double area = 0;
};

struct BarImpact {
  double loss = 0;  // share of the energy
  double duration = 0;
  double left = 0;  // speed of the striker
  double peak = 0;  // force over that of the theory
  double mean = 0;
};

BarImpact impact_of(Bars& bars) {
  ReactingScene& scene = bars.scene;
  scene.step();
  const double time_step = scene.report().time_step, energy = scene.report().energy.kinetic;
  const double theory = 0.5 * bars.density * bars.wave_speed * bars.area, waves = 2 / bars.wave_speed;
  BarImpact impact;
  double touched_at = 0, sum = 0;
  int forces = 0;
  while (scene.report().time < 0.01 + 3 / bars.wave_speed) {
    scene.step();
    const std::vector<hs_contact> contacts = scene.contacts();
    if (contacts.empty()) continue;
    if (touched_at == 0) {
      touched_at = contacts.front().touched_at;
      continue;  // the blow is no force
    }
    const double now = scene.report().time, force = scene.force_on(bars.struck).x() / theory;
    impact.duration = now - touched_at;
    impact.peak = std::max(impact.peak, force);
    if (now - touched_at > 0.1 * waves && now - touched_at < 0.9 * waves) {
      sum += force;
      ++forces;
    }
  }
  CHECK(touched_at == Approx(0.01).epsilon(1e-12));
  impact.duration = (impact.duration + 0.5 * time_step) / waves;
  impact.mean = sum / forces;
  impact.loss = scene.report().impact_loss / energy;
  impact.left = scene.speed(bars.striker);
  CHECK(scene.speed(bars.striker) + scene.speed(bars.struck) == Approx(1).epsilon(1e-13));
  CHECK(std::abs(scene.report().energy.residual) < 2e-3 * energy);
  return impact;
}

}  // namespace

/// The striking node has a third of its triangle's mass, each of the two that are struck as well: at the
/// middle of their edge they weigh as two thirds. What is lost is m g'^2 / 2 with m = 2/9 of the triangle.
TEST_CASE("C6: a triangle strikes the middle of an edge within a step", "[mesh][reaction]") {
  Triangles triangles(1, 5e-4);
  const double energy = 0.5 * triangles.scene.body_state(triangles.striker).mass * 9;
  triangles.step_until(0.3334);
  REQUIRE(triangles.scene.contacts().size() == 1);
  CHECK(triangles.scene.contacts().front().touched_at == Approx(1.0 / 3).margin(1e-12));
  CHECK(triangles.scene.report().impact_loss / energy == Approx(2.0 / 9).epsilon(1e-11));
  triangles.step_until(0.6);
  CHECK(triangles.scene.contacts().empty());
  const double struck = triangles.scene.speed(triangles.struck),
               left = triangles.scene.speed(triangles.striker);
  std::printf("C6: the struck triangle leaves at %.4f m/s, the striker goes on at %.4f m/s\n", struck, left);
  CHECK(struck == Approx(2.18).margin(0.02));
  CHECK(struck + left == Approx(3).epsilon(1e-13));
}

TEST_CASE("C6: the finer the mesh, the less is lost", "[mesh][reaction]") {
  double before = 1;
  for (const int parts : {1, 2, 4, 8}) {
    Triangles triangles(parts, 0);
    const double energy = 0.5 * triangles.scene.body_state(triangles.striker).mass * 9;
    triangles.step_until(0.6);
    const double loss = triangles.scene.report().impact_loss / energy,
                 struck = triangles.scene.speed(triangles.struck);
    std::printf("C6 with %d elements a side: %.5f of the energy lost, the struck one leaves at %.4f m/s\n",
                parts, loss, struck);
    CHECK(loss < before);
    before = loss;
    if (parts == 8) CHECK(struck >= 2.95);
  }
}

/// Each pair of nodes that meet has half a layer of elements on both sides: h / (4 L) of the energy is lost.
TEST_CASE("flush bars rebound as waves want it, the better the finer", "[mesh][reaction]") {
  BarImpact before{1, 2, 1, 2, 0};
  for (const int count : {10, 20, 40, 80}) {
    Bars bars(count);
    const BarImpact impact = impact_of(bars);
    std::printf(
        "bars of %2d squares: loss %.6f of the energy, in touch for %.4f of 2 L/c, left %.4f of the speed, "
        "force "
        "%.4f on average and %.3f at most of rho c v/2\n",
        count, impact.loss, impact.duration, impact.left, impact.mean, impact.peak);
    CHECK(impact.loss == Approx(0.25 / count).epsilon(1e-3));
    CHECK(impact.peak < 1.10);
    CHECK(std::abs(impact.duration - 1) < std::abs(before.duration - 1));
    CHECK(impact.left < before.left);
    CHECK(std::abs(impact.mean - 1) < 0.01);
    if (count >= 40) {
      CHECK(std::abs(impact.duration - 1) < 0.03);
      CHECK(impact.left < 0.015);
    }
    before = impact;
  }
}

TEST_CASE("flush bars of hexahedra and of triangles rebound as well", "[mesh][reaction]") {
  for (const int32_t kind : {HS_CELL_TRIANGLE, HS_CELL_HEXAHEDRON, HS_CELL_TETRAHEDRON}) {
    INFO(name_of_cell(kind));
    Bars bars(20, kind);
    const BarImpact impact = impact_of(bars);
    CHECK(impact.left < 0.04);
    // A bar that is cut into tetrahedra twists a little: its corners part one by one.
    CHECK(impact.duration == Approx(1).epsilon(kind == HS_CELL_TETRAHEDRON ? 0.15 : 0.06));
    CHECK(impact.mean == Approx(1).epsilon(0.02));
  }
}

/// A touch inside of a step ends where it would with a step of its own: places after the impact are exact to
/// the second order in the step.
TEST_CASE("places after an impact converge with the square of the step", "[mesh][reaction]") {
  const auto places_with = [](double time_step) {
    Triangles triangles(1, time_step);
    triangles.step_until(0.36 - 0.5 * time_step);
    Nodes places = triangles.scene.positions(triangles.striker);
    for (const Node& node : triangles.scene.positions(triangles.struck)) places.push_back(node);
    return places;
  };
  const double coarsest = 0.36 / 160;
  const Nodes exact = places_with(coarsest / 256);
  std::vector<double> errors;
  for (const int parts : {1, 2, 4, 8, 16}) {
    const Nodes places = places_with(coarsest / parts);
    double error = 0;
    for (std::size_t i = 0; i < places.size(); ++i) error = std::max(error, (places[i] - exact[i]).norm());
    errors.push_back(error);
    std::printf("a step of %.3e s: places after the impact are off by %.2e m\n", coarsest / parts, error);
  }
  const double order = std::log2(errors.front() / errors.back()) / 4;
  std::printf("order in the step: %.2f\n", order);
  CHECK(order >= 1.8);
}
