#pragma once

#include <string>

#include "trade/front.h"

namespace halfspace::cli {

/// The work-precision picture: a dot for each run, error over cost, both by powers of ten, a colour for each
/// law; a line through the best; a band for what is chance. There must be a run that counts.
std::string chart(const Scene& scene, const Front& front);

}  // namespace halfspace::cli
