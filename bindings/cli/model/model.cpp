#include "model/model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/text.h"
#include "common/vector.h"
#include "model/joint_stress.h"
#include "model/placing.h"

namespace halfspace::cli {
namespace {

/// The frame of an excavated block: it has no vertices.
BlockFrame removed() {
  BlockFrame frame;
  frame.state.kind = HS_BLOCK_FIXED;
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  for (double* values : {frame.state.pose.position, frame.state.velocity, frame.state.angular_velocity})
    std::fill_n(values, 3, nowhere);
  frame.state.angle = nowhere;
  return frame;
}

void set_velocity(hs_block_def& def, const Motion& motion) {
  std::copy(motion.velocity.begin(), motion.velocity.end(), def.velocity);
  std::copy(motion.angular_velocity.begin(), motion.angular_velocity.end(), def.angular_velocity);
}

/// Refuses steps so small that the run cannot reach its end: the time, a double, does not resolve them.
/// Longer runs than of 1e9 s are meant to be stopped.
void require_end(const Scene& scene, const hs_world_report& start) {
  constexpr double max_steps = 0x1p53, endless = 1e9;
  const double given = scene.world.time_step, stable = start.stable_time_step;
  const double step = given > 0 ? given : scene.world.safety * stable;
  const double resolved = std::min(scene.duration, endless) / max_steps;
  if (step >= resolved || (given == 0 && stable == 0)) return;
  const bool is_too_stiff = given == 0 && stable < resolved;
  throw SceneFault(given > 0 ? scene.places.time_step : scene.places.duration,
                   given > 0 ? "world.time_step" : "world.duration",
                   shortest(scene.duration) + " s in steps of " + rounded(step, 3) +
                       " s: the run never ends; allowed: steps of at least " + rounded(resolved, 2) +
                       " s, by a " +
                       (given > 0      ? "larger time_step"
                        : is_too_stiff ? "smaller normal_stiffness"
                                       : "larger safety"));
}

}  // namespace

Model::Model(const Context& context, const Scene& scene, Layout layout)
    : context_(context),
      layout_(std::move(layout)),
      actions_(scene.actions),
      state_{.gravity = {scene.world.gravity[0], scene.world.gravity[1], scene.world.gravity[2]},
             .gravity_before = {},
             .local_damping = scene.world.local_damping,
             .mass_damping = scene.world.mass_damping},
      water_(scene.water),
      water_before_(scene.water),
      given_bolts_(scene.bolts),
      bolt_numbers_(scene.bolts.size(), -1),
      given_time_step_(scene.world.time_step),
      safety_(scene.world.safety),
      frames_have_contacts_(scene.output.contacts || scene.output.forces || scene.output.thrust) {
  hs_world* world = nullptr;
  require(context, hs_world_create(context.get(), &scene.world, &world));
  world_.reset(world);
  for (const Material& material : scene.materials) {
    densities_.push_back(material.density);
    int32_t index = 0;  // counted from 0 in order, as in the scene
    require(context, hs_world_add_material(world, material.density, &index));
    if (material.elasticity) require(context, hs_world_set_elasticity(world, index, &*material.elasticity));
  }
  require(context, hs_world_set_default_law(world, &scene.default_law));
  for (const PairLaw& pair : scene.laws) require(context, hs_world_set_law(world, pair.a, pair.b, &pair.law));
  for (const LayoutBlock& given : layout_.blocks) {
    if (given.body || given.compound) {
      blocks_.push_back(0);
      continue;
    }
    hs_block_def def;
    require(context, hs_block_def_init(&def, sizeof def, given.shape.get()));
    def.kind = given.kind;
    def.material = given.material;
    place(def.pose, given.placing);
    if (given.motion.start == 0) set_velocity(def, given.motion);
    hs_block block = 0;
    require(context, hs_world_add_block(world, given.shape.get(), &def, &block));
    if (given.stress) require(context, hs_world_set_stress(world, block, given.stress->data()));
    if (given.motion.held_axes != 0)
      require(context, hs_world_hold_block(world, block, static_cast<int32_t>(given.motion.held_axes)));
    index_of_block_.emplace(block, blocks_.size());
    blocks_.push_back(block);
  }
  for (const LayoutCompound& compound : layout_.compounds) add(compound);
  is_removed_.resize(blocks_.size());
  released_.resize(layout_.bodies.size());
  for (const LayoutBody& body : layout_.bodies) add(body, scene.materials);
  for (std::size_t body = 0; body < bodies_.size(); ++body) load_nodes(body);
  for (const PairBond& pair : scene.bonds)
    require(context, hs_world_bond_materials(world, pair.a, pair.b, &pair.def, nullptr));
  for (const hs_bond& bond : all_records(context, world, hs_world_get_bonds))
    bonded_.emplace_back(index_of(bond.block_a), index_of(bond.block_b));
  set_water();
  prepare_bolts();
  if (scene.in_situ) preload_joints(scene);
  update_report();
  require_end(scene, report_);
  is_moving_.resize(blocks_.size());
  note_motions();
  if (scene.stages.empty()) begin_actions(0);
}

void Model::add(const LayoutCompound& given) {
  std::vector<const hs_shape*> shapes;
  std::vector<hs_pose> poses;
  for (std::size_t i = given.first_block; i < given.first_block + given.part_count; ++i) {
    const LayoutBlock& part = layout_.blocks[i];
    hs_block_def at;
    require(context_, hs_block_def_init(&at, sizeof at, part.shape.get()));
    place(at.pose, part.placing);
    shapes.push_back(part.shape.get());
    poses.push_back(at.pose);
  }
  const LayoutBlock& first = layout_.blocks[given.first_block];
  const auto count = static_cast<int64_t>(shapes.size());
  hs_block_def def;
  require(context_, hs_compound_def_init(&def, sizeof def, shapes.data(), poses.data(), count));
  def.kind = first.kind;
  def.material = first.material;
  if (first.motion.start == 0) set_velocity(def, first.motion);
  hs_block block = 0;
  require(context_, hs_world_add_compound(world_.get(), shapes.data(), poses.data(), count, &def, &block));
  if (first.motion.held_axes != 0)
    require(context_, hs_world_hold_block(world_.get(), block, static_cast<int32_t>(first.motion.held_axes)));
  index_of_compound_.emplace(block, compounds_.size());
  compounds_.push_back(block);
  require(context_,
          hs_world_get_compound_parts(world_.get(), block, &blocks_[given.first_block], count, nullptr));
  for (std::size_t i = given.first_block; i < given.first_block + given.part_count; ++i)
    index_of_block_.emplace(blocks_[i], i);
}

/// Gives the shear stress of the start to the joints that resist it.
void Model::preload_joints(const Scene& scene) {
  require(context_, hs_world_detect(world_.get(), nullptr));
  for (const hs_contact& contact : all_records(context_, world_.get(), hs_world_get_contacts)) {
    const LayoutBlock& a = layout_.blocks[index_of(contact.block_a)];
    const LayoutBlock& b = layout_.blocks[index_of(contact.block_b)];
    const hs_law_def& law = law_between(scene, a.material, b.material);
    const bool is_loaded = a.kind == HS_BLOCK_RIGID || b.kind == HS_BLOCK_RIGID;
    if (!is_loaded || contact.area == 0 || (law.friction_angle == 0 && law.cohesion == 0)) continue;
    const Point shear = shear_force_at(scene, *scene.in_situ, contact);
    require(context_, hs_world_set_shear_force(world_.get(), contact.block_a, contact.block_b, shear.data()));
  }
}

void Model::add(const LayoutBody& given, const std::vector<Material>& materials) {
  hs_body_def def;
  require(context_, hs_body_def_init(&def, sizeof def));
  place(def.pose, given.placing);
  std::copy(given.velocity.begin(), given.velocity.end(), def.velocity);
  hs_body body = 0;
  require(context_, hs_world_add_mesh(world_.get(), given.mesh.get(), &def, given.materials.data(), &body));
  for (const LayoutBody::Support& support : given.supports) {
    require(context_, hs_world_hold_nodes(world_.get(), body, support.nodes.data(),
                                          static_cast<int64_t>(support.nodes.size()), support.axes,
                                          support.velocity.data()));
  }
  make_viscous(given, body, materials);
  if (given.stress) {
    std::array<double, 27> gradient{};
    std::copy(given.stress_by_height.begin(), given.stress_by_height.end(),
              gradient.begin() + static_cast<std::ptrdiff_t>(9 * up_axis(layout_.dimension)));
    require(context_, hs_world_set_body_stress(world_.get(), body, given.stress->data(), gradient.data()));
  }
  index_of_body_.emplace(body, bodies_.size());
  bodies_.push_back(body);
}

void Model::step_towards(double time, std::int64_t max_steps, double end) {
  const double step = usual_time_step();
  const double target = std::min({time, next_motion_change(), end});
  // An unknown time step is determined by one step.
  const double left = step > 0 ? (target - report_.time) / step : 1;
  auto steps = std::clamp<std::int64_t>(std::llround(std::min(left, 1e15)), 1, max_steps);
  const double to_end = step > 0 ? (end - report_.time) / step : never;
  if (to_end < 1e15 && std::abs(to_end - std::round(to_end)) * step > time_tolerance(end)) {
    if (to_end < 2) return step_shortened((end - report_.time) / std::ceil(to_end));
    steps = std::min(steps, static_cast<std::int64_t>(to_end) - 1);
  }
  state_.usual_time_step = 0;
  const hs_status status = hs_world_step(world_.get(), steps);
  update_report();
  require(context_, status);
  set_due_motions();
}

void Model::step_shortened(double length) {
  const double usual = usual_time_step();
  require(context_, hs_world_set_time_step(world_.get(), length));
  const hs_status status = hs_world_step(world_.get(), 1);
  require(context_, hs_world_set_time_step(world_.get(), given_time_step_));
  state_.usual_time_step = usual;
  update_report();
  require(context_, status);
  set_due_motions();
}

double Model::usual_time_step() const {
  if (report_.time_step > 0) return report_.time_step;
  return given_time_step_ > 0 ? given_time_step_ : safety_ * report_.stable_time_step;
}

double Model::time_tolerance(double end) const {
  return std::ldexp(usual_time_step(), -20) + std::ldexp(std::abs(end), -50);
}

bool Model::settle(const hs_relaxation_def& relaxation, hs_balance& balance) {
  state_.usual_time_step = 0;
  const hs_status status = hs_world_relax(world_.get(), &relaxation, &balance, sizeof balance);
  update_report();
  require(context_, status);
  set_due_motions();
  return status != HS_NOTE_NOT_AT_REST;
}

void Model::set_time_step(double time_step) {
  given_time_step_ = time_step;
  require(context_, hs_world_set_time_step(world_.get(), time_step));
}

void Model::weaken(double factor) { require(context_, hs_world_set_strength_factor(world_.get(), factor)); }

std::vector<hs_bond_event> Model::bond_events() const {
  int64_t count = 0;
  require(context_, hs_world_get_bond_events(world_.get(), 0, nullptr, 0, &count));
  std::vector<hs_bond_event> events(static_cast<std::size_t>(count));
  require(context_, hs_world_get_bond_events(world_.get(), 0, events.data(), count, nullptr));
  return events;
}

std::vector<hs_bond> Model::bonds() const {
  std::vector<hs_bond> bonds = all_records(context_, world_.get(), hs_world_get_bonds);
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    bonds[i].block_a = bonded_[i].first;
    bonds[i].block_b = bonded_[i].second;
  }
  return bonds;
}

