#pragma once

#include "trade/quantity.h"
#include "trade/setting.h"

namespace halfspace::cli {

/// Runs the scene with its knobs turned and takes the quantity; short runs several times, of which the
/// fastest tells the cost. A friction angle is found by halving the interval from 0 to 89 degrees.
/// @throws LibraryError, std::runtime_error
Outcomes measure(const Setting& setting, const Scene& scene, const FaceSize& face);

/// The width of the last interval in which a friction angle lies, in degrees.
double angle_resolution();

/// The blocks of a scene that has been checked, or of one with its knobs turned. @throws std::runtime_error
Layout layout_of(const Context& context, const Scene& scene);

/// The typical face of the scene's blocks.
FaceSize typical_face(const Scene& scene);

}  // namespace halfspace::cli
