#pragma once

// Who finds the contacts of polygons in a world, and steps it.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "halfspace/box2d.hpp"
#include "scenes.h"
#include "stage.h"

namespace box2d_comparison {

class Engine {
 public:
  virtual ~Engine() = default;
  /// One frame of 1/60 s.
  virtual void step() = 0;
  /// Of the next frame.
  virtual int sub_steps() { return 1; }
};

/// A kind of world, of which a stage that has just been furnished becomes one.
struct EngineKind {
  std::string name;  // in the CSVs
  float rest_gap;    // that its stage is furnished with
  std::function<std::unique_ptr<Engine>(Stage&)> begin;
  bool is_by_itself = false;  // timed apart from the others
};

/// Those of a scene, Box2D's own first: the others are compared with it. Each is there twice more with
/// everything 0.1 mm aside, force mode only if wanted: what a world differs in from its own nudged runs is
/// luck.
std::vector<EngineKind> engine_kinds(const ForceUse& forces);

/// The world whose pairs both narrow phases judge: half-spaces drive it.
std::unique_ptr<Engine> begin_compared(Stage& stage,
                                       std::function<void(const halfspace::box2d::Comparison&)> compared);

constexpr double frame_seconds = 1 / 60.;
constexpr float skins = 2 * b2_polygonRadius;

}  // namespace box2d_comparison
