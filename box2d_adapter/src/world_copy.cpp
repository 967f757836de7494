#include <cmath>
#include <halfspace/box2d_world.hpp>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "block_world.h"
#include "placement.h"
#include "polygon.h"

namespace halfspace::box2d {
namespace {

/// A rigid block has one shape.
bool can_be_taken(const b2Body& body) {
  if (!body.IsEnabled()) return false;
  if (body.GetType() != b2_dynamicBody) return true;
  const b2Fixture* only = body.GetFixtureList();
  return only && !only->GetNext() && takes_part(*only);
}

}  // namespace

class WorldCopy::Blocks {
 public:
  Blocks(b2World& source, const hs_law_def& law)
      : context_(make_context()),
        polygons_(*context_),
        world_(*context_, law, make_world_def(source.GetGravity())) {
    for (b2Body* body = source.GetBodyList(); body; body = body->GetNext()) {
      if (can_be_taken(*body)) {
        add(*body);
      } else {
        left_out += body->GetType() == b2_dynamicBody;
      }
    }
  }

  void write_back() {
    for (const Rigid& rigid : rigid_) {
      hs_block_state state;
      world_.require_ok(hs_world_get_block_state(world_.get(), rigid.block, &state));
      move(*rigid.body, rigid.centroid, state);
    }
  }

  hs_world* world() const { return world_.get(); }
  hs_block block_of(const b2Fixture& fixture) const {
    const auto found = blocks_.find(&fixture);
    return found == blocks_.end() ? 0 : found->second;
  }

  std::int64_t left_out = 0;

 private:
  struct Rigid {
    b2Body* body;
    hs_block block;
    Vector centroid;  // in body coordinates
  };

  void add(b2Body& body) {
    for (b2Fixture* fixture = body.GetFixtureList(); fixture; fixture = fixture->GetNext()) {
      if (takes_part(*fixture)) add(body, *fixture);
    }
  }

  void add(b2Body& body, b2Fixture& fixture) {
    const auto polygon = polygons_.polygon_of(static_cast<const b2PolygonShape&>(*fixture.GetShape()));
    if (!polygon) throw std::invalid_argument(hs_context_last_error(context_.get()));
    const b2Transform& at = body.GetTransform();
    const Turn turn = turn_of(at.q);
    const Vector centroid = turn * polygon->centroid();
    hs_block_def def;
    world_.require_ok(hs_block_def_init(&def, sizeof def, polygon->shape()));
    def.kind = kind_of(body);
    def.pose = pose_of({turn, Vector(at.p) + centroid});
    const b2Vec2 velocity = body.GetLinearVelocityFromWorldPoint(rounded(Vector(at.p) + centroid));
    def.velocity[0] = velocity.x;
    def.velocity[1] = velocity.y;
    def.angular_velocity[2] = body.GetAngularVelocity();
    const hs_block block = world_.add(*polygon, material_of(fixture, *polygon), def);
    blocks_.emplace(&fixture, block);
    if (def.kind == HS_BLOCK_RIGID) rigid_.push_back({&body, block, polygon->centroid()});
  }

  static void move(b2Body& body, const Vector& centroid, const hs_block_state& state) {
    const double z = state.pose.rotation[2], w = state.pose.rotation[3];
    const Turn turn{w * w - z * z, 2 * z * w};
    // Relative to the angle of the body, to keep full turns.
    const Turn since = turn * turn_of(b2Rot(body.GetAngle())).inverse();
    const double angle = body.GetAngle() + std::atan2(since.sine, since.cosine);
    const Vector at{state.pose.position[0], state.pose.position[1]};
    body.SetTransform(rounded(at - turn * centroid), float(angle));
    body.SetLinearVelocity({float(state.velocity[0]), float(state.velocity[1])});
    body.SetAngularVelocity(float(state.angular_velocity[2]));
  }

  Context context_;
  Polygons polygons_;
  BlockWorld world_;
  std::unordered_map<const b2Fixture*, hs_block> blocks_;
  std::vector<Rigid> rigid_;
};

WorldCopy::WorldCopy(b2World& source, const hs_law_def& law)
    : blocks_(std::make_unique<Blocks>(source, law)) {}

WorldCopy::~WorldCopy() = default;

hs_world* WorldCopy::world() const { return blocks_->world(); }

hs_block WorldCopy::block_of(const b2Fixture& fixture) const { return blocks_->block_of(fixture); }

std::int64_t WorldCopy::bodies_left_out() const { return blocks_->left_out; }

void WorldCopy::write_back() { blocks_->write_back(); }

}  // namespace halfspace::box2d
