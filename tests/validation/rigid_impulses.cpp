// Rigid blocks without springs at a step of 1/60 s, against exact answers.

#include <memory>
#include <random>

#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

constexpr double frame = 1.0 / 60;
constexpr double gravity = 9.81;

hs_law_def hard_law(double friction, double restitution = 0) {
  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  law.friction_angle = std::atan(friction);
  law.restitution = restitution;
  return law;
}

constexpr Start fixed{HS_BLOCK_FIXED, {}, 0};

/// On a level floor; a slope is gravity turned.
struct Level : Scene {
  explicit Level(double friction, double restitution = 0, double slope = 0, double step = frame)
      : Scene(def_of(slope, step), hard_law(friction, restitution), 1000) {
    floor = add(box(-200, -2, 200, 0), fixed);
  }
  static hs_world_def def_of(double slope, double step) {
    hs_world_def def = world_def(step, -gravity * std::cos(slope));
    def.gravity[0] = gravity * std::sin(slope);
    return def;
  }
  std::vector<Point> places() const {
    std::vector<Point> all;
    for (const hs_block block : blocks()) all.push_back(position(block));
    return all;
  }
  /// How far any block has moved.
  double farthest_from(const std::vector<Point>& before) const {
    double farthest = 0;
    const std::vector<Point> now = places();
    for (std::size_t i = 0; i < now.size(); ++i)
      farthest = std::max(farthest, std::hypot(now[i].x - before[i].x, now[i].y - before[i].y));
    return farthest;
  }
  hs_block floor = 0;
};

/// A semicircle of mean radius 1 on two fixed blocks.
bool arch_stands(int voussoirs, double thickness) {
  Scene scene(world_def(frame, -gravity), hard_law(1.5), 1000);
  for (const double side : {-1.0, 1.0}) scene.add(box(side - 0.5, -1, side + 0.5, 0), fixed);
  const auto at = [](double radius, double angle) {
    return Point{radius * std::cos(angle), radius * std::sin(angle)};
  };
  const double inner = 1 - thickness / 2, outer = 1 + thickness / 2;
  hs_block crown = 0;
  for (int i = 0; i < voussoirs; ++i) {
    const double from = pi * i / voussoirs, to = pi * (i + 1) / voussoirs;
    const hs_block block = scene.add({at(inner, from), at(outer, from), at(outer, to), at(inner, to)});
    if (i == voussoirs / 2) crown = block;
  }
  const double height = scene.position(crown).y;
  scene.step(300);
  return scene.position(crown).y > height - 0.01;
}

}  // namespace

TEST_CASE("a block slides down a slope by the law of Coulomb to rounding", "[impulses]") {
  const double slope = 30 * degree, friction = std::tan(20 * degree);
  Level level(friction, 0, slope);
  const hs_block block = level.add(box(-0.5, 0, 0.5, 1));
  level.step(60);
  const double exact = 0.5 * gravity * (std::sin(slope) - friction * std::cos(slope));
  CHECK(level.position(block).x == Approx(exact).epsilon(1e-13));
  CHECK(std::abs(level.energy().residual) < 1e-12 * level.energy().friction_loss);
}

TEST_CASE("stacks and walls stay where they are", "[impulses]") {
  Level stack(0.5);
  for (int i = 0; i < 100; ++i) stack.add(box(-0.5, i, 0.5, i + 1));
  const std::vector<Point> stacked = stack.places();
  stack.step(60);
  std::printf("a stack of 100 at 1/60 s moves by %.1e in a second\n", stack.farthest_from(stacked));
  CHECK(stack.farthest_from(stacked) < 1e-8);

  Level wall(0.5);
  for (int row = 0; row < 20; ++row)
    for (int brick = 0; brick < 20; ++brick) {
      const double x = 2 * brick + row % 2;
      wall.add(box(x, row, x + 2, row + 1));
    }
  const std::vector<Point> built = wall.places();
  wall.step(60);
  std::printf("a wall of 400 bricks moves by %.1e in a second\n", wall.farthest_from(built));
  CHECK(wall.farthest_from(built) < 1e-8);
  CHECK(std::abs(wall.energy().residual) < 1e-9 * gravity * 400 * 2000);
}

