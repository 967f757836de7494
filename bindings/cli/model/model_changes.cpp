#include <algorithm>
#include <cmath>
#include <map>

#include "common/vector.h"
#include "model/model.h"

// Changes of a model that stages make.

namespace halfspace::cli {

void Model::begin(const SceneStage& stage, const std::vector<std::size_t>& excavated) {
  hs_world* world = world_.get();
  change_to(1);  // completes the changes of the stage before
  for (std::vector<Point>& forces : released_) forces.clear();
  state_.gravity_before = state_.gravity;
  state_.gravity = stage.gravity.value_or(state_.gravity);
  state_.loads_before = state_.loads;
  state_.loads = stage.loads.value_or(state_.loads);
  state_.local_damping = stage.local_damping.value_or(state_.local_damping);
  state_.mass_damping = stage.mass_damping.value_or(state_.mass_damping);
  require(context_, hs_world_set_damping(world, state_.local_damping, state_.mass_damping));
  if (stage.default_law) require(context_, hs_world_set_default_law(world, &*stage.default_law));
  for (const PairLaw& pair : stage.laws)
    require(context_, hs_world_set_law(world, pair.a, pair.b, &pair.law));
  if (stage.strength_factor) require(context_, hs_world_set_strength_factor(world, *stage.strength_factor));
  water_before_ = water_;
  if (stage.water) water_ = stage.water;
  const bool changes = stage.gravity || stage.loads || stage.water || !excavated.empty();
  state_.progress = changes ? 0 : 1;
  excavate(excavated);
  begin_actions(stage.index);
  for (const std::size_t bolt : stage.installed) install(bolt);
  update_report();
}

void Model::change_to(double progress) {
  if (state_.progress == progress) return;
  state_.progress = progress;
  set_gravity();
  set_water();
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    if (bodies_[body] != 0) load_nodes(body);
  }
  update_report();
}

void Model::set_gravity() {
  const double progress = state_.progress;
  const Point gravity =
      progress == 1 ? state_.gravity
                    : plus(times(1 - progress, state_.gravity_before), times(progress, state_.gravity));
  require(context_, hs_world_set_gravity(world_.get(), gravity.data()));
}

void Model::tilt(const Point& axis, double angle) {
  for (Point* gravity : {&state_.gravity_before, &state_.gravity}) {
    const Point down = *gravity, along = times(dot(axis, down) * (1 - std::cos(angle)), axis);
    *gravity = plus(plus(times(std::cos(angle), down), times(std::sin(angle), cross(axis, down))), along);
  }
  set_gravity();
}

/// Applies the current mesh loads, and the remaining forces of excavated cells.
void Model::load_nodes(std::size_t body) {
  const double progress = state_.progress;
  const double loads =
      progress == 1 ? state_.loads : (1 - progress) * state_.loads_before + progress * state_.loads;
  std::map<int32_t, Point> forces;
  for (const LayoutBody::Force& force : layout_.bodies[body].forces) {
    const char is_removed =
        is_removed_[layout_.bodies[body].first_block + static_cast<std::size_t>(force.cell)];
    const double left = is_removed == 0 ? 1 : is_removed == 1 ? 0 : 1 - progress;
    Point& sum = forces[force.node];
    sum = plus(sum, times(left * loads, force.force));
  }
  const std::vector<Point>& released = released_[body];
  for (std::size_t node = 0; node < released.size(); ++node) {
    if (released[node] == Point{}) continue;
    Point& force = forces[static_cast<int32_t>(node)];
    force = plus(force, times(1 - progress, released[node]));
  }
  for (const auto& [node, force] : forces)
    require(context_, hs_world_set_node_force(world_.get(), bodies_[body], &node, 1, force.data()));
}

void Model::excavate(const std::vector<std::size_t>& blocks) {
  for (char& is_removed : is_removed_) is_removed = is_removed != 0;
  std::map<std::size_t, std::vector<int32_t>> cells_of;
  for (const std::size_t block : blocks) {
    if (is_removed_[block]) continue;
    is_removed_[block] = 2;
    if (const std::optional<std::size_t> body = layout_.blocks[block].body) {
      cells_of[*body].push_back(static_cast<int32_t>(block - layout_.bodies[*body].first_block));
    } else if (const std::optional<std::size_t> compound = layout_.blocks[block].compound) {
      if (block == layout_.compounds[*compound].first_block)
        require(context_, hs_world_remove_block(world_.get(), compounds_[*compound]));
    } else {
      require(context_, hs_world_remove_block(world_.get(), blocks_[block]));
    }
  }
  for (const auto& [body, cells] : cells_of) excavate_cells(body, cells);
}

bool Model::is_excavated(std::size_t body) const {
  const LayoutBody& given = layout_.bodies[body];
  const auto first = is_removed_.begin() + static_cast<std::ptrdiff_t>(given.first_block);
  const auto last = first + static_cast<std::ptrdiff_t>(given.cell_nodes.size());
  return std::find(first, last, 0) == last;
}

void Model::excavate_cells(std::size_t index, const std::vector<int32_t>& cells) {
  const LayoutBody& given = layout_.bodies[index];
  if (is_excavated(index)) {
    require(context_, hs_world_remove_body(world_.get(), bodies_[index]));
    bodies_[index] = 0;
    return;
  }
  std::vector<Point> released(given.node_count);
  require(context_, hs_world_remove_cells(world_.get(), bodies_[index], cells.data(),
                                          static_cast<int64_t>(cells.size()), view_of(released)));
  std::vector<Point>& forces = released_[index];
  forces.resize(given.node_count);
  for (std::size_t node = 0; node < released.size(); ++node)
    forces[node] = plus(forces[node], released[node]);
  load_nodes(index);  // at once, so that the remaining cells stay in equilibrium
}

}  // namespace halfspace::cli
