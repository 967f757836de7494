#pragma once

// Scenes that Box2D's users know, rebuilt from what they show. Gravity is 10 m/s2 downwards, a step 1/60 s
// with 8 velocity and 3 position iterations, and nothing sleeps.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "stage.h"

namespace box2d_comparison {

/// Whether a scene is run in force mode as well.
struct ForceUse {
  /// Blocks on the ground, between which the weight of all the others is about shared. 0: not run
  int bearers = 0;
  bool is_nudged = false;  // run twice more with everything 0.1 mm aside, where that does not take minutes
  std::string why_not;     // for readers, where it is not run
};
inline ForceUse borne_by(int bearers) { return {bearers, true, ""}; }
inline ForceUse borne_by_and_run_once(int bearers) { return {bearers, false, ""}; }
inline ForceUse without_forces(std::string why_not) { return {0, false, std::move(why_not)}; }

struct Scene {
  std::string name;        // in the CSVs
  std::string title;       // for readers
  std::string stands_for;  // whose scene it is, and what it shows
  bool stands;             // all is to stay where it is; else things fall or move on purpose
  double seconds;          // simulated
  b2Vec2 drift_axis;       // along which bodies are to stay where they are, of unit length
  ForceUse forces;
  std::function<void(Stage&)> build;
  double settling = 0;  // seconds before the scene begins, of which nothing is recorded
  std::function<void(Stage&)> let_go = nullptr;  // after these
  bool on_slopes = false;                        // where friction alone holds the blocks
};

std::vector<Scene> stacks();        // stacks.cpp
std::vector<Scene> far_and_near();  // stacks.cpp
std::vector<Scene> slopes();        // slopes.cpp
std::vector<Scene> fine_shapes();   // fine_shapes.cpp
std::vector<Scene> moving();        // moving.cpp

std::vector<Scene> all_scenes();

inline const b2Vec2 sideways = {1, 0};
/// Why a scene is not run in force mode.
inline const char* const nothing_to_stay =
    "Its blocks tumble and have no place to stay at, so that drift and creep say nothing; what forces cost "
    "where "
    "many blocks touch is seen in the pyramid.";

}  // namespace box2d_comparison
