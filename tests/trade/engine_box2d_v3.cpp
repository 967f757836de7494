#include <box2d/box2d.h>

#include <cmath>
#include <stdexcept>

#include "benchmarks/timing.h"
#include "sub_steps.h"

namespace halfspace_trade {
namespace {

b2Vec2 vector_of(const Vector& v) { return {float(v[0]), float(v[1])}; }

b2WorldDef definition_of(const Scene& scene, const SubSteps& way, double time_step) {
  b2SetLengthUnitsPerMeter(length_units_per_meter(way));
  b2WorldDef def = b2DefaultWorldDef();
  def.gravity = vector_of(scene.gravity);
  def.enableSleep = false;
  set_contacts(def, way, time_step);
  return def;
}

b2Polygon polygon_of(const Body& body) {
  std::vector<b2Vec2> corners;
  for (const Vector& corner : corners_of(body, 2)) corners.push_back(vector_of(corner));
  const b2Hull hull = b2ComputeHull(corners.data(), int(corners.size()));
  if (hull.count == 0) throw std::runtime_error("Box2D takes these corners for no polygon");
  return b2MakePolygon(&hull, 0);
}

class Box2dWorld : public World {
 public:
  Box2dWorld(const Scene& scene, const Setting& setting)
      : way_(sub_step_ways.at(setting.way)), time_step_(whole_part(scene.duration, setting.step)) {
    const b2WorldDef def = definition_of(scene, way_, time_step_);
    world_ = b2CreateWorld(&def);
    for (const Body& body : scene.bodies) bodies_.push_back(add(body, scene));
  }
  ~Box2dWorld() override { b2DestroyWorld(world_); }

  double step(long steps) override {
    return halfspace_benchmark::seconds_of([&] {
      for (long i = 0; i < steps; ++i) b2World_Step(world_, float(time_step_), way_.count);
    });
  }
  double time_step() const override { return time_step_; }

  State state(std::size_t i) const override {
    const b2BodyId body = bodies_[i];
    const auto position = b2Body_GetPosition(body);
    const b2Rot rotation = b2Body_GetRotation(body);
    const b2Vec2 velocity = b2Body_GetLinearVelocity(body);
    const double half = 0.5 * std::atan2(double(rotation.s), double(rotation.c));
    State state;
    state.position = {double(position.x), double(position.y), 0};
    state.rotation = {0, 0, std::sin(half), std::cos(half)};
    state.velocity = {double(velocity.x), double(velocity.y), 0};
    state.spin = {0, 0, double(b2Body_GetAngularVelocity(body))};
    return state;
  }

 private:
  b2BodyId add(const Body& body, const Scene& scene) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = body.is_fixed ? b2_staticBody : b2_dynamicBody;
    def.position.x = float(body.position[0]);
    def.position.y = float(body.position[1]);
    def.rotation = b2MakeRot(float(2 * std::atan2(body.rotation[2], body.rotation[3])));
    def.linearVelocity = vector_of(body.velocity);
    def.angularVelocity = float(body.spin[2]);
    const b2BodyId made = b2CreateBody(world_, &def);
    b2ShapeDef shape = b2DefaultShapeDef();
    shape.density = float(body.density);
    shape.material.friction = float(scene.friction);
    shape.material.restitution = float(scene.restitution);
    const b2Polygon polygon = polygon_of(body);
    b2CreatePolygonShape(made, &shape, &polygon);
    return made;
  }

  SubSteps way_;
  double time_step_;
  b2WorldId world_{};
  std::vector<b2BodyId> bodies_;
};

}  // namespace

const char* engine_name() {
  static const std::string name = with_version("Box2D", b2GetVersion());
  return name.c_str();
}
bool knows_dimension(int dimension) { return dimension == 2; }
bool knows_hulls() { return false; }

std::vector<Setting> settings() { return sub_step_settings(); }

std::unique_ptr<World> build(const Scene& scene, const Setting& setting) {
  return std::make_unique<Box2dWorld>(scene, setting);
}

}  // namespace halfspace_trade
