#include "world/loads/actions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

/// The dashpot of a servo corrects this fraction of the missing force per step, as seen from the resistance
/// of its contacts [Cundall 1988].
constexpr double servo_fraction = 0.5;
/// Its mass reaches the velocity of its dashpot after this number of steps.
constexpr double servo_steps = 50;

template <int D>
Vector<D> in(const Vector<3>& components) {
  return components.template head<D>();
}

template <int D>
Angular<D> angular_in(const Vector<3>& components) {
  constexpr int count = D == 2 ? 1 : 3;
  return components.template tail<count>();
}

/// Gives the components whose scale is not 0.
template <class Velocity>
void give(GivenVelocity<Velocity>& given, const Velocity& scale, const Velocity& start, const Velocity& mean,
          const Velocity& end) {
  given.start = start;
  for (Eigen::Index k = 0; k < scale.size(); ++k) {
    if (scale[k] == 0) continue;
    given.components |= std::uint8_t(1 << k);
    given.mean[k] = mean[k];
    given.end[k] = end[k];
  }
}

/// Mean and end of a velocity: those of its table, or those that follow from an acceleration.
template <class Velocity>
void give_by_table(GivenVelocity<Velocity>& given, bool is_acceleration, const Velocity& scale,
                   const Velocity& start, const Velocity& once, const Velocity& twice, const Velocity& last,
                   double duration) {
  if (is_acceleration) {
    give(given, scale, start, Velocity(start + scale.cwiseProduct(twice) / duration),
         Velocity(start + scale.cwiseProduct(once)));
  } else {
    give(given, scale, start, Velocity(scale.cwiseProduct(once) / duration),
         Velocity(scale.cwiseProduct(last)));
  }
}

/// Loads act on blocks that move freely, motions on prescribed blocks and along held axes of rigid ones: an
/// axis that is not held any more does not follow its motion.
template <int D>
bool can_act_on(const Blocks<D>& blocks, std::size_t slot, ActionKind kind) {
  if (blocks.is_of_mesh(slot) || blocks.is_part(slot)) return false;
  if (is_load(kind)) return blocks.moves_freely(slot);
  return blocks.kind[slot] == BlockKind::prescribed ||
         (blocks.kind[slot] == BlockKind::rigid && !is_angular(kind));
}

bool is_same_motion(ActionKind a, ActionKind b) {
  return !is_load(a) && !is_load(b) && is_angular(a) == is_angular(b);
}

/// Does a motion give a velocity along an axis?
template <int D>
bool moves_along(const Action<D>& motion, int axis) {
  const bool is_read = is_angular(motion.kind) ? D == 3 || axis == 2 : axis < D;
  return is_read && motion.scale[axis] != 0;
}

template <int D>
bool moves(const Action<D>& motion) {
  return moves_along(motion, 0) || moves_along(motion, 1) || moves_along(motion, 2);
}

/// Takes the axes of a new motion from an older one.
template <int D>
void take_axes(const Action<D>& motion, Action<D>& older) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves_along(motion, axis) || !moves_along(older, axis)) continue;
    older.scale[axis] = 0;
    if (older.kind == ActionKind::servo) older.scale.setZero();  // its force has a direction
  }
}

}  // namespace

void Servo::adapt(double contact_stiffness, double contact_viscosity, double duration, double time_step) {
  viscosity = (duration * contact_stiffness + contact_viscosity) / servo_fraction;
  mass = (time_step * contact_stiffness + contact_viscosity) / servo_fraction * servo_steps * time_step;
}

template <int D>
void Actions<D>::add(const Action<D>& action) {
  make_room_for_one(actions_);
  for (Action<D>& older : actions_) {
    if (older.slot == action.slot && is_same_motion(older.kind, action.kind)) take_axes(action, older);
  }
  std::erase_if(actions_, [](const Action<D>& known) { return !is_load(known.kind) && !moves(known); });
  actions_.push_back(action);
  is_renewed_ = false;
}

template <int D>
void Actions<D>::add(NodeAction action, std::span<const std::int32_t> nodes,
                     std::span<const Vector<D>> scales) {
  make_room_for_one(node_actions_);
  nodes_.reserve(nodes_.size() + nodes.size());
  scales_.reserve(nodes_.size() + nodes.size());
  nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  scales_.insert(scales_.end(), scales.begin(), scales.end());
  action.end = std::int64_t(nodes_.size());
  node_actions_.push_back(action);
  is_renewed_ = false;
}

template <int D>
void Actions<D>::end_on_block(std::int32_t slot, const Blocks<D>& blocks) {
  const auto ends = [&](const Action<D>& action) { return action.slot == slot; };
  if (std::erase_if(actions_, ends) > 0 && is_renewed_) renew(blocks);
}

