#pragma once

#include <halfspace/box2d_force.hpp>
#include <vector>

#include "mirror.h"

namespace halfspace::box2d {

/// The contact forces of a law with springs, between mirrored fixtures.
class ForceMode::Forces : public Mirror {
 public:
  Forces(NarrowPhase::Installation& narrow_phase, const hs_law_def& law)
      : Mirror(narrow_phase, law, make_world_def({0, 0})) {}

  /// Follows the bodies as Mirror does. Contacts of changed blocks keep their shear forces.
  void follow();
  /// Computes contacts and forces at the current poses of the bodies.
  void evaluate();
  /// Applies the forces to the bodies for a sub-step.
  void push(float sub_step);
  /// Updates the motion after Box2D has moved the bodies.
  void carry_on(float sub_step);

  bool is_awake() const;
  double stable_sub_step() const;

 private:
  /// The force of a shear spring on block b.
  struct KeptShear {
    hs_block a, b;
    double force[3];
  };

  std::optional<Material> material_for(const b2Fixture& fixture, const Polygon& polygon) const override {
    return material_of(fixture, polygon);
  }
  void keep_shear_of_renewed();
  void give_back_kept_shear();
  void find_forces(double elapsed);
  bool begin_shear_of_new_pairs();
  void begin_shear(const hs_contact& contact);
  JudgedPair* pair_of(const hs_contact& contact) const;
  void load(const hs_contact& contact);
  void load(const Block& block, const hs_contact& contact, double sign);

  std::vector<KeptShear> kept_shear_;
  std::int64_t pairs_begun_ = 0;  // at the last evaluation
  double elapsed_ = 0;            // time over which shear springs extend, s
  std::vector<hs_contact> contacts_;
};

}  // namespace halfspace::box2d
