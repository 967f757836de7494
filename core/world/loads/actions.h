#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "block/blocks.h"
#include "world/loads/table.h"

namespace halfspace {

/// The quantity that a table gives to a block or to nodes. The values are those of the C API.
enum class ActionKind : std::int32_t {
  velocity = 0,
  angular_velocity = 1,
  acceleration = 2,
  angular_acceleration = 3,
  force = 4,
  torque = 5,
  servo = 6,  // the force on contacts, controlled by the velocity of the block
  last = servo
};

inline bool is_load(ActionKind kind) { return kind == ActionKind::force || kind == ActionKind::torque; }
inline bool is_angular(ActionKind kind) {
  return kind == ActionKind::angular_velocity || kind == ActionKind::angular_acceleration;
}

/// The place of a force.
enum class ForcePlace : std::int32_t { centroid = 0, carried = 1, fixed = 2 };

/// A motion or load of one block, or an acceleration of all blocks by a body force.
template <int D>
struct Action {
  std::int32_t slot = -1;  // -1: all blocks
  ActionKind kind = ActionKind::force;
  std::int32_t table = 0;
  ForcePlace place = ForcePlace::centroid;
  double start = 0;                     // time of the world at time 0 of the table, s
  double max_speed = 0;                 // of a servo, m/s
  double drift = 0;                     // of a servo: the velocity of its mass, m/s
  Vector<3> scale = Vector<3>::Ones();  // a motion leaves components with scale 0 as they are
  Vector<3> point = Vector<3>::Zero();  // carried: in the frame of the shape; fixed: in space
};

/// An action with the key of its block in all shares of a world.
template <int D>
struct ActionOfKey {
  std::int64_t key = 0;
  Action<D> action;
};

/// The same for nodes of a body, each with a scale of its own.
struct NodeAction {
  std::int32_t body = -1;
  ActionKind kind = ActionKind::force;
  std::int32_t table = 0;
  std::int32_t reserved = 0;
  double start = 0;
  std::int64_t end = 0;  // of its entries in the arrays of nodes and scales
};

/// Components of a velocity that are given for the coming motion of the world.
template <class Velocity>
struct GivenVelocity {
  std::uint8_t components = 0;  // bit k: component k is given
  Velocity start = Velocity::Zero();
  Velocity mean = Velocity::Zero();
  Velocity end = Velocity::Zero();

  bool is_given(Eigen::Index k) const { return (components >> k & 1) != 0; }
  /// The change of the power of a force by the jump of the velocity at the begin of the motion.
  double power_of_jump(const Velocity& force) const {
    double power = 0;
    for (Eigen::Index k = 0; k < force.size(); ++k) {
      if (is_given(k)) power += force[k] * (2 * mean[k] - end[k] - start[k]);
    }
    return power;
  }
};

/// A servo moves as a plate without weight that is pushed by the missing force: the velocity of a dashpot
/// plus that of a mass. Both only take up energy, so no vibration of the contacts grows. Where contacts yield
/// at a constant velocity, the mass follows them, and no force is missing after a while.
struct Servo {
  double viscosity = 0;  // of the dashpot, N s/m
  double mass = 0;       // kg

  /// From the sums over its contacts.
  void adapt(double contact_stiffness, double contact_viscosity, double duration, double time_step);
};

/// Motions and loads that follow tables. Over each motion of the world a load is constant, the mean of its
/// table. So impulses and the displacements of prescribed blocks are exact at any time step.
template <int D>
class Actions {
 public:
  explicit Actions(Memory* memory)
      : tables_(memory),
        actions_(memory),
        node_actions_(memory),
        nodes_(memory),
        scales_(memory),
        of_keys_(memory),
        means_(memory),
        drifts_(memory),
        targets_(memory),
        target_of_(memory),
        node_velocities_(memory),
        node_loads_(memory) {}

  bool empty() const { return actions_.empty() && node_actions_.empty() && of_keys_.empty(); }
  /// Does a condition hold for any action on blocks?
  template <class Condition>
  bool any(Condition condition) const {
    return std::any_of(actions_.begin(), actions_.end(), condition);
  }
  /// On blocks, in the order in which they were added.
  const Array<Action<D>>& on_blocks() const { return actions_; }
  const Tables& tables() const { return tables_; }
  std::int32_t add_table(std::span<const double> times, std::span<const Vector<3>> values) {
    return tables_.add(times, values);
  }

  /// Adds a load or a motion, from the next renew() on. A motion ends those of the block before it along its
  /// own axes, and a servo that has any of these as a whole. If memory runs out, nothing has changed.
  void add(const Action<D>& action);
  void add(NodeAction action, std::span<const std::int32_t> nodes, std::span<const Vector<D>> scales);
  /// Ends the actions on a block, or the acceleration of all blocks if the slot is -1.
  void end_on_block(std::int32_t slot, const Blocks<D>& blocks);
  void end_on_nodes(std::int32_t body, const Blocks<D>& blocks);

