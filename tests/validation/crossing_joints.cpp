// Rows of blocks between joints that cross: the corners of all meet at once, before any block rests on
// another.

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

constexpr double along = 3, down = -9.81;

void run_scene(Scene& scene, double duration) {
  const double end = scene.report().time + duration;
  while (scene.report().time < end) scene.step(20);
}

/// Two rows of bricks, the lower one fixed. Each joint between bricks is straight through both rows.
class Rows {
 public:
  Rows(int dimension, int32_t kind, double lean)
      : dimension_(dimension), scene_(def_in(dimension), law_of(kind), 2500) {
    for (int i = 0; i < 8; ++i) add(i - 4, i - 3, -1, lean, HS_BLOCK_FIXED);
    stop_ = add(2, 3, 0, lean, HS_BLOCK_FIXED);
    for (int i = 0; i < 4; ++i) row_.push_back(add(i - 2, i - 1, 0, lean, HS_BLOCK_RIGID));
  }

  void remove_stop() { scene_.check(hs_world_remove_block(scene_.world(), stop_)); }
  void run(double duration) { run_scene(scene_, duration); }
  double time() const { return scene_.report().time; }
  /// The row also spreads, as its joints open.
  double mean_place() const {
    double sum = 0;
    for (const hs_block brick : row_) sum += scene_.state(brick).pose.position[0];
    return sum / double(row_.size());
  }
  double residual() const { return scene_.energy().residual; }
  double kinetic() const { return scene_.energy().kinetic; }

 private:
  static hs_world_def def_in(int dimension) {
    hs_world_def def = solid_world_def(0, {along, dimension == 2 ? down : 0, dimension == 2 ? 0 : down});
    def.dimension = dimension;
    return def;
  }
  static hs_law_def law_of(int32_t kind) {
    hs_law_def law = spring_law(1e9);
    law.stiffness_kind = kind;
    law.normal_damping = 0.3;
    return law;
  }

  hs_block add(double left, double right, double low, double lean, int32_t kind) {
    const double high = low + 1;
    const Points face{{left + lean * low, low},
                      {right + lean * low, low},
                      {right + lean * high, high},
                      {left + lean * high, high}};
    if (dimension_ == 2) return scene_.add(face, {kind, {}, 0});
    Corners corners;
    for (const Point& p : face) {
      for (const double y : {0.0, 1.0}) corners.push_back({p.x, y, p.y});
    }
    return scene_.add_hull_in_place(corners, kind);
  }

  int dimension_;
  SolidScene scene_;
  hs_block stop_ = 0;
  std::vector<hs_block> row_;
};

void slide(int dimension) {
  for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    for (const double lean : {0.0, 0.2, -0.2}) {
      INFO(dimension << "D, " << name_of_stiffness(kind) << ", lean " << lean);
      Rows rows(dimension, kind, lean);
      rows.run(0.3);  // all joints close
      rows.remove_stop();
      const double start = rows.time(), place = rows.mean_place();
      rows.run(0.5);
      const double expected = 0.5 * along * square_of(rows.time() - start);
      CHECK(rows.mean_place() - place == Approx(expected).epsilon(5e-3));
      CHECK(std::abs(rows.residual()) < 1e-4 * rows.kinetic());
    }
  }
}

/// A course of free bricks between walls, on bedrock. What slides over it has material 1, without friction.
class Course {
 public:
  Course(int32_t kind, int bricks) : scene_(world_def(0), law_of(kind, 0.6), 2000) {
    scene_.add_material(2000);
    const hs_law_def smooth = law_of(kind, 0);
    scene_.check(hs_world_set_law(scene_.world(), 0, 1, &smooth));
    scene_.add(box(-1, -2, bricks + 1, -1), {HS_BLOCK_FIXED, {}, 0});
    scene_.add(box(-1, -1, 0, -0.1), {HS_BLOCK_FIXED, {}, 0});
    scene_.add(box(bricks, -1, bricks + 1, -0.1), {HS_BLOCK_FIXED, {}, 0});
    for (int i = 0; i < bricks; ++i) course_.push_back(scene_.add(box(i, -1, i + 1, 0)));
    run(0.15);
  }

  Scene& scene() { return scene_; }
  const std::vector<hs_block>& course() const { return course_; }
  void run(double duration) { run_scene(scene_, duration); }

 private:
  static hs_law_def law_of(int32_t kind, double friction) {
    hs_law_def law = spring_law(1e9, std::atan(friction));
    law.stiffness_kind = kind;
    law.normal_damping = law.shear_damping = 0.3;
    return law;
  }

  Scene scene_;
  std::vector<hs_block> course_;
};

}  // namespace

TEST_CASE("a row of blocks slides over a row cut by the same joints in the plane") { slide(2); }

TEST_CASE("a row of blocks slides over a row cut by the same joints in space") { slide(3); }

