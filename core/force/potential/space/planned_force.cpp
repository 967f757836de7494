#include "force/potential/space/planned_force.h"

#include "force/potential/space/plan_writer.h"

namespace halfspace {

PotentialForce<3> planned_force(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                bool makes_plans, DivisionCache& memory, CachedDivisions& plans,
                                PotentialRoom<3>& room) {
  if (memory.knows())
    if (const std::optional<PotentialForce<3>> force = follow(plans[memory], a, b, to_b)) return *force;
  if (!makes_plans) return potential_force(a, b, to_b, room);
  memory.forget();
  const PotentialForce<3> found = potential_force(a, b, to_b, room, &room.record);
  if (!(found.content > 0)) return found;
  const std::span<const PlanCode> plan = encode_division(room.record, room.plan);
  if (plan.empty()) return found;
  const std::optional<PotentialForce<3>> followed = follow(plan, a, b, to_b);
  return followed && plans.add(plan, memory) ? *followed : found;
}

}  // namespace halfspace
