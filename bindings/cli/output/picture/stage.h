#pragma once

#include <cmath>
#include <string>

#include "common/archive.h"
#include "model/model.h"
#include "output/picture/camera.h"
#include "output/picture/colour.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The view common to all pictures of a run, so that they can be compared.
struct Stage {
  std::string title;
  int dimension = 2;
  Camera camera{0, 0};  ///< 3D
  Point lower_left{};   ///< of the view; 3D: in camera coordinates
  Point upper_right{};
  Colour colour = Colour::displacement;
  int layers = 1;
  bool forces = false;   ///< contact forces are drawn
  bool numbers = false;  ///< of blocks are drawn
  bool open_joints = false;
  bool thrust = false;
  double lowest = 0;   ///< value at the dark end of the colours
  double highest = 1;  ///< value at the bright end
};

/// A rectangle around points.
struct Bounds {
  Point low{INFINITY, INFINITY};
  Point high{-INFINITY, -INFINITY};

  void add(const Point& p);
  bool have_an_area() const;
};

/// Collects the common bounds and colour range of all frames of a run.
class RunStage {
 public:
  /// Displacements are measured from `origin`, which must outlive this.
  RunStage(const Scene& scene, const Frame& origin);
  /// Measures displacements from another origin, and restarts their range.
  void reset_displacement(const Frame& origin);
  void add(const Frame& frame);
  /// Adds the state to an archive, or restores it. @return false if the stored view was another one, which is
  /// ignored
  bool add_to(Archive& archive);
  Stage stage() const;

 private:
  void add_to_bounds(const BlockFrame& block);

  Stage stage_;
  std::string view_;  ///< settings of the view
  const Frame* origin_;
  Bounds bounds_;
  bool has_window_;  ///< the scene gives the bounds
  bool has_free_;    ///< some blocks are free: only these have to fit
  double lowest_ = INFINITY;
  double highest_ = -INFINITY;
};

/// A point in the view.
inline Point shown(const Stage& stage, const Point& p) {
  return stage.dimension == 3 ? stage.camera.seen(p) : p;
}

/// The position of a value in the colour range, from 0 to 1.
double colour_position(const Stage& stage, double value);

/// The colour of a block, grey unless it is free to move.
Rgb colour_of(const Stage& stage, const BlockFrame& then, const BlockFrame& now);

/// The mean apparent size of the free blocks, m: the edge of a square with their mean projected area; 0
/// without any.
double typical_size(const Stage& stage, const Frame& frame);

}  // namespace halfspace::cli
