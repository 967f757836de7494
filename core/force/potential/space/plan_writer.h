#pragma once

#include <span>

#include "force/potential/space/division_plan.h"
#include "force/potential/space/division_record.h"

namespace halfspace {

/// The plan of how two blocks' intersection has been divided. Empty when there is none: it would be too
/// large, or what is written down does not fit together, as where much lies in one place to rounding.
std::span<const PlanCode> encode_division(const DivisionRecord& record, Array<PlanCode>& room);

}  // namespace halfspace