template <int D>
void Actions<D>::end_on_nodes(std::int32_t body, const Blocks<D>& blocks) {
  std::int64_t first = 0, kept = 0;
  for (NodeAction& action : node_actions_) {
    const std::int64_t begin = std::exchange(first, action.end);
    if (action.body == body) continue;
    std::copy(nodes_.begin() + begin, nodes_.begin() + action.end, nodes_.begin() + kept);
    std::copy(scales_.begin() + begin, scales_.begin() + action.end, scales_.begin() + kept);
    kept += action.end - begin;
    action.end = kept;
  }
  std::erase_if(node_actions_, [&](const NodeAction& action) { return action.body == body; });
  nodes_.resize(std::size_t(kept));
  scales_.resize(std::size_t(kept));
  if (is_renewed_) renew(blocks);
}

template <int D>
std::size_t Actions<D>::nodes_up_to(std::int32_t body, const Meshes<D>& meshes) const {
  return std::size_t(meshes.body(body).first_node + meshes.body(body).node_count);
}

template <int D>
void Actions<D>::renew(const Blocks<D>& blocks) {
  std::size_t slots = 0, loaded_nodes = 0;
  for (const Action<D>& action : actions_) slots = std::max(slots, std::size_t(action.slot + 1));
  for (const NodeAction& action : node_actions_) {
    if (is_load(action.kind))
      loaded_nodes = std::max(loaded_nodes, nodes_up_to(action.body, blocks.meshes()));
  }
  means_.reserve(actions_.size());
  drifts_.reserve(actions_.size());
  targets_.reserve(actions_.size());
  target_of_.reserve(slots);
  node_velocities_.reserve(nodes_.size());
  node_loads_.reserve(loaded_nodes);
  accelerates_all_ = false;
  targets_.clear();
  target_of_.assign(slots, -1);
  for (const Action<D>& action : actions_) {
    accelerates_all_ |= action.slot < 0;
    if (action.slot < 0) continue;
    std::int32_t& target = target_of_[std::size_t(action.slot)];
    if (target < 0) {
      target = std::int32_t(targets_.size());
      targets_.push_back({.slot = action.slot});
    }
    if (action.kind == ActionKind::servo) target_at(action.slot).is_servo = true;
  }
  node_velocities_.assign(nodes_.size(), {});
  node_loads_.assign(loaded_nodes, Vector<D>::Zero());
  acceleration_.setZero();
  if (motion_.duration > 0) predict(motion_, blocks);
  is_renewed_ = true;
}

template <int D>
void Actions<D>::predict(const Motion& motion, const Blocks<D>& blocks) {
  motion_ = motion;
  means_.clear();
  drifts_.assign(actions_.size(), 0);
  acceleration_.setZero();
  for (Target& target : targets_) target.velocity.components = target.spin.components = 0;
  for (const Action<D>& action : actions_) {
    const TableIntegrals integrals = integrals_of(action);
    means_.push_back(action.scale.cwiseProduct(integrals.once) / motion_.duration);
    if (action.slot < 0) {
      acceleration_ += in<D>(means_.back());
    } else if (!is_load(action.kind)) {
      Target& target = target_at(action.slot);
      if (action.kind == ActionKind::servo)
        drifts_[means_.size() - 1] = control_force(action, means_.back(), blocks, target);
      else
        give_velocity(action, integrals, blocks, target);
      const std::size_t slot = std::size_t(action.slot);
      if (blocks.kind[slot] == BlockKind::rigid) target.velocity.components &= blocks.held[slot];
    }
  }
  std::fill(node_loads_.begin(), node_loads_.end(), Vector<D>::Zero());
  std::size_t first = 0;
  for (const NodeAction& action : node_actions_) {
    act_on_nodes(action, first, integrals_of(action), blocks.meshes());
    first = std::size_t(action.end);
  }
  place_loads(blocks);
  for (Target& target : targets_) {
    target.torque_at_start = target.torque;
    target.virial_at_start = target.virial;
  }
}

template <int D>
void Actions<D>::give_velocity(const Action<D>& action, const TableIntegrals& integrals,
                               const Blocks<D>& blocks, Target& target) const {
  const std::size_t slot = std::size_t(action.slot);
  const Vector<3> last = last_value_of(action);
  if (is_angular(action.kind)) {
    give_by_table(target.spin, action.kind == ActionKind::angular_acceleration, angular_in<D>(action.scale),
                  blocks.spin[slot], angular_in<D>(integrals.once), angular_in<D>(integrals.twice),
                  angular_in<D>(last), motion_.duration);
  } else {
    give_by_table(target.velocity, action.kind == ActionKind::acceleration, in<D>(action.scale),
                  blocks.velocity[slot], in<D>(integrals.once), in<D>(integrals.twice), in<D>(last),
                  motion_.duration);
  }
}

/// The block moves towards its contacts while their force on it is too small. At its max speed, and without
/// contacts, the mass keeps its velocity.
template <int D>
double Actions<D>::control_force(const Action<D>& action, const Vector<3>& mean, const Blocks<D>& blocks,
                                 Target& target) const {
  const std::size_t slot = std::size_t(action.slot);
  const Vector<D> direction = in<D>(action.scale).normalized();
  const double missing = in<D>(mean).dot(direction) + blocks.force[slot].dot(direction);
  const double closing = action.drift + missing / target.servo.viscosity;
  const double speed = std::clamp(closing, -action.max_speed, action.max_speed);
  const Vector<D> other = blocks.velocity[slot] - blocks.velocity[slot].dot(direction) * direction;
  const Vector<D> velocity = other + (std::isfinite(speed) ? speed : 0.0) * direction;
  give(target.velocity, direction, blocks.velocity[slot], velocity, velocity);
  return speed == closing ? action.drift + missing / target.servo.mass * motion_.duration : action.drift;
}

