// Boundary segments (Zheng et al. 2020, section 3.3): blocks rest on them as on a fixed polygon, and what
// crosses the joint of two in line moves on as on one, but for what is derived below.

#include <functional>

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double gravity = 9.81;
constexpr double density = 2000;
constexpr double width = 1;  // of a square block
constexpr double weight = density * width * width * gravity;
constexpr double mass = density * width * width;

hs_world_def world(double time_step) {
  hs_world_def def = world_def(time_step);
  def.potential_length = 1;
  return def;
}

hs_law_def law_of(int32_t kind, double stiffness) {
  hs_law_def law = kind == HS_STIFFNESS_POTENTIAL ? potential_law(stiffness) : spring_law(stiffness);
  law.stiffness_kind = kind;
  return law;
}

/// Springs carry the weight with k d, spread over the base or not. Of potentials, with H = 1 m, the segment
/// pushes with k b d, and the block, in which the triangles along its sides are nearer to these, with
/// k (b d - d^2).
double rest_depth(int32_t kind, double stiffness) {
  if (kind == HS_STIFFNESS_PER_CONTACT) return weight / stiffness;
  if (kind == HS_STIFFNESS_PER_AREA) return weight / (stiffness * width);
  return width - std::sqrt(square_of(width) - weight / stiffness);
}

/// A floor at y = 0 in one piece, in two that meet at x = 0, or as a polygon of its own.
void add_whole(Scene& scene) { scene.add_boundary({{20, 0}, {-20, 0}}, 1); }
void add_in_two(Scene& scene) { scene.add_boundary({{20, 0}, {0, 0}, {-20, 0}}, 1); }
void add_polygon(Scene& scene) { scene.add(box(-20, -1, 20, 0), {HS_BLOCK_FIXED, {}, 0}); }

TEST_CASE("a block that drops onto a boundary segment comes to rest where its law says") {
  constexpr double stiffness = 1e8, drop = 0.01;
  constexpr int steps = 20000;
  for (int32_t kind : all_stiffness_kinds) {
    hs_law_def law = law_of(kind, stiffness);
    law.normal_damping = 0.5;  // of what is left after 2 s nothing is above rounding
    const double expected = rest_depth(kind, stiffness);
    for (const auto& add_floor : {add_whole, add_polygon}) {
      Scene scene(world(1e-4), law, density);
      add_floor(scene);
      const hs_block block = scene.add(box(-0.3, drop, 0.7, 1 + drop));
      scene.step(steps);
      const double depth = width / 2 - scene.position(block).y;
      std::printf("boundary, %s: depth at rest %.15g m, expected %.15g m\n", name_of_stiffness(kind), depth,
                  expected);
      // Of the block's and the floor's vertices about their own centroids, and of the height.
      CHECK(std::abs(depth - expected) <= 8 * rounding);
      CHECK(std::abs(scene.position(block).x - 0.2) <= steps * rounding);
    }
  }
}

/// A block at rest on its law, without friction, slides towards +x; its front starts this far before x = 0.
struct Crossing {
  Scene scene;
  hs_block block;

  Crossing(const std::function<void(Scene&)>& add_floor, int32_t kind, double stiffness, double time_step,
           double speed, double ahead)
      : scene(world(time_step), law_of(kind, stiffness), density) {
    add_floor(scene);
    const double depth = rest_depth(kind, stiffness);
    block = scene.add(box(-ahead - width, -depth, -ahead, width - depth), {HS_BLOCK_RIGID, {speed, 0}, 0});
  }
  double speed() const { return scene.velocity(block).x; }
};

/// Behind a joint the depths of both segments add up to that of one, but for the block's own potential both
/// polygons are there: in the triangle between their flanks, d/tan(60) wide on either side at the surface and
/// d high, where a point of height z above the base has the potential k z. The block is slowed down by the
/// energy k d^3 / (3 tan(60)) as it comes over the joint, and gets it back as it leaves.
TEST_CASE("by potentials a block crosses the joint of two boundary segments as one") {
  constexpr double stiffness = 1e6, speed = 1;
  const double depth = rest_depth(HS_STIFFNESS_POTENTIAL, stiffness);
  const double barrier = stiffness * depth * depth * depth / (3 * std::sqrt(3.0));
  Crossing one(add_whole, HS_STIFFNESS_POTENTIAL, stiffness, 1e-5, speed, 0.5);
  Crossing two(add_in_two, HS_STIFFNESS_POTENTIAL, stiffness, 1e-5, speed, 0.5);
  double farthest_up = 0;
  const auto go = [&](int steps) {
    for (int i = 0; i < steps; i += 100) {
      one.scene.step(100);
      two.scene.step(100);
      farthest_up =
          std::max(farthest_up, std::abs(one.scene.position(one.block).y - two.scene.position(two.block).y));
    }
  };
  go(100000);  // the middle of the block is on the joint
  const double lost = mass / 2 * (square_of(one.speed()) - square_of(two.speed()));
  go(100000);  // and all of it is behind
  const double kept = mass / 2 * (square_of(one.speed()) - square_of(two.speed()));
  // The push k d^2 / tan(60) of that triangle lifts and tilts the block; let go at once it swings, with up to
  // four times the energy that it has at rest: F^2 / (2 K) as it is lifted and three times that as it is
  // tilted by its end. All of it when it comes and again when it leaves.
  const double push = stiffness * depth * depth / std::sqrt(3.0), lift = push / (2 * stiffness * width);
  const double swing = 2 * 4 * (1 + 3) * push * lift / 2;
  std::printf(
      "boundary, potential: over the joint %.4g J slower, expected %.4g J; behind it %.1e J, at most "
      "%.1e J; up or down %.1e of the depth\n",
      lost, barrier, kept, swing, farthest_up / depth);
  CHECK(std::abs(lost - barrier) <= swing);
  CHECK(std::abs(kept) <= swing);
  CHECK(farthest_up <= 2 * (1 + 3) * lift);
}

