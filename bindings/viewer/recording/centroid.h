#pragma once

#include <vector>

#include "recording/recording.h"

namespace halfspace::viewer {

/// The centroid of a polygon, or of a polyhedron with these faces.
Point centroid_of(const std::vector<Point>& vertices, const std::vector<std::vector<int>>& faces,
                  int dimension);

}  // namespace halfspace::viewer