TEST_CASE("each contact carries its load", "[impulses]") {
  Level stack(0.5);
  std::vector<hs_block> blocks = {stack.floor};
  for (int i = 0; i < 10; ++i) blocks.push_back(stack.add(box(-0.5, i, 0.5, i + 1)));
  stack.step(2);
  REQUIRE(stack.contacts().size() == 10);
  for (std::size_t i = 0; i < 10; ++i) {
    const std::optional<hs_contact> contact = stack.contact_between(blocks[i], blocks[i + 1]);
    REQUIRE(contact);
    CHECK(contact->normal_force == Approx(double(10 - i) * 1000 * gravity).epsilon(1e-6));
    CHECK(contact->point_count == 2);
    CHECK(contact->normal[1] == Approx(1));
  }
}

TEST_CASE("a block slides over flush joints as over one floor", "[impulses]") {
  for (const double friction : {0.0, 0.3}) {
    Scene scene(world_def(frame, -gravity), hard_law(friction), 1000);
    for (int i = 0; i < 40; ++i) scene.add(box(0.7 * i - 5, -1, 0.7 * (i + 1) - 5, 0), fixed);
    const hs_block block = scene.add(box(-0.5, 0, 0.5, 1), {HS_BLOCK_RIGID, {4, 0}, 0});
    scene.step(60);
    const double exact = 4 - friction * gravity;
    CHECK(scene.velocity(block).x == Approx(exact).epsilon(1e-9));
    CHECK(std::abs(scene.spin(block)) < 1e-9);
    CHECK(scene.position(block).y == Approx(0.5).margin(1e-8));
  }
}

/// Corners that end a step exactly at a joint, and joints that are off by a billionth of a block.
TEST_CASE("no joint stops a block, wherever a step ends", "[impulses]") {
  for (const double step : {1e-3, frame}) {
    for (const double ledge : {0.0, 1e-9, 1e-7}) {
      for (int start = 0; start < 70; start += step == frame ? 1 : 7) {
        INFO("step " << step << ", ledge " << ledge << ", start " << start);
        Scene scene(world_def(step, -gravity), hard_law(0), 1000);
        for (int i = 0; i < 20; ++i) scene.add(box(0.7 * i - 5, -1, 0.7 * (i + 1) - 5, i % 2 * ledge), fixed);
        const double x = 0.01 * start;
        const hs_block block =
            scene.add(box(x - 0.5, ledge, x + 0.5, 1 + ledge), {HS_BLOCK_RIGID, {4, 0}, 0});
        scene.step(std::int64_t(1 / step));
        REQUIRE(scene.velocity(block).x == Approx(4).epsilon(1e-4));
        REQUIRE(scene.position(block).y == Approx(0.5).margin(1e-5));
      }
    }
  }
}

TEST_CASE("a block topples beyond the slope of its diagonal", "[impulses]") {
  for (const double ratio : {0.9999, 1.0001}) {
    Level level(1, 0, std::atan(0.25 * ratio));
    const hs_block slab = level.add(box(-0.5, 0, 0.5, 4));
    level.step(1200);
    CHECK((std::abs(level.position(slab).y - 2) < 1e-3) == (ratio < 1));
  }
}

/// Two of Heyman's limits: exact thicknesses of the thinnest arches of 16 and of 60 voussoirs that stand.
TEST_CASE("the thinnest arch stands, and a thinner one falls", "[impulses]") {
  for (const auto& [voussoirs, exact] : {std::pair(16, 0.107076), std::pair(60, 0.107448)}) {
    INFO(voussoirs << " voussoirs");
    CHECK(arch_stands(voussoirs, exact * (1 + 1e-4)));
    CHECK_FALSE(arch_stands(voussoirs, exact * (1 - 1e-4)));
  }
}

TEST_CASE("a block rebounds by the coefficient of restitution", "[impulses]") {
  const double fall = std::sqrt(2 / gravity);
  for (const double restitution : {0.0, 0.5, 0.9, 1.0}) {
    INFO("restitution " << restitution);
    Level level(0.3, restitution);
    const hs_block block = level.add(box(-0.5, 1, 0.5, 2));
    double speed = 0;
    while (level.report().time < 1.9 * fall) {
      level.step();
      speed = std::max(speed, level.velocity(block).y);
    }
    // The largest speed after the impact is that at the end of its step.
    const double rebound = restitution * gravity * fall;
    CHECK(speed <= rebound + 1e-9);
    CHECK(speed >= rebound - gravity * frame - 1e-9);
    const hs_energy energy = level.energy();
    const double lost = 1000 * gravity * (1 - restitution * restitution);
    CHECK(energy.kinetic + energy.gravity == Approx(1000 * gravity * 1.5 - lost).epsilon(1e-9));
    CHECK(std::abs(energy.residual) < 1e-9 * 1000 * gravity);
  }
}