hs_bond_report Model::bond_report() const {
  hs_bond_report report;
  require(context_, hs_world_get_bond_report(world_.get(), &report, sizeof report));
  return report;
}

double Model::next_motion_change() const {
  double next = never;
  for (std::size_t i = 0; i < layout_.terrain_begin(); ++i) {
    const Motion& motion = layout_.blocks[i].motion;
    for (double change : {motion.start, motion.stop}) {
      if (!reached(change)) next = std::min(next, change);
    }
  }
  return next;
}

std::vector<Model::PrescribedBlock> Model::prescribed_blocks() const {
  std::vector<PrescribedBlock> found;
  const auto is_due = [&](std::size_t block) {
    return layout_.blocks[block].kind == HS_BLOCK_PRESCRIBED && !is_removed_[block];
  };
  for (std::size_t i = 0; i < layout_.terrain_begin(); ++i) {
    if (is_due(i) && !layout_.blocks[i].compound) found.push_back({i, blocks_[i]});
  }
  for (std::size_t i = 0; i < compounds_.size(); ++i) {
    const std::size_t first = layout_.compounds[i].first_block;
    if (is_due(first)) found.push_back({first, compounds_[i]});
  }
  return found;
}

bool Model::moves(std::size_t block) const {
  const Motion& motion = layout_.blocks[block].motion;
  return (motion.start == 0 || reached(motion.start)) && !reached(motion.stop);
}

