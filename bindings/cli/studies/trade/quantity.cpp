#include "studies/trade/quantity.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "common/text.h"
#include "common/vector.h"
#include "output/summary.h"
#include "studies/trade/pieces.h"
#include "studies/trade/stepping.h"

namespace halfspace::cli {
namespace {

constexpr std::int64_t max_steps_at_once = 64;  // steps between two checks for interrupts
constexpr std::int64_t min_steps = 10;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Point position_of(const BlockFrame& block) { return point_of(block.state.pose.position); }

double height_of(const Frame& frame, int dimension) {
  const std::size_t up = up_axis(dimension);
  double height = -INFINITY;
  for (const BlockFrame& block : frame.blocks) {
    if (!moves_freely(block.state.kind)) continue;
    for (const Point& p : block.vertices) height = std::max(height, p[up]);
  }
  return height;
}

/// True if no free piece has moved farther than the limit; excavated pieces are ignored.
bool stands(const std::vector<Piece>& pieces, const Frame& start, const Frame& end, double limit) {
  for (const Piece& piece : pieces) {
    if (!is_free(piece, start) || !is_free(piece, end)) continue;
    const double moved = length(minus(centroid_of(piece, end), centroid_of(piece, start)));
    if (moved > (limit > 0 ? limit : 0.1 * size_of(piece, start))) return false;
  }
  return true;
}

/// The quantity of a run, from its frames and its steps.
class Measurement {
 public:
  Measurement(const Scene& scene, const Model& model)
      : scene_(scene), model_(model), start_(model.frame()), is_referenced_(start_.blocks.size()) {
    for (const std::size_t block : model.layout().referenced) is_referenced_[block] = true;
  }

  std::int64_t steps_at_once() const { return of_force() ? 1 : max_steps_at_once; }
  void observe() {
    if (of_force()) largest_force_ = std::max(largest_force_, length(force()));
  }
  /// Measures displacements from now on.
  void reset_displacement() { start_ = model_.frame(); }
  double value(double time) const {
    const Reference& reference = scene_.reference;
    const Frame now = frame_at(model_, time);
    switch (reference.quantity) {
      case Quantity::run_out:
        return run_out(start_, now, scene_.world.dimension).farthest();
      case Quantity::height:
        return height_of(now, scene_.world.dimension);
      case Quantity::position:
        return centroid_of_referenced(now)[reference.axis];
      case Quantity::force:
        return largest_force_;
      default:
        return stands(pieces_of(model_.layout()), start_, now, reference.limit);
    }
  }

 private:
  bool of_force() const { return scene_.reference.quantity == Quantity::force; }

  /// The sum of the contact forces from other blocks. A single block with springs has it in its state.
  Point force() const {
    const std::vector<std::size_t>& referenced = model_.layout().referenced;
    const bool has_spring_force = referenced.size() == 1 && !model_.layout().blocks[referenced[0]].body &&
                                  model_.report().touch_count == 0;
    if (has_spring_force) return point_of(model_.state_of(referenced[0]).force);
    Point sum{};
    for (const hs_contact& contact : model_.contacts()) {
      const bool on_a = is_referenced_[contact.block_a], on_b = is_referenced_[contact.block_b];
      if (on_a != on_b) sum = plus(sum, times(on_b ? 1 : -1, point_of(contact.force)));
    }
    return sum;
  }

  Point centroid_of_referenced(const Frame& frame) const {
    Centroid centroid;
    for (const std::size_t i : model_.layout().referenced) centroid.add(frame.blocks[i]);
    return centroid.value();
  }

  const Scene& scene_;
  const Model& model_;
  Frame start_;
  std::vector<char> is_referenced_;  // of each block
  double largest_force_ = 0;
};

}  // namespace

Frame frame_at(const Model& model, double time) {
  Frame frame = model.frame();
  if (model.report().steps == 0) return frame;
  const double ahead = time - model.report().time;
  for (BlockFrame& block : frame.blocks) {
    const Point centroid = position_of(block);
    const Point velocity = point_of(block.state.velocity), spin = point_of(block.state.angular_velocity);
    for (Point& p : block.vertices)
      p = plus(p, times(ahead, plus(velocity, cross(spin, minus(p, centroid)))));
    const Point moved = plus(centroid, times(ahead, velocity));
    std::copy(moved.begin(), moved.end(), block.state.pose.position);
  }
  return frame;
}

namespace {

/// @throws LibraryError for errors that are no end of a run
RunEnd end_by(const LibraryError& error) {
  switch (error.status) {
    case HS_ERROR_UNSTABLE:
      return RunEnd::unstable;
    case HS_ERROR_TOO_FAST:
      return RunEnd::too_fast;
    case HS_ERROR_INVERTED:
      return RunEnd::inverted;
    default:
      throw error;
  }
}

}  // namespace

Outcomes run_for_quantity(const Scene& scene, Model& model) {
  Outcomes outcomes;
  Measurement measurement(scene, model);
  const auto reset_displacement = [&] {
    measurement.reset_displacement();
    outcomes.start = measurement.value(model.report().time);
  };
  reset_displacement();
  const double before = cpu_seconds();
  try {
    outcomes.end = step_through(
        scene, model, {measurement.steps_at_once(), [&] { measurement.observe(); }, reset_displacement},
        outcomes.time);
  } catch (const LibraryError& error) {
    outcomes.end = end_by(error);
  }
  outcomes.cpu_seconds = cpu_seconds() - before;
  outcomes.simulated = scene.stages.empty() ? model.report().time : 1;
  if (outcomes.end == RunEnd::whole && model.report().steps < min_steps) outcomes.end = RunEnd::too_few_steps;
  if (outcomes.end == RunEnd::whole) outcomes.value = measurement.value(outcomes.time);
  return outcomes;
}

std::string describe_quantity(const Scene& scene) {
  const Reference& reference = scene.reference;
  const bool has_stages = !scene.stages.empty();
  const std::string when = has_stages ? " the end of the stages" : ' ' + shortest(reference.time) + " s";
  const std::string at = " at" + when;
  switch (reference.quantity) {
    case Quantity::run_out:
      return "run-out" + at;
    case Quantity::height:
      return "height of the free blocks" + at;
    case Quantity::position:
      return "position of " + reference.block + " along " + "xyz"[reference.axis] + at;
    case Quantity::force:
      return "largest contact force on " + reference.block + " up to" + when;
    case Quantity::stands:
      return "stable (1) or fallen (0)" + at;
    case Quantity::friction_angle:
      return "min friction angle of a stable scene" + at;
  }
  return "";
}

const char* unit_of_cost(const Scene& scene) {
  return scene.stages.empty() ? "CPU seconds per simulated second" : "CPU seconds for all stages";
}

const char* unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::force:
      return "N";
    case Quantity::stands:
      return "";
    case Quantity::friction_angle:
      return "degrees";
    default:
      return "m";
  }
}

}  // namespace halfspace::cli
