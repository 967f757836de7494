#pragma once

#include <cmath>

namespace halfspace {

/// A convex body in n dimensions extends at least this many radii of gyration from its centroid, in every
/// direction (Kannan, Lovasz and Simonovits 1995, theorem 4.1).
inline double certain_reach(int n) { return std::sqrt((n + 2.0) / n); }

}  // namespace halfspace