/// Both blocks are pressed against the wall. It overlaps both alike, which tells nothing about their contact.
/// Per area the tip sinks by less than it is wide: one that sinks deeper leaves by the end of the block.
TEST_CASE("a tip stands on the end of a block beside a wall that presses on both") {
  constexpr double bearing = 2e-4;
  for (const auto& [kind, stiffness] :
       {std::pair(HS_STIFFNESS_PER_CONTACT, 1e7), std::pair(HS_STIFFNESS_PER_AREA, 1e12)}) {
    INFO(name_of_stiffness(kind));
    hs_law_def law = spring_law(stiffness);
    law.stiffness_kind = kind;
    law.normal_damping = 0.3;
    hs_world_def def = world_def(0);
    def.gravity[0] = 2 * 9.81;
    Scene scene(def, law, 2500);
    scene.add(box(-2, -1, 0, 0), {HS_BLOCK_FIXED, {}, 0});
    scene.add(box(0, -1, 2, 4), {HS_BLOCK_FIXED, {}, 0});
    scene.add(box(-0.1, 0, 0, 1));
    const hs_block tip = scene.add(Points{{-bearing, 1}, {0, 1 + 20 * bearing}, {0, 2}, {-0.2, 1.5}});
    const double start = scene.position(tip).y;
    while (scene.report().time < 1) scene.step(100);
    CHECK(scene.position(tip).y > start - 0.01);
    CHECK(std::abs(scene.velocity(tip).y) < 1e-3);
  }
}

/// Corners of triangles meet at the overlap of the moment, which makes energy per contact
/// (docs/concepts/contact.md) and none per area.
TEST_CASE("a wall of triangles that slides apart keeps its energy per area") {
  constexpr int width = 4, height = 3;
  for (const double jitter : {0.0, 0.05, 0.15}) {
    INFO("jitter " << jitter);
    hs_law_def law = spring_law(1e9);
    law.stiffness_kind = HS_STIFFNESS_PER_AREA;
    law.normal_damping = 0.3;
    hs_world_def def = world_def(0);
    def.gravity[0] = along;
    Scene scene(def, law, 2500);
    scene.add(box(-1, -1, width + 3, 0), {HS_BLOCK_FIXED, {}, 0});
    scene.add(box(width, 0, width + 1, height), {HS_BLOCK_FIXED, {}, 0});
    const auto node = [&](int i, int j) {
      const bool is_inner_x = i > 0 && i < width;
      const bool is_inner_y = j > 0 && j < height;
      return Point{i + (is_inner_x ? jitter * std::sin(3 * i + 5 * j) : 0),
                   j + (is_inner_y ? jitter * std::cos(4 * i + 2 * j) : 0)};
    };
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j < height; ++j) {
        const Point a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
        const bool is_odd = (i + j) % 2 == 1;
        scene.add(is_odd ? Points{a, b, c} : Points{a, b, d});
        scene.add(is_odd ? Points{a, c, d} : Points{b, c, d});
      }
    }
    while (scene.report().time < 0.2) scene.step(100);
    const hs_energy energy = scene.energy();
    CHECK(std::abs(energy.residual) < 1e-4 * (energy.kinetic + energy.contact_damping_loss));
  }
}

/// The brick ahead stands higher, since none loads it, and its side is pressed as little as it is crossed.
TEST_CASE("bricks slide over a course of free bricks with the same joints") {
  for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    INFO(name_of_stiffness(kind));
    Course course(kind, 6);
    std::vector<hs_block> bricks;
    for (int i = 0; i < 3; ++i) bricks.push_back(course.scene().add(box(i, 0, i + 1, 1), {}, 1));
    course.run(0.15);
    constexpr double push = 5;
    for (const hs_block brick : bricks)
      course.scene().apply(brick, {push * course.scene().state(brick).mass, 0});
    const double start = course.scene().report().time, place = course.scene().position(bricks[0]).x;
    course.run(0.5);
    const double expected = 0.5 * push * square_of(course.scene().report().time - start);
    CHECK(course.scene().position(bricks[0]).x - place == Approx(expected).epsilon(1e-2));
  }
}

/// The joint ahead is pressed much deeper than the slider is overlapped.
TEST_CASE("a block slides over a joint that is pressed") {
  for (const double press : {1.0, 1e5}) {
    INFO(press << " N");
    Course course(HS_STIFFNESS_PER_CONTACT, 2);
    course.scene().apply(course.course()[1], {-press, 0});
    const hs_block slider = course.scene().add(box(0.1, 0, 0.9, 0.5), {}, 1);
    course.run(0.1);
    course.scene().set_velocity(slider, {2, 0});
    course.run(0.3);
    CHECK(course.scene().velocity(slider).x == Approx(2).epsilon(1e-3));
  }
}

TEST_CASE("contacts at corners are reported within Coulomb's law in each step") {
  constexpr double friction = 0.2;
  hs_law_def law = spring_law(1e9, std::atan(friction));
  law.normal_damping = 0.3;
  hs_world_def def = world_def(0);
  def.gravity[0] = along;
  Scene scene(def, law, 2500);
  for (int i = -4; i < 8; ++i) scene.add(box(i, -1, i + 1, 0), {HS_BLOCK_FIXED, {}, 0});
  for (int i = 0; i < 3; ++i) scene.add(box(i, 0, i + 1, 1));
  for (int step = 0; step < 8000; ++step) {
    scene.step();
    for (const hs_contact& c : scene.contacts()) {
      const double normal = c.force[0] * c.normal[0] + c.force[1] * c.normal[1];
      const double shear = std::abs(c.force[0] * c.normal[1] - c.force[1] * c.normal[0]);
      if (shear > friction * normal + 1e-3)
        FAIL("step " << step << ": " << shear << " N on " << normal << " N");
    }
  }
  SUCCEED();
}
