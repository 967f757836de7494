#include "block_world.h"

#include <box2d/b2_contact.h>

#include <cmath>
#include <new>
#include <stdexcept>

namespace halfspace::box2d {
namespace {

float mass_of(const b2Fixture& fixture) {
  if (fixture.GetDensity() == 0) return 0;
  b2MassData mass;
  fixture.GetMassData(&mass);
  return mass.mass;
}

}  // namespace

bool takes_part(const b2Fixture& fixture) {
  return fixture.GetType() == b2Shape::e_polygon && !fixture.IsSensor();
}

std::int32_t kind_of(const b2Body& body) {
  if (body.GetType() == b2_staticBody) return HS_BLOCK_FIXED;
  const bool is_pushed = body.GetType() == b2_dynamicBody && body.GetMass() > 0;
  return is_pushed ? HS_BLOCK_RIGID : HS_BLOCK_PRESCRIBED;
}

Material material_of(const b2Fixture& fixture, const Polygon& polygon) {
  if (!b2IsValid(fixture.GetFriction()))
    throw std::invalid_argument("the friction of a fixture must be finite");
  const b2Body& body = *fixture.GetBody();
  if (kind_of(body) != HS_BLOCK_RIGID) return {1, fixture.GetFriction()};
  float of_all = 0;  // the same sum as in b2Body::ResetMassData()
  int fixtures = 0;
  for (const b2Fixture* each = body.GetFixtureList(); each; each = each->GetNext()) {
    of_all += mass_of(*each);
    ++fixtures;
  }
  const float own = mass_of(fixture);
  if (own > 0 && of_all == body.GetMass()) return {fixture.GetDensity(), fixture.GetFriction()};
  const double share = own > 0 ? double(own) / of_all : 1. / fixtures;
  return {share * body.GetMass() / properties_of_polygon(*polygon.shape()).volume, fixture.GetFriction()};
}

void require_current(hs_status status) {
  if (status != HS_OK) throw std::runtime_error("the library is older than the adapter");
}

hs_world_def make_world_def(const b2Vec2& gravity) {
  hs_world_def def;
  require_current(hs_world_def_init(&def, sizeof def, 2));
  def.gravity[0] = gravity.x;
  def.gravity[1] = gravity.y;
  return def;
}

BlockWorld::BlockWorld(hs_context& context, const hs_law_def& law, const hs_world_def& def)
    : context_(context), law_(law) {
  hs_world* world = nullptr;
  require_ok(hs_world_create(&context_, &def, &world));
  world_.reset(world);
  require_ok(hs_world_set_default_law(world, &law_));
}

void BlockWorld::require_ok(hs_status status) const {
  if (status == HS_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status < 0) throw std::invalid_argument(hs_context_last_error(&context_));
}

hs_block BlockWorld::add(const Polygon& polygon, const Material& material, hs_block_def def) {
  def.material = index_of(material);
  hs_block block = 0;
  require_ok(hs_world_add_block(world_.get(), polygon.shape(), &def, &block));
  return block;
}

std::int32_t BlockWorld::index_of(const Material& material) {
  const auto found = materials_.find(material);
  if (found != materials_.end()) return found->second;
  std::int32_t made = 0;
  require_ok(hs_world_add_material(world_.get(), material.density, &made));
  const auto set_law = [&](const Material& other, std::int32_t index) {
    hs_law_def law = law_;
    law.friction_angle = std::atan(b2MixFriction(material.friction, other.friction));
    const float restitution = b2MixRestitution(material.restitution, other.restitution);
    if (restitution != 0) law.restitution = restitution;
    require_ok(hs_world_set_law(world_.get(), made, index, &law));
  };
  set_law(material, made);
  for (const auto& [other, index] : materials_) set_law(other, index);
  materials_.emplace(material, made);  // after all of its laws are set
  return made;
}

}  // namespace halfspace::box2d
