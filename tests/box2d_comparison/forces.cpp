#include "forces.h"

#include "capi/handles.h"

namespace box2d_comparison {

double force_stiffness(const b2World& world, int bearers) {
  double mass = 0;
  for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext()) mass += body->GetMass();
  return mass * world.GetGravity().Length() / (bearers * bearing_overlap);
}

hs_law_def law_of_forces(double stiffness) {
  hs_law_def law;
  halfspace_test::require_ok(hs_law_def_init(&law, sizeof law), nullptr);
  law.normal_stiffness = stiffness;
  law.shear_stiffness = 4 * stiffness;
  law.normal_damping = law.shear_damping = 1;
  return law;
}

}  // namespace box2d_comparison
