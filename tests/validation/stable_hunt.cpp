// Hunts for scenes that gain energy at 0.95 of the stable time step that they report: piles of random blocks,
// stacks and walls, in the plane and in space, by every law, damped or not, on stiff springs and on soft
// ones.

#include <random>

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

struct Body {
  Corners corners;  // in the plane z is 0
  Triple position;
  Quaternion rotation{0, 0, 0, 1};
  int32_t kind = HS_BLOCK_RIGID;
};
using Bodies = std::vector<Body>;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double from, double to) {
    return from + (to - from) * double(engine_()) / 4294967296.0;  // the same on every platform
  }

 private:
  std::mt19937 engine_;
};

class BodyScene : public SolidScene {
 public:
  BodyScene(int dimension, const hs_world_def& def, const hs_law_def& law, const Bodies& bodies)
      : SolidScene(def, law) {
    for (const Body& body : bodies) {
      const SolidStart start{body.position, body.rotation, body.kind, {}, {}};
      blocks_.push_back(dimension == 3 ? add_hull(body.corners, start) : add_flat(body));
    }
  }

  /// Sets all that is free to move in some motion.
  void shake(Random& random, double speed) {
    for (const hs_block block : blocks_) {
      if (state(block).kind == HS_BLOCK_FIXED) continue;
      double v[3] = {}, w[3] = {};
      for (double* x : {v, w})
        for (int k = 0; k < 3; ++k) x[k] = random.uniform(-speed, speed);
      check(hs_world_set_velocity(world(), block, v, w));
    }
  }

  /// The same bodies where they are now.
  Bodies moved(Bodies bodies) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const hs_pose pose = state(blocks_[i]).pose;
      bodies[i].position = triple(pose.position);
      bodies[i].rotation = {pose.rotation[0], pose.rotation[1], pose.rotation[2], pose.rotation[3]};
    }
    return bodies;
  }

 private:
  hs_block add_flat(const Body& body) {
    Points points;
    for (const Triple& c : body.corners) points.push_back({c[0], c[1]});
    const double turn = 2 * std::atan2(body.rotation[2], body.rotation[3]);
    return add_at(points, {body.position[0], body.position[1]}, turn, {body.kind, {}, 0});
  }

  std::vector<hs_block> blocks_;
};

hs_world_def def_of(int dimension, double time_step, double local_damping) {
  hs_world_def def = dimension == 3 ? solid_world_def(time_step) : world_def(time_step);
  def.local_damping = local_damping;
  return def;
}

Corners flat(double width, double height) {
  Corners corners;
  for (const Point& p : rectangle(width, height)) corners.push_back({p.x, p.y, 0});
  return corners;
}

