#pragma once

#include <string>

#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// What the pictures of one run have in common, so that they can be laid side by side.
struct Stage {
  std::string title;
  Point lower_left{};
  Point upper_right{};
  Colour colour = Colour::displacement;
  int layers = 1;
  double lowest = 0;   ///< value at the dark end of the colours
  double highest = 1;  ///< value at the bright end
};

/// A stage on which both the start and the end of a run fit.
Stage stage_for(const Scene& scene, const Frame& start, const Frame& end);

/// The blocks of a frame as SVG, with axes, scale bar, title, time and the meaning of the colours.
std::string picture(const Stage& stage, const Scene& scene, const Frame& start, const Frame& frame);

}  // namespace halfspace::cli
