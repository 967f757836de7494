#pragma once

#include <string>

#include "studies/trade/front.h"

namespace halfspace::cli {

/// The work-precision diagram: a dot for each run, error over cost, both logarithmic, a colour for each law;
/// the Pareto front as a line; a band for errors due to chance. Requires a run that counts.
std::string chart(const Scene& scene, const Front& front);

}  // namespace halfspace::cli
