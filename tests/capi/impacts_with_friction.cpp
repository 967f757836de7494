// Impacts of rigid blocks without springs: no energy is made, and Newton's rule holds where it makes none.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "capi/polyhedra.h"
#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double density = 1000, pi = 3.14159265358979323846;

/// Rigid blocks by one law without springs, by default without weight.
struct ImpactWorld {
  Context context = make_context();
  World world;

  ImpactWorld(int dimension, double restitution, double friction, double time_step, bool locates,
              double weight = 0, std::int32_t max_impulse_iterations = 200) {
    hs_world_def def = world_def(dimension);
    std::fill(def.gravity, def.gravity + 3, 0.0);
    def.gravity[dimension - 1] = -weight;
    def.time_step = time_step;
    def.locate_impacts = locates;
    def.max_impulse_iterations = max_impulse_iterations;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), density, &material), context.get());
    hs_law_def law = law_def(1, std::atan(friction));
    law.stiffness_kind = HS_STIFFNESS_NONE;
    law.restitution = restitution;
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    if (dimension == 2) {
      add_block(context.get(), world.get(), box(-99, -1, 99, 0), HS_BLOCK_FIXED);
    } else {
      add(make_hull(context.get(), box_corners({-99, -99, -1}, {99, 99, 0})), {}, {}, HS_BLOCK_FIXED);
    }
  }

  hs_block add(const Shape& shape, const std::array<double, 3>& velocity, const std::array<double, 3>& spin,
               std::int32_t kind = HS_BLOCK_RIGID) {
    hs_block_def def = block_def(context.get(), shape, kind);
    std::copy(velocity.begin(), velocity.end(), def.velocity);
    std::copy(spin.begin(), spin.end(), def.angular_velocity);
    return add_block(context.get(), world.get(), shape, def);
  }
  hs_block add(const Points& corners, double along, double up, double spin) {
    return add(make_shape(context.get(), corners), {along, up, 0}, {0, 0, spin});
  }
  void step(int count = 1) { require_ok(hs_world_step(world.get(), count), context.get()); }
  hs_block_state state(hs_block block) const { return state_of(world.get(), block); }
  hs_world_report report() { return report_of(world.get()); }
  double energy() { return report().energy.kinetic + report().energy.gravity; }
  /// The largest rise of energy in a step, over the kinetic energy at the start.
  double largest_rise(int steps) {
    const double start = report().energy.kinetic;
    double largest = -1;
    for (int i = 0; i < steps; ++i) {
      const double before = energy();
      step();
      largest = std::max(largest, (energy() - before) / start);
    }
    return largest;
  }
};

double power_of_ten(Random& random, double low, double high) {
  return std::pow(10, uniform_between(random, low, high));
}

/// A polygon about the origin.
Points random_polygon(Random& random) {
  const int sides = std::uniform_int_distribution<int>(3, 7)(random);
  const double turn = uniform_between(random, 0, 2 * pi), height = uniform_between(random, 0.4, 1);
  Points corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * pi * i / sides;
    const double x = 0.5 * std::cos(angle), y = 0.5 * height * std::sin(angle);
    corners.push_back({std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y});
  }
  return corners;
}

Points moved(Points corners, double x, double y) {
  for (Point& corner : corners) corner = {corner.x + x, corner.y + y};
  return corners;
}

double lowest(const Points& corners) {
  double y = HUGE_VAL;
  for (const Point& corner : corners) y = std::min(y, corner.y);
  return y;
}

double highest(const Points& corners) {
  double y = -HUGE_VAL;
  for (const Point& corner : corners) y = std::max(y, corner.y);
  return y;
}

/// A cube of 1 m about the origin, turned. Any axis is one of its principal axes, so that it spins freely
/// without an error of the integrator.
Points3 turned_cube(Random& random) {
  std::array<double, 4> q;
  double square = 0;
  for (double& part : q) {
    part = uniform_between(random, -1, 1);
    square += part * part;
  }
  for (double& part : q) part /= std::sqrt(square);
  const auto [x, y, z, w] = q;
  Points3 corners;
  for (const Point3& p : box_corners({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5})) {
    corners.push_back(
        {(1 - 2 * (y * y + z * z)) * p.x + 2 * (x * y - w * z) * p.y + 2 * (x * z + w * y) * p.z,
         2 * (x * y + w * z) * p.x + (1 - 2 * (x * x + z * z)) * p.y + 2 * (y * z - w * x) * p.z,
         2 * (x * z - w * y) * p.x + 2 * (y * z + w * x) * p.y + (1 - 2 * (x * x + y * y)) * p.z});
  }
  return corners;
}

