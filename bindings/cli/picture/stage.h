#pragma once

#include <string>

#include "model.h"
#include "picture/camera.h"
#include "picture/colour.h"
#include "scene.h"

namespace halfspace::cli {

/// What the pictures of one run have in common, so that they can be laid side by side.
struct Stage {
  std::string title;
  int dimension = 2;
  Camera camera{0, 0};  ///< 3D
  Point lower_left{};   ///< of what is shown; 3D: as the camera sees it
  Point upper_right{};
  Colour colour = Colour::displacement;
  int layers = 1;
  double lowest = 0;   ///< value at the dark end of the colours
  double highest = 1;  ///< value at the bright end
};

/// A stage on which both the start and the end of a run fit.
Stage stage_for(const Scene& scene, const Frame& start, const Frame& end);

/// A point as the stage shows it.
inline Point shown(const Stage& stage, const Point& p) {
  return stage.dimension == 3 ? stage.camera.seen(p) : p;
}

/// Where in the colours a value lies, from 0 to 1.
double share_of(const Stage& stage, double value);

/// The colour of a block, grey unless it is free to move.
Rgb colour_of(const Stage& stage, const BlockFrame& then, const BlockFrame& now);

/// Edge length in m of a square as large as a rigid block seems, on average; 0 without rigid blocks.
double typical_size(const Stage& stage, const Frame& frame);

}  // namespace halfspace::cli
