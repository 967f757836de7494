#include <algorithm>
#include <cmath>
#include <map>

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

/// Force over velocity of a part of a face: density times the speed of compression waves along its normal,
/// and of shear waves across it [Lysmer 1969].
Tensor impedance_of(const Material& material, const Point& area, int dimension) {
  const hs_elasticity_def& elasticity = *material.elasticity;
  const double modulus = elasticity.young_modulus, ratio = elasticity.poisson_ratio;
  const double shear = modulus / (2 * (1 + ratio));
  const double compression = dimension == 2 && elasticity.plane == HS_PLANE_STRESS
                                 ? modulus / (1 - ratio * ratio)
                                 : modulus * (1 - ratio) / ((1 + ratio) * (1 - 2 * ratio));
  const double size = length(area);
  const double along = size * std::sqrt(material.density * compression);
  const double across = size * std::sqrt(material.density * shear);
  Tensor impedance{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
      impedance[3 * i + k] = (along - across) * area[i] * area[k] / (size * size) + (i == k ? across : 0);
  }
  return impedance;
}

}  // namespace

void Model::make_viscous(const LayoutBody& given, hs_body body, const std::vector<Material>& materials) {
  std::map<int32_t, Tensor> viscosities;
  for (const LayoutBody::ViscousPart& part : given.viscous) {
    const Tensor more =
        impedance_of(materials[static_cast<std::size_t>(part.material)], part.area, layout_.dimension);
    Tensor& sum = viscosities[part.node];
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
  }
  for (const auto& [node, viscosity] : viscosities)
    require(context_, hs_world_set_node_viscosity(world_.get(), body, &node, 1, viscosity.data()));
}

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
      const std::optional<std::size_t> compound = layout_.blocks[block].compound;
      const bool is_later_part = compound && block != layout_.compounds[*compound].first_block;
      if (is_removed_[block] || is_later_part) continue;
      require(context_,
              hs_world_add_action(world_.get(), compound ? compounds_[*compound] : blocks_[block], &def));
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
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const Action& action = actions_[i];
    if (action.stage != stage) continue;
    add(action.kind, action.table, {action.scale, action.at.value_or(Point{}), Point{action.max_speed}});
    std::vector<std::size_t> blocks = layout_.acted_on[i];
    bool has_place = action.at.has_value(), is_carried = action.is_carried;
    archive.add(blocks);
    archive.add(has_place);
    archive.add(is_carried);
  }
  for (const LayoutBody& body : layout_.bodies) {
    for (const LayoutBody::NodeAction& action : body.actions) {
      if (action.stage != stage) continue;
      add(action.kind, action.table, action.scales);
      std::vector<int32_t> nodes = action.nodes;
      archive.add(nodes);
    }
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
