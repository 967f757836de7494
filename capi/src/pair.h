#pragma once

#include "detect/contact.h"
#include "halfspace/pair.h"

namespace halfspace::capi {

/// Detection settings from a definition's angles and shares, checked.
DetectOptions read_detect_options(double parallel_angle, double vertex_zone);

}  // namespace halfspace::capi