void Model::note_motions() {
  for (const auto& [index, block] : prescribed_blocks()) is_moving_[index] = moves(index);
}

/// Between its start and its stop the velocity of a block is that of its actions, if it has any.
void Model::set_due_motions() {
  for (const auto& [index, block] : prescribed_blocks()) {
    const bool is_moving = moves(index);
    if (is_moving == (is_moving_[index] != 0)) continue;
    is_moving_[index] = is_moving;
    const Motion& motion = layout_.blocks[index].motion;
    const Point velocity = is_moving ? motion.velocity : Point{};
    const Point spin = is_moving ? motion.angular_velocity : Point{};
    require(context_, hs_world_set_velocity(world_.get(), block, velocity.data(), spin.data()));
  }
}

/// Frames have the contacts and forces that the report has.
void Model::update_report() {
  require(context_, hs_world_step(world_.get(), 0));
  require(context_, hs_world_get_report(world_.get(), &report_, sizeof report_));
  if (state_.usual_time_step > 0) report_.time_step = state_.usual_time_step;
}

hs_world_plan Model::account(std::int64_t steps) const {
  hs_world_plan account{};
  require(context_, hs_world_get_plan(world_.get(), steps, &account, sizeof account));
  return account;
}

std::size_t Model::index_of(hs_block block) const {
  const auto known = index_of_block_.find(block);
  if (known != index_of_block_.end()) return known->second;
  const auto compound = index_of_compound_.find(block);
  if (compound != index_of_compound_.end()) return layout_.compounds[compound->second].first_block;
  hs_body body = 0;
  int32_t cell = 0;
  require(context_, hs_world_get_body_of_block(world_.get(), block, &body, &cell));
  return index_of(body, cell);
}