TEST_CASE("a bounce without loss returns to its height", "[impulses]") {
  Level level(0, 1);
  const hs_block block = level.add(box(-0.5, 1, 0.5, 2));
  const double fall = std::sqrt(2 / gravity);
  const int steps = int(4 * fall / frame);
  level.step(steps);
  const double time = level.report().time, since_apex = 4 * fall - time;
  CHECK(level.position(block).y == Approx(1.5 - 0.5 * gravity * since_apex * since_apex).epsilon(1e-9));
}

/// The first block's velocity passes from block to block, although a step takes it over several gaps.
TEST_CASE("impacts that are located come one after the other", "[impulses]") {
  hs_world_def def = world_def(frame, 0);
  def.locate_impacts = 1;
  Scene scene(def, hard_law(0, 1), 1000);
  std::vector<hs_block> row;
  for (int i = 0; i < 10; ++i)
    row.push_back(scene.add(box(1.01 * i, 0, 1.01 * i + 1, 1), {HS_BLOCK_RIGID, {i == 0 ? 5.0 : 0, 0}, 0}));
  scene.step(12);
  for (const hs_block block : row)
    CHECK(scene.velocity(block).x == Approx(block == row.back() ? 5 : 0).margin(1e-12));
  CHECK(scene.report().divided_steps > 0);
  CHECK(std::abs(scene.energy().residual) < 1e-12 * scene.energy().kinetic);
}

