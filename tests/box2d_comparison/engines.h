#pragma once

// Who finds the contacts of polygons in a world, and steps it.

#include <memory>
#include <vector>

#include "halfspace/box2d.hpp"
#include "stage.h"

namespace box2d_comparison {

class Engine {
 public:
  virtual ~Engine() = default;
  /// One frame of 1/60 s.
  virtual void step() = 0;
};

/// A kind of world, of which a stage that has just been furnished becomes one.
struct EngineKind {
  const char* name;  // in the CSVs
  std::unique_ptr<Engine> (*begin)(Stage&);
};

/// Box2D's own first: the others are compared with it. Each is there twice more with everything 0.1 mm aside:
/// what a world differs in from its own nudged runs is luck.
const std::vector<EngineKind>& engine_kinds();

/// The world whose pairs both narrow phases judge: half-spaces drive it.
std::unique_ptr<Engine> begin_compared(Stage& stage,
                                       std::function<void(const halfspace::box2d::Comparison&)> compared);

constexpr double frame_seconds = 1 / 60.;

}  // namespace box2d_comparison
