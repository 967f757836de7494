#pragma once

#include <span>

#include "force/potential/space/division_plan.h"
#include "force/potential/space/division_record.h"

namespace halfspace {

/// The plan of the division of two blocks' intersection. Empty when it would be too large, or when the record
/// is inconsistent, as for many corners that coincide to rounding.
std::span<const PlanCode> encode_division(const DivisionRecord& record, Array<PlanCode>& room);

}  // namespace halfspace
