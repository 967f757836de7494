#include "history.h"

#include "text.h"

namespace halfspace::cli {

History::History(const Plan& plan) {
  text_ =
      "time,steps,contacts,largest_overlap,largest_speed,kinetic,gravity,strain,friction_loss,contact_"
      "damping_loss,"
      "local_damping_loss,mass_damping_loss,outer_work,residual";
  for (std::size_t block : plan.tracked) {
    for (const char* column : {".x", ".y", ".angle", ".vx", ".vy", ".angular_velocity"}) {
      text_ += ',' + plan.blocks[block].name + column;
    }
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
    const hs_block_state state = model.state_of(block);
    for (double value : {state.pose.position[0], state.pose.position[1], state.angle, state.velocity[0],
                         state.velocity[1], state.angular_velocity[2]}) {
      text_ += ',' + shortest(value);
    }
  }
  text_ += '\n';
}

}  // namespace halfspace::cli
