// Coulomb's block on a slope: what creeps that should stay.

#include <algorithm>
#include <cmath>

#include "scenes.h"

namespace box2d_comparison {
namespace {

/// Blocks that just touch, upon a slope of their own. Friction is the tangent of the slope, as its angle has
/// it and as the floats of its turn do, or the next float above.
void add_slope(Stage& stage, const b2PolygonShape& block, int blocks, double slope, b2Vec2 at, double brake) {
  const float angle = float(std::atan(slope));
  const b2Rot turn(angle);
  const double tangent = std::max(std::abs(double(turn.s) / turn.c), std::abs(std::tan(double(angle))));
  float friction = float(tangent);
  while (friction < tangent) friction = std::nextafter(friction, INFINITY);
  friction *= float(brake);
  stage.add_box(30, 2, {at, angle, b2_staticBody, 0, friction});
  for (int i = 0; i < blocks; ++i) {
    const float height = 1.5f + stage.rest_gap() + (1 + stage.rest_gap()) * float(i);
    stage.add(block, {at + height * turn.GetYAxis(), angle, b2_dynamicBody, 1, friction});
  }
}

b2PolygonShape box_of_2_by_1() {
  b2PolygonShape box;
  box.SetAsBox(1, 0.5f);
  return box;
}

/// 1 m high, with no two sides alike.
b2PolygonShape hexagon() {
  const b2Vec2 corners[] = {{-1, -0.5f},  {0.9f, -0.5f}, {1.1f, -0.3f},
                            {0.8f, 0.5f}, {-0.7f, 0.5f}, {-1.05f, 0.1f}};
  b2PolygonShape shape;
  shape.Set(corners, 6);
  return shape;
}

constexpr double braked = 4;

/// From four times the friction to the friction of the slope.
void release_brakes(Stage& stage) {
  for (b2Body* body = stage.world().GetBodyList(); body; body = body->GetNext())
    body->GetFixtureList()->SetFriction(body->GetFixtureList()->GetFriction() / float(braked));
  for (b2Contact* c = stage.world().GetContactList(); c; c = c->GetNext()) c->ResetFriction();
}

/// Tangents from 0.1 to 0.575, descending to the left and to the right, eight to a row, so that none is far
/// from the origin.
void add_slopes(Stage& stage, int blocks) {
  for (int i = 0; i < 40; ++i) {
    const double slope = (i % 2 ? -1 : 1) * (0.1 + 0.025 * (i / 2));
    add_slope(stage, hexagon(), blocks, slope, {100 * (float(i % 8) - 3.5f), 100 * (float(i / 8) - 2)},
              braked);
  }
}

}  // namespace

std::vector<Scene> slopes() {
  const b2Vec2 along = b2Rot(std::atan(0.5f)).GetXAxis();
  return {
      {"slope_below_friction", "Slope just below the friction angle",
       "Coulomb's block, let go on a slope whose tangent is a hundredth below the friction. It is to stay.",
       true, 30, along, borne_by(1),
       [](Stage& stage) {
         add_slope(stage, box_of_2_by_1(), 1, 0.5, {0, 0}, 1.01);
       },
       0, nullptr, true},
      {"slope_at_friction", "Slope at the friction angle, let go",
       "The limit itself: friction is the tangent of the slope, 0.5. Whatever speed the 8 iterations of the "
       "first step "
       "leave stays, as nothing is left to slow the block.",
       true, 30, along, borne_by(1),
       [](Stage& stage) {
         add_slope(stage, box_of_2_by_1(), 1, 0.5, {0, 0}, 1);
       },
       0, nullptr, true},
      {"slopes_settled", "Forty slopes at the friction angle, settled",
       "One hexagon on each of forty slopes of tangents 0.1 to 0.575. They rest with four times the friction "
       "for 5 s; "
       "then it falls to the tangent of the slope. All are to stay.",
       true, 30, sideways, borne_by(40), [](Stage& stage) { add_slopes(stage, 1); }, 5, release_brakes, true},
      {"slopes_of_two", "Forty slopes at the friction angle, two blocks",
       "The same with a second hexagon on the first. Whatever the solver leaves undone at the limit lets "
       "them slide.",
       true, 30, sideways, borne_by_and_run_once(40), [](Stage& stage) { add_slopes(stage, 2); }, 5,
       release_brakes, true}};
}

}  // namespace box2d_comparison
