// Box2D worlds with the half-space narrow phase, with forces or impulses of the library, and copied: whatever
// bodies are in them, they step.

#include <halfspace/box2d_force.hpp>
#include <halfspace/box2d_impulse.hpp>
#include <halfspace/box2d_world.hpp>
#include <memory>
#include <stdexcept>

#include "fuzz/geometry.h"

namespace halfspace_fuzz {
namespace {

using namespace halfspace_test;
using namespace halfspace::box2d;

constexpr int most_bodies = 8;
constexpr int max_steps = 40;

/// Within what Box2D is made for: 0.1 to 10 m, and far around that.
float length_from(Bytes& bytes) { return std::ldexp(1 + float(bytes.byte()) / 256, bytes.between(-6, 6)); }
float place_from(Bytes& bytes) { return float(bytes.raw<std::int16_t>()) / 1024; }
b2Vec2 vector_from(Bytes& bytes) {
  const float x = place_from(bytes);
  return {x, place_from(bytes)};
}

b2PolygonShape read_polygon(Bytes& bytes) {
  b2PolygonShape shape;
  const float width = length_from(bytes), height = length_from(bytes);
  if (bytes.flag()) {
    shape.SetAsBox(width, height, vector_from(bytes), place_from(bytes));
    return shape;
  }
  const int count = bytes.between(3, b2_maxPolygonVertices);
  b2Vec2 corners[b2_maxPolygonVertices];
  for (int i = 0; i < count; ++i) {
    const float angle = 2 * b2_pi * (float(i) + 0.4f * float(bytes.byte()) / 256) / float(count);
    corners[i] = {width * std::cos(angle), height * std::sin(angle)};
  }
  shape.Set(corners, count);
  return shape;
}

class Arena {
 public:
  Arena(Bytes bytes) : bytes_(bytes), world_({place_from(bytes_), -10}) {
    Options options;
    options.geometry_of = [this](b2Fixture& fixture) { return geometry_of(fixture); };
    narrow_phase_ = std::make_unique<NarrowPhase>(world_, options);
    for (int bodies = bytes_.between(1, 4); bodies > 0; --bodies) add_body();
  }

  void run() {
    while (!bytes_.empty()) {
      switch (bytes_.below(8)) {
        case 0:
          add_body();
          break;
        case 1:
          remove_body();
          break;
        case 2:
          move_body();
          break;
        case 3:
          begin_or_end_mode();
          break;
        case 4:
          copy();
          break;
        case 5:
          refresh();
          break;
        default:
          step();
      }
      check();
    }
  }

 private:
  FixtureGeometry geometry_of(b2Fixture& fixture) const {
    FixtureGeometry geometry;
    const std::uintptr_t which = fixture.GetUserData().pointer;
    geometry.left_to_box2d = which == 1;
    if (which >= 2) geometry.shape = attached_[which - 2].get();
    return geometry;
  }

  b2Body* any_body() {
    b2Body* body = world_.GetBodyList();
    for (int i = bytes_.below(most_bodies); body && i > 0; --i) body = body->GetNext();
    return body;
  }

  void add_body() {
    if (world_.GetBodyCount() >= most_bodies) return;
    b2BodyDef def;
    def.type = b2BodyType(bytes_.below(3));
    def.position = vector_from(bytes_);
    def.angle = place_from(bytes_);
    def.linearVelocity = vector_from(bytes_);
    def.angularVelocity = place_from(bytes_);
    def.bullet = bytes_.flag();
    b2Body& body = *world_.CreateBody(&def);
    for (int fixtures = bytes_.between(1, 2); fixtures > 0; --fixtures) add_fixture(body);
  }