template <int D>
void Actions<D>::act_on_nodes(const NodeAction& action, std::size_t first, const TableIntegrals& integrals,
                              const Meshes<D>& meshes) {
  const Vector<D> once = in<D>(integrals.once), twice = in<D>(integrals.twice);
  const Vector<D> last = in<D>(last_value_of(action));
  for (std::size_t entry = first; entry < std::size_t(action.end); ++entry) {
    const std::size_t node = node_of(action, entry, meshes);
    if (is_load(action.kind)) {
      if (meshes.mass[node] > 0) node_loads_[node] += scales_[entry].cwiseProduct(once) / motion_.duration;
      continue;
    }
    GivenVelocity<Vector<D>>& given = node_velocities_[entry];
    give_by_table(given, action.kind == ActionKind::acceleration, scales_[entry], meshes.velocity[node], once,
                  twice, last, motion_.duration);
    given.components &= meshes.held[node];
  }
}

template <int D>
void Actions<D>::accept_motion() {
  made_ = motion_;
  for (std::size_t i = 0; i < actions_.size(); ++i) actions_[i].drift = drifts_[i];
}

template <int D>
void Actions<D>::place_loads(const Blocks<D>& blocks) {
  for (Target& target : targets_) {
    target.force.setZero();
    target.torque.setZero();
    target.virial.setZero();
  }
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const Action<D>& action = actions_[i];
    if (action.slot < 0 || !is_load(action.kind)) continue;
    const std::size_t slot = std::size_t(action.slot);
    Target& target = target_at(action.slot);
    if (action.kind == ActionKind::torque) {
      target.torque += angular_in<D>(means_[i]);
      continue;
    }
    const Vector<D> force = in<D>(means_[i]), point = in<D>(action.point);
    target.force += force;
    if (action.place == ForcePlace::centroid) continue;
    const bool is_carried = action.place == ForcePlace::carried;
    if (blocks.is_affine(slot)) {
      target.virial += force * (is_carried ? point : blocks.in_frame_of(slot, point)).transpose();
    } else {
      const Vector<D> arm =
          is_carried ? blocks.arm_to(slot, point) : Vector<D>(point - blocks.position[slot]);
      target.torque += moment(arm, force);
    }
  }
}

template <int D>
bool Actions<D>::is_consistent(const Blocks<D>& blocks) const {
  const auto is_kind = [](ActionKind kind) {
    return kind >= ActionKind::velocity && kind <= ActionKind::last;
  };
  const auto acts_on_its_block = [&](const Action<D>& action) {
    return action.slot < 0 || (std::size_t(action.slot) < blocks.slot_count() &&
                               can_act_on(blocks, std::size_t(action.slot), action.kind));
  };
  const auto is_valid = [&](const Action<D>& action) {
    const bool is_on_all = action.slot == -1 && action.kind == ActionKind::acceleration;
    const bool is_servo = action.kind == ActionKind::servo;
    return is_kind(action.kind) && (is_on_all || action.slot >= 0) &&
           (!is_servo || (action.max_speed > 0 && is_positive(in<D>(action.scale).norm()))) &&
           action.table >= 0 && action.table < tables_.count() && action.place >= ForcePlace::centroid &&
           action.place <= ForcePlace::fixed && is_finite(action.start) && is_nonnegative(action.max_speed) &&
           is_finite(action.drift) && action.scale.allFinite() && action.point.allFinite();
  };
  std::int64_t first = 0;
  const auto is_valid_on_nodes = [&](const NodeAction& action) {
    const Array<Body<D>>& bodies = blocks.meshes().bodies();
    if (action.body < 0 || std::size_t(action.body) >= bodies.size() || action.end < first ||
        std::size_t(action.end) > nodes_.size() || !is_kind(action.kind) || is_angular(action.kind) ||
        action.kind >= ActionKind::torque || action.table < 0 || action.table >= tables_.count() ||
        !is_finite(action.start))
      return false;
    const Body<D>& body = bodies[std::size_t(action.body)];
    return std::all_of(nodes_.begin() + std::exchange(first, action.end), nodes_.begin() + action.end,
                       [&](std::int32_t node) { return node >= 0 && node < body.node_count; });
  };
  const auto is_valid_of_key = [&](const ActionOfKey<D>& one) { return is_valid(one.action); };
  return tables_.is_consistent() && all(actions_, acts_on_its_block) && all(actions_, is_valid) &&
         all(of_keys_, is_valid_of_key) && all(node_actions_, is_valid_on_nodes) &&
         std::size_t(first) == nodes_.size() && scales_.size() == nodes_.size() &&
         all(scales_, [](const Vector<D>& scale) { return scale.allFinite(); }) && is_finite(made_.time) &&
         is_nonnegative(made_.duration);
}

template class Actions<2>;
template class Actions<3>;

}  // namespace halfspace
