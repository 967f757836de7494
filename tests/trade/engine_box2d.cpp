#include <box2d/box2d.h>

#include <cmath>

#include "benchmarks/timing.h"
#include "engine.h"

namespace halfspace_trade {
namespace {

/// Box2D keeps polygons apart by their skins less the slop. Faces that bear are drawn in by half of that, so
/// that they meet where the true ones do. A base keeps its width.
constexpr double drawn_in = b2_polygonRadius - b2_linearSlop / 2;

b2Vec2 vector_of(const Vector& v) { return {float(v[0]), float(v[1])}; }

/// A regular polygon on all sides; a box above and below, or where nothing weighs at its ends.
std::vector<b2Vec2> drawn_in_corners(const Body& body, bool has_weight) {
  std::vector<b2Vec2> corners;
  const std::vector<Vector> own = corners_of(body, 2);
  for (const Vector& p : own) {
    const double radius = std::hypot(p[0], p[1]), apothem = radius * std::cos(M_PI / double(own.size()));
    const double share = body.corners.empty() ? 0 : drawn_in / apothem;
    corners.push_back(vector_of({p[0] * (1 - share), p[1] * (1 - share), 0}));
    if (!body.corners.empty()) continue;
    float& bearing = has_weight ? corners.back().y : corners.back().x;
    bearing -= std::copysign(float(drawn_in), bearing);
  }
  return corners;
}

b2PolygonShape shape_of(const Body& body, bool has_weight) {
  const std::vector<b2Vec2> corners = drawn_in_corners(body, has_weight);
  b2PolygonShape shape;
  shape.Set(corners.data(), int(corners.size()));
  return shape;
}

class Box2dWorld : public World {
 public:
  Box2dWorld(const Scene& scene, const Setting& setting)
      : time_step_(whole_part(scene.duration, setting.step)),
        is_patient_(setting.way == "50 velocity, 20 position iterations"),
        world_(vector_of(scene.gravity)) {
    world_.SetAllowSleeping(false);
    for (const Body& body : scene.bodies) bodies_.push_back(add(body, scene));
  }

  double step(long steps) override {
    return halfspace_benchmark::seconds_of([&] {
      for (long i = 0; i < steps; ++i)
        world_.Step(float(time_step_), is_patient_ ? 50 : 8, is_patient_ ? 20 : 3);
    });
  }
  double time_step() const override { return time_step_; }

  State state(std::size_t i) const override {
    const b2Body& body = *bodies_[i];
    const double half = 0.5 * double(body.GetAngle());
    State state;
    state.position = {double(body.GetWorldCenter().x), double(body.GetWorldCenter().y), 0};
    state.rotation = {0, 0, std::sin(half), std::cos(half)};
    state.velocity = {double(body.GetLinearVelocity().x), double(body.GetLinearVelocity().y), 0};
    state.spin = {0, 0, double(body.GetAngularVelocity())};
    return state;
  }

 private:
  b2Body* add(const Body& body, const Scene& scene) {
    b2BodyDef def;
    def.type = body.is_fixed ? b2_staticBody : b2_dynamicBody;
    def.position = vector_of(body.position);
    def.angle = float(2 * std::atan2(body.rotation[2], body.rotation[3]));
    def.linearVelocity = vector_of(body.velocity);
    def.angularVelocity = float(body.spin[2]);
    b2Body* made = world_.CreateBody(&def);
    const b2PolygonShape shape = shape_of(body, scene.gravity[1] != 0 || body.is_fixed);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = float(body.density);
    fixture.friction = float(scene.friction);
    fixture.restitution = float(scene.restitution);
    made->CreateFixture(&fixture);
    if (!body.is_fixed) {
      const Mass truth = mass_of(body, 2);
      const b2MassData mass = {float(truth.mass), {0, 0}, float(truth.inertia[2])};
      made->SetMassData(&mass);
    }
    return made;
  }

  double time_step_;
  bool is_patient_;
  b2World world_;
  std::vector<b2Body*> bodies_;
};

}  // namespace

const char* engine_name() { return "Box2D"; }
bool knows_dimension(int dimension) { return dimension == 2; }
bool knows_hulls() { return false; }

std::vector<Setting> settings() {
  return with_frame_steps({"8 velocity, 3 position iterations", "50 velocity, 20 position iterations"});
}

std::unique_ptr<World> build(const Scene& scene, const Setting& setting) {
  return std::make_unique<Box2dWorld>(scene, setting);
}

}  // namespace halfspace_trade
