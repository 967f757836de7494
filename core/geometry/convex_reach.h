#pragma once

#include <numbers>

namespace halfspace {

// A convex body in n dimensions extends at least sqrt((n + 2) / n) radii of gyration from its centroid, in
// every direction (Kannan, Lovasz and Simonovits 1995, theorem 4.1). The plane is a section of space, and has
// its bounds.
constexpr double certain_reach_of_area = std::numbers::sqrt2;
constexpr double certain_reach_of_body = 1.2909944487358056;  // sqrt(5 / 3)

}  // namespace halfspace
