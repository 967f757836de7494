#pragma once

namespace halfspace {

/// Gaps at the end of a motion that are not solved are corrected at most so often.
constexpr int max_corrections = 4;

/// Impulses may move blocks to where the search has found no contact. Then it is repeated.
constexpr int max_searches = 4;

/// Points that are still not balanced after so many sweeps go on with what they have.
constexpr int max_sweeps_of_points = 1000;

}  // namespace halfspace
