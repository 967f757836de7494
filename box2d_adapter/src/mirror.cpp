#include "mirror.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "placement.h"

namespace halfspace::box2d {

bool is_somewhere(const b2Body& body) {
  return body.IsEnabled() && body.GetPosition().IsValid() && body.GetLinearVelocity().IsValid() &&
         b2IsValid(body.GetAngle()) && b2IsValid(body.GetAngularVelocity());
}

Mirror::Known::Known(b2Fixture& of, const std::shared_ptr<const Polygon>& taken_for, const Material& material)
    : fixture(&of),
      polygon(taken_for),
      held(taken_for->is_borrowed() ? nullptr : taken_for),
      centroid(taken_for->centroid()),
      material(material),
      kind(kind_of(*of.GetBody())) {}

/// Bodies that no force moves are first: of two parallel edges the one of the first block is the contact
/// plane, and that of a floor does not tilt under load.
void Mirror::follow() {
  renewed_.clear();
  for (auto& [fixture, known] : known_) known.is_there = false;
  for (const bool are_moved : {false, true}) {
    for (b2Body* body = narrow_phase_.world().GetBodyList(); body; body = body->GetNext()) {
      const bool is_moved = body->GetType() == b2_dynamicBody;
      if (is_somewhere(*body) && is_moved == are_moved) find(*body);
    }
  }
  remove_what_is_gone();
  list_blocks();
}

bool Mirror::are_all_somewhere() const {
  return std::all_of(bodies_.begin(), bodies_.end(),
                     [](const Body& body) { return is_somewhere(*body.body); });
}

/// In order of blocks, not of the hash table, as later blocks reuse the slots.
void Mirror::remove_what_is_gone() {
  std::vector<std::pair<hs_block, const b2Fixture*>> gone;
  for (const auto& [fixture, known] : known_) {
    if (!known.is_there) gone.emplace_back(known.block, fixture);
  }
  std::sort(gone.begin(), gone.end());
  for (const auto& [block, fixture] : gone) {
    world_.require_ok(hs_world_remove_block(world_.get(), block));
    known_.erase(fixture);
  }
}

void Mirror::find(b2Body& body) {
  for (b2Fixture* fixture = body.GetFixtureList(); fixture; fixture = fixture->GetNext()) {
    if (takes_part(*fixture)) find(*fixture);
  }
}

void Mirror::find(b2Fixture& fixture) {
  const auto polygon = narrow_phase_.polygon_taken_for(fixture);
  if (!polygon) return;
  const std::optional<Material> material = material_for(fixture, *polygon);
  if (!material) return;
  Known now(fixture, polygon, *material);
  const auto found = known_.find(&fixture);
  if (found == known_.end()) {
    add(*polygon, std::move(now));
  } else if (found->second.is_same(now)) {
    found->second.is_there = true;
  } else {
    renew(found->second, *polygon, std::move(now));
  }
}

void Mirror::add(const Polygon& polygon, Known known) {
  hs_block_def def;
  world_.require_ok(hs_block_def_init(&def, sizeof def, polygon.shape()));
  def.kind = known.kind;
  const auto added = known_.emplace(known.fixture, std::move(known)).first;
  try {
    added->second.block = world_.add(polygon, added->second.material, def);
  } catch (...) {
    known_.erase(added);
    throw;
  }
}

/// Material and kind of a block are constant, so a new block replaces it.
void Mirror::renew(Known& before, const Polygon& polygon, Known now) {
  const hs_block old = before.block;
  const bool keeps_its_surface = before.is_of_same_polygon(now);
  const b2Fixture* fixture = now.fixture;
  world_.require_ok(hs_world_remove_block(world_.get(), old));
  known_.erase(fixture);
  add(polygon, std::move(now));
  if (keeps_its_surface) renewed_.emplace(old, known_.at(fixture).block);
}

void Mirror::list_blocks() {
  ids_.resize(known_.size());
  world_.require_ok(hs_world_get_blocks(world_.get(), ids_.data(), std::int64_t(ids_.size()), nullptr));
  index_of_block_.clear();
  for (std::size_t i = 0; i < ids_.size(); ++i) index_of_block_.emplace(ids_[i], i);

  std::vector<Body> before;
  before.swap(bodies_);
  const auto index_before = std::exchange(index_of_body_, {});
  blocks_.resize(ids_.size());
  for (const auto& [key, known] : known_) {
    b2Body& body = *known.fixture->GetBody();
    const auto [listed, is_new] = index_of_body_.emplace(&body, bodies_.size());
    if (is_new) {
      const auto old = index_before.find(&body);
      bodies_.push_back(old == index_before.end() ? Body(body) : before[old->second]);
      bodies_.back().motion.follow(body);
    }
    const Vector arm = known.centroid - Vector(body.GetLocalCenter());
    blocks_[index_of_block_.at(known.block)] = {known.fixture, listed->second, arm};
  }
  poses_.resize(ids_.size());
  motions_.resize(ids_.size());
}

void Mirror::place() {
  for (Body& body : bodies_) body.turn = {std::cos(body.motion.angle()), std::sin(body.motion.angle())};
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Body& body = bodies_[blocks_[i].body];
    const Vector arm = body.turn * blocks_[i].arm;
    const double spin = body.motion.spin();
    const Vector velocity = body.motion.velocity() + spin * Vector{-arm.y, arm.x};
    poses_[i] = pose_of({body.turn, body.motion.center() + arm});
    motions_[i] = {{velocity.x, velocity.y, 0}, {0, 0, spin}};
  }
  if (blocks_.empty()) return;
  world_.require_ok(hs_world_set_poses(world_.get(), poses_.data(), block_count()));
  world_.require_ok(hs_world_set_velocities(world_.get(), view_of<hs_view>(&Motion::velocity),
                                            view_of<hs_view>(&Motion::spin)));
}

hs_block Mirror::block_of(const b2Fixture& fixture) const {
  const auto found = known_.find(&fixture);
  return found == known_.end() ? 0 : found->second.block;
}

}  // namespace halfspace::box2d
