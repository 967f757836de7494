#pragma once

#include <box2d/b2_contact.h>

#include "installation.h"

namespace halfspace::box2d {

/// Box2D's contact of two polygon fixtures, judged by half-spaces as long as a narrow phase is installed in
/// its world, and as Box2D does where that leaves the pair to it and once it has ended.
///
/// It has the size class of Box2D's own polygon contact (see fits_in_place_of_box2d()). So it can be made
/// where such a one lies, to which bodies and world point, and Box2D's table of contact types can go on to
/// free both.
class PolygonContact final : public b2Contact {
 public:
  PolygonContact(b2Fixture* a, b2Fixture* b, NarrowPhase::Installation& installation);
  ~PolygonContact() override { leave(); }

  /// Takes over a contact of Box2D's, with all that it holds, in its place. One that is a PolygonContact
  /// already asks anew what its fixtures are taken for.
  static void install(b2Contact& contact, NarrowPhase::Installation& installation);

  /// From here on it is judged by Box2D.
  void leave();

  void Evaluate(b2Manifold* manifold, const b2Transform& at_a, const b2Transform& at_b) override;

  /// Null when Box2D judges it.
  JudgedPair* pair() const { return pair_; }

 private:
  explicit PolygonContact(const b2Contact& of_box2d) : b2Contact(of_box2d) {}
  PolygonContact(const PolygonContact&) = delete;
  void join(NarrowPhase::Installation& installation);

  JudgedPair* pair_ = nullptr;
};

/// Is this a contact of two polygon fixtures?
bool is_of_polygons(b2Contact& contact);

/// The pair that half-spaces judge; null when Box2D judges the contact.
JudgedPair* judged_pair_of(b2Contact& contact);

/// Does Box2D's allocator take the memory of both kinds of contact from one list? Then one can take the place
/// of the other.
bool fits_in_place_of_box2d();

}  // namespace halfspace::box2d
