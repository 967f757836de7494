#pragma once

// The half-space narrow phase inside Box2D worlds: polygons meet by libhalfspace's detection, in double, and
// everything else stays Box2D's: broad phase, solver, continuous collision, sensors, circles, edges, chains.
//
//   b2World world(gravity);
//   halfspace::box2d::NarrowPhase narrow_phase(world);  // until the end of its scope
//   world.Step(1 / 60.f, 8, 3);

#include <box2d/box2d.h>
#include <halfspace/halfspace.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace halfspace::box2d {

/// What the narrow phase takes a polygon fixture for.
struct FixtureGeometry {
  /// Pairs with this fixture stay with Box2D's own narrow phase.
  bool left_to_box2d = false;
  /// A polygon to use in place of the fixture's, of any number of vertices, in the coordinates of the body
  /// that it was made from; NULL for the fixture's own. Borrowed: it must live as long as the fixture, or
  /// until NarrowPhase::refresh() has been told of another, and its context and all made from that belong to
  /// the thread that steps the world. The fixture's own shape must hold this one (box_around() makes one that
  /// does): it still serves the broad phase, continuous collision, ray casts, sensors and the mass, it is
  /// what circles, edges, chains and fixtures left to Box2D meet, and what is left of it when the narrow
  /// phase ends.
  const hs_shape* shape = nullptr;
};

/// One pair as both narrow phases have judged it, at the same poses. All is borrowed for the call.
struct Comparison {
  b2Fixture& a;  ///< the contact's first fixture; its shape may have another polygon attached to it
  b2Fixture& b;
  const b2Transform& at_a;
  const b2Transform& at_b;
  const b2Manifold& halfspace;  ///< the one that drives the world. Of its points, impulses are not set yet
  const b2Manifold& box2d;      ///< of the fixtures' own shapes, also where a polygon is attached
  double seconds;               ///< of the half-space narrow phase, and of reading the clock once
  double box2d_seconds;         ///< of Box2D's, likewise
};

struct Options {
  /// Asked when a contact is made, in refresh(), and by force mode about fixtures without contacts; empty:
  /// every fixture is taken for its own polygon. It must not change the world nor begin, refresh or end a
  /// narrow phase; what it throws leaves the pair to Box2D, as does a shape that is no polygon.
  std::function<FixtureGeometry(b2Fixture&)> geometry_of;
  /// When given, Box2D's narrow phase is run as well on each pair that the library answers, and both answers
  /// and times are told; Box2D's is not used. Called while the world steps, by its thread: it must not change
  /// the world, nor throw. An empty function costs nothing; one that does nothing leaves the counts in the
  /// statistics.
  std::function<void(const Comparison&)> compared;
};

/// What has happened since the narrow phase began, or since reset_statistics().
struct Statistics {
  std::int64_t pairs = 0;     ///< asked about and answered by half-spaces, each time again
  std::int64_t touching = 0;  ///< of these, with one manifold point or two
  std::int64_t refused = 0;   ///< answered by Box2D as the library could not: a pose that is not finite, or
                              ///< no memory. Pairs that are left to Box2D from the start are not counted
  std::int64_t compared = 0;  ///< answered by both; this and the following only where compared
  std::int64_t disagreements = 0;  ///< where one had manifold points and the other had none
  double seconds = 0;              ///< of the half-space narrow phase, on pairs compared
  double box2d_seconds = 0;        ///< of Box2D's, on the same
};

class ForceMode;  // box2d_force.hpp

/// The half-space narrow phase in one world, from the constructor to the destructor. Contacts that exist when
/// it begins are taken over with their impulses, so that a stack at rest stays so, and go on as Box2D's when
/// it ends. Other worlds of the process see nothing of it.
///
/// It must end before its world does: declare it after the world.
///
/// Thread rule: that of its world. Box2D's table of contact types is shared by all worlds, and changes when
/// the first narrow phase of the process begins and when the last one ends: no other world may step then.
class NarrowPhase {
 public:
  /// Throws std::logic_error when the world is locked or has a narrow phase already, std::bad_alloc, and
  /// std::runtime_error when this Box2D keeps contacts in another manner than the one it was made for, 2.4.
  explicit NarrowPhase(b2World& world, Options options = {});
  ~NarrowPhase();
  NarrowPhase(const NarrowPhase&) = delete;
  NarrowPhase& operator=(const NarrowPhase&) = delete;

  /// To be called when Options::geometry_of has changed its mind about a fixture that has contacts, or when
  /// the vertices or the radius of its shape have been changed. The world must not be locked.
  void refresh(b2Fixture& fixture);

  const Statistics& statistics() const;
  void reset_statistics();

  class Installation;

 private:
  friend class ForceMode;
  std::unique_ptr<Installation> installation_;
};

/// An upright box in the coordinates of the body that holds a polygon, to a float's rounding, which is within
/// its skin: a shape for the fixture that the polygon is attached to. Its mass is that of the box; see
/// mass_of().
b2PolygonShape box_around(const hs_shape& polygon);

/// Mass, centre and inertia about the body's origin of a polygon, for b2Body::SetMassData().
b2MassData mass_of(const hs_shape& polygon, float density);

}  // namespace halfspace::box2d