struct Motion {
  double along, up, spin;
};

/// A square of 1 m, turned by an angle, strikes a floor with its lowest corner: Newton's rule and Coulomb's
/// law for the impulses p (up) and q (along) at the arm (x, y).
struct CornerImpact {
  double x, y;  // from the centroid
  double mass = density, inertia = density / 6;

  explicit CornerImpact(double turn) {
    const Points square = turned(turn);
    const Point corner = *std::min_element(square.begin(), square.end(),
                                           [](const Point& a, const Point& b) { return a.y < b.y; });
    x = corner.x;
    y = corner.y;
  }
  static Points turned(double turn) {
    Points corners;
    for (const Point& p : box(-0.5, -0.5, 0.5, 0.5))
      corners.push_back(
          {std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y});
    return corners;
  }
  double energy(const Motion& m) const {
    return 0.5 * mass * (m.along * m.along + m.up * m.up) + 0.5 * inertia * m.spin * m.spin;
  }
  Motion after(const Motion& m, double p, double q) const {
    return {m.along + q / mass, m.up + p / mass, m.spin + (x * p - y * q) / inertia};
  }
  double opening(const Motion& m) const { return m.up + x * m.spin; }
  double slip(const Motion& m) const { return m.along - y * m.spin; }
  Motion by_newton(const Motion& before, double restitution, double friction) const {
    const double upwards = 1 / mass + x * x / inertia, along = 1 / mass + y * y / inertia,
                 both = -x * y / inertia;
    const double target = -(1 + restitution) * opening(before), stop = -slip(before);
    const double determinant = upwards * along - both * both;
    const double p = (along * target - both * stop) / determinant,
                 q = (upwards * stop - both * target) / determinant;
    if (std::abs(q) <= friction * p) return after(before, p, q);
    for (const double side : {-1.0, 1.0}) {
      const double sliding = target / (upwards + side * friction * both);
      const Motion result = after(before, sliding, side * friction * sliding);
      if (sliding > 0 && side * slip(result) <= 0) return result;
    }
    throw std::runtime_error("no impulse");
  }
};

Motion motion_of(const hs_block_state& state) {
  return {state.velocity[0], state.velocity[1], state.angular_velocity[2]};
}

/// Of a square that starts at a floor.
Motion after_impact(double turn, const Motion& before, double restitution, double friction, bool locates) {
  ImpactWorld world(2, restitution, friction, 1e-4, locates);
  const Points corners = CornerImpact::turned(turn);
  const hs_block square =
      world.add(moved(corners, 0, 1e-9 - lowest(corners)), before.along, before.up, before.spin);
  world.step(2);
  return motion_of(world.state(square));
}

}  // namespace

TEST_CASE("no polygon gains energy from a floor, whatever restitution and friction") {
  Random random(20261129);
  double worst = -1;
  for (int i = 0; i < 1000; ++i) {
    INFO("impact " << i);
    const double friction = uniform_between(random, 0, 2),
                 restitution = i % 3 == 0 ? 1 : uniform_between(random, 0, 1);
    const double speed = power_of_ten(random, -1, 2), time_step = power_of_ten(random, -3.5, -1.5);
    ImpactWorld world(2, restitution, friction, time_step, i % 2 == 0);
    const Points corners = random_polygon(random);
    const double height = uniform_between(random, 0, 0.02) - lowest(corners);
    world.add(moved(corners, 0, height), speed * uniform_between(random, -2, 2), -speed,
              speed * uniform_between(random, -4, 4));
    worst = std::max(worst, world.largest_rise(10));
    REQUIRE(worst < 1e-9);
  }
  std::printf("polygons on a floor: energy rises by %.1e of it at most\n", worst);
}