/// By springs the front corner, d deep, meets the flank of the second segment under the surface and stays on
/// it until its foot is at the flank's upper end: then it is d / cos(60) deep in it, and the contact moves on
/// to the segment. Per contact a corner has half of the stiffness, which takes k (2 d)^2 / 4 of the motion
/// along. Per area the corner has a triangle behind the flank that is 2 d (tan(30) + tan(60)) wide:
/// k (2 d)^2 / 6 times that, when it is all on the flank. The block crosses so fast that it has no time to
/// rise, and leaves the flank up to one step late. Sooner, where a question about contacts at corners turns
/// it to the segment's face.
TEST_CASE("by springs the joint of two boundary segments takes no more than it must") {
  constexpr double stiffness = 1e8, speed = 4;
  for (int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    const double depth = rest_depth(kind, stiffness), time_step = depth / speed / 200;
    Crossing crossing(add_in_two, kind, stiffness, time_step, speed, 0.6 * depth);
    crossing.scene.step(200 * 3);
    const double lost = mass / 2 * (square_of(speed) - square_of(crossing.speed()));
    const double triangle = 2 * depth * (1 / std::sqrt(3.0) + std::sqrt(3.0));
    const bool per_contact = kind == HS_STIFFNESS_PER_CONTACT;
    const double most = 2 * stiffness * square_of(depth) * (per_contact ? 0.5 : triangle / 3);
    std::printf("boundary, %s: the joint takes %.4g J of %.4g J, at most %.4g J\n", name_of_stiffness(kind),
                lost, mass / 2 * square_of(speed), most);
    const double late = 2 * stiffness * depth * std::sin(pi / 3) * speed * time_step;
    CHECK(lost > 0);
    CHECK(lost <= most + late);
  }
}

/// A block slides down a slope and on over level ground, where its front corner comes deep under the slope's
/// surface: it must meet the ground and not the flank of the polygon behind it. The same with two segments
/// that reach on behind each other has no joint. What the flank may take until the corner has left it, 4 d /
/// sqrt(3) on: the energy of a spring as above, and the work of its dashpot against the speed.
TEST_CASE("a hollow in a boundary catches nothing") {
  constexpr double stiffness = 1e8, damping = 0.3, height = 0.5, speed = 5, duration = 1, time_step = 2e-5;
  constexpr double slider = density * width * height;
  for (int32_t kind : all_stiffness_kinds) {
    hs_law_def law = law_of(kind, stiffness);
    law.normal_damping = damping;
    for (double bend : {3., 10., 27., 45., 75.}) {
      const Point up{-std::cos(bend * degree), std::sin(bend * degree)}, normal{up.y, -up.x};
      const double depth = slider * gravity * normal.y / stiffness;
      const auto speed_behind = [&](const std::function<void(Scene&)>& add_ground) {
        Scene scene(world(time_step), law, density);
        add_ground(scene);
        const double rise = height / 2 - depth;
        const hs_block block =
            scene.add_at(rectangle(width, height), {2 * up.x + rise * normal.x, 2 * up.y + rise * normal.y},
                         -bend * degree, {HS_BLOCK_RIGID, {-speed * up.x, -speed * up.y}, 0});
        scene.step(std::int64_t(duration / time_step));
        return scene.velocity(block).x;
      };
      const double jointed = speed_behind([&](Scene& scene) {
        scene.add_boundary({{30, 0}, {0, 0}, {20 * up.x, 20 * up.y}}, 1);
      });
      const double crossing = speed_behind([&](Scene& scene) {
        scene.add_boundary({{30, 0}, {-2, 0}}, 1);
        scene.add_boundary({{-2 * up.x, -2 * up.y}, {20 * up.x, 20 * up.y}}, 1);
      });
      const double fastest = std::sqrt(square_of(speed) + 2 * gravity * (2 * up.y + height));
      const double dashpot = 2 * damping * std::sqrt(stiffness * slider);
      const double most = 2 * stiffness * square_of(depth) +
                          dashpot * fastest * square_of(std::sin(pi / 3)) * 4 / std::sqrt(3.0) * depth;
      const double lost = slider / 2 * (square_of(crossing) - square_of(jointed));
      std::printf(
          "boundary, %s, hollow of %.0f degrees: on at %.4f m/s, without a joint at %.4f m/s: %.3g J, at "
          "most %.3g J\n",
          name_of_stiffness(kind), bend, jointed, crossing, lost, most);
      CHECK(std::abs(lost) <= most);
    }
  }
}

}  // namespace
