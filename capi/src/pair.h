#pragma once

#include "detect/contact.h"
#include "halfspace/pair.h"

namespace halfspace::capi {

/// Detection settings from a definition's angles and shares, checked.
DetectOptions read_detect_options(double parallel_angle, double vertex_zone);

/// The same from a host's options, which may be NULL.
DetectOptions read_options(const hs_pair_options* options);

}  // namespace halfspace::capi
