#pragma once

#include <string>

#include "studies/trade/front.h"

namespace halfspace::cli {

/// A setting in a few words: "step 1/4, stiffness x 10, per area".
std::string describe(const Setting& setting);

/// The report of a trade: the reference and the convergence to it, the Pareto front of error and cost, the
/// error by each parameter with all others held, and the cheapest setting within a tolerance, as lines of a
/// scene file. `left_out` is the number of runs beyond the budget.
std::string report(const Scene& scene, const Front& front, const FaceSize& face, double tolerance,
                   int left_out);

}  // namespace halfspace::cli
