#include "model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "vector.h"

namespace halfspace::cli {
namespace {

/// The quaternion of a turn by an axis times an angle.
std::array<double, 4> quaternion_of(const Point& turn) {
  const double angle = length(turn);
  if (angle == 0) return {0, 0, 0, 1};
  const Point along = times(std::sin(angle / 2) / angle, turn);
  return {along[0], along[1], along[2], std::cos(angle / 2)};
}

/// p turned by a quaternion q = (v, w): p + 2 w (v x p) + 2 v x (v x p).
Point turned(const std::array<double, 4>& q, const Point& p) {
  const Point v = point_of(q.data());
  const Point once = cross(v, p);
  return plus(p, times(2, plus(times(q[3], once), cross(v, once))));
}

/// Moves a pose from where the shape was given to where the scene puts it.
void place(hs_pose& pose, const Placing& placing) {
  const std::array<double, 4> rotation = quaternion_of(placing.rotation);
  const Point centroid = plus(turned(rotation, point_of(pose.position)), placing.shift);
  std::copy(centroid.begin(), centroid.end(), pose.position);
  std::copy(rotation.begin(), rotation.end(), pose.rotation);  // shapes are given unturned
}

void set_velocity(hs_block_def& def, const Motion& motion) {
  std::copy(motion.velocity.begin(), motion.velocity.end(), def.velocity);
  std::copy(motion.angular_velocity.begin(), motion.angular_velocity.end(), def.angular_velocity);
}

}  // namespace

Model::Model(const Context& context, const Scene& scene, Layout layout)
    : context_(context),
      layout_(std::move(layout)),
      local_damping_(scene.world.local_damping),
      mass_damping_(scene.world.mass_damping) {
  hs_world* world = nullptr;
  require(context, hs_world_create(context.get(), &scene.world, &world));
  world_.reset(world);
  for (const Material& material : scene.materials) {
    int32_t index = 0;  // counted from 0 in order, as the scene does
    require(context, hs_world_add_material(world, material.density, &index));
    if (material.elasticity) require(context, hs_world_set_elasticity(world, index, &*material.elasticity));
  }
  require(context, hs_world_set_default_law(world, &scene.default_law));
  for (const PairLaw& pair : scene.laws) require(context, hs_world_set_law(world, pair.a, pair.b, &pair.law));
  for (const LayoutBlock& given : layout_.blocks) {
    hs_block_def def;
    require(context, hs_block_def_init(&def, sizeof def, given.shape.get()));
    def.kind = given.kind;
    def.material = given.material;
    place(def.pose, given.placing);
    if (given.motion.start == 0) set_velocity(def, given.motion);
    hs_block block = 0;
    require(context, hs_world_add_block(world, given.shape.get(), &def, &block));
    if (given.stress) require(context, hs_world_set_stress(world, block, given.stress->data()));
    blocks_.push_back(block);
  }
  for (const PairBond& pair : scene.bonds)
    require(context, hs_world_bond_materials(world, pair.a, pair.b, &pair.def, nullptr));
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

void Model::begin(const SceneStage& stage) {
  hs_world* world = world_.get();
  if (stage.gravity) require(context_, hs_world_set_gravity(world, stage.gravity->data()));
  local_damping_ = stage.local_damping.value_or(local_damping_);
  mass_damping_ = stage.mass_damping.value_or(mass_damping_);
  require(context_, hs_world_set_damping(world, local_damping_, mass_damping_));
  if (stage.strength_factor) require(context_, hs_world_set_strength_factor(world, *stage.strength_factor));
  update_report();
}

bool Model::settle(const hs_relaxation_def& relaxation, hs_balance& balance) {
  const hs_status status = hs_world_relax(world_.get(), &relaxation, &balance, sizeof balance);
  update_report();
  require(context_, status);
  set_due_motions();
  return status != HS_NOTE_NOT_AT_REST;
}

hs_bond_report Model::bond_report() const {
  hs_bond_report report;
  require(context_, hs_world_get_bond_report(world_.get(), &report, sizeof report));
  return report;
}

double Model::next_motion_change() const {
  double next = never;
  for (const LayoutBlock& block : layout_.blocks) {
    for (double change : {block.motion.start, block.motion.stop}) {
      if (!reached(change)) next = std::min(next, change);
    }
  }
  return next;
}

void Model::set_due_motions() {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const LayoutBlock& block = layout_.blocks[i];
    if (block.kind != HS_BLOCK_PRESCRIBED) continue;
    const bool moves = reached(block.motion.start) && !reached(block.motion.stop);
    const Point velocity = moves ? block.motion.velocity : Point{};
    const Point spin = moves ? block.motion.angular_velocity : Point{};
    const hs_block_state now = state_of(i);
    if (std::equal(velocity.begin(), velocity.end(), now.velocity) &&
        std::equal(spin.begin(), spin.end(), now.angular_velocity))
      continue;
    require(context_, hs_world_set_velocity(world_.get(), blocks_[i], velocity.data(), spin.data()));
  }
}

void Model::update_report() {
  require(context_, hs_world_get_report(world_.get(), &report_, sizeof report_));
}

hs_world_plan Model::account(std::int64_t steps) const {
  hs_world_plan account{};
  require(context_, hs_world_get_plan(world_.get(), steps, &account, sizeof account));
  return account;
}

std::size_t Model::index_of(hs_block block) const {
  return static_cast<std::size_t>(std::find(blocks_.begin(), blocks_.end(), block) - blocks_.begin());
}

hs_block_state Model::state_of(std::size_t block) const {
  hs_block_state state;
  require(context_, hs_world_get_block_state(world_.get(), blocks_[block], &state));
  return state;
}

hs_deformation Model::deformation_of(std::size_t block) const {
  hs_deformation deformation;
  require(context_, hs_world_get_deformation(world_.get(), blocks_[block], &deformation));
  return deformation;
}

std::vector<hs_contact> Model::contacts() const {
  int64_t count = 0;
  const hs_status status = hs_world_get_contacts(world_.get(), nullptr, 0, &count);
  require(context_, status);
  std::vector<hs_contact> contacts(static_cast<std::size_t>(count));
  require(context_, hs_world_get_contacts(world_.get(), contacts.data(), count, nullptr));
  std::map<hs_block, std::size_t> indices;
  for (std::size_t i = 0; i < blocks_.size(); ++i) indices[blocks_[i]] = i;
  for (hs_contact& contact : contacts) {
    contact.block_a = indices.at(contact.block_a);
    contact.block_b = indices.at(contact.block_b);
  }
  return contacts;
}

Frame Model::frame() const {
  Frame frame{.time = report_.time, .blocks = std::vector<BlockFrame>(blocks_.size())};
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    BlockFrame& block = frame.blocks[i];
    block.state = state_of(i);
    if (block.state.kind == HS_BLOCK_AFFINE) block.deformation = deformation_of(i);
    block.vertices.resize(
        static_cast<std::size_t>(properties_of(context_, layout_.blocks[i].shape).vertex_count));
    require(context_,
            hs_world_get_block_vertices(world_.get(), blocks_[i], view_of(block.vertices), nullptr));
  }
  return frame;
}

}  // namespace halfspace::cli
