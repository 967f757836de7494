#include "contact.h"

#include <box2d/b2_block_allocator.h>
#include <box2d/b2_polygon_shape.h>

#include <new>

namespace halfspace::box2d {
PolygonContact::PolygonContact(b2Fixture* a, b2Fixture* b, NarrowPhase::Installation& installation)
    : b2Contact(a, 0, b, 0) {
  join(installation);
}

void PolygonContact::install(b2Contact& contact, NarrowPhase::Installation& installation) {
  if (auto* own = dynamic_cast<PolygonContact*>(&contact)) {
    own->leave();
    own->join(installation);
    return;
  }
  const PolygonContact kept(contact);
  const b2Contact& state = kept;
  (new (&contact) PolygonContact(state))->join(installation);
}

void PolygonContact::join(NarrowPhase::Installation& installation) {
  pair_ = installation.begin(*m_fixtureA, *m_fixtureB);
}

void PolygonContact::leave() {
  if (pair_) pair_->installation.end(pair_);
  pair_ = nullptr;
}

void PolygonContact::Evaluate(b2Manifold* manifold, const b2Transform& at_a, const b2Transform& at_b) {
  if (pair_ && pair_->installation.collide(*pair_, *this, at_a, at_b, *manifold)) return;
  b2CollidePolygons(manifold, static_cast<const b2PolygonShape*>(m_fixtureA->GetShape()), at_a,
                    static_cast<const b2PolygonShape*>(m_fixtureB->GetShape()), at_b);
}

bool is_of_polygons(b2Contact& contact) {
  return contact.GetFixtureA()->GetType() == b2Shape::e_polygon &&
         contact.GetFixtureB()->GetType() == b2Shape::e_polygon;
}

JudgedPair* judged_pair_of(b2Contact& contact) {
  const auto* own = dynamic_cast<PolygonContact*>(&contact);
  return own ? own->pair() : nullptr;
}

bool fits_in_place_of_box2d() {
  b2BlockAllocator allocator;
  // The allocator returns the last freed block of a size class first.
  void* const freed = allocator.Allocate(int32(sizeof(b2Contact)));
  allocator.Free(freed, int32(sizeof(b2Contact)));
  return allocator.Allocate(int32(sizeof(PolygonContact))) == freed;
}

}  // namespace halfspace::box2d
