// A vertex falls onto an edge of 1 cm and next to it (Wang et al. 2021, section 4.3, and Zheng et al. 2020,
// section 5.3). The papers give no coordinates: a square of 1 m stands on its corner above a block of 1 m
// whose roof of 30 degrees ends in the small edge. The papers' friction is not given: none.

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double time_step = 2e-5;
constexpr double stiffness = 5e6;
constexpr double density = 2000;
constexpr double drop = 0.1;
constexpr double speed = 1.4007141035914502;  // sqrt(2 g drop)
constexpr double small = 0.01;
const double omega = std::sqrt(0.5 * stiffness / density);  // a vertex has half the stiffness

Points diamond(double x) {
  const double r = std::sqrt(0.5);
  return {{x, drop}, {x + r, drop + r}, {x, drop + 2 * r}, {x - r, drop + r}};
}

/// Its roof's ridge, cut off to an edge of the given length, lies at height 0.
Points house(double ridge) {
  const double eaves = -(0.5 - ridge / 2) * std::tan(30 * degree);
  Points p{{-0.5, -1}, {0.5, -1}, {0.5, eaves}, {ridge / 2, 0}, {-ridge / 2, 0}, {-0.5, eaves}};
  if (ridge == 0) p.erase(p.begin() + 4);
  return p;
}

hs_law_def law() {
  hs_law_def law = spring_law(stiffness);
  law.shear_stiffness = 1e6;
  return law;
}

struct Fall {
  Scene scene;
  hs_block block;
  Fall(const Points& target, const Points& falling) : scene(world_def(time_step), law(), density) {
    scene.add(target, {HS_BLOCK_FIXED, {}, 0});
    block = scene.add(falling);
  }
};

/// The overlap (v / omega = 28 mm) passes the small edge's length: the contact must remember through which
/// edge it came.
TEST_CASE("A4.3 case 1: a vertex that falls onto an edge of 1 cm goes straight back up") {
  Fall fall(house(small), diamond(0.001));
  const double start = fall.scene.position(fall.block).y;
  double largest_side = 0, largest_spin = 0, top = 0, deepest = 0;
  for (int i = 0; i < 20000; ++i) {
    fall.scene.step();
    const Point v = fall.scene.velocity(fall.block);
    largest_side = std::max(largest_side, std::abs(v.x));
    largest_spin = std::max(largest_spin, std::abs(fall.scene.spin(fall.block)));
    if (deepest > 0) top = std::max(top, fall.scene.position(fall.block).y - start + drop);
    deepest = std::max(deepest, fall.scene.report().largest_overlap);
  }
  const hs_energy energy = fall.scene.energy();
  std::printf(
      "A4.3 case 1: falls %.6f m, rises %.9f m, sideways %.1e m/s, spin %.1e /s, overlap %.2f mm, residual "
      "%.1e J\n",
      drop, top, largest_side, largest_spin, 1e3 * deepest, energy.residual);
  CHECK(deepest > small);
  // The vertex lies below the centroid, the normal is vertical: rounding of the arm, 1e-16 m, times the
  // momentum 2 m v, over m/6.
  CHECK(largest_side <= 1e-15 * speed);
  CHECK(largest_spin <= 6 * 2 * speed * rounding * 10);
  // Elastic. The discrete energy is off by (omega dt)^2 / 4 at each of the two ends of the contact (see
  // B4.1), and so is the height; the highest of the steps' places is g (dt/2)^2 / 2 short of the summit.
  CHECK(std::abs(top - drop) <= drop * square_of(omega * time_step) / 2 + 9.81 * square_of(time_step) / 8);
}

/// The vertex strikes the roof right of the edge: it is deflected to the right, and as if the small edge were
/// not there, until at 0.34 s the ridge strikes the turning block from below.
TEST_CASE("A4.3 case 2: a vertex that falls next to the edge of 1 cm is deflected to the right") {
  constexpr double x = 0.03;
  constexpr int steps = 15000;
  Fall fall(house(small), diamond(x));
  // Without the small edge: the same roof line, carried on to its ridge.
  Points whole = house(0);
  for (Point& p : whole) p.y += small / 2 * std::tan(30 * degree);
  Fall plain(whole, diamond(x));
  double largest_difference = 0;
  for (int i = 0; i < steps; ++i) {
    fall.scene.step();
    plain.scene.step();
    const Point p = fall.scene.position(fall.block), q = plain.scene.position(plain.block);
    largest_difference = std::max({largest_difference, std::abs(p.x - q.x), std::abs(p.y - q.y)});
  }
  const Point v = fall.scene.velocity(fall.block);
  const hs_energy energy = fall.scene.energy();
  std::printf(
      "A4.3 case 2: after the bounce %.4f, %.4f m/s, spin %.4f /s, at 0.3 s; against the roof without small "
      "edge %.1e m; residual %.1e J\n",
      v.x, v.y, fall.scene.spin(fall.block), largest_difference, energy.residual);
  CHECK(v.x > 0.1);
  fall.scene.step(20000 - steps);
  CHECK(fall.scene.velocity(fall.block).x > v.x);  // the ridge, on its left, throws it further right
  // The two roofs' lines differ by rounding of their vertices, some 1e-16 m. The contact turns that into a
  // velocity off by omega (at the vertex, whose reduced mass is at least a quarter of the mass, 100 /s) times
  // that, for 0.15 s: the steps' own rounding is larger.
  CHECK(largest_difference <= steps * rounding);
  // The contact takes or gives energy at its two ends only, (omega dt)^2 / 4 of 1/2 m v^2 each.
  CHECK(std::abs(energy.residual) <= 0.5 * square_of(2 * omega * time_step) * 0.5 * density * speed * speed);
}

