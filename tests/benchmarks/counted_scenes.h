#pragma once

// The worlds whose steps count_instructions counts: settled_scenes.h under each law, and bodies of finite
// elements.

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "capi/handles.h"

namespace halfspace_benchmark {

/// The library is an earlier one, which lacks what the scene needs.
struct NotOffered : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct CountedScene {
  std::string name;
  double rest;        ///< largest speed of blocks at rest, m/s
  std::int64_t wait;  ///< steps between looks at their speed, while they settle
  std::function<halfspace_test::World(hs_context*)> make;
};

std::vector<CountedScene> counted_scenes();

}  // namespace halfspace_benchmark