TEST_CASE("no cube gains energy from a floor in space, whatever restitution and friction") {
  Random random(19850101);
  double worst = -1;
  for (int i = 0; i < 1000; ++i) {
    INFO("impact " << i);
    const double friction = uniform_between(random, 0, 2),
                 restitution = i % 3 == 0 ? 1 : uniform_between(random, 0, 1);
    const double speed = power_of_ten(random, -1, 1), time_step = power_of_ten(random, -3.5, -2);
    ImpactWorld world(3, restitution, friction, time_step, i % 2 == 0);
    Points3 corners = turned_cube(random);
    double low = HUGE_VAL;
    for (const Point3& corner : corners) low = std::min(low, corner.z);
    const double height = uniform_between(random, 0, 1e-3) - low;
    for (Point3& corner : corners) corner.z += height;
    std::array<double, 3> velocity, spin;
    for (double& part : velocity) part = speed * uniform_between(random, -2, 2);
    for (double& part : spin) part = speed * uniform_between(random, -3, 3);
    velocity[2] = -speed;
    world.add(make_hull(world.context.get(), corners), velocity, spin);
    worst = std::max(worst, world.largest_rise(10));
    REQUIRE(worst < 1e-9);
  }
  std::printf("cubes on a floor: energy rises by %.1e of it at most\n", worst);
}

TEST_CASE("no polygon that falls gains energy") {
  Random random(9);
  double worst = -1;
  for (int i = 0; i < 300; ++i) {
    INFO("impact " << i);
    ImpactWorld world(2, 1, uniform_between(random, 0, 2), power_of_ten(random, -3.5, -2), i % 2 == 0, 9.81);
    const Points corners = random_polygon(random);
    world.add(moved(corners, 0, 0.01 - lowest(corners)), uniform_between(random, -2, 2), -1,
              uniform_between(random, -2, 2));
    worst = std::max(worst, world.largest_rise(20));
    REQUIRE(worst < 1e-9);
  }
  std::printf("polygons that fall: energy rises by %.1e of it at most\n", worst);
}

/// The solver's tolerance and blocks that roll over each other may leave more than rounding.
TEST_CASE("no energy is made where a polygon hits several") {
  Random random(7);
  double worst = -1;
  for (int i = 0; i < 300; ++i) {
    INFO("impact " << i);
    const double friction = uniform_between(random, 0, 2),
                 restitution = i % 3 == 0 ? 1 : uniform_between(random, 0, 1);
    ImpactWorld world(2, restitution, friction, power_of_ten(random, -3, -2), i % 2 == 0);
    double top = 0;
    for (int k = 0; k < 3; ++k) {
      for (const double side : {-0.51, 0.51}) {
        const Points corners = random_polygon(random);
        const bool is_thrown = k == 2;
        world.add(moved(corners, side, top + 1e-6 - lowest(corners)), 0, is_thrown ? -3 : 0,
                  is_thrown ? uniform_between(random, -5, 5) : 0);
        if (side > 0) top += highest(corners) - lowest(corners) + uniform_between(random, 0, 0.01);
      }
    }
    worst = std::max(worst, world.largest_rise(40));
    REQUIRE(worst < 1e-5);
  }
  std::printf("polygons that hit several: energy rises by %.1e of it at most\n", worst);
}

/// Where Newton's rule makes energy, as by a quarter in the first case, some is kept and none is made.
TEST_CASE("a corner impact has the result of Newton's rule, or its energy") {
  const CornerImpact known(1.363);
  const Motion thrown = {-0.324, -1, -0.292};
  REQUIRE(known.energy(known.by_newton(thrown, 1, 0.7)) > 1.2 * known.energy(thrown));
  Random random(1);
  int bound = 0;
  for (int i = 0; i < 400; ++i) {
    const bool is_first = i == 0;
    const double turn = is_first ? 1.363 : uniform_between(random, 0.05, pi / 2 - 0.05);
    const double friction = is_first ? 0.7 : uniform_between(random, 0, 2);
    const Motion before =
        is_first ? thrown : Motion{uniform_between(random, -3, 3), -1, uniform_between(random, -1, 1)};
    const CornerImpact impact(turn);
    if (impact.opening(before) > -0.1) continue;
    INFO("impact " << i << ", turn " << turn << ", friction " << friction);
    const Motion newton = impact.by_newton(before, 1, friction);
    const Motion result = after_impact(turn, before, 1, friction, i % 2 == 0);
    const double start = impact.energy(before), end = impact.energy(result);
    CHECK(end <= start * (1 + 1e-9));
    if (impact.energy(newton) <= start * (1 - 1e-3)) {
      CHECK(result.along == Approx(newton.along).margin(2e-3));
      CHECK(result.up == Approx(newton.up).margin(2e-3));
      CHECK(result.spin == Approx(newton.spin).margin(2e-3));
    } else if (impact.energy(newton) > start * (1 + 1e-3)) {
      ++bound;
      CHECK(end > 0.97 * start);
      CHECK(impact.opening(result) > 0);
      CHECK(std::abs(result.along - before.along) <= (1 + 1e-9) * friction * (result.up - before.up));
    }
  }
  CHECK(bound > 20);
}

