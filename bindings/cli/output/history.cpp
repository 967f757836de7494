#include "output/history.h"

#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

std::vector<const char*> columns_of_block(int dimension) {
  if (dimension == 2) return {".x", ".y", ".angle", ".vx", ".vy", ".angular_velocity"};
  return {".x", ".y", ".z", ".qx", ".qy", ".qz", ".qw", ".vx", ".vy", ".vz", ".wx", ".wy", ".wz"};
}

/// A column of a stress: its name and the component of the tensor.
struct StressColumn {
  const char* name;
  std::size_t component;
};

std::vector<StressColumn> stress_columns(int dimension) {
  if (dimension == 2) return {{".sxx", 0}, {".syy", 4}, {".sxy", 1}};
  return {{".sxx", 0}, {".syy", 4}, {".szz", 8}, {".syz", 5}, {".szx", 2}, {".sxy", 1}};
}

std::vector<const char*> columns_of_point(int dimension) {
  if (dimension == 2) return {".x", ".y", ".ux", ".uy", ".vx", ".vy"};
  return {".x", ".y", ".z", ".ux", ".uy", ".uz", ".vx", ".vy", ".vz"};
}

std::vector<double> motion_of_block(const hs_block_state& state, int dimension) {
  const auto& [x, y, z] = state.pose.position;
  const auto& [vx, vy, vz] = state.velocity;
  const auto& [wx, wy, wz] = state.angular_velocity;
  if (dimension == 2) return {x, y, state.angle, vx, vy, wz};
  const auto& [qx, qy, qz, qw] = state.pose.rotation;
  return {x, y, z, qx, qy, qz, qw, vx, vy, vz, wx, wy, wz};
}

}  // namespace

History::History(const Scene& scene, const Model& start)
    : has_stages_(!scene.stages.empty()), has_water_(has_water(scene)), has_bolts_(!scene.bolts.empty()) {
  const Layout& layout = start.layout();
  text_ =
      "time,steps,contacts,largest_overlap,largest_speed,kinetic,gravity,strain,friction_loss,contact_"
      "damping_loss,"
      "local_damping_loss,mass_damping_loss,outer_work,residual";
  if (layout.has_deformable()) text_ += ",block_strain,block_damping_loss";
  if (has_stages_) text_ += ",stage,stage_time";
  if (has_water_) text_ += ",water";
  if (has_bolts_) text_ += ",bolt_strain,bolt_loss";
  for (std::size_t block : layout.tracked) {
    for (const char* column : columns_of_block(layout.dimension))
      text_ += ',' + layout.blocks[block].name + column;
    if (!deforms(layout.blocks[block].kind)) continue;
    for (const auto& [column, component] : stress_columns(layout.dimension))
      text_ += ',' + layout.blocks[block].name + column;
  }
  for (const LayoutPoint& point : layout.points) {
    points_.push_back(start.carry(point.block, point.at));
    for (const char* column : columns_of_point(layout.dimension)) text_ += ',' + point.name + column;
  }
  for (const LayoutJoint& joint : layout.joints) {
    joints_.emplace_back(start, joint);
    for (const char* column : {".opening", ".slip", ".normal_force", ".shear_force"})
      text_ += ',' + joint.name + column;
  }
  text_ += '\n';
}

void History::add(const Model& model, const HistoryStage& stage, const Frame& origin) {
  const hs_world_report& report = model.report();
  const hs_energy& energy = report.energy;
  text_ +=
      shortest(report.time) + ',' + std::to_string(report.steps) + ',' + std::to_string(report.contact_count);
  for (double value :
       {report.largest_overlap, report.largest_speed, energy.kinetic, energy.gravity, energy.strain,
        energy.friction_loss, energy.contact_damping_loss, energy.local_damping_loss,
        energy.mass_damping_loss, energy.outer_work, energy.residual}) {
    text_ += ',' + shortest(value);
  }
  const Layout& layout = model.layout();
  if (layout.has_deformable())
    text_ += ',' + shortest(report.block_strain_energy) + ',' + shortest(report.block_damping_loss);
  if (has_stages_) text_ += ',' + csv_value(stage.name) + ',' + shortest(report.time - stage.start);
  if (has_water_) text_ += ',' + shortest(report.water_energy);
  if (has_bolts_) text_ += ',' + shortest(report.bolt_strain_energy) + ',' + shortest(report.bolt_loss);
  for (std::size_t block : layout.tracked) {
    const BlockFrame now = model.motion_of(block);
    for (double value : motion_of_block(now.state, layout.dimension)) text_ += ',' + shortest(value);
    if (!deforms(layout.blocks[block].kind)) continue;
    for (const auto& [column, component] : stress_columns(layout.dimension))
      text_ += ',' + shortest(now.deformation.stress[component]);
  }
  add_points(model, origin);
  add_joints(model);
  text_ += '\n';
}

void History::add_points(const Model& model, const Frame& origin) {
  const auto dimension = static_cast<std::size_t>(model.layout().dimension);
  for (const CarriedPoint& point : points_) {
    const Point position = model.position_of(point);
    const Point displacement = minus(position, model.position_of(point, origin.blocks[point.block]));
    for (const Point& vector : {position, displacement, model.velocity_of(point)})
      for (std::size_t axis = 0; axis < dimension; ++axis) text_ += ',' + shortest(vector[axis]);
  }
}

void History::add_joints(const Model& model) {
  if (joints_.empty()) return;
  const std::vector<hs_contact> contacts = model.contacts();
  const std::vector<hs_bond> bonds = model.bonds();
  for (const JointMotion& joint : joints_) {
    const JointState state = joint.state(model, contacts, bonds);
    for (const double value : {state.opening, state.slip, state.normal_force, state.shear_force})
      text_ += ',' + shortest(value);
  }
}

}  // namespace halfspace::cli
