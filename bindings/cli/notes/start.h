#pragma once

#include <string>
#include <vector>

#include "faults.h"
#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// A block at the start, as notes look at it.
struct Body {
  hs_block_state state;
  double thickness;
  double volume;
  double speed;  ///< of its fastest point at most; of a prescribed motion also when it starts later
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

/// Deeper than the rounding of where the two blocks are, and than what no one would see.
bool is_beyond_rounding(double depth, double thinner, const Body& a, const Body& b);

/// A length as a share of a thickness.
std::string share_of_it(double share);

inline std::string quoted(const std::string& name) { return '"' + name + '"'; }

/// "1 block", "2 blocks".
std::string counted(std::size_t count, const std::string& noun);

constexpr std::size_t most_lines = 5;  ///< of one kind of note

}  // namespace halfspace::cli
