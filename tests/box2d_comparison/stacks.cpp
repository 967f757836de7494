// Boxes on boxes: what a solver has to carry, at home and far from the origin.

#include "benchmarks/box2d_polygon.h"
#include "benchmarks/box2d_scenes.h"
#include "scenes.h"

namespace box2d_comparison {
namespace {

/// Boxes of 1 m, 1 mm higher than they lie on each other. The floor's top is at the place.
void add_stack(Stage& stage, int height, b2Vec2 place) {
  stage.add_floor(40, place);
  for (int i = 0; i < height; ++i) {
    const float above = 0.5f + stage.rest_gap() + (1.001f + stage.rest_gap()) * float(i);
    stage.add_box(1, 1, {place + b2Vec2(0, above)});
  }
}

Scene stack_of(int height) {
  const std::string count = std::to_string(height);
  return {"stack_" + count,
          "Stack of " + count,
          "The vertical stack of Box2D's testbed, " + count +
              " boxes of 1 m high. It is to come to rest at once and not to sway.",
          true,
          15,
          sideways,
          height > 10 ? borne_by_and_run_once(1) : borne_by(1),
          [=](Stage& stage) {
            add_stack(stage, height, {0, 0});
          }};
}

/// As far to the right as up.
Scene stack_at(float distance, ForceUse forces, const char* name, const char* where) {
  return {name,
          std::string("Stack of 10, ") + where,
          std::string("An open world: the stack of ten boxes ") + where +
              ", to the right and up. Box2D keeps positions in float, whichever narrow phase reads them.",
          true,
          15,
          sideways,
          std::move(forces),
          [=](Stage& stage) {
            add_stack(stage, 10, {distance, distance});
          }};
}

/// Random polygons in a bin, which touch in all directions.
void add_heap(Stage& stage, b2Vec2 place) {
  stage.add_floor(40, place);
  for (const float x : {-4.f, 4.f}) stage.add_box(1, 20, {place + b2Vec2(x, 10), 0, b2_staticBody});
  halfspace_benchmark::Random random(2);
  for (int i = 0; i < 60; ++i) {
    const b2Vec2 above = {-2.4f + 1.2f * float(i % 5), 0.8f + 1.2f * float(i / 5)};
    stage.add(halfspace_benchmark::random_box2d_shape(0.4, 0.6, random), {place + above});
  }
}

Scene heap_at(float distance, const char* name, const char* where) {
  return {name,
          std::string("Heap of polygons, ") + where,
          std::string("Sixty random polygons of 3 to 8 vertices that fall into a bin ") + where +
              ". They turn and touch in all directions.",
          false,
          15,
          sideways,
          without_forces(nothing_to_stay),
          [=](Stage& stage) {
            add_heap(stage, {distance, distance});
          }};
}

/// One block upon three light ones of its size.
Scene heavy_on_light(int ratio) {
  const std::string mass = std::to_string(ratio);
  return {"mass_ratio_" + mass,
          "Mass ratio 1:" + mass,
          "Heavy on light, as in Box2D's testbed: a block " + mass +
              " times as heavy as each of the three boxes that carry it. Iterative solvers let the light "
              "ones be squeezed.",
          true,
          15,
          sideways,
          borne_by(1),
          [=](Stage& stage) {
            stage.add_floor(40);
            const auto above = [&](int i) {
              return 0.5f + stage.rest_gap() + (1 + stage.rest_gap()) * float(i);
            };
            for (int i = 0; i < 3; ++i) stage.add_box(1, 1, {{0, above(i)}});
            Placing heavy{{0, above(3)}};
            heavy.density = float(ratio);
            stage.add_box(1, 1, heavy);
          }};
}

}  // namespace

std::vector<Scene> stacks() {
  return {{"pyramid", "Pyramid of 20 rows",
           "The pyramid of Box2D's testbed: 210 boxes, the benchmark of box stacking since Box2D Lite.", true,
           15, sideways, borne_by_and_run_once(20),
           [](Stage& stage) { halfspace_benchmark::add_pyramid(stage.world()); }},
          stack_of(10),
          stack_of(50),
          heavy_on_light(100),
          heavy_on_light(1000)};
}

std::vector<Scene> far_and_near() {
  const char* floats_too_far_apart =
      "Floats are 6 cm from each other there: blocks would begin as far within each other, which no "
      "spring is meant for.";
  return {heap_at(0, "heap", "at the origin"), heap_at(1e4f, "heap_10km", "10 km from the origin"),
          stack_at(1e4f, borne_by(1), "stack_10km", "10 km from the origin"),
          stack_at(1e6f, without_forces(floats_too_far_apart), "stack_1000km", "1000 km from the origin")};
}

}  // namespace box2d_comparison
