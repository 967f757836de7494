#pragma once

#include <optional>
#include <span>

#include "force/potential/potential_force.h"
#include "force/potential/space/division_plan.h"
#include "force/potential/space/division_plans.h"

namespace halfspace {

/// The force of potentials by a plan. None when the plan is that of other places.
std::optional<PotentialForce<3>> follow(std::span<const PlanCode> plan, const Outline<3>& a,
                                        const Outline<3>& b, const Vector<3>& to_b);

/// The force of potentials of a pair that may know a plan: by that, or else found anew, and then with a plan
/// for the next time if one is to be made. In the same places it has the same bits again.
PotentialForce<3> planned_force(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                bool makes_plans, DivisionCache& memory, CachedDivisions& plans,
                                PotentialRoom<3>& room);

}  // namespace halfspace
