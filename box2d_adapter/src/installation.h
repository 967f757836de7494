#pragma once

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include <halfspace/box2d.hpp>
#include <memory_resource>
#include <utility>

#include "polygon.h"
#include "polygon_pair.h"

namespace halfspace::box2d {

/// What a contact has while the narrow phase judges it.
struct JudgedPair {
  JudgedPair(PolygonPair pair, NarrowPhase::Installation& judge, std::int64_t place_in_order)
      : polygons(std::move(pair)), installation(judge), order(place_in_order) {}

  PolygonPair polygons;
  NarrowPhase::Installation& installation;
  std::int64_t order;        // so many pairs had begun with it
  bool let_through = false;  // in force mode, by the host's listener
};

/// What the contacts of one world share.
class NarrowPhase::Installation {
 public:
  Installation(b2World& world, Options options);
  ~Installation();

  /// For a new contact. Null when the pair is Box2D's: left to it, of a shape that the library refuses, or
  /// without memory.
  JudgedPair* begin(b2Fixture& a, b2Fixture& b) noexcept;
  void end(JudgedPair* pair) noexcept;

  /// The pair is that of the contact. False when the manifold has to come from Box2D.
  bool collide(JudgedPair& pair, b2Contact& contact, const b2Transform& at_a, const b2Transform& at_b,
               b2Manifold& manifold);

  /// Asks anew about the contacts of a fixture.
  void refresh(b2Fixture& fixture);

  b2World& world() const { return world_; }
  /// What a polygon fixture is taken for: in its contacts, or if it has none, what the host would have it be
  /// in one now. Null when it is Box2D's.
  std::shared_ptr<const Polygon> polygon_taken_for(b2Fixture& fixture) noexcept;
  std::int64_t pairs_begun() const { return pairs_begun_; }
  /// Of force mode, of which there is one at a time.
  bool has_force_mode = false;

  Statistics statistics;

 private:
  /// Null when the fixture is left to Box2D.
  std::shared_ptr<const Polygon> geometry_of(b2Fixture& fixture);
  bool collide_and_compare(JudgedPair& pair, b2Contact& contact, const b2Transform& at_a,
                           const b2Transform& at_b, b2Manifold& manifold);

  b2World& world_;
  Options options_;
  Context context_;
  Polygons polygons_;
  std::int64_t pairs_begun_ = 0;
  std::pmr::unsynchronized_pool_resource pairs_;  // gone through in every step: side by side
};

}  // namespace halfspace::box2d
