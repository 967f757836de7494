#pragma once

#include <set>
#include <string>
#include <vector>

#include "model/model.h"
#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Properties of a block at the start.
struct Body {
  hs_block_state state;
  double thickness;
  double volume;
  double speed;  ///< m/s, upper bound over its points; also of a prescribed motion that starts later
};

/// A scene that is ready to run.
struct Start {
  Start(const Context& context, const Scene& scene, const Model& model);

  const Context& context;
  const Scene& scene;
  const Model& model;
  const Layout& layout;
  Frame frame;
  std::vector<Body> bodies;  ///< of each block of the layout
};

/// True if a depth is above the rounding of the coordinates of both blocks, and above 2^-20 of the thickness.
bool is_beyond_rounding(double depth, double thinner, const Body& a, const Body& b);

/// The materials of the blocks.
std::set<int> used_materials(const Start& start);

/// A ratio in words: "12 % of" or "3 times".
std::string ratio_text(double ratio);

inline std::string quoted(const std::string& name) { return '"' + name + '"'; }

/// "1 block", "2 blocks".
std::string counted(std::size_t count, const std::string& noun);

constexpr std::size_t max_notes = 5;  ///< of one kind

}  // namespace halfspace::cli
