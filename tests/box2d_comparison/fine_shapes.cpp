// Shapes finer than Box2D's tolerances: edges it welds, blocks as thin as its skins.

#include "benchmarks/random_polygon.h"
#include "scenes.h"

namespace box2d_comparison {
namespace {

/// A square of 1 m about the origin, its corners cut off over a thousandth of its side.
Points square_with_cut_corners() {
  constexpr double h = 0.5, cut = 0.001;
  return {{-h + cut, -h}, {h - cut, -h}, {h, -h + cut}, {h, h - cut},
          {h - cut, h},   {-h + cut, h}, {-h, h - cut}, {-h, -h + cut}};
}

/// Turned by half a right angle, between floor, wall and each other: they meet at the cut corners.
void add_heap_of_cut_squares(Stage& stage) {
  stage.add_floor(40);
  for (const float x : {-4.f, 4.f}) stage.add_box(1, 20, {{x, 10}, 0, b2_staticBody});
  for (int row = 0; row < 8; ++row) {
    for (int i = 0; i < 4; ++i) {
      const float aside = row % 2 ? 0.4f : -0.4f;
      stage.add(square_with_cut_corners(), {{-2.25f + 1.5f * float(i) + aside, 1 + 1.5f * float(row)},
                                            float(halfspace_benchmark::pi / 4)});
    }
  }
}

/// Thin wedges and planks of 1.5 m that fall into a bin.
void add_heap_of_slivers(Stage& stage) {
  stage.add_floor(40);
  for (const float x : {-3.f, 3.f}) stage.add_box(1, 20, {{x, 10}, 0, b2_staticBody});
  halfspace_benchmark::Random random(3);
  for (int i = 0; i < 60; ++i) {
    const Placing placing{{-1.2f + 1.2f * float(i % 3), 0.5f + 0.25f * float(i / 3)},
                          float(halfspace_benchmark::uniform(random, -0.3, 0.3))};
    b2PolygonShape wedge;
    const b2Vec2 corners[] = {{-0.75f, 0}, {0.75f, -0.01f}, {0.75f, 0.01f}};
    wedge.Set(corners, 3);
    if (i % 2) {
      stage.add(wedge, placing);
    } else {
      stage.add_box(1.5f, 0.02f, placing);
    }
  }
}

}  // namespace

std::vector<Scene> fine_shapes() {
  return {
      {"tiny_edges", "Edges of a thousandth",
       "Squares whose corners are cut off over 0.001 of their side, as cells and digitized grains have them. "
       "Box2D welds the cut's two vertices into one; the half-space narrow phase has the true polygon.",
       false, 15, sideways, without_forces(nothing_to_stay), add_heap_of_cut_squares},
      {"balanced", "Standing on a tiny edge",
       "One square with such corners stands on one of them, an edge of 1.4 mm: its weight is over the edge. "
       "But Box2D's "
       "solver takes two points so near each other for one, whoever finds them, and it falls.",
       true, 15, sideways, borne_by(1),
       [](Stage& stage) {
         stage.add_floor(40);
         const float to_edge = float((1 - 0.001) * std::sqrt(0.5));
         stage.add(square_with_cut_corners(),
                   {{0, to_edge + stage.rest_gap()}, float(halfspace_benchmark::pi / 4)});
       }},
      {"slivers", "Slivers",
       "Planks and wedges of 1.5 m, 2 cm thick and pointed, in a bin: as thin as the two skins between them.",
       false, 15, sideways, without_forces(nothing_to_stay), add_heap_of_slivers}};
}

}  // namespace box2d_comparison
