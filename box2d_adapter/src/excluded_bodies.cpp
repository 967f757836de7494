#include "excluded_bodies.h"

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_joint.h>

#include <typeinfo>

#include "block_world.h"
#include "contact.h"

namespace halfspace::box2d {
namespace {

bool is_default(const b2Filter& filter) {
  const b2Filter other;
  return filter.categoryBits == other.categoryBits && filter.maskBits == other.maskBits &&
         filter.groupIndex == other.groupIndex;
}

/// Visits the fixtures that can be blocks.
template <class Visit>
void for_each_part(b2Body& body, Visit visit) {
  for (b2Fixture* fixture = body.GetFixtureList(); fixture; fixture = fixture->GetNext()) {
    if (takes_part(*fixture)) visit(*fixture);
  }
}

bool has_part(b2Body& body) {
  bool any = false;
  for_each_part(body, [&](b2Fixture&) { any = true; });
  return any;
}

/// Does Box2D's own filter let all fixtures collide?
bool do_all_collide(b2World& world) {
  const b2ContactFilter& filter = *world.GetContactManager().m_contactFilter;
  bool all = typeid(filter) == typeid(b2ContactFilter);
  for (b2Body* body = world.GetBodyList(); body && all; body = body->GetNext())
    for_each_part(*body, [&](b2Fixture& fixture) { all = all && is_default(fixture.GetFilterData()); });
  return all;
}

template <class Visit>
struct Query final : b2QueryCallback {
  explicit Query(Visit each) : visit(each) {}
  bool ReportFixture(b2Fixture* fixture) override {
    visit(*fixture);
    return true;
  }
  Visit visit;
};

}  // namespace

void ExcludedBodies::find(b2World& world, float time_step) {
  bodies_.clear();
  for (b2Contact* contact = world.GetContactList(); contact; contact = contact->GetNext()) {
    const JudgedPair* pair = judged_pair_of(*contact);
    if (pair && pair->let_through && contact->IsTouching())
      exclude(*contact->GetFixtureA()->GetBody(), *contact->GetFixtureB()->GetBody());
  }
  const bool all_collide = do_all_collide(world);
  for (b2Body* body = world.GetBodyList(); body; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody || !body->IsEnabled()) continue;
    exclude_joined(*body);
    if (all_collide) continue;
    for_each_part(*body, [&](b2Fixture& fixture) { exclude_filtered(world, fixture, time_step); });
  }
}

void ExcludedBodies::exclude(const b2Body& a, const b2Body& b) {
  if (a.GetType() == b2_dynamicBody) bodies_.insert(&a);
  if (b.GetType() == b2_dynamicBody) bodies_.insert(&b);
}

void ExcludedBodies::exclude_joined(b2Body& body) {
  for (const b2JointEdge* edge = body.GetJointList(); edge; edge = edge->next) {
    if (!edge->joint->GetCollideConnected() && has_part(body) && has_part(*edge->other))
      exclude(body, *edge->other);
  }
}

/// Box2D's boxes have a margin; the way in the step is added.
void ExcludedBodies::exclude_filtered(b2World& world, b2Fixture& fixture, float time_step) {
  const b2Body& body = *fixture.GetBody();
  b2ContactFilter& filter = *world.GetContactManager().m_contactFilter;
  Query query([&](b2Fixture& other) {
    const bool is_pair = other.GetBody() != &body && takes_part(other);
    if (is_pair && !filter.ShouldCollide(&fixture, &other)) exclude(body, *other.GetBody());
  });
  const b2AABB here = fixture.GetAABB(0);
  const b2Vec2 way = time_step * body.GetLinearVelocity();
  b2AABB swept{here.lowerBound + way, here.upperBound + way};
  swept.Combine(here);
  world.QueryAABB(&query, swept);
}

}  // namespace halfspace::box2d