TEST_CASE("friction leaves Newton's rule as it is in a central impact") {
  for (const double restitution : {0.3, 0.7, 1.0}) {
    for (const bool locates : {false, true}) {
      INFO("restitution " << restitution << ", located " << locates);
      ImpactWorld world(2, restitution, 0.6, 1. / 60, locates);
      const hs_block diamond = world.add({{0, 0.01}, {0.5, 0.51}, {0, 1.01}, {-0.5, 0.51}}, 0, -4, 0);
      const hs_block flush = world.add(box(9, 0.02, 11, 1.02), 0, -4, 0);
      world.step(3);
      for (const hs_block block : {diamond, flush}) {
        CHECK(world.state(block).velocity[1] == Approx(4 * restitution).epsilon(1e-12));
        CHECK(std::abs(world.state(block).velocity[0]) < 1e-12);
        CHECK(std::abs(world.state(block).angular_velocity[2]) < 1e-12);
      }
      const double start = 0.5 * density * (0.5 + 2) * 16;
      CHECK(world.energy() == Approx(restitution * restitution * start).epsilon(1e-12));
      CHECK(std::abs(world.report().energy.residual) < 1e-12 * start);
    }
  }
}

/// Outer work is no gain by the impact: that goes by relative velocities.
TEST_CASE("a paddle throws a block by twice its speed") {
  for (const double friction : {0.0, 0.6}) {
    ImpactWorld world(2, 1, friction, 1. / 60, false);
    const hs_block block = world.add(box(-0.5, 5.05, 0.5, 6.05), 0, 0, 0);
    world.add(make_shape(world.context.get(), box(-2, 4, 2, 5)), {0, 6, 0}, {}, HS_BLOCK_PRESCRIBED);
    world.step(2);
    CHECK(world.state(block).velocity[1] == Approx(12).epsilon(1e-6));
    CHECK(std::abs(world.report().energy.residual) < 1e-9 * world.energy());
  }
}

/// A bar falls on a floor and is tilted so little that its corners strike one after the other within a step.
TEST_CASE("a corner that strikes twice in a step rebounds twice") {
  constexpr double length = 1, height = 0.5, gyration_squared = (length * length + height * height) / 12;
  for (const int dimension : {2, 3}) {
    for (const double restitution : {0.5, 0.9}) {
      for (const double tilt : {1e-6, 1e-4, 1e-3}) {
        INFO(dimension << "D, restitution " << restitution << ", tilt " << tilt);
        // Impacts of single corners without friction, of a bar of mass 1 at speed 1.
        double up = -1, spin = 0;
        int impacts = 0;
        for (double arm = -length / 2; up + arm * spin < 0; arm = -arm, ++impacts) {
          const double impulse = -(1 + restitution) * (up + arm * spin) / (1 + arm * arm / gyration_squared);
          up += impulse;
          spin += arm * impulse / gyration_squared;
        }
        REQUIRE(impacts == 3);

        ImpactWorld world(dimension, restitution, 0, 1. / 240, true);
        Points corners;
        for (const Point& p : box(-length / 2, 0, length / 2, height))
          corners.push_back({p.x - tilt * p.y, p.y + tilt * (p.x + length / 2) + 0.05});
        const double speed = 4;
        hs_block bar = 0;
        if (dimension == 2) {
          bar = world.add(corners, 0, -speed, 0);
        } else {
          Points3 prism;
          for (const Point& p : corners)
            for (const double y : {-0.2, 0.2}) prism.push_back({p.x, y, p.y});
          bar = world.add(make_hull(world.context.get(), prism), {0, 0, -speed}, {});
        }
        world.step(6);
        const hs_block_state state = world.state(bar);
        CHECK(state.velocity[dimension - 1] == Approx(speed * up).epsilon(5e-3));
        CHECK((dimension == 2 ? 1 : -1) * state.angular_velocity[dimension == 2 ? 2 : 1] ==
              Approx(speed * spin).epsilon(5e-3));
      }
    }
  }
}

