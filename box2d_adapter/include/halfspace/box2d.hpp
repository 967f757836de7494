#pragma once

// The half-space narrow phase inside Box2D worlds: libhalfspace detects contacts of polygons in double
// precision. Broad phase, solver, continuous collision, sensors, circles, edges and chains remain Box2D's.
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

/// The geometry that the narrow phase uses for a polygon fixture.
struct FixtureGeometry {
  /// True: Box2D's narrow phase handles all pairs of this fixture.
  bool left_to_box2d = false;
  /// A polygon that replaces the fixture's own, in body coordinates, with any number of vertices; NULL: the
  /// fixture's own. It is borrowed: it must outlive the fixture, or the call of NarrowPhase::refresh() that
  /// replaces it; its context belongs to the thread that steps the world. The fixture's own shape must
  /// contain it (see box_around()): broad phase, continuous collision, ray casts, sensors, the mass, and
  /// contacts with circles, edges, chains and fixtures left to Box2D still use that shape.
  const hs_shape* shape = nullptr;
};

/// Results of both narrow phases for one pair, at the same poses. All members are borrowed for the call.
struct Comparison {
  b2Fixture& a;  ///< first fixture of the contact; another polygon may replace its shape
  b2Fixture& b;
  const b2Transform& at_a;
  const b2Transform& at_b;
  const b2Manifold& halfspace;  ///< the manifold in use; impulses are not set yet
  const b2Manifold& box2d;      ///< of the fixtures' own shapes, also if a polygon replaces them
  double seconds;               ///< s, of the half-space narrow phase, including one reading of the clock
  double box2d_seconds;         ///< s, of Box2D's narrow phase, likewise
};

struct Options {
  /// Returns the geometry of a fixture; empty: its own polygon. Called when a contact is created, by
  /// refresh(), and by force mode for fixtures without contacts. It must not change the world, nor begin,
  /// refresh or end a narrow phase. If it throws, or returns a shape that is no polygon, Box2D handles the
  /// pair.
  std::function<FixtureGeometry(b2Fixture&)> geometry_of;
  /// Receives the results and times of both narrow phases for each pair that the library handles; those of
  /// Box2D are not used. Called on the thread that steps the world: it must not change the world, nor throw.
  /// An empty function costs nothing; with one that does nothing, Statistics still has the counts.
  std::function<void(const Comparison&)> compared;
};

/// Counts since the narrow phase began, or since reset_statistics().
struct Statistics {
  std::int64_t pairs = 0;          ///< evaluations of pairs by the library
  std::int64_t touching = 0;       ///< of these, with one or two manifold points
  std::int64_t refused = 0;        ///< evaluated by Box2D as the library failed: a pose is not finite, or no
                                   ///< memory. Pairs left to Box2D from the start are not counted
  std::int64_t compared = 0;       ///< evaluated by both; this and the following only with Options::compared
  std::int64_t disagreements = 0;  ///< only one of the two had manifold points
  double seconds = 0;              ///< s, of the half-space narrow phase, over compared pairs
  double box2d_seconds = 0;        ///< s, of Box2D's narrow phase, over compared pairs
};

class ForceMode;    // box2d_force.hpp
class ImpulseMode;  // box2d_impulse.hpp

/// The half-space narrow phase of one world, from the constructor to the destructor. Existing contacts keep
/// their impulses when it begins, so that a stack at rest stays at rest, and when it ends. Other worlds of
/// the process are not affected.
///
/// It must be destroyed before its world: declare it after the world.
///
/// Thread rule: as for its world. All worlds share Box2D's table of contact types. It changes when the first
/// narrow phase of the process begins and when the last one ends: no other world may step at that time.
class NarrowPhase {
 public:
  /// Throws std::logic_error if the world is locked or already has a narrow phase, std::bad_alloc, and
  /// std::runtime_error if the contacts of this Box2D have another layout than in version 2.4.
  explicit NarrowPhase(b2World& world, Options options = {});
  ~NarrowPhase();
  NarrowPhase(const NarrowPhase&) = delete;
  NarrowPhase& operator=(const NarrowPhase&) = delete;

  /// Call it after the result of Options::geometry_of, or the vertices or radius of the shape, have changed
  /// for a fixture with contacts. The world must not be locked.
  void refresh(b2Fixture& fixture);

  const Statistics& statistics() const;
  void reset_statistics();

  class Installation;

 private:
  friend class ForceMode;
  friend class ImpulseMode;
  std::unique_ptr<Installation> installation_;
};

/// Returns the axis-aligned bounding box of a polygon in body coordinates, to rounding of a float, which is
/// less than the skin: a shape for the fixture whose polygon is replaced. Its mass is that of the box; see
/// mass_of().
b2PolygonShape box_around(const hs_shape& polygon);

/// Returns mass, center of mass and moment of inertia about the body's origin of a polygon, for
/// b2Body::SetMassData().
b2MassData mass_of(const hs_shape& polygon, float density);

}  // namespace halfspace::box2d
