#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene.h"

namespace halfspace_trade {

/// A point on an engine's ladder from cheap to accurate.
struct Setting {
  std::string way;         // law and kind of block, or solver and iterations
  double indentation = 0;  // how deep the scene's load or impact presses a spring, m; 0 where there are none
  double step = 0;         // s; with springs a share of the stable one
};

/// A scene in an engine.
class World {
 public:
  virtual ~World() = default;
  /// Returns the processor seconds that the steps took.
  virtual double step(long steps) = 0;
  /// Its own choice where the setting leaves it open. A whole number of them makes the scene's duration.
  virtual double time_step() const = 0;
  virtual State state(std::size_t body) const = 0;
};

/// Each program of the trade links one definition of these.
const char* engine_name();
bool knows_dimension(int dimension);
bool knows_hulls();  // in space; all know boxes
std::vector<Setting> settings();
std::unique_ptr<World> build(const Scene& scene, const Setting& setting);

/// The step of at most this length of which a whole number makes the duration.
double whole_part(double duration, double step);

/// The ladder of engines with implicit steps: each way at 1/60 s, and that halved up to seven times.
std::vector<Setting> with_frame_steps(const std::vector<std::string>& ways);

}  // namespace halfspace_trade
