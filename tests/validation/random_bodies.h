#pragma once

// Random blocks above a bin, for tests that let them fall, and the worlds they are in.

#include <random>

#include "validation/solid_scene.h"

namespace halfspace_test {

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
    for (const Body& body : bodies) add(dimension, body);
  }

  hs_block add(int dimension, const Body& body) {
    const SolidStart start{body.position, body.rotation, body.kind, {}, {}};
    blocks_.push_back(dimension == 3 ? add_hull(body.corners, start) : add_flat(body));
    return blocks_.back();
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

inline Corners flat(double width, double height) {
  Corners corners;
  for (const Point& p : rectangle(width, height)) corners.push_back({p.x, p.y, 0});
  return corners;
}

/// A bin: its floor at height 0, and walls.
inline Bodies bin(int dimension, double width) {
  const double half = 0.5 * width, tall = 90;
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

inline Body random_body(int dimension, Random& random) {
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

/// Random blocks on a grid above the floor of a bin, so many to a side and so many layers.
inline Bodies loose(int dimension, int across, int layers, Random& random) {
  const double cell = 1.3;
  Bodies all = bin(dimension, across * cell);
  const int in_layer = dimension == 2 ? across : across * across;
  for (int i = 0; i < in_layer * layers; ++i) {
    Body body = random_body(dimension, random);
    const auto place = [&](int index) { return (index % across + 0.5 - 0.5 * across) * cell; };
    const int layer = i / in_layer;
    if (dimension == 2) {
      body.position = {place(i), (layer + 0.5) * cell, 0};
    } else {
      body.position = {place(i), place(i / across), (layer + 0.7) * cell};
    }
    all.push_back(body);
  }
  return all;
}

}  // namespace halfspace_test
