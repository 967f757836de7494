// Collisions of two random convex blocks, without damping: none gains energy.

#include "catch.h"
#include "validation/random_bodies.h"

// How many collisions of a kind are tried.
#ifndef HALFSPACE_COLLISIONS
#define HALFSPACE_COLLISIONS 10
#endif

namespace {

using namespace halfspace_test;

/// Two blocks that fly at each other at 1 m/s, turned and turning at random, and overlap by some `depth`.
class Collision {
 public:
  Collision(int dimension, int32_t kind, double friction, double depth, unsigned seed)
      : scene_(dimension, definition(dimension), law(kind, friction, depth), {}) {
    Random random(seed);
    Bodies bodies{random_body(dimension, random), random_body(dimension, random)};
    bodies[1].position = {dimension == 2 ? 1.6 : 2.2, random.uniform(-0.3, 0.3),
                          dimension == 2 ? 0 : random.uniform(-0.3, 0.3)};
    for (int i = 0; i < 2; ++i) {
      const hs_block block = scene_.add(dimension, bodies[std::size_t(i)]);
      const double velocity[3] = {i == 0 ? 0.5 : -0.5, 0, 0};
      double spin[3] = {0, 0, random.uniform(-2, 2)};
      for (int k = 0; k < 2 && dimension == 3; ++k) spin[k] = random.uniform(-2, 2);
      scene_.check(hs_world_set_velocity(scene_.world(), block, velocity, spin));
    }
  }

  /// The energy made until the blocks have left each other, over the one they came with.
  double gain() {
    const double before = scene_.energy().kinetic;
    bool have_met = false;
    while (scene_.report().time < 4) {
      scene_.step(10);
      const bool touch = scene_.report().contact_count > 0;
      if (have_met && !touch) break;
      have_met |= touch;
    }
    return scene_.energy().residual / before;
  }

 private:
  static constexpr double density = 2000;

  static hs_world_def definition(int dimension) {
    hs_world_def def = solid_world_def(0, {0, 0, 0});
    def.dimension = dimension;
    def.safety = 0.05;
    def.potential_length = 1;
    return def;
  }

  static hs_law_def law(int32_t kind, double friction, double depth) {
    const double stiffness = density * square_of(1 / depth);
    hs_law_def law = kind == HS_STIFFNESS_POTENTIAL ? potential_law(stiffness, std::atan(friction), stiffness)
                                                    : spring_law(stiffness, std::atan(friction));
    law.stiffness_kind = kind;
    return law;
  }

  BodyScene scene_;
};

}  // namespace

TEST_CASE("collisions of random blocks make no energy per area and by potentials") {
  for (const int dimension : {2, 3}) {
    for (const int32_t kind : all_stiffness_kinds) {
      for (const double depth : {1e-2, 1e-3}) {
        double most = 0;
        for (unsigned seed = 0; seed < HALFSPACE_COLLISIONS; ++seed)
          most = std::max(most, Collision(dimension, kind, seed % 2 ? 0.5 : 0, depth, seed).gain());
        std::printf("%d random collisions in %dD, %s, depth %g: %.1e of the energy is made at most\n",
                    HALFSPACE_COLLISIONS, dimension, name_of_stiffness(kind), depth, most);
        if (kind != HS_STIFFNESS_PER_CONTACT) CHECK(most < 1e-3);
      }
    }
  }
}
