#pragma once

#include <cmath>

namespace halfspace {

/// A convex body of n dimensions has all places within so many radii of gyration of its centroid, whichever
/// way (Kannan, Lovasz and Simonovits 1995, theorem 4.1).
inline double certain_reach(int n) { return std::sqrt((n + 2.0) / n); }

}  // namespace halfspace
