#include <box2d/box2d.h>

#include <cstdio>

int main() {
  b2World world(b2Vec2(0, -10));

  b2BodyDef ground_def;
  ground_def.position.Set(0, -10);
  b2PolygonShape ground_box;
  ground_box.SetAsBox(50, 10);
  world.CreateBody(&ground_def)->CreateFixture(&ground_box, 0);

  b2BodyDef body_def;
  body_def.type = b2_dynamicBody;
  body_def.position.Set(0, 4);
  b2PolygonShape dynamic_box;
  dynamic_box.SetAsBox(1, 1);
  b2FixtureDef fixture_def;
  fixture_def.shape = &dynamic_box;
  fixture_def.density = 1;
  fixture_def.friction = 0.3f;
  b2Body *body = world.CreateBody(&body_def);
  body->CreateFixture(&fixture_def);

  for (int i = 1; i <= 60; ++i) {
    world.Step(1 / 60.f, 6, 2);
    if (i % 15 == 0) {
      std::printf("%4.2f %4.2f %4.2f\n", body->GetPosition().x, body->GetPosition().y, body->GetAngle());
    }
  }
}
