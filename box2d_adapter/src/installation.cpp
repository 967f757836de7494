#include "installation.h"

#include <box2d/b2_polygon_shape.h>

#include <chrono>
#include <stdexcept>

#include "contact.h"
#include "registration.h"

namespace halfspace::box2d {
namespace {

/// Seconds that `work` takes.
template <class Work>
double seconds_of(Work&& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const b2PolygonShape& polygon_of(const b2Fixture& fixture) {
  return static_cast<const b2PolygonShape&>(*fixture.GetShape());
}

}  // namespace

NarrowPhase::Installation::Installation(b2World& world, Options options)
    : world_(world), options_(std::move(options)), context_(make_context()), polygons_(*context_) {
  if (world.IsLocked()) throw std::logic_error("a narrow phase cannot begin while its world steps");
  if (!fits_in_place_of_box2d())
    throw std::runtime_error("the contacts of this Box2D have another layout than in version 2.4");
  if (!enter(world, *this)) throw std::logic_error("the world has a narrow phase already");
  for (b2Contact* contact = world.GetContactList(); contact; contact = contact->GetNext()) {
    if (is_of_polygons(*contact)) PolygonContact::install(*contact, *this);
  }
}

NarrowPhase::Installation::~Installation() {
  withdraw(world_);
  for (b2Contact* contact = world_.GetContactList(); contact; contact = contact->GetNext()) {
    if (auto* judged = dynamic_cast<PolygonContact*>(contact)) judged->leave();
  }
}

std::shared_ptr<const Polygon> NarrowPhase::Installation::geometry_of(b2Fixture& fixture) {
  const FixtureGeometry chosen = options_.geometry_of ? options_.geometry_of(fixture) : FixtureGeometry();
  if (chosen.left_to_box2d) return nullptr;
  return chosen.shape ? polygons_.polygon_of(*chosen.shape) : polygons_.polygon_of(polygon_of(fixture));
}

JudgedPair* NarrowPhase::Installation::begin(b2Fixture& a, b2Fixture& b) noexcept {
  try {
    std::shared_ptr<const Polygon> of_a = geometry_of(a), of_b = geometry_of(b);
    if (!of_a || !of_b) return nullptr;
    const double radii = polygon_of(a).m_radius + polygon_of(b).m_radius;
    auto* pair = std::pmr::polymorphic_allocator<>(&pairs_).new_object<JudgedPair>(
        PolygonPair(std::move(of_a), std::move(of_b), radii), *this, pairs_begun_ + 1);
    ++pairs_begun_;
    return pair;
  } catch (...) {
    return nullptr;
  }
}

std::shared_ptr<const Polygon> NarrowPhase::Installation::polygon_taken_for(b2Fixture& fixture) noexcept {
  try {
    for (b2ContactEdge* edge = fixture.GetBody()->GetContactList(); edge; edge = edge->next) {
      const JudgedPair* pair = judged_pair_of(*edge->contact);
      if (pair && edge->contact->GetFixtureA() == &fixture) return pair->polygons.a();
      if (pair && edge->contact->GetFixtureB() == &fixture) return pair->polygons.b();
    }
    return geometry_of(fixture);
  } catch (...) {
    return nullptr;
  }
}

void NarrowPhase::Installation::end(JudgedPair* pair) noexcept {
  std::pmr::polymorphic_allocator<>(&pairs_).delete_object(pair);
}

bool NarrowPhase::Installation::collide(JudgedPair& pair, b2Contact& contact, const b2Transform& at_a,
                                        const b2Transform& at_b, b2Manifold& manifold) {
  const bool known = options_.compared ? collide_and_compare(pair, contact, at_a, at_b, manifold)
                                       : pair.polygons.collide(at_a, at_b, manifold);
  statistics.refused += !known;
  statistics.pairs += known;
  statistics.touching += known && manifold.pointCount > 0;
  return known;
}

bool NarrowPhase::Installation::collide_and_compare(JudgedPair& pair, b2Contact& contact,
                                                    const b2Transform& at_a, const b2Transform& at_b,
                                                    b2Manifold& manifold) {
  bool known = false;
  const double seconds = seconds_of([&] { known = pair.polygons.collide(at_a, at_b, manifold); });
  if (!known) return false;
  b2Fixture &a = *contact.GetFixtureA(), &b = *contact.GetFixtureB();
  b2Manifold of_box2d;
  const double box2d_seconds =
      seconds_of([&] { b2CollidePolygons(&of_box2d, &polygon_of(a), at_a, &polygon_of(b), at_b); });
  statistics.seconds += seconds;
  statistics.box2d_seconds += box2d_seconds;
  ++statistics.compared;
  statistics.disagreements += (manifold.pointCount > 0) != (of_box2d.pointCount > 0);
  options_.compared({a, b, at_a, at_b, manifold, of_box2d, seconds, box2d_seconds});
  return true;
}

void NarrowPhase::Installation::refresh(b2Fixture& fixture) {
  if (world_.IsLocked()) throw std::logic_error("a fixture cannot be refreshed while its world steps");
  for (b2ContactEdge* edge = fixture.GetBody()->GetContactList(); edge; edge = edge->next) {
    b2Contact& contact = *edge->contact;
    const bool concerned = contact.GetFixtureA() == &fixture || contact.GetFixtureB() == &fixture;
    if (concerned && is_of_polygons(contact)) PolygonContact::install(contact, *this);
  }
}

}  // namespace halfspace::box2d