TEST_CASE("blocks at rest do not rebound") {
  for (const double restitution : {0.5, 1.0}) {
    INFO("restitution " << restitution);
    ImpactWorld world(2, restitution, 0.5, 1. / 60, true, 9.81);
    std::vector<hs_block> blocks;
    for (int i = 0; i < 4; ++i) blocks.push_back(world.add(box(0.1 * i, i, 0.1 * i + 1, i + 1), 0, 0, 0));
    world.step(120);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      CHECK(world.state(blocks[i]).pose.position[1] == Approx(double(i) + 0.5).margin(1e-9));
      CHECK(std::abs(world.state(blocks[i]).velocity[1]) < 1e-6);
    }
    CHECK(world.report().divided_steps == 0);
  }
}

/// The whole impulses of a motion with rebounds begin with those that held the blocks before.
TEST_CASE("a heap that rebounds does not sink where sweeps are few") {
  Random random(3);
  ImpactWorld world(2, 0.5, 0.5, 0.01, false, 9.81, 4);
  for (const double side : {-3., 3.})
    add_block(world.context.get(), world.world.get(), box(side - 0.5, 0, side + 0.5, 40), HS_BLOCK_FIXED);
  for (int i = 0; i < 24; ++i)
    world.add(moved(random_polygon(random), (i % 2) * 2.2 - 1.1, 1.1 + 2.2 * (i / 2)), 0, 0, 0);
  world.step(600);
  CHECK(world.report().largest_overlap < 5e-3);
}

/// By itself the lower block would fall as the upper one does, and none would land.
TEST_CASE("a block lands on one that the floor supports") {
  ImpactWorld world(2, 0.5, 0, 1. / 60, false, 9.81);
  world.add(box(0, 0, 1, 0.3), 0, 0, 0);
  world.step(3);
  const hs_block upper = world.add(box(0, 0.3 + 2.06e-4, 1, 0.6 + 2.06e-4), 0, -0.0819, 0);
  for (int i = 0; i < 3; ++i) {
    world.step();
    CHECK(world.state(upper).pose.position[1] == Approx(0.45).margin(1e-12));
    CHECK(std::abs(world.report().energy.residual) < 1e-9);
  }
}

/// Sweeps with friction came to a cycle at such impacts, so that the column fell over.
TEST_CASE("blocks that fall on one another and bounce end as a straight column") {
  const double place = GENERATE(0.5, 7.77, 33.3), restitution = GENERATE(0.2, 0.8);
  ImpactWorld world(3, restitution, 0.6, 1. / 60, false, 9.81);
  std::vector<hs_block> column;
  for (int i = 0; i < 6; ++i) {
    const double low = 0.2 + 0.5 * i;
    const Points3 corners = box_corners({place, 0, low}, {place + 1, 1, low + 0.3});
    column.push_back(world.add(make_hull(world.context.get(), corners), {}, {}));
  }
  world.step(600);
  for (std::size_t i = 0; i < column.size(); ++i) {
    const hs_block_state block = world.state(column[i]);
    CHECK(block.pose.position[0] == Approx(place + 0.5).margin(1e-9));
    CHECK(block.pose.position[2] == Approx(0.15 + 0.3 * double(i)).margin(1e-6));
    CHECK(block.velocity[2] == 0);
  }
}

/// Each lands on those that stand already. A point without load of a contact that bears bounced, so that a
/// tower tipped; then coupled friction diverged, and made forty times the energy that was there.
TEST_CASE("slabs that land flat on one another stay upright and make no energy") {
  const int count = GENERATE(6, 8);
  constexpr double way = 0.02;  // m, the first slab; each falls so much farther
  ImpactWorld world(3, 0.3, 0.6, 1. / 60, true, 9.81);
  std::vector<hs_block> slabs;
  double fall = 0;  // J
  for (int i = 0; i < count; ++i) {
    const double low = 0.5 * i + way * (i + 1);
    slabs.push_back(
        world.add(make_hull(world.context.get(), box_corners({0, 0, low}, {1, 1, low + 0.5})), {}, {}));
    fall += 0.5 * density * 9.81 * way * (i + 1);
  }
  world.step(120);
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const hs_block_state slab = world.state(slabs[i]);
    CHECK(slab.pose.position[0] == Approx(0.5).margin(1e-9));
    CHECK(slab.pose.position[1] == Approx(0.5).margin(1e-9));
    CHECK(slab.pose.position[2] == Approx(0.25 + 0.5 * double(i)).margin(1e-6));
  }
  CHECK(std::abs(world.report().energy.residual) < 1e-3 * fall);
}

