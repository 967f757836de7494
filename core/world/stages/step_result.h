#pragma once

namespace halfspace {

/// overworked: the step has been divided, and its motions have taken too many iterations.
enum class StepResult { ok, unstable, no_time_step, too_fast, inverted, overworked, interrupted };

}  // namespace halfspace
