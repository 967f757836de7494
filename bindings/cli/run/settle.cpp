#include "run/settle.h"

#include <algorithm>
#include <cmath>

#include "common/interrupt.h"
#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {

std::string endless_motion(const Model& model) {
  const Layout& layout = model.layout();
  for (const LayoutBody& body : layout.bodies) {
    for (const LayoutBody::Support& support : body.supports)
      if (support.velocity != Point{}) return layout.blocks[body.first_block].name;
  }
  for (std::size_t i = 0; i < layout.blocks.size(); ++i) {
    const LayoutBlock& block = layout.blocks[i];
    if (block.kind != HS_BLOCK_PRESCRIBED || std::isfinite(block.motion.stop)) continue;
    const hs_block_state now = model.state_of(i);  // NaN for an excavated block
    if (length(point_of(now.velocity)) > 0 || length(point_of(now.angular_velocity)) > 0) return block.name;
  }
  return {};
}

std::string largest_force_block(const Model& model, const hs_balance& balance) {
  if (balance.largest_force_block == 0) return {};
  const auto name = [&](hs_block index) { return '"' + model.layout().blocks[index].name + '"'; };
  const std::size_t block = model.index_of(balance.largest_force_block);
  std::string text = "; largest on " + name(block) + ", " + rounded(balance.largest_force, 3) + " N";
  double largest = 0;
  std::string other;
  for (const hs_contact& contact : model.contacts()) {
    const double force = length(point_of(contact.force));
    if ((contact.block_a != block && contact.block_b != block) || force <= largest) continue;
    largest = force;
    other = name(contact.block_a == block ? contact.block_b : contact.block_a);
  }
  if (!other.empty()) text += ", whose largest contact is " + rounded(largest, 3) + " N with " + other;
  return text;
}

namespace {

Box box_of(const Frame& frame) {
  Box box;
  for (const BlockFrame& block : frame.blocks)
    for (const Point& vertex : block.vertices) box.add(vertex);
  return box;
}

/// The name of a free block that is farther from the scene than this is long: nothing is there to stop it.
std::string block_outside(const Box& scene, const Model& model) {
  for (std::size_t i = 0; i < model.layout().blocks.size(); ++i) {
    if (!moves_freely(model.layout().blocks[i].kind)) continue;
    const hs_block_state now = model.state_of(i);  // NaN for an excavated block
    if (scene.distance(point_of(now.pose.position)) > length(scene.sides()))
      return model.layout().blocks[i].name;
  }
  return {};
}

}  // namespace

hs_balance settle_on(const SceneStage& stage, Model& model, Settling& settling, std::int64_t steps_of_piece) {
  if ((settling.is_balanced || settling.portions == 0) && !model.is_changed())
    model.change_to(static_cast<double>(++settling.portions) / static_cast<double>(stage.portions));
  if (!(settling.scene.low[0] <= settling.scene.high[0])) settling.scene = box_of(model.frame());
  hs_relaxation_def piece = stage.relaxation;
  piece.max_steps = std::min(steps_of_piece, stage.relaxation.max_steps - settling.steps);
  hs_balance balance{};
  settling.is_balanced = model.settle(piece, balance);
  settling.steps += balance.steps;
  if (!settling.is_balanced) settling.fallen = block_outside(settling.scene, model);
  settling.is_driven = !settling.is_balanced && !endless_motion(model).empty();
  return balance;
}

bool settle(const SceneStage& stage, Model& model, hs_balance& balance) {
  Settling settling;
  while (!settling.is_over(stage, model) && !interrupt_requested())
    balance = settle_on(stage, model, settling);
  balance.steps = settling.steps;
  return settling.is_at_rest(model);
}

}  // namespace halfspace::cli
