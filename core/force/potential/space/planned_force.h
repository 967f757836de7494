#pragma once

#include <optional>
#include <span>

#include "force/potential/potential_force.h"
#include "force/potential/space/division_plan.h"
#include "force/potential/space/division_plans.h"

namespace halfspace {

/// The potential force by a plan. None when the plan is not valid at these poses.
std::optional<PotentialForce<3>> follow(std::span<const PlanCode> plan, const Outline<3>& a,
                                        const Outline<3>& b, const Vector<3>& to_b);

/// The potential force of a pair by a new division, whose plan is cached. In the same poses the result has
/// the same bits as by the plan.
PotentialForce<3> force_by_new_plan(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                    DivisionCache& memory, CachedDivisions& plans, PotentialRoom<3>& room);

}  // namespace halfspace
