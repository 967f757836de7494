#include <box3d/box3d.h>

#include <stdexcept>

#include "benchmarks/timing.h"
#include "sub_steps.h"

namespace halfspace_trade {
namespace {

b3Vec3 vector_of(const Vector& v) { return {float(v[0]), float(v[1]), float(v[2])}; }
Vector vector_from(const b3Vec3& v) { return {double(v.x), double(v.y), double(v.z)}; }

b3WorldDef definition_of(const Scene& scene, const SubSteps& way, double time_step) {
  b3SetLengthUnitsPerMeter(length_units_per_meter(way));
  b3WorldDef def = b3DefaultWorldDef();
  def.gravity = vector_of(scene.gravity);
  def.enableSleep = false;
  set_contacts(def, way, time_step);
  return def;
}

class Box3dWorld : public World {
 public:
  Box3dWorld(const Scene& scene, const Setting& setting)
      : way_(sub_step_ways.at(setting.way)), time_step_(whole_part(scene.duration, setting.step)) {
    const b3WorldDef def = definition_of(scene, way_, time_step_);
    world_ = b3CreateWorld(&def);
    for (const Body& body : scene.bodies) bodies_.push_back(add(body, scene));
  }
  ~Box3dWorld() override { b3DestroyWorld(world_); }

  double step(long steps) override {
    return halfspace_benchmark::seconds_of([&] {
      for (long i = 0; i < steps; ++i) b3World_Step(world_, float(time_step_), way_.count);
    });
  }
  double time_step() const override { return time_step_; }

  State state(std::size_t i) const override {
    const b3BodyId body = bodies_[i];
    const auto position = b3Body_GetPosition(body);
    const b3Quat rotation = b3Body_GetRotation(body);
    return {{double(position.x), double(position.y), double(position.z)},
            {double(rotation.v.x), double(rotation.v.y), double(rotation.v.z), double(rotation.s)},
            vector_from(b3Body_GetLinearVelocity(body)),
            vector_from(b3Body_GetAngularVelocity(body))};
  }

 private:
  b3BodyId add(const Body& body, const Scene& scene) {
    b3BodyDef def = b3DefaultBodyDef();
    def.type = body.is_fixed ? b3_staticBody : b3_dynamicBody;
    def.position.x = float(body.position[0]);
    def.position.y = float(body.position[1]);
    def.position.z = float(body.position[2]);
    def.rotation.v = vector_of({body.rotation[0], body.rotation[1], body.rotation[2]});
    def.rotation.s = float(body.rotation[3]);
    def.linearVelocity = vector_of(body.velocity);
    def.angularVelocity = vector_of(body.spin);
    const b3BodyId made = b3CreateBody(world_, &def);
    add_shape(made, body, scene);
    return made;
  }

  /// The world keeps a copy of the hull.
  void add_shape(b3BodyId made, const Body& body, const Scene& scene) {
    b3ShapeDef def = b3DefaultShapeDef();
    def.density = float(body.density);
    def.baseMaterial.friction = float(scene.friction);
    def.baseMaterial.restitution = float(scene.restitution);
    if (body.corners.empty()) {
      const b3Vec3 half = vector_of({body.size[0] / 2, body.size[1] / 2, body.size[2] / 2});
      const b3BoxHull box = b3MakeBoxHull(half.x, half.y, half.z);
      b3CreateHullShape(made, &def, &box.base);
      return;
    }
    std::vector<b3Vec3> corners;
    for (const Vector& corner : body.corners) corners.push_back(vector_of(corner));
    b3HullData* hull = b3CreateHull(corners.data(), int(corners.size()), int(corners.size()));
    if (!hull) throw std::runtime_error("Box3D takes these corners for no hull");
    b3CreateHullShape(made, &def, hull);
    b3DestroyHull(hull);
  }

  SubSteps way_;
  double time_step_;
  b3WorldId world_{};
  std::vector<b3BodyId> bodies_;
};

}  // namespace

const char* engine_name() {
  static const std::string name = with_version("Box3D", b3GetVersion());
  return name.c_str();
}
bool knows_dimension(int dimension) { return dimension == 3; }
bool knows_hulls() { return true; }

std::vector<Setting> settings() { return sub_step_settings(); }

std::unique_ptr<World> build(const Scene& scene, const Setting& setting) {
  return std::make_unique<Box3dWorld>(scene, setting);
}

}  // namespace halfspace_trade
