#include "stage.h"

#include "benchmarks/box2d_polygon.h"

namespace box2d_comparison {

const TruePolygon* true_polygon_of(const b2Fixture& fixture) {
  // Box2D's accessor of a fixture's user data is not const.
  return reinterpret_cast<const TruePolygon*>(const_cast<b2Fixture&>(fixture).GetUserData().pointer);
}

b2Body& Stage::add(const b2PolygonShape& shape, const Placing& placing) {
  return add(shape, placing, nullptr);
}

b2Body& Stage::add(const Points& vertices, const Placing& placing) {
  const TruePolygon& truth = true_polygons_.emplace_back(
      TruePolygon{vertices, halfspace_test::make_shape(context_.get(), vertices)});
  return add(halfspace_benchmark::box2d_shape(vertices), placing, &truth);
}

b2Body& Stage::add_box(float width, float height, const Placing& placing) {
  b2PolygonShape box;
  box.SetAsBox(width / 2, height / 2);
  return add(box, placing);
}

b2Body& Stage::add_floor(float width, b2Vec2 place, float friction) {
  return add_box(width, 2, {place - b2Vec2(0, 1), 0, b2_staticBody, 0, friction});
}

b2Body& Stage::add(const b2PolygonShape& shape, const Placing& placing, const TruePolygon* truth) {
  b2BodyDef body;
  body.type = placing.type;
  body.position = placing.at;
  body.angle = placing.angle;
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = placing.density;
  fixture.friction = placing.friction;
  fixture.userData.pointer = reinterpret_cast<std::uintptr_t>(truth);
  b2Body& made = *world_.CreateBody(&body);
  made.CreateFixture(&fixture);
  return made;
}

}  // namespace box2d_comparison