  void add_fixture(b2Body& body) {
    b2PolygonShape polygon = read_polygon(bytes_);
    b2FixtureDef def;
    def.userData.pointer = std::uintptr_t(bytes_.below(4));
    if (def.userData.pointer >= 2) {
      Shape shape = read_hull(bytes_, context_.get(), 2);
      if (!shape || properties_of(shape.get()).bounding_radius > 1e3 ||
          properties_of(shape.get()).bounding_radius < 1e-2)
        return;
      polygon = box_around(*shape);
      attached_.push_back(std::move(shape));
      def.userData.pointer = attached_.size() + 1;
    }
    b2CircleShape circle;
    circle.m_radius = 0.5f;
    def.shape = bytes_.below(8) == 0 ? static_cast<b2Shape*>(&circle) : &polygon;
    def.density = bytes_.flag() ? 1 : length_from(bytes_);
    def.friction = float(bytes_.byte()) / 128;
    def.restitution = float(bytes_.byte()) / 256;
    def.isSensor = bytes_.below(16) == 0;
    body.CreateFixture(&def);
  }

  void remove_body() {
    if (b2Body* body = any_body()) world_.DestroyBody(body);
  }

  void move_body() {
    b2Body* body = any_body();
    if (!body) return;
    const b2Vec2 to = vector_from(bytes_);
    body->SetTransform(to, place_from(bytes_));
    body->SetLinearVelocity(vector_from(bytes_));
    body->SetEnabled(bytes_.below(8) != 0);
  }

  void begin_or_end_mode() {
    if (forces_) return forces_.reset();
    if (impulses_) return impulses_.reset();
    const hs_law_def law = read_law();
    try {
      if (law.stiffness_kind == HS_STIFFNESS_NONE) {
        impulses_ =
            std::make_unique<ImpulseMode>(*narrow_phase_, ImpulseOptions{.locate_impacts = bytes_.flag()});
        return;
      }
      forces_ = std::make_unique<ForceMode>(*narrow_phase_, law);
    } catch (const std::invalid_argument& refusal) {
      demand(*refusal.what() != 0, "a refusal has a text");
    }
  }

  hs_law_def read_law() {
    hs_law_def law;
    hs_law_def_init(&law, sizeof law);
    law.stiffness_kind = bytes_.below(4);
    law.normal_stiffness = 1024 * bytes_.positive();
    return law;
  }

  void copy() {
    try {
      WorldCopy copy(world_, read_law());
      const hs_status status = hs_world_step(copy.world(), 2);
      succeeds_or(status, {HS_ERROR_STATE, HS_ERROR_UNSTABLE, HS_ERROR_TOO_FAST}, "step");
      copy.write_back();
    } catch (const std::invalid_argument& refusal) {
      demand(*refusal.what() != 0, "a refusal has a text");
    }
  }

  void refresh() {
    b2Body* body = any_body();
    if (!body || !body->GetFixtureList()) return;
    body->GetFixtureList()->GetUserData().pointer = std::uintptr_t(bytes_.below(2));
    narrow_phase_->refresh(*body->GetFixtureList());
  }

  void step() {
    if (++steps_ > max_steps) return;
    if (!forces_ && !impulses_) return world_.Step(1 / 60.f, 8, 3);
    try {
      if (impulses_) return impulses_->step(1 / 60.f, 4, 2);
      constexpr int most_sub_steps = 50;
      forces_->step(1 / 60.f, std::min(forces_->sub_steps_for(1 / 60.f), most_sub_steps), 4, 2);
    } catch (const std::invalid_argument& refusal) {
      demand(*refusal.what() != 0, "a refusal has a text");
    }
  }

  void check() {
    for (const b2Body* body = world_.GetBodyList(); body; body = body->GetNext()) {
      demand(body->GetPosition().IsValid() && std::isfinite(body->GetAngle()), "a body is somewhere");
      demand(body->GetLinearVelocity().IsValid() && std::isfinite(body->GetAngularVelocity()),
             "a body has a velocity");
    }
    const Statistics& s = narrow_phase_->statistics();
    demand(s.pairs >= s.touching && s.touching >= 0, "of the pairs some touch");
  }

  Bytes bytes_;
  Context context_ = make_context();
  std::vector<Shape> attached_;
  b2World world_;
  std::unique_ptr<NarrowPhase> narrow_phase_;
  std::unique_ptr<ForceMode> forces_;
  std::unique_ptr<ImpulseMode> impulses_;
  int steps_ = 0;
};

}  // namespace
}  // namespace halfspace_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  halfspace_fuzz::Arena({data, size}).run();
  return 0;
}
