// Things that fall over, stand by leaning, or hit.

#include <cmath>

#include "scenes.h"

namespace box2d_comparison {
namespace {

/// Tiles of 0.2 x 2 m, 1 m from each other. The first is pushed at its top.
void add_dominoes(Stage& stage) {
  stage.add_floor(60);
  for (int i = 0; i < 20; ++i) {
    b2Body& tile =
        stage.add_box(0.2f, 2, {{-10 + float(i), 1 + stage.rest_gap()}, 0, b2_dynamicBody, 1, 0.3f});
    if (i == 0) tile.SetAngularVelocity(-1);
  }
}

/// Pairs of cards that lean on each other, with cards across, storey upon storey.
void add_card_house(Stage& stage) {
  constexpr int storeys = 4;
  constexpr float length = 2, thickness = 0.04f, lean = 0.35f, friction = 0.7f;
  const float gap = stage.rest_gap();
  const float half_base =
      0.5f * (length * std::sin(lean) + thickness * std::cos(lean) + gap / std::cos(lean));
  const float height = length * std::cos(lean) + thickness * std::sin(lean);
  const float spacing = 4 * half_base + gap;
  stage.add_floor(40, {0, 0}, friction);
  float ground = gap;
  for (int storey = 0; storey < storeys; ++storey) {
    const int tents = storeys - storey;
    const auto middle = [&](int i, int count) { return spacing * (float(i) - 0.5f * float(count - 1)); };
    for (int i = 0; i < tents; ++i) {
      for (const float side : {-1.f, 1.f})
        stage.add_box(thickness, length,
                      {{middle(i, tents) + side * half_base, ground + height / 2},
                       side * lean,
                       b2_dynamicBody,
                       1,
                       friction});
    }
    for (int i = 0; i + 1 < tents; ++i)
      stage.add_box(
          spacing - gap, thickness,
          {{middle(i, tents - 1), ground + height + gap + thickness / 2}, 0, b2_dynamicBody, 1, friction});
    ground += height + thickness + 2 * gap;
  }
}

/// A bullet of 0.2 m at 200 m/s, more than 3 m a step, on a wall of ten boxes before a fixed plate of 2 cm.
void add_bullet_and_wall(Stage& stage) {
  stage.add_floor(60);
  for (int i = 0; i < 10; ++i) stage.add_box(0.5f, 0.5f, {{0, 0.27f + 0.515f * float(i)}});
  stage.add_box(0.02f, 20, {{6, 10}, 0, b2_staticBody});
  Placing placing{{-20, 2.5f}};
  placing.density = 20;
  b2Body& bullet = stage.add_box(0.2f, 0.2f, placing);
  bullet.SetBullet(true);
  bullet.SetLinearVelocity({200, 0});
}

}  // namespace

std::vector<Scene> moving() {
  return {
      {"dominoes", "Domino row",
       "The domino row of Box2D's testbed, twenty tiles; the first is pushed. It moves to the end, so "
       "that drift "
       "is no fault here; both engines should spend the same energy.",
       false, 15, sideways, borne_by(20), add_dominoes},
      {"card_house", "Card house",
       "Four storeys of leaning cards with friction 0.7, known from the samples of several engines. "
       "Stands only "
       "as long as friction holds at edges.",
       true, 15, sideways, borne_by(8), add_card_house},
      {"bullet", "Fast bullet",
       "A bullet of 200 m/s through a wall of boxes, before a plate of 2 cm. Continuous collision is "
       "Box2D's in "
       "both; the bullet must not pass the plate.",
       false, 10, sideways,
       without_forces(
           "Pairs that take forces have no continuous collision: the bullet would need sub-steps so short "
           "that it does not pass the plate between two of them."),
       add_bullet_and_wall}};
}

}  // namespace box2d_comparison
