#pragma once

// Other people's engines on pairs of convex polyhedra, each in double and with its own shapes and poses:
// libccd, FCL, Bullet and ODE; and libhalfspace itself.

#include <memory>
#include <vector>

#include "oracles/random_polyhedra.h"

namespace halfspace_benchmark {

using halfspace_test::Polyhedron;
using Random = halfspace_test::Random3;

/// Two polyhedra of a set, by index, and where they lie.
struct PolyhedraAt {
  int a = 0;
  int b = 0;
  hs_pose at_a;
  hs_pose at_b;
};

struct PairSet3 {
  std::vector<Polyhedron> polyhedra;
  std::vector<PolyhedraAt> pairs;
};

struct Answer {
  bool touches = false;
  double depth = 0;      ///< if it touches
  bool gave_up = false;  ///< the engine reported a failure instead of a verdict
};

/// One engine's copy of a set. Making it makes the shapes.
class Peer {
 public:
  virtual ~Peer() = default;

  /// In the order of the set until they are shuffled.
  virtual Answer answer(std::size_t pair) = 0;

  /// Moves the pairs in memory, not an index to them.
  virtual void shuffle(Random& random) = 0;

  /// Asks about every pair in turn: what is timed.
  virtual int count_touching() = 0;
};

struct NamedPeer {
  const char* name;
  std::unique_ptr<Peer> (*make)(const PairSet3& set);
};

/// libhalfspace's search for the separation or the least depth, without a memory; and with the contact
/// described: its type, plane and region.
std::unique_ptr<Peer> make_halfspace(const PairSet3& set);
std::unique_ptr<Peer> make_halfspace_contact(const PairSet3& set);

/// libccd with support functions of our own: a loop over the vertices, or from 64 vertices on a climb over
/// neighbours; its default tolerances, and at most 100 iterations.
std::unique_ptr<Peer> make_ccd_mpr(const PairSet3& set);
std::unique_ptr<Peer> make_ccd_gjk(const PairSet3& set);

/// fcl::collide on fcl::Convex, with a contact, by its solver on libccd's algorithms (its default), or by its
/// own.
std::unique_ptr<Peer> make_fcl_ccd(const PairSet3& set);
std::unique_ptr<Peer> make_fcl_own(const PairSet3& set);

/// btGjkPairDetector and its EPA on btConvexHullShape without margins: the bare polyhedra.
std::unique_ptr<Peer> make_bullet(const PairSet3& set);

/// dCollide on convex geoms, for one contact.
std::unique_ptr<Peer> make_ode(const PairSet3& set);

inline constexpr NamedPeer all_peers[] = {
    {"halfspace", make_halfspace},
    {"ccd MPR", make_ccd_mpr},
    {"ccd GJK", make_ccd_gjk},
    {"FCL ccd", make_fcl_ccd},
    {"FCL own", make_fcl_own},
    {"Bullet", make_bullet},
    {"ODE", make_ode},
};

}  // namespace halfspace_benchmark
