#pragma once

#include <string>

#include "trade/front.h"

namespace halfspace::cli {

/// A setting in a few words: "step 1/4, stiffness x 10, per area".
std::string describe(const Setting& setting);

/// The findings of a trade, when its budget left out so many runs, as a page of text: the reference and
/// whether runs converge to it, the front of error against cost, what each knob does with all others held,
/// and the cheapest setting within a tolerance, as lines of a scene file.
std::string report(const Scene& scene, const Front& front, const FaceSize& face, double tolerance,
                   int left_out);

}  // namespace halfspace::cli
