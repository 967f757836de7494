#include "force/potential/space/planned_force.h"

#include "force/potential/space/plan_writer.h"

namespace halfspace {

PotentialForce<3> force_by_new_plan(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                    DivisionCache& memory, CachedDivisions& plans, PotentialRoom<3>& room) {
  memory.forget();
  const PotentialForce<3> found = potential_force(a, b, to_b, room, &room.record);
  if (!(found.content > 0)) return found;
  const std::span<const PlanCode> plan = encode_division(room.record, room.plan);
  if (plan.empty()) return found;
  const std::optional<PotentialForce<3>> followed = follow(plan, a, b, to_b);
  return followed && plans.add(plan, memory) ? *followed : found;
}

}  // namespace halfspace
