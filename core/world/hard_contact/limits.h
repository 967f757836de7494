#pragma once

namespace halfspace {

/// Gaps at the end of a motion are solved to this fraction of the distance at which a point is on a face.
constexpr double gap_tolerance = 0.1;
constexpr int max_corrections = 4;

/// Impulses may move blocks to where the search has found no contact. Then it is repeated.
constexpr int max_searches = 4;

/// Rounding and rotation do not reach this depth over a block's size: there the solver has not converged.
constexpr double reported_depth = 1e-3;

}  // namespace halfspace
