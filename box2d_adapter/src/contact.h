#pragma once

#include <box2d/b2_contact.h>

#include "installation.h"

namespace halfspace::box2d {

/// Box2D's contact of two polygon fixtures. The half-space narrow phase evaluates it while that is installed
/// in its world; Box2D does so for pairs left to it, and after the narrow phase has ended.
///
/// It has the size class of Box2D's own polygon contact (see fits_in_place_of_box2d()). So it can replace
/// such a contact in place, where bodies and world point to it, and Box2D's table of contact types can free
/// both.
class PolygonContact final : public b2Contact {
 public:
  PolygonContact(b2Fixture* a, b2Fixture* b, NarrowPhase::Installation& installation);
  ~PolygonContact() override { leave(); }

  /// Replaces a contact of Box2D in place, with its state. A PolygonContact updates the geometry of its
  /// fixtures instead.
  static void install(b2Contact& contact, NarrowPhase::Installation& installation);

  /// Box2D evaluates it from now on.
  void leave();

  void Evaluate(b2Manifold* manifold, const b2Transform& at_a, const b2Transform& at_b) override;

  /// NULL if Box2D evaluates it.
  JudgedPair* pair() const { return pair_; }

 private:
  explicit PolygonContact(const b2Contact& of_box2d) : b2Contact(of_box2d) {}
  PolygonContact(const PolygonContact&) = delete;
  void join(NarrowPhase::Installation& installation);

  JudgedPair* pair_ = nullptr;
};

/// Is this a contact of two polygon fixtures?
bool is_of_polygons(b2Contact& contact);

/// The pair of the half-space narrow phase; NULL if Box2D evaluates the contact.
JudgedPair* judged_pair_of(b2Contact& contact);

/// Does Box2D's allocator use the same size class for both kinds of contact? Then one can replace the other
/// in place.
bool fits_in_place_of_box2d();

}  // namespace halfspace::box2d
