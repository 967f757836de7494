#include "model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace::cli {
namespace {

void set_velocity(hs_block_def& def, const Motion& motion) {
  def.velocity[0] = motion.velocity[0];
  def.velocity[1] = motion.velocity[1];
  def.angular_velocity[2] = motion.angular_velocity;
}

}  // namespace

Model::Model(const Context& context, const Scene& scene, Plan plan)
    : context_(context), plan_(std::move(plan)) {
  hs_world* world = nullptr;
  require(context, hs_world_create(context.get(), &scene.world, &world));
  world_.reset(world);
  for (const Material& material : scene.materials) {
    int32_t index = 0;  // counted from 0 in order, as the scene does
    require(context, hs_world_add_material(world, material.density, &index));
  }
  require(context, hs_world_set_default_law(world, &scene.default_law));
  for (const PairLaw& pair : scene.laws) require(context, hs_world_set_law(world, pair.a, pair.b, &pair.law));
  for (const PlannedBlock& planned : plan_.blocks) {
    hs_block_def def;
    require(context, hs_block_def_init(&def, sizeof def, planned.shape.get()));
    def.kind = planned.kind;
    def.material = planned.material;
    if (planned.motion.start == 0) set_velocity(def, planned.motion);
    hs_block block = 0;
    require(context, hs_world_add_block(world, planned.shape.get(), &def, &block));
    blocks_.push_back(block);
  }
  update_report();
}

void Model::step_towards(double time, std::int64_t most_steps) {
  const double target = std::min(time, next_motion_change());
  // Before the first step the library may not have derived the time step yet: one step finds it.
  const double left = report_.time_step > 0 ? (target - report_.time) / report_.time_step : 1;
  const auto steps = std::clamp<std::int64_t>(std::llround(std::min(left, 1e15)), 1, most_steps);
  const hs_status status = hs_world_step(world_.get(), steps);
  update_report();
  require(context_, status);
  set_due_motions();
}

double Model::next_motion_change() const {
  double next = never;
  for (const PlannedBlock& block : plan_.blocks) {
    for (double change : {block.motion.start, block.motion.stop}) {
      if (!reached(change)) next = std::min(next, change);
    }
  }
  return next;
}

void Model::set_due_motions() {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const PlannedBlock& block = plan_.blocks[i];
    if (block.kind != HS_BLOCK_PRESCRIBED) continue;
    const bool moves = reached(block.motion.start) && !reached(block.motion.stop);
    const Point velocity = moves ? block.motion.velocity : Point{};
    const double spin = moves ? block.motion.angular_velocity : 0;
    const hs_block_state now = state_of(i);
    if (now.velocity[0] == velocity[0] && now.velocity[1] == velocity[1] && now.angular_velocity[2] == spin)
      continue;
    const double velocity3[] = {velocity[0], velocity[1], 0};
    const double spin3[] = {0, 0, spin};
    require(context_, hs_world_set_velocity(world_.get(), blocks_[i], velocity3, spin3));
  }
}

void Model::update_report() { require(context_, hs_world_get_report(world_.get(), &report_)); }

hs_block_state Model::state_of(std::size_t block) const {
  hs_block_state state;
  require(context_, hs_world_get_block_state(world_.get(), blocks_[block], &state));
  return state;
}

Frame Model::frame() const {
  Frame frame{.time = report_.time, .blocks = std::vector<BlockFrame>(blocks_.size())};
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    BlockFrame& block = frame.blocks[i];
    block.state = state_of(i);
    block.vertices.resize(
        static_cast<std::size_t>(properties_of(context_, plan_.blocks[i].shape).vertex_count));
    require(context_,
            hs_world_get_block_vertices(world_.get(), blocks_[i], view_of(block.vertices), nullptr));
  }
  return frame;
}

}  // namespace halfspace::cli