BlockFrame Model::motion_of(std::size_t block) const {
  if (is_removed_[block]) return removed();
  if (const std::optional<std::size_t> body = layout_.blocks[block].body)
    return frame_of(*body)[block - layout_.bodies[*body].first_block];
  BlockFrame frame;
  require(context_, hs_world_get_block_state(world_.get(), blocks_[block], &frame.state));
  if (layout_.blocks[block].compound) {
    frame.state.mass = densities_[static_cast<std::size_t>(frame.state.material)] *
                       properties_of(context_, layout_.blocks[block].shape).volume;
  }
  if (frame.state.kind == HS_BLOCK_AFFINE)
    require(context_, hs_world_get_deformation(world_.get(), blocks_[block], &frame.deformation));
  return frame;
}

hs_block_state Model::state_of(std::size_t block) const { return motion_of(block).state; }

std::vector<hs_contact> Model::contacts() const {
  std::vector<hs_contact> contacts = all_records(context_, world_.get(), hs_world_get_contacts);
  for (hs_contact& contact : contacts) {
    contact.block_a = index_of(contact.block_a);
    contact.block_b = index_of(contact.block_b);
  }
  return contacts;
}

std::vector<BlockFrame> Model::frame_of(std::size_t index) const {
  const LayoutBody& given = layout_.bodies[index];
  const hs_body body = bodies_[index];
  if (body == 0) return std::vector<BlockFrame>(given.cell_nodes.size(), removed());
  std::vector<Point> places(given.node_count), velocities(given.node_count);
  require(context_, hs_world_get_node_positions(world_.get(), body, view_of(places), nullptr));
  require(context_, hs_world_get_node_velocities(world_.get(), body, view_of(velocities), nullptr));
  std::vector<hs_cell_state> cells(given.cell_nodes.size());
  require(context_,
          hs_world_get_cells(world_.get(), body, cells.data(), static_cast<int64_t>(cells.size()), nullptr));
  std::vector<BlockFrame> frame(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    BlockFrame& cell = frame[i];
    if (is_removed_[given.first_block + i]) {
      cell = removed();
      continue;
    }
    Point middle{}, velocity{};
    const double weight = 1 / static_cast<double>(given.cell_nodes[i].size());
    for (const int node : given.cell_nodes[i]) {
      cell.vertices.push_back(places[static_cast<std::size_t>(node)]);
      middle = plus(middle, times(weight, cell.vertices.back()));
      velocity = plus(velocity, times(weight, velocities[static_cast<std::size_t>(node)]));
    }
    cell.state.kind = HS_BLOCK_MESH;
    cell.state.material = given.materials[i];
    cell.state.mass = densities_[static_cast<std::size_t>(given.materials[i])] * given.cell_sizes[i];
    cell.state.pose.rotation[3] = 1;
    std::copy(middle.begin(), middle.end(), cell.state.pose.position);
    std::copy(velocity.begin(), velocity.end(), cell.state.velocity);
    std::copy(std::begin(cells[i].stress), std::end(cells[i].stress), cell.deformation.stress);
    std::copy(std::begin(cells[i].strain), std::end(cells[i].strain), cell.deformation.strain);
  }
  return frame;
}

Frame Model::frame() const {
  Frame frame{.time = report_.time,
              .blocks = std::vector<BlockFrame>(blocks_.size()),
              .contacts = {},
              .bolts = {},
              .water = {}};
  if (frames_have_contacts_) frame.contacts = contacts();
  frame.bolts = bolts();
  if (const std::optional<Water> now = water()) frame.water = now->table;
  for (std::size_t body = 0; body < layout_.bodies.size(); ++body) {
    std::vector<BlockFrame> cells = frame_of(body);
    std::move(cells.begin(), cells.end(),
              frame.blocks.begin() + static_cast<std::ptrdiff_t>(layout_.bodies[body].first_block));
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (layout_.blocks[i].body) continue;
    BlockFrame& block = frame.blocks[i];
    block = motion_of(i);
    if (is_removed_[i]) continue;
    block.vertices.resize(
        static_cast<std::size_t>(properties_of(context_, layout_.blocks[i].shape).vertex_count));
    require(context_,
            hs_world_get_block_vertices(world_.get(), blocks_[i], view_of(block.vertices), nullptr));
  }
  return frame;
}

}  // namespace halfspace::cli
