#include "history.h"

#include "text.h"

namespace halfspace::cli {
namespace {

std::vector<const char*> columns_of_block(int dimension) {
  if (dimension == 2) return {".x", ".y", ".angle", ".vx", ".vy", ".angular_velocity"};
  return {".x", ".y", ".z", ".qx", ".qy", ".qz", ".qw", ".vx", ".vy", ".vz", ".wx", ".wy", ".wz"};
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

History::History(const Plan& plan) {
  text_ =
      "time,steps,contacts,largest_overlap,largest_speed,kinetic,gravity,strain,friction_loss,contact_"
      "damping_loss,"
      "local_damping_loss,mass_damping_loss,outer_work,residual";
  for (std::size_t block : plan.tracked) {
    for (const char* column : columns_of_block(plan.dimension))
      text_ += ',' + plan.blocks[block].name + column;
  }
  text_ += '\n';
}

void History::add(const Model& model) {
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
  for (std::size_t block : model.plan().tracked) {
    for (double value : motion_of_block(model.state_of(block), model.plan().dimension))
      text_ += ',' + shortest(value);
  }
  text_ += '\n';
}

}  // namespace halfspace::cli
