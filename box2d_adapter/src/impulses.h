#pragma once

#include <halfspace/box2d_impulse.hpp>
#include <vector>

#include "excluded_bodies.h"
#include "mirror.h"

namespace halfspace::box2d {

/// The contacts without springs between mirrored fixtures. The mirror steps first; then Box2D is given the
/// velocities by which its own step makes the same motion.
class ImpulseMode::Impulses : public Mirror {
 public:
  Impulses(NarrowPhase::Installation& narrow_phase, const ImpulseOptions& options);

  /// Steps the mirror, and directs the bodies. If it throws, no body has changed.
  void advance(float time_step);
  /// Completes the motion after Box2D has moved the bodies.
  void complete(float time_step);

  /// Must Box2D's solver skip the contact? The mirror has it, or a body has no finite position.
  bool keep(const b2Contact& contact) const;
  /// True after an error that has stopped the mirror.
  bool is_within_step() const { return is_within_step_; }
  double unbalanced_velocity() const;

 private:
  /// A step of a dynamic body.
  struct Course {
    Rates acceleration;  // by gravity and user forces
    Rates free;          // velocity at the end without contacts of the mirror
    Rates mean;          // velocity by which Box2D moves the body
    Rates end;           // velocity at the end
    Rates shift;         // displacement after Box2D's step
  };

  std::optional<Material> material_for(const b2Fixture& fixture, const Polygon& polygon) const override;
  bool has(const b2Contact& contact) const;
  bool is_free(const b2Body& body) const;
  void load(std::size_t block, double time_step);
  void direct(std::size_t block, double time_step);

  ExcludedBodies excluded_;
  std::vector<Course> courses_;  // of the bodies
  bool is_within_step_ = false;
};

}  // namespace halfspace::box2d
