#pragma once

#include <string>

#include "scene/scene.h"

namespace halfspace::cli {

/// A script for ParaView that shows the run in its directory: blocks coloured by their displacement, and the
/// contacts, bolts and water that the frames have.
std::string paraview_script(const Scene& scene);

}  // namespace halfspace::cli