/// An octagon that strikes with a corner below its centroid slips, so that the spin is known by Coulomb's
/// law.
TEST_CASE("an oblique impact gives the spin of friction", "[impulses]") {
  constexpr double friction = 0.2, down = 2, along = 4, radius = 0.5;
  hs_world_def def = world_def(frame, 0);
  def.locate_impacts = 1;
  Scene scene(def, hard_law(friction, 1), 1000);
  scene.add(box(-10, -2, 10, 0), fixed);
  Points octagon;
  for (int i = 0; i < 8; ++i) {
    const double angle = (i - 2) * pi / 4;
    octagon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const hs_block block = scene.add_at(octagon, {0, radius + 0.02}, 0, {HS_BLOCK_RIGID, {along, -down}, 0});
  scene.step(18);
  const double inertia_over_mass = radius * radius / 6 * (2 + std::cos(pi / 4));
  CHECK(-scene.spin(block) == Approx(2 * friction * down * radius / inertia_over_mass).epsilon(1e-9));
  CHECK(scene.velocity(block).y == Approx(down).epsilon(1e-9));
  CHECK(scene.velocity(block).x == Approx(along - 2 * friction * down).epsilon(1e-9));
}

/// A restored world has the impulses that the next step starts from.
TEST_CASE("a restored world without springs goes on bit for bit", "[impulses]") {
  hs_world_def def = world_def(frame, -gravity);
  def.locate_impacts = 1;
  Scene scene(def, hard_law(0.4, 0.2), 1000);
  scene.add(box(-20, -2, 20, 0), fixed);
  for (int i = 0; i < 20; ++i)
    scene.add_at(box(0, 0, 1, 1), {i % 5 * 1.3, 0.7 + 1.4 * (i / 5)}, 0.1 * (i % 7));
  scene.step(60);
  std::vector<unsigned char> bytes(1 << 20);
  std::size_t size = 0;
  scene.check(hs_world_save(scene.world(), bytes.data(), bytes.size(), &size));
  hs_world* made = nullptr;
  scene.check(hs_world_restore(scene.context(), bytes.data(), size, &made));
  const World restored(made);
  scene.step(30);
  scene.check(hs_world_step(restored.get(), 30));
  for (const hs_block block : scene.blocks()) {
    hs_block_state state;
    scene.check(hs_world_get_block_state(restored.get(), block, &state));
    for (int k = 0; k < 3; ++k) {
      CHECK(state.pose.position[k] == scene.state(block).pose.position[k]);
      CHECK(state.velocity[k] == scene.state(block).velocity[k]);
    }
  }
}

TEST_CASE("solids without springs rest, slide and keep their energy", "[impulses]") {
  SolidScene wall(solid_world_def(frame), hard_law(0.5), 1000);
  wall.add_hull(cuboid({60, 10, 2}), {.position = {0, 0, -1}, .kind = HS_BLOCK_FIXED});
  std::vector<hs_block> bricks;
  for (int row = 0; row < 6; ++row)
    for (int brick = 0; brick < 6; ++brick)
      bricks.push_back(wall.add_hull(cuboid({2, 1, 1}), {.position = {2.0 * brick + row % 2, 0, row + 0.5}}));
  std::vector<Triple> built;
  for (const hs_block brick : bricks) built.push_back(wall.place_of(brick));
  wall.step(60);
  double farthest = 0;
  for (std::size_t i = 0; i < bricks.size(); ++i)
    farthest = std::max(farthest, length(wall.place_of(bricks[i]) - built[i]));
  std::printf("a wall of 36 solid bricks moves by %.1e in a second\n", farthest);
  CHECK(farthest < 1e-8);

  const double slope = 30 * degree, friction = std::tan(20 * degree);
  SolidScene tilted(solid_world_def(frame, {gravity * std::sin(slope), 0, -gravity * std::cos(slope)}),
                    hard_law(friction), 1000);
  tilted.add_hull(cuboid({200, 10, 2}), {.position = {0, 0, -1}, .kind = HS_BLOCK_FIXED});
  const hs_block block = tilted.add_hull(cuboid({1, 1, 1}), {.position = {0, 0, 0.5}});
  tilted.step(60);
  const double exact = 0.5 * gravity * (std::sin(slope) - friction * std::cos(slope));
  CHECK(tilted.place_of(block)[0] == Approx(exact).epsilon(1e-12));
}

/// Iterations do not converge while so many blocks fall upon each other.
TEST_CASE("a heap falls and comes to rest, and goes on from any snapshot", "[impulses]") {
  Level heap(0.5);
  for (const double side : {-1.0, 1.0}) heap.add(box(7 * side - 1, 0, 7 * side + 1, 60), fixed);
  std::mt19937 random(1);
  const auto next = [&] { return double(random()) / double(std::mt19937::max()); };
  for (int i = 0; i < 200; ++i) {
    const int corners = 4 + int(random() % 5);
    const double radius = 0.35 + 0.2 * next();
    std::vector<Point> polygon;
    for (int k = 0; k < corners; ++k)
      polygon.push_back({radius * std::cos(2 * pi * k / corners), radius * std::sin(2 * pi * k / corners)});
    const double angle = 2 * pi * next();
    heap.add_at(polygon, {1.2 * (i % 9 - 4), 0.7 + 1.2 * (i / 9)}, angle);
  }
  const auto energy = [&] { return heap.energy().kinetic + heap.energy().gravity; };
  const double first = energy();
  double before = first, rises = 0;
  std::vector<unsigned char> bytes(1 << 22);
  for (int i = 0; i < 400; ++i) {
    heap.step(1);
    rises += std::max(0.0, energy() - before);
    before = energy();
    if (i % 40 != 0) continue;
    std::size_t size = 0;
    heap.check(hs_world_save(heap.world(), bytes.data(), bytes.size(), &size));
    hs_world* made = nullptr;
    heap.check(hs_world_restore(heap.context(), bytes.data(), size, &made));
    hs_world_destroy(made);
  }
  double depth = 0;
  for (const hs_contact& contact : heap.contacts()) depth = std::max(depth, -contact.gap);
  std::printf(
      "a heap of 200: rises of %.1e of the energy that it lost, overlaps of %.1e m, kinetic energy %.1e J\n",
      rises / (first - before), depth, heap.energy().kinetic);
  CHECK(rises < 1e-4 * (first - before));
  CHECK(depth < 1e-3);
  CHECK(heap.energy().kinetic < 1e-6 * (first - before));
  // What the impulses of a step gain is no loss: the ledger shows these rises.
  CHECK(heap.energy().residual < 1.001 * rises);
  CHECK(heap.energy().residual > 0.5 * rises);
}

TEST_CASE("a wall without springs sleeps where it stands, and wakes when it is hit", "[impulses]") {
  const auto built = [](double sleep_tolerance) {
    hs_world_def def = Level::def_of(0, frame);
    def.sleep_tolerance = sleep_tolerance;
    auto scene = std::make_unique<Scene>(def, hard_law(0.5), 1000);
    scene->add(box(-200, -2, 200, 0), fixed);
    for (int row = 0; row < 8; ++row)
      for (int brick = 0; brick < 8; ++brick) {
        const double x = 2 * brick + row % 2;
        scene->add(box(x, row, x + 2, row + 1));
      }
    return scene;
  };
  const auto awake = built(0), asleep = built(1e-5);
  for (const auto& scene : {awake.get(), asleep.get()}) {
    scene->step(20);
    scene->add(box(7, 30, 9, 31));  // falls on the wall after 2.1 s
    scene->step(120);
  }
  CHECK(asleep->report().sleeping_count == 64);
  CHECK(asleep->contacts().size() == awake->contacts().size());
  for (const auto& scene : {awake.get(), asleep.get()}) scene->step(20);
  CHECK(asleep->report().sleeping_count == 0);
  for (const auto& scene : {awake.get(), asleep.get()}) scene->step(600);
  for (const hs_block block : awake->blocks()) {
    CHECK(asleep->position(block).x == Approx(awake->position(block).x).margin(1e-5));
    CHECK(asleep->position(block).y == Approx(awake->position(block).y).margin(1e-5));
  }
  CHECK(asleep->report().sleeping_count == 65);
  CHECK(asleep->report().max_sleep_error <= 1e-5);
}

TEST_CASE("a sleeping block takes its part of an impact, and a plate that moves wakes it", "[impulses]") {
  hs_world_def def = Level::def_of(0, frame);
  def.sleep_tolerance = 1e-6;
  Scene scene(def, hard_law(0), 1000);
  scene.add(box(-200, -2, 200, 0), fixed);
  const hs_block small = scene.add(box(0, 0, 1, 1)),
                 large = scene.add(box(-16, 0, -12, 1), {HS_BLOCK_RIGID, {3, 0}, 0});
  const hs_block other = scene.add(box(20, 0, 21, 1));
  scene.add(box(29, 0.1, 30, 0.9), {HS_BLOCK_PRESCRIBED, {-1.5, 0}, 0});
  scene.step(192);
  CHECK(scene.report().sleeping_count == 2);
  scene.step(60);
  CHECK(scene.velocity(large).x == Approx(3 * 4.0 / 5).epsilon(1e-9));
  CHECK(scene.velocity(small).x == Approx(3 * 4.0 / 5).epsilon(1e-9));
  scene.step(108);
  CHECK(scene.velocity(other).x == Approx(-1.5).epsilon(1e-9));
  CHECK(std::abs(scene.energy().residual) < 1e-9 * scene.energy().kinetic);
}

/// Rebounds follow each other ever faster until the blocks lie still.
TEST_CASE("impacts of tumbling solids are located without end of the step", "[impulses]") {
  hs_world_def def = solid_world_def(frame);
  def.locate_impacts = 1;
  SolidScene scene(def, hard_law(0.46, 0.2), 1000);
  scene.add_hull(cuboid({20, 20, 2}), {.position = {0, 0, -1}, .kind = HS_BLOCK_FIXED});
  std::mt19937 random(3);
  const auto next = [&] { return double(random()) / double(std::mt19937::max()); };
  for (int i = 0; i < 30; ++i) {
    const Triple size = {0.4 + 0.6 * next(), 0.4 + 0.6 * next(), 0.4 + 0.6 * next()};
    const double angle = 2 * pi * next();
    scene.add_hull(cuboid(size), {.position = {(i % 3 - 1) * 1.5, (i / 3 % 3 - 1) * 1.5, 1.0 + 1.5 * (i / 9)},
                                  .rotation = turn_about({0.6, 0.8, 0}, angle)});
  }
  scene.step(70);
  CHECK(scene.report().divided_steps > 20);
  CHECK(scene.report().max_penetration_ratio < 0.2);
}
