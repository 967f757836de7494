#include <algorithm>

#include "model/model.h"

// Motions and loads in time, which begin with stages.

namespace halfspace::cli {
namespace {

hs_action_def definition_of(const Context& context, int kind, double start) {
  hs_action_def def;
  require(context, hs_action_def_init(&def, sizeof def));
  def.kind = kind;
  def.start = start;
  return def;
}

}  // namespace

void Model::begin_actions(std::size_t stage) {
  const double now = report_.time;
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const Action& action = actions_[i];
    if (action.stage != stage) continue;
    hs_action_def def = definition_of(context_, action.kind, now);
    def.table = add_table(action.table);
    std::copy(action.scale.begin(), action.scale.end(), def.scale);
    def.max_speed = action.max_speed;
    if (action.at) {
      def.place = action.is_carried ? HS_PLACE_CARRIED : HS_PLACE_FIXED;
      std::copy(action.at->begin(), action.at->end(), def.point);
    }
    if (action.on.empty()) require(context_, hs_world_add_action(world_.get(), 0, &def));
    for (const std::size_t block : layout_.acted_on[i]) {
      if (!is_removed_[block]) require(context_, hs_world_add_action(world_.get(), blocks_[block], &def));
    }
  }
  for (std::size_t body = 0; body < layout_.bodies.size(); ++body) {
    for (const LayoutBody::NodeAction& action : layout_.bodies[body].actions) {
      if (action.stage != stage || bodies_[body] == 0) continue;
      hs_action_def def = definition_of(context_, action.kind, now);
      def.table = add_table(action.table);
      require(context_, hs_world_add_node_action(world_.get(), bodies_[body], action.nodes.data(),
                                                 view_of(action.scales), &def));
    }
  }
}

std::string Model::actions_of(std::size_t stage) const {
  Archive archive;
  const auto add = [&](int kind, TimeTable table, std::vector<Point> scales) {
    archive.add(kind);
    archive.add(table.times);
    archive.add(table.values);
    archive.add(scales);
  };
  for (const Action& action : actions_) {
    if (action.stage == stage)
      add(action.kind, action.table, {action.scale, action.at.value_or(Point{}), Point{action.max_speed}});
  }
  for (const LayoutBody& body : layout_.bodies) {
    for (const LayoutBody::NodeAction& action : body.actions)
      if (action.stage == stage) add(action.kind, action.table, action.scales);
  }
  return archive.bytes();
}

int32_t Model::add_table(const TimeTable& table) {
  int32_t index = 0;
  require(context_, hs_world_add_table(world_.get(), table.times.data(), view_of(table.values), &index));
  state_.actions_end = std::max(state_.actions_end, report_.time + table.times.back());
  return index;
}

}  // namespace halfspace::cli