  /// A block with actions of its own.
  struct Target {
    std::int32_t slot = -1;
    bool is_servo = false;
    Servo servo = {};
    GivenVelocity<Vector<D>> velocity = {};
    GivenVelocity<Angular<D>> spin = {};
    Vector<D> force = Vector<D>::Zero();
    Angular<D> torque = Angular<D>::Zero();  // of a rigid block: with that of the forces about the centroid
    Tensor<D> virial = Tensor<D>::Zero();    // of an affine block: force times arm^T, arms as in the shape
    Angular<D> torque_at_start = Angular<D>::Zero();  // of the motion
    Tensor<D> virial_at_start = Tensor<D>::Zero();
  };
  Array<Target>& targets() { return targets_; }
  const Array<Target>& targets() const { return targets_; }
  /// The target of a block, if it is one.
  const Target* target_of(std::size_t slot) const {
    return slot < target_of_.size() && target_of_[slot] >= 0 ? &targets_[std::size_t(target_of_[slot])]
                                                             : nullptr;
  }
  /// The acceleration of all blocks and nodes that move freely, besides gravity.
  const Vector<D>& acceleration() const { return acceleration_; }
  bool accelerates_all() const { return accelerates_all_; }
  Vector<D> load_on_node(std::size_t node) const {
    return node < node_loads_.size() ? node_loads_[node] : Vector<D>(Vector<D>::Zero());
  }
  /// Calls `visit(node, velocity)` for each node of a body with a given velocity.
  template <class Visit>
  void for_each_given_node(const Meshes<D>& meshes, Visit visit) const {
    std::size_t first = 0;
    for (const NodeAction& action : node_actions_) {
      for (; first < std::size_t(action.end); ++first) {
        const std::size_t node = node_of(action, first, meshes);
        if (node_velocities_[first].components != 0 && meshes.mass[node] > 0)
          visit(node, node_velocities_[first]);
      }
    }
  }

  struct Motion {
    double time = 0;  // of the world at its begin, s
    double duration = 0;
  };
  /// Sets loads and given velocities for the coming motion.
  void predict(const Motion& motion, const Blocks<D>& blocks);
  /// The predicted motion is made, and servos go on from its end.
  void accept_motion();
  /// The predicted motion is not made: loads are those of the last one again. Takes no memory.
  void drop_motion(const Blocks<D>& blocks) {
    motion_ = made_;
    if (is_renewed_) renew(blocks);  // else loads have not changed since
  }
  /// Sets the loads for the poses that blocks have now.
  void place_loads(const Blocks<D>& blocks);
  /// Sets targets and loads of the last predicted motion again. Call when actions, slots or nodes come or go,
  /// and after reading. If memory runs out, nothing has changed; without such changes it takes none.
  void renew(const Blocks<D>& blocks);

  /// Takes over the actions of another world, those on blocks that are here; a share keeps the others, too,
  /// as their blocks may come. Call renew() afterwards. `key_of(slot)`: of a block there. `slot_of(key)`: of
  /// a block here; -1: it is not here.
  template <class KeyOf, class SlotOf>
  void take_over(const Actions& other, KeyOf key_of, SlotOf slot_of, bool is_whole) {
    tables_ = other.tables_;
    motion_ = made_ = other.made_;
    of_keys_ = other.of_keys_;
    if (of_keys_.empty()) {
      for (const Action<D>& action : other.actions_)
        of_keys_.push_back({action.slot < 0 ? 0 : key_of(action.slot), action});
    }
    for (auto [key, action] : of_keys_) {
      const bool is_on_all = action.slot < 0;
      if (!is_on_all) action.slot = slot_of(key);
      if (is_on_all || action.slot >= 0) actions_.push_back(action);
    }
    if (is_whole) of_keys_.clear();
  }

  /// Validates the state read from a snapshot.
  bool is_consistent(const Blocks<D>& blocks) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(tables_, actions_, node_actions_, nodes_, scales_, made_.time, made_.duration, of_keys_);
    if constexpr (Archive::reads) motion_ = made_;
  }

 private:
  /// The index of a node in the meshes.
  std::size_t node_of(const NodeAction& action, std::size_t entry, const Meshes<D>& meshes) const {
    return std::size_t(meshes.body(action.body).first_node + nodes_[entry]);
  }
  /// The integrals of an action's table over the motion.
  template <class AnyAction>
  TableIntegrals integrals_of(const AnyAction& action) const {
    return tables_[action.table].integrals(motion_.time - action.start, motion_.duration);
  }
  template <class AnyAction>
  Vector<3> last_value_of(const AnyAction& action) const {
    return tables_[action.table].at(motion_.time + motion_.duration - action.start);
  }
  void give_velocity(const Action<D>& action, const TableIntegrals& integrals, const Blocks<D>& blocks,
                     Target& target) const;
  /// Returns the velocity of the servo's mass at the end of the motion, m/s.
  double control_force(const Action<D>& action, const Vector<3>& mean, const Blocks<D>& blocks,
                       Target& target) const;
  void act_on_nodes(const NodeAction& action, std::size_t first, const TableIntegrals& integrals,
                    const Meshes<D>& meshes);
  Target& target_at(std::int32_t slot) { return targets_[std::size_t(target_of_[std::size_t(slot)])]; }
  /// The number of nodes of the meshes up to the last one of a body.
  std::size_t nodes_up_to(std::int32_t body, const Meshes<D>& meshes) const;

  Tables tables_;
  Array<Action<D>> actions_;
  Array<NodeAction> node_actions_;
  Array<std::int32_t> nodes_;      // of node actions, by their number in the body
  Array<Vector<D>> scales_;        // likewise
  Motion motion_;                  // predicted last
  Motion made_;                    // made last
  Array<ActionOfKey<D>> of_keys_;  // in a share, the actions of the whole world
  // Derived from the above and from the last predicted motion.
  Array<Vector<3>> means_;  // of each action on blocks
  Array<double> drifts_;    // likewise, at the end of the motion
  Array<Target> targets_;
  Array<std::int32_t> target_of_;  // per slot up to the last target's, or -1
  Array<GivenVelocity<Vector<D>>> node_velocities_;
  Array<Vector<D>> node_loads_;  // per node up to the last body's with loads
  Vector<D> acceleration_ = Vector<D>::Zero();
  bool accelerates_all_ = false;
  bool is_renewed_ = false;  // since actions were added
};

extern template class Actions<2>;
extern template class Actions<3>;

}  // namespace halfspace