/// The impulses of its impacts end short parts of steps, and the solver began the next part from 4e4 times
/// these: it made four hundred times the energy that was there.
TEST_CASE("a tower that rocks back onto its foot makes no energy") {
  constexpr int count = 12;
  constexpr double tilt = 0.02;
  ImpactWorld world(2, 0, 0.7, 1. / 60, true, 9.81);
  double at_rest = 0;  // J
  for (int i = 0; i < count; ++i) {
    Points corners;
    for (const Point& p : box(-1, 0.5 * i, 0, 0.5 * (i + 1)))
      corners.push_back(
          {std::cos(tilt) * p.x + std::sin(tilt) * p.y, std::cos(tilt) * p.y - std::sin(tilt) * p.x});
    world.add(corners, 0, 0, 0);
    at_rest += 0.5 * density * 9.81 * (0.25 + 0.5 * i);
  }
  const double available = world.energy() - at_rest;
  world.step(120);
  CHECK(world.energy() - at_rest < available);
  CHECK(std::abs(world.report().energy.residual) < 0.01 * available);
}

/// The angular momentum of squares or cubes of side 1 m about the origin of the world, over their density.
std::array<double, 3> angular_momentum(const std::vector<hs_block_state>& blocks) {
  std::array<double, 3> sum{};
  for (const hs_block_state& block : blocks) {
    const double *x = block.pose.position, *v = block.velocity;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum[i] += x[j] * v[k] - x[k] * v[j] + block.angular_velocity[i] / 6;
    }
  }
  return sum;
}

/// Blocks that turn may overlap. The displacements that take the overlap away change angular momentum a
/// little.
TEST_CASE("two blocks that collide keep their angular momentum") {
  const int dimension = GENERATE(2, 3);
  Random random(4);
  double error = 0;
  constexpr int pairs = 100;
  for (int i = 0; i < pairs; ++i) {
    ImpactWorld world(dimension, uniform_between(random, 0, 1), uniform_between(random, 0, 1), 1. / 60,
                      false);
    const auto any = [&](double size) {
      std::array<double, 3> parts{};
      for (double& part : parts) part = uniform_between(random, -size, size);
      return parts;
    };
    std::vector<hs_block> blocks;
    for (const double side : {-1., 1.}) {
      std::array<double, 3> velocity = any(0.3), spin = any(2);
      velocity[0] -= 1.5 * side;
      const double middle = 0.9 * side, above = 10 + 0.2 * side;
      if (dimension == 2) velocity[2] = spin[0] = spin[1] = 0;
      Points3 corners = turned_cube(random);
      for (Point3& p : corners) p = {p.x + middle, p.y, p.z + above};
      const Shape shape =
          dimension == 2
              ? make_shape(world.context.get(), box(middle - 0.5, above - 0.5, middle + 0.5, above + 0.5))
              : make_hull(world.context.get(), corners);
      blocks.push_back(world.add(shape, velocity, spin));
    }
    const auto states = [&] {
      return std::vector<hs_block_state>{world.state(blocks[0]), world.state(blocks[1])};
    };
    const std::array<double, 3> before = angular_momentum(states());
    world.step(40);
    const std::array<double, 3> after = angular_momentum(states());
    error += std::hypot(after[0] - before[0], after[1] - before[1], after[2] - before[2]) / pairs;
  }
  std::printf("%d dimensions: angular momentum of two blocks differs by %.1e m^2/s\n", dimension, error);
  CHECK(error < 1e-3);
}

TEST_CASE("blocks that have bounced lie on the floor") {
  const int dimension = GENERATE(2, 3);
  ImpactWorld world(dimension, 0.5, 0.9, 1. / 60, false, 9.81);
  std::vector<hs_block> blocks;
  for (int i = 0; i < 40; ++i) {
    const double x = 2 * i - 40, low = 0.0125 * i;
    const Shape shape =
        dimension == 2 ? make_shape(world.context.get(), box(x, low, x + 1, low + 0.5))
                       : make_hull(world.context.get(), box_corners({x, 0, low}, {x + 1, 0.8, low + 0.5}));
    blocks.push_back(world.add(shape, {}, {}));
  }
  world.step(240);
  for (const hs_block block : blocks) {
    CHECK(world.state(block).pose.position[dimension - 1] == Approx(0.25).margin(1e-9));
    CHECK(world.state(block).velocity[dimension - 1] == 0);
  }
}

}  // namespace halfspace_test
