#include "force/potential/space/planned_force.h"

namespace halfspace {

namespace {

/// Steps without a plan after one that did not serve. A plan costs about as much as the force without it.
constexpr std::int32_t steps_to_wait = 8;

/// Found without a plan, and a plan for it, if there is one: it serves in the places that it was made for.
struct Planned {
  PotentialForce<3> force;
  std::span<const PlanCode> plan;
};

Planned find_and_plan(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                      PotentialRoom<3>& room) {
  const PotentialForce<3> found = potential_force(a, b, to_b, room, &room.planner);
  if (!(found.content > 0)) return {found, {}};
  const std::span<const PlanCode> plan = room.planner.make();
  if (plan.empty()) return {found, {}};
  const std::optional<PotentialForce<3>> followed = follow(plan, a, b, to_b);
  return followed ? Planned{*followed, plan} : Planned{found, {}};
}

}  // namespace

PotentialForce<3> planned_force(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                bool makes_plans, PlanMemory& memory, DivisionPlans& plans,
                                PotentialRoom<3>& room) {
  if (memory.knows()) {
    if (const std::optional<PotentialForce<3>> force = follow(plans[memory], a, b, to_b)) {
      if (makes_plans) memory.serve();
      return *force;
    }
  }
  if (!makes_plans || memory.waits()) return potential_force(a, b, to_b, room);
  const bool is_worth_it = !memory.knows() || memory.has_served();
  memory.wait(steps_to_wait);
  if (!is_worth_it) return potential_force(a, b, to_b, room);
  const Planned planned = find_and_plan(a, b, to_b, room);
  if (planned.plan.empty() || plans.add(planned.plan, memory)) return planned.force;
  return potential_force(a, b, to_b, room);
}

}  // namespace halfspace