/// A bin: its floor at height 0, and walls.
Bodies bin(int dimension, double width) {
  const double half = 0.5 * width, tall = 30;
  if (dimension == 2)
    return {{flat(width + 4, 1), {0, -0.5, 0}, {0, 0, 0, 1}, HS_BLOCK_FIXED},
            {flat(1, tall), {-half - 0.5, tall / 2, 0}, {0, 0, 0, 1}, HS_BLOCK_FIXED},
            {flat(1, tall), {half + 0.5, tall / 2, 0}, {0, 0, 0, 1}, HS_BLOCK_FIXED}};
  Bodies all{{cuboid({width + 4, width + 4, 1}), {0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED}};
  for (const double side : {-half - 0.5, half + 0.5}) {
    all.push_back({cuboid({1, width + 4, tall}), {side, 0, tall / 2}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
    all.push_back({cuboid({width + 4, 1, tall}), {0, side, tall / 2}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
  }
  return all;
}

Body random_body(int dimension, Random& random) {
  Body body;
  const double size = random.uniform(0.3, 0.55);
  if (dimension == 2) {
    const int count = int(random.uniform(3, 8));
    for (int i = 0; i < count; ++i) {
      const double turn = 2 * pi * (i + random.uniform(-0.2, 0.2)) / count;
      body.corners.push_back({size * std::cos(turn), size * std::sin(turn), 0});
    }
    const double turn = random.uniform(0, pi);
    body.rotation = {0, 0, std::sin(turn), std::cos(turn)};
    return body;
  }
  // A cuboid of which each corner is moved: its faces break up into triangles, some of them nearly level.
  body.corners = cuboid({2 * size, random.uniform(1, 2) * size, random.uniform(1, 2) * size});
  for (Triple& corner : body.corners)
    for (double& x : corner) x += random.uniform(-0.05, 0.05);
  body.rotation = turn_about({random.uniform(-1, 1), random.uniform(-1, 1), 1.1}, random.uniform(0, 2 * pi));
  return body;
}

/// Random blocks on a grid above the floor of a bin.
Bodies loose(int dimension, Random& random) {
  const int across = dimension == 2 ? 5 : 2, count = dimension == 2 ? 25 : 16;
  const double cell = 1.3;
  Bodies all = bin(dimension, across * cell);
  for (int i = 0; i < count; ++i) {
    Body body = random_body(dimension, random);
    const auto place = [&](int index) { return (index % across + 0.5 - 0.5 * across) * cell; };
    if (dimension == 2) {
      body.position = {place(i), (i / across + 0.5) * cell, 0};
    } else {
      body.position = {place(i), place(i / across), (i / (across * across) + 0.7) * cell};
    }
    all.push_back(body);
  }
  return all;
}

/// Bricks in courses, each half a brick on from the one below; with one to a course a stack.
Bodies wall(int dimension, int bricks) {
  Bodies all{dimension == 2 ? Body{flat(40, 1), {0, -0.5, 0}, {0, 0, 0, 1}, HS_BLOCK_FIXED}
                            : Body{cuboid({40, 40, 1}), {0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED}};
  for (int course = 0; course < 5; ++course) {
    for (int i = 0; i < bricks; ++i) {
      const double x = i + (bricks > 1 ? 0.5 * (course % 2) : 0), y = 0.25 + 0.5 * course;
      all.push_back(dimension == 2 ? Body{flat(1, 0.5), {x, y, 0}} : Body{cuboid({1, 1, 0.5}), {x, 0, y}});
    }
  }
  return all;
}

double mechanical(const hs_energy& e) { return e.kinetic + e.strain + e.gravity; }

/// Bodies that have come to lie, under a law.
struct Settled {
  int dimension;
  hs_law_def law;
  Bodies bodies;
  double stable_time_step;
};

Settled settled(int dimension, const Bodies& start, const hs_law_def& law, double settling_time) {
  hs_law_def damped = law;
  damped.normal_damping = damped.shear_damping = 0.1;
  BodyScene settling(dimension, def_of(dimension, 0, 0.5), damped, start);
  settling.step(std::int64_t(settling_time / settling.report().time_step));
  const Bodies bodies = settling.moved(start);
  return {dimension, law, bodies,
          BodyScene(dimension, def_of(dimension, 0, 0), law, bodies).report().stable_time_step};
}

/// Makes a world of them anew and runs it at a share of its stable step. Returns what mechanical energy it
/// has gained, over what its springs held.
double gained(const Settled& scene_of, double share) {
  constexpr int steps = 2000;
  const double time_step = share * scene_of.stable_time_step;
  BodyScene scene(scene_of.dimension, def_of(scene_of.dimension, time_step, 0), scene_of.law,
                  scene_of.bodies);
  Random random(11);
  scene.shake(random, 0.02);
  scene.step(1);
  const hs_energy before = scene.energy();
  double most = 0;
  for (int i = 0; i < 10; ++i) {
    if (hs_world_step(scene.world(), steps / 10) != HS_OK) return HUGE_VAL;
    most = std::max(most, mechanical(scene.energy()) - mechanical(before));
  }
  return most / (before.strain + before.kinetic);
}

hs_law_def law_of(int32_t stiffness_kind, double stiffness, double damping) {
  hs_law_def law = stiffness_kind == HS_STIFFNESS_POTENTIAL ? potential_law(stiffness, 30 * degree, stiffness)
                                                            : spring_law(stiffness, 30 * degree);
  law.stiffness_kind = stiffness_kind;
  law.normal_damping = law.shear_damping = damping;
  return law;
}

/// Of what the springs hold. Friction on undamped springs feeds vibration a little, at any time step; where
/// the step is too large some of these scenes gain three times as much and more.
constexpr double most_gained = 0.05;

TEST_CASE("no scene gains energy at 0.95 of the stable time step that it reports") {
  Random random(7);
  for (const int dimension : {2, 3}) {
    for (const int32_t kind : all_stiffness_kinds) {
      double most = 0;
      for (const double damping : {0.0, 0.1}) {
        for (const double stiffness : {1e6, 1e7}) {  // the weight of a block is some 1e4 N
          const auto hunt = [&](const char* name, const Bodies& bodies, double settling_time) {
            const hs_law_def law = law_of(kind, stiffness, damping);
            const double gain = gained(settled(dimension, bodies, law, settling_time), 0.95);
            if (gain > most_gained)
              std::printf("%s in %dD, %s, damping %.1f, stiffness %.0e: gains %.2e\n", name, dimension,
                          name_of_stiffness(kind), damping, stiffness, gain);
            most = std::max(most, gain);
          };
          hunt("pile", loose(dimension, random), 5);
          hunt("pile", loose(dimension, random), 5);
          hunt("stack", wall(dimension, 1), 4);
          hunt("wall", wall(dimension, 4), 4);
        }
      }
      std::printf("hunt in %dD, %s: at 0.95 of the stable step at most %.1e of the springs' energy gained\n",
                  dimension, name_of_stiffness(kind), most);
      CHECK(most <= most_gained);
    }
  }
}

/// The least multiple of the stable step, in steps of a tenth, at which a scene gains energy or ends as
/// unstable; at most 10.
double breaking_share(const Settled& scene) {
  double share = 1;
  while (share < 10 && gained(scene, share) <= most_gained) share *= 1.1;
  return share;
}

TEST_CASE("how far above the stable time step scenes break", "[.][breaking]") {
  for (const int dimension : {2, 3}) {
    for (const int32_t kind : all_stiffness_kinds) {
      for (const double damping : {0.0, 0.1}) {
        Random random(7);
        const hs_law_def law = law_of(kind, 1e7, damping);
        const auto breaks = [&](const Bodies& bodies, double settling_time) {
          return breaking_share(settled(dimension, bodies, law, settling_time));
        };
        const double pile = breaks(loose(dimension, random), 5);
        const double stack = breaks(wall(dimension, 1), 4), of_wall = breaks(wall(dimension, 4), 4);
        std::printf("breaking in %dD, %s, damping %.1f: pile %.1f, stack %.1f, wall %.1f\n", dimension,
                    name_of_stiffness(kind), damping, pile, stack, of_wall);
      }
    }
  }
}

}  // namespace
