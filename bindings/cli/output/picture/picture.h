#pragma once

#include <string>

#include "model/model.h"
#include "output/picture/stage.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The blocks of a frame as SVG, with axes, scale bar, title, time and the meaning of the colours.
std::string picture(const Stage& stage, const Scene& scene, const Layout& layout, const Frame& start,
                    const Frame& frame);

}  // namespace halfspace::cli
