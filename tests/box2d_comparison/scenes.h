#pragma once

// Scenes that Box2D's users know, rebuilt from what they show. Gravity is 10 m/s2 downwards, a step 1/60 s
// with 8 velocity and 3 position iterations, and nothing sleeps.

#include <functional>
#include <string>
#include <vector>

#include "stage.h"

namespace box2d_comparison {

struct Scene {
  std::string name;        // in the CSVs
  std::string title;       // for readers
  std::string stands_for;  // whose scene it is, and what it shows
  bool stands;             // all is to stay where it is; else things fall or move on purpose
  double seconds;          // simulated
  b2Vec2 drift_axis;       // along which bodies are to stay where they are, of unit length
  std::function<void(Stage&)> build;
  double settling = 0;  // seconds before the scene begins, of which nothing is recorded
  std::function<void(Stage&)> let_go = nullptr;  // after these
};

std::vector<Scene> stacks();        // stacks.cpp
std::vector<Scene> far_and_near();  // stacks.cpp
std::vector<Scene> slopes();        // slopes.cpp
std::vector<Scene> fine_shapes();   // fine_shapes.cpp
std::vector<Scene> moving();        // moving.cpp

std::vector<Scene> all_scenes();

inline const b2Vec2 sideways = {1, 0};

}  // namespace box2d_comparison