/// By the potentials of the paper, which let the vertex in by some centimetres.
struct PotentialFall {
  static constexpr double time_step = 1e-4;
  static constexpr double stiffness = 5e7;
  Scene scene;
  hs_block block;
  double deepest = 0;

  PotentialFall(const Points& target, const Points& falling)
      : scene(definition(), potential_law(stiffness), density) {
    scene.add(target, {HS_BLOCK_FIXED, {}, 0});
    block = scene.add(falling);
  }
  static hs_world_def definition() {
    hs_world_def def = world_def(time_step);
    def.potential_length = 1;
    return def;
  }
  void run() {
    for (int i = 0; i < 2500; ++i) {
      scene.step();
      deepest = std::max(deepest, scene.report().largest_overlap);
    }
  }
};

/// A vertex straight above the middle finds mirror images on both sides, but the arithmetic is no mirror
/// image of itself, and what it is off by grows: a vertex off the middle is pushed further off. A shift tells
/// by how much.
TEST_CASE("B5.3 case 1: potentials throw a vertex that falls onto an edge of 1 cm straight back up") {
  PotentialFall fall(house(small), diamond(0));
  fall.run();
  const Point v = fall.scene.velocity(fall.block);
  const double spin = fall.scene.spin(fall.block);
  const hs_energy energy = fall.scene.energy();
  std::printf(
      "B5.3 case 1: after the bounce %.1e, %.6f m/s, spin %.1e /s, overlap %.2f mm, residual %.1e of the "
      "energy\n",
      v.x, v.y, spin, 1e3 * fall.deepest, energy.residual / (0.5 * density * speed * speed));
  CHECK(fall.deepest > small);
  CHECK(v.y > 0);
  CHECK(fall.scene.report().contact_count == 0);
  // Forces of ten roundings push it off by no more than as many roundings of the overlap at every step of the
  // contact, all of which grow as much as the first one at most.
  constexpr double shift = 1e-9;
  PotentialFall shifted(house(small), diamond(shift));
  shifted.run();
  std::printf("B5.3 case 1: a shift of %.0e m grows to %.1e m/s\n", shift,
              shifted.scene.velocity(shifted.block).x);
  const double steps = 2500;
  const double off = 10 * rounding * fall.deepest * steps / shift;
  CHECK(std::abs(v.x) <= off * std::abs(shifted.scene.velocity(shifted.block).x));
  CHECK(std::abs(spin) <= off * std::abs(shifted.scene.spin(shifted.block)));
  // A wedge with a right angle in a half-plane has the depth d over the area d^2, twice over in both fields:
  // its force 2 k/H d^2 rises with the slope 4 k/H d. No contact is harder, and it sets in without a jump of
  // the slope: the energy is off by less than (omega dt)^2 / 4 at either end.
  const double hardest = 4 * PotentialFall::stiffness * fall.deepest;
  CHECK(std::abs(energy.residual) <=
        hardest / density * square_of(PotentialFall::time_step) / 2 * 0.5 * density * speed * speed);
}

/// What the small edge cuts off changes force and energy by less than its share: against a roof without it
/// the motion differs the less the smaller the edge.
TEST_CASE("B5.3 case 2: potentials deflect a vertex that falls next to a small edge to the right") {
  for (double ridge : {1e-2, 1e-3, 1e-4, 1e-6, 1e-9}) {
    PotentialFall fall(house(ridge), diamond(0.03));
    Points whole = house(0);
    for (Point& p : whole) p.y += ridge / 2 * std::tan(30 * degree);
    PotentialFall plain(whole, diamond(0.03));
    fall.run();
    plain.run();
    const Point v = fall.scene.velocity(fall.block), w = plain.scene.velocity(plain.block);
    const double spin = fall.scene.spin(fall.block), plain_spin = plain.scene.spin(plain.block);
    const double difference =
        std::max({std::abs(v.x - w.x), std::abs(v.y - w.y), std::abs(spin - plain_spin)});
    std::printf(
        "B5.3 case 2, edge of %.0e m: after the bounce %.4f, %.4f m/s, spin %.4f /s; against the roof "
        "without "
        "small edge %.1e\n",
        ridge, v.x, v.y, spin, difference);
    CHECK(fall.scene.report().contact_count == 0);
    CHECK(v.x > 0.1);
    CHECK(difference <= ridge * speed);
  }
}

}  // namespace
