#pragma once

#include <vector>

#include "scene.h"

namespace halfspace_trade {

/// The mean depth of overlap of all pairs of bodies that overlap, m, by the theorem of separating axes: 0
/// when none does.
double mean_overlap(const std::vector<Body>& bodies, int dimension);

}  // namespace halfspace_trade
