// The program of one engine on walls and heaps of many blocks at steps of 1/60 s: `list` names its cases,
// `run N` prints the cost of one, how far the farthest block has moved, and how deep blocks overlap at the
// end. `walls_and_heaps` runs all and writes the table.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "list_or_run.h"
#include "overlap.h"
#include "trial.h"

namespace halfspace_trade {
namespace {

constexpr double frame = 1.0 / 60;  // s
constexpr int passes = 3;

struct Assembly {
  std::string name;
  Scene scene;
};

Vector up(int dimension, double x) { return dimension == 2 ? Vector{0, x, 0} : Vector{0, 0, x}; }

Body fixed_box(const Vector& size, const Vector& position) {
  Body body;
  body.size = size;
  body.position = position;
  body.is_fixed = true;
  return body;
}

Scene on_plate(int dimension, double width, double depth) {
  Scene scene{.dimension = dimension, .gravity = up(dimension, -gravity), .friction = 0.5};
  const Vector size = dimension == 2 ? Vector{width, 2, 1} : Vector{width, depth, 2};
  scene.bodies.push_back(fixed_box(size, up(dimension, -1)));
  return scene;
}

/// Bricks of 2 by 1 in running bond.
Assembly wall(int dimension, int courses, int bricks) {
  Scene scene = on_plate(dimension, 4 * bricks, 10);
  for (int course = 0; course < courses; ++course) {
    for (int k = 0; k < bricks; ++k) {
      Body brick;
      brick.size = {2, 1, 1};
      brick.position = up(dimension, course + 0.5);
      brick.position[0] = 2 * k - bricks + course % 2;
      scene.bodies.push_back(brick);
    }
  }
  return {"wall of " + std::to_string(courses * bricks), scene};
}

/// A regular polygon of 4 to 8 corners.
Body polygon(std::mt19937& random) {
  const int count = 4 + int(random() % 5);
  const double radius = 0.35 + 0.2 * double(random() % 1024) / 1024;
  Body body;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    body.polygon.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  const double half = M_PI * double(random() % 1024) / 1024;
  body.rotation = {0, 0, std::sin(half), std::cos(half)};
  return body;
}

Body turned_box(std::mt19937& random) {
  Body body;
  for (double& side : body.size) side = 0.55 + 0.3 * double(random() % 1024) / 1024;
  double square = 0;
  for (double& part : body.rotation) {
    part = double(random() % 1024) / 512 - 1 + 1e-3;
    square += part * part;
  }
  for (double& part : body.rotation) part /= std::sqrt(square);
  return body;
}

/// Blocks of many forms fall into a bin, in layers.
Assembly heap(int dimension, int count) {
  const int across = dimension == 2 ? int(1.5 * std::sqrt(count)) : int(1.5 * std::cbrt(count));
  const int per_layer = dimension == 2 ? across : across * across;
  const double spacing = dimension == 2 ? 1.2 : 1.45, width = spacing * across;
  const double height = 2 * spacing * count / per_layer + 2;
  Scene scene = on_plate(dimension, width + 4, width + 4);
  for (const double side : {-1.0, 1.0}) {
    const double at = side * (width / 2 + 1);
    if (dimension == 2) {
      scene.bodies.push_back(fixed_box({2, height, 1}, {at, height / 2, 0}));
    } else {
      scene.bodies.push_back(fixed_box({2, width + 4, height}, {at, 0, height / 2}));
      scene.bodies.push_back(fixed_box({width, 2, height}, {0, at, height / 2}));
    }
  }
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i) {
    Body body = dimension == 2 ? polygon(random) : turned_box(random);
    const int layer = i / per_layer, k = i % per_layer;
    body.position = up(dimension, spacing * (layer + 0.6));
    body.position[0] = spacing * (k % across - (across - 1) / 2.0);
    if (dimension == 3) body.position[1] = spacing * (k / across - (across - 1) / 2.0);
    scene.bodies.push_back(body);
  }
  scene.duration = 5;
  return {"heap of " + std::to_string(count), scene};
}

struct Case {
  Assembly assembly;
  Setting setting;
};

std::vector<Case> cases() {
  std::vector<Assembly> assemblies = {wall(2, 10, 10), wall(2, 30, 33), wall(2, 50, 60), wall(3, 10, 10),
                                      wall(3, 20, 20), wall(3, 30, 33), heap(2, 1000),   heap(3, 1000)};
  std::vector<Case> all;
  for (const Assembly& assembly : assemblies)
    for (const Setting& setting : settings())
      if (knows_dimension(assembly.scene.dimension) && setting.indentation == 0 && setting.step == frame)
        all.push_back({assembly, setting});
  return all;
}

void print_name(const Case& c) {
  std::printf("%s|%d|%s|%s", c.assembly.name.c_str(), c.assembly.scene.dimension, engine_name(),
              c.setting.way.c_str());
}

double distance(const Vector& p, const Vector& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

void run(const Case& c) {
  const Scene& scene = c.assembly.scene;
  double least = HUGE_VAL, farthest = 0, overlap = 0;
  for (int pass = 0; pass < passes; ++pass) {
    Trial trial(c.setting);
    Trial::Run run = trial.start(scene);
    run.finish();
    least = std::min(least, trial.cpu_seconds());
    if (pass > 0) continue;
    std::vector<Body> bodies = scene.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].is_fixed) continue;
      const State state = run.state(i);
      farthest = std::max(farthest, distance(state.position, bodies[i].position));
      bodies[i].position = state.position;
      bodies[i].rotation = state.rotation;
    }
    overlap = mean_overlap(bodies, scene.dimension);
  }
  std::size_t blocks = 0;
  for (const Body& body : scene.bodies) blocks += !body.is_fixed;
  print_name(c);
  std::printf("|%.3g|%.2g|%.2g\n", 1e6 * least * frame / scene.duration / double(blocks), farthest, overlap);
}

}  // namespace
}  // namespace halfspace_trade

int main(int argc, char** argv) {
  using namespace halfspace_trade;
  return list_or_run(argc, argv, cases, print_name, run);
}
