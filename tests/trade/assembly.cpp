#include "assembly.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace halfspace_trade {
namespace {

Vector up(int dimension, double x) { return dimension == 2 ? Vector{0, x, 0} : Vector{0, 0, x}; }

Body fixed_box(const Vector& size, const Vector& position) {
  Body body;
  body.size = size;
  body.position = position;
  body.is_fixed = true;
  return body;
}

Scene on_plate(int dimension, double width, double depth) {
  Scene scene{.dimension = dimension, .gravity = up(dimension, -gravity), .friction = 0.5, .duration = 5};
  const Vector size = dimension == 2 ? Vector{width, 2, 1} : Vector{width, depth, 2};
  scene.bodies.push_back(fixed_box(size, up(dimension, -1)));
  return scene;
}

/// A box of 1 by 1 in the plane of the wall's length and height.
void put_brick(Scene& scene, double length, double along, int course) {
  Body brick;
  brick.size = {length, 1, 1};
  brick.position = up(scene.dimension, course + 0.5);
  brick.position[0] = along;
  scene.bodies.push_back(brick);
}

std::string counted(const std::string& what, const Scene& scene) {
  const auto is_free = [](const Body& body) { return !body.is_fixed; };
  return what + " of " + std::to_string(std::count_if(scene.bodies.begin(), scene.bodies.end(), is_free));
}

Assembly stack(int dimension, int count) {
  Scene scene = on_plate(dimension, 10, 10);
  for (int i = 0; i < count; ++i) put_brick(scene, 1, 0, i);
  return {counted("stack", scene), scene};
}

/// Bricks of 2 by 1 in running bond. Every other course ends with half bricks, so that no brick overhangs.
Assembly wall(int dimension, int courses, int bricks) {
  Scene scene = on_plate(dimension, 4 * bricks, 10);
  for (int course = 0; course < courses; ++course) {
    const bool is_shifted = course % 2 == 1;
    for (int k = 0; k < bricks - is_shifted; ++k)
      put_brick(scene, 2, 2 * k + 1 - bricks + is_shifted, course);
    if (!is_shifted) continue;
    for (const double side : {-1, 1}) put_brick(scene, 1, side * (bricks - 0.5), course);
  }
  return {counted("wall", scene), scene};
}

Assembly pyramid(int dimension, int base) {
  Scene scene = on_plate(dimension, 2 * base, 10);
  for (int course = 0; course < base; ++course)
    for (int k = 0; k < base - course; ++k) put_brick(scene, 1, k - (base - course - 1) / 2.0, course);
  return {counted("pyramid", scene), scene};
}

double number(std::mt19937& random) { return double(random() % 1024) / 1024; }

/// A regular polygon of 4 to 8 corners.
Body polygon(std::mt19937& random) {
  const int count = 4 + int(random() % 5);
  const double radius = 0.35 + 0.2 * number(random);
  Body body;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    body.corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  const double half = M_PI * number(random);
  body.rotation = {0, 0, std::sin(half), std::cos(half)};
  return body;
}

void turn(Body& body, std::mt19937& random) {
  double square = 0;
  for (double& part : body.rotation) {
    part = 2 * number(random) - 1 + 1e-3;
    square += part * part;
  }
  for (double& part : body.rotation) part /= std::sqrt(square);
}

Body box(std::mt19937& random) {
  Body body;
  for (double& side : body.size) side = 0.55 + 0.3 * number(random);
  turn(body, random);
  return body;
}

/// A hull of 12, 14, 18 or 20 corners on an ellipsoid. Mirrored corners have their centroid at the origin.
Body hull(std::mt19937& random) {
  Vector half;
  for (double& axis : half) axis = 0.38 + 0.17 * number(random);
  Body body;
  // The corner and its images at the planes in which it does not lie.
  const auto mirror = [&](const Vector& direction) {
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    std::vector<Vector> images = {{0, 0, 0}};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t count = images.size();
      for (std::size_t i = 0; i < count; ++i) {
        images[i][k] = half[k] * direction[k] / length;
        if (direction[k] == 0) continue;
        images.push_back(images[i]);
        images.back()[k] *= -1;
      }
    }
    body.corners.insert(body.corners.end(), images.begin(), images.end());
  };
  const auto some = [&] { return 0.4 + 0.6 * number(random); };
  const int kind = int(random() % 4);  // 12, 8 + 6, 12 + 6, 8 + 12
  if (kind != 1)
    for (std::size_t k = 0; k < 3; ++k) {
      Vector in_plane{};
      in_plane[k] = 1;
      in_plane[(k + 1) % 3] = some();
      mirror(in_plane);
    }
  if (kind == 1 || kind == 3) mirror({some(), some(), some()});
  if (kind == 1 || kind == 2)
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) mirror(axis);
  turn(body, random);
  return body;
}

/// Blocks of many forms fall into a bin, in layers.
Assembly heap(const std::string& of_what, int dimension, int count, Body (*make)(std::mt19937&)) {
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
    Body body = make(random);
    const int layer = i / per_layer, k = i % per_layer;
    body.position = up(dimension, spacing * (layer + 0.6));
    body.position[0] = spacing * (k % across - (across - 1) / 2.0);
    if (dimension == 3) body.position[1] = spacing * (k / across - (across - 1) / 2.0);
    scene.bodies.push_back(body);
  }
  return {counted("heap", scene) + " " + of_what, scene, 4, true};
}

}  // namespace

std::vector<Assembly> assemblies() {
  return {
      stack(2, 100),
      wall(2, 8, 12),
      wall(2, 36, 27),
      wall(2, 48, 62),
      pyramid(2, 100),
      heap("polygons", 2, 1000, polygon),
      heap("polygons", 2, 5000, polygon),
      stack(3, 100),
      wall(3, 8, 12),
      wall(3, 36, 27),
      pyramid(3, 70),
      heap("boxes", 3, 1000, box),
      heap("hulls", 3, 1000, hull),
  };
}

bool has_hulls(const Assembly& assembly) {
  if (assembly.scene.dimension == 2) return false;
  for (const Body& body : assembly.scene.bodies)
    if (!body.corners.empty()) return true;
  return false;
}

}  // namespace halfspace_trade
