#pragma once

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include <halfspace/box2d.hpp>
#include <memory_resource>
#include <utility>

#include "polygon.h"
#include "polygon_pair.h"

namespace halfspace::box2d {

/// The data of a contact that the half-space narrow phase evaluates.
struct JudgedPair {
  JudgedPair(PolygonPair pair, NarrowPhase::Installation& judge, std::int64_t place_in_order)
      : polygons(std::move(pair)), installation(judge), order(place_in_order) {}

  PolygonPair polygons;
  NarrowPhase::Installation& installation;
  std::int64_t order;        // number of this pair, in order of their begin
  bool let_through = false;  // with forces or impulses: the host's listener has disabled the contact
};

/// Common data of the contacts of one world.
class NarrowPhase::Installation {
 public:
  Installation(b2World& world, Options options);
  ~Installation();

  /// Creates the pair of a new contact. NULL if Box2D handles it: it was left to Box2D, the library refuses a
  /// shape, or there is no memory.
  JudgedPair* begin(b2Fixture& a, b2Fixture& b) noexcept;
  void end(JudgedPair* pair) noexcept;

  /// Evaluates the pair of a contact. False if Box2D must compute the manifold.
  bool collide(JudgedPair& pair, b2Contact& contact, const b2Transform& at_a, const b2Transform& at_b,
               b2Manifold& manifold);

  /// Updates the geometry in the contacts of a fixture.
  void refresh(b2Fixture& fixture);

  b2World& world() const { return world_; }
  /// The polygon of a fixture: that of its contacts, or without contacts the one that the host returns now.
  /// NULL if Box2D handles the fixture.
  std::shared_ptr<const Polygon> polygon_taken_for(b2Fixture& fixture) noexcept;
  std::int64_t pairs_begun() const { return pairs_begun_; }
  /// Do forces or impulses of the library replace Box2D's solver? Max one mode at a time.
  bool has_mode = false;

  Statistics statistics;

 private:
  /// NULL if the fixture is left to Box2D.
  std::shared_ptr<const Polygon> geometry_of(b2Fixture& fixture);
  bool collide_and_compare(JudgedPair& pair, b2Contact& contact, const b2Transform& at_a,
                           const b2Transform& at_b, b2Manifold& manifold);

  b2World& world_;
  Options options_;
  Context context_;
  Polygons polygons_;
  std::int64_t pairs_begun_ = 0;
  std::pmr::unsynchronized_pool_resource pairs_;  // visited in every step: contiguous in memory
};

}  // namespace halfspace::box2d
