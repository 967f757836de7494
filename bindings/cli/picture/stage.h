#pragma once

#include <cmath>
#include <string>

#include "archive.h"
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
  bool forces = false;  ///< of contacts are shown
  double lowest = 0;    ///< value at the dark end of the colours
  double highest = 1;   ///< value at the bright end
};

/// A rectangle around points.
struct Bounds {
  Point low{INFINITY, INFINITY};
  Point high{-INFINITY, -INFINITY};

  void add(const Point& p);
  bool have_an_area() const;
};

/// Watches the frames of a run, so that all of them fit on the stage of its pictures, and on its colours.
class RunStage {
 public:
  /// Displacements are those from the origin, which must outlive it.
  RunStage(const Scene& scene, const Frame& origin);
  /// Counts from another origin from now on, as if no frame had been seen.
  void reset_displacement(const Frame& origin);
  void add(const Frame& frame);
  /// One that is read goes on with what that had seen, if it looks at the same, which is told.
  bool add_to(Archive& archive);
  Stage stage() const;

 private:
  void add_to_bounds(const BlockFrame& block);

  Stage stage_;
  std::string view_;  ///< what it looks at
  const Frame* origin_;
  Bounds bounds_;
  bool has_window_;  ///< given in the scene: its bounds are those
  bool has_free_;    ///< blocks: only what is free to move has to fit
  double lowest_ = INFINITY;
  double highest_ = -INFINITY;
};

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
