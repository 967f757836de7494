#include "world/relaxation/relax.h"

#include <algorithm>

#include "world/copies.h"

namespace halfspace {
namespace {

/// Computing the balance costs as much as a step.
constexpr std::int64_t steps_per_look = 10;

/// Steps between two estimates of the slowest motion, up to ten times as many near rest: over a longer
/// interval, contacts that open and close at a high frequency return to their position, and do not affect the
/// estimate.
std::int64_t steps_per_damping(std::int64_t steps) {
  return steps_per_look * std::clamp<std::int64_t>(steps / 1000, 1, 10);
}

/// Fraction of the stable time step if forces are continuous; the rest is a margin for damping. Springs per
/// contact are not continuous: in larger steps, their jumps create more energy than damping dissipates. For
/// them a smaller given fraction remains, as does a smaller given time step.
constexpr double safety_in_relaxation = 0.9;

/// Displacements of blocks since construction, over their radius.
template <int D>
class Travel {
 public:
  Travel(const Blocks<D>& blocks, Memory* memory) : start_(blocks.position, memory) {}

  double longest(const Blocks<D>& blocks) const {
    double longest = 0;
    for (std::size_t i = 0; i < start_.size(); ++i) {
      if (blocks.moves_freely(i))
        longest = std::max(longest, (blocks.position[i] - start_[i]).norm() / blocks.radius[i]);
    }
    return longest;
  }

 private:
  Array<Vector<D>> start_;
};

/// Monitors a relaxation. All memory is allocated at construction.
template <int D>
struct RestMonitor {
  RestMonitor(const Model<D>& model, Memory* memory)
      : slowest(model, memory), way(model.blocks, memory), room(model.blocks, memory) {}

  SlowestMotion<D> slowest;
  Travel<D> way;
  BalanceRoom room;
};

template <int D>
void stop_all(World<D>& world) {
  Blocks<D>& blocks = world.state().model.blocks;
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    if (!blocks.moves_by_itself(i)) continue;
    if (blocks.is_affine(i)) {
      const Tensor<D> gradient = blocks.deformation(i).gradient;
      blocks.velocity[i] = Vector<D>::Zero();
      blocks.deform(std::int32_t(i), gradient, Tensor<D>::Zero());
    } else {
      blocks.set_motion(std::int32_t(i), blocks.velocity[i] - blocks.freed(i, blocks.velocity[i]),
                        Angular<D>::Zero());
    }
  }
  Meshes<D>& meshes = blocks.meshes();
  for (std::size_t i = 0; i < meshes.node_count(); ++i) {
    for (int k = 0; k < D; ++k) {
      if (!(meshes.held[i] >> k & 1)) meshes.velocity[i][k] = 0;
    }
  }
  for (std::size_t body = 0; body < meshes.bodies().size(); ++body) world.end_node_edits(std::int32_t(body));
  world.state().edit();
}

/// Damping may make a given time step unstable.
template <int D>
bool leaves_room_for_damping(World<D>& world) {
  const double time_step = world.model().settings.time_step;
  if (time_step == 0) return true;
  world.detect();
  return time_step <= safety_in_relaxation * world.state().stable_step.bound();
}

template <int D>
void relax_under_damping(World<D>& world, const Relaxation& relaxation, RestMonitor<D>& monitor,
                         Relaxed& relaxed) {
  State<D>& state = world.state();
  while (!relaxed.is_at_rest && !relaxed.has_failed && relaxed.steps < relaxation.max_steps) {
    for (std::int64_t i = 0; i < steps_per_look && relaxed.steps < relaxation.max_steps; ++i) {
      relaxed.result = world.step();
      if (relaxed.result != StepResult::ok) return;
      ++relaxed.steps;
    }
    relaxed.balance = balance_of(state, monitor.room);
    const double ratio = relaxation.by_largest ? relaxed.balance.largest : relaxed.balance.mean;
    relaxed.is_at_rest = ratio <= relaxation.ratio;
    relaxed.has_failed = relaxation.max_displacement > 0 &&
                         monitor.way.longest(state.model.blocks) > relaxation.max_displacement;
    if (!relaxation.is_adaptive || relaxed.steps % steps_per_damping(relaxed.steps) != 0) continue;
    const double wanted = monitor.slowest.look();
    // The damping per step is limited, so that steps remain stable.
    if (wanted >= 0) state.model.settings.mass_damping = std::min(wanted, 0.2 / state.clock.time_step());
  }
}

}  // namespace

template <int D>
Balance balance_of(World<D>& world) {
  BalanceRoom room(world.blocks(), world.state().memory());
  if (world.prepare() != StepResult::ok) return {};
  return balance_of(world.state(), room);
}

template <int D>
Relaxed relax(World<D>& world, const Relaxation& relaxation) {
  State<D>& state = world.state();
  const bool leaves_room = leaves_room_for_damping(world);
  Memory* memory = state.memory();
  RestMonitor<D> monitor(state.model, memory);
  const auto known = [&] { return std::tuple_cat(state.written_before_motion(), state.integrator.state()); };
  const auto before = copies_of(known(), memory);
  const auto epoch = copies_of(state.clock.epoch(), memory);
  const bool was_edited = state.is_edited();
  const std::int64_t steps = state.clock.steps();
  const WorldSettings<D> settings = state.model.settings;
  const bool held_bonds = state.model.blocks.bonds().are_held();
  const auto restore = [&] {
    state.model.settings = settings;
    world.hold_bonds(held_bonds);
    state.edit();
  };
  state.model.settings.sleep_tolerance = 0;
  const bool has_jumps =
      state.model.materials.laws().any([](const ContactLaw& law) { return law.has_springs_at_points(); });
  state.model.settings.safety =
      has_jumps ? std::min(settings.safety, safety_in_relaxation) : safety_in_relaxation;
  if (!leaves_room) state.model.settings.time_step = 0;
  world.set_damping(relaxation.local_damping, relaxation.is_adaptive ? 0 : settings.mass_damping);
  if (relaxation.holds_bonds) world.hold_bonds(true);
  Relaxed relaxed;
  try {
    relax_under_damping(world, relaxation, monitor, relaxed);
  } catch (...) {
    restore();
    if (!was_edited && state.clock.steps() == steps && state.clock.epoch() == epoch) known() = before;
    throw;
  }
  restore();
  if (relaxed.is_at_rest) stop_all(world);
  return relaxed;
}

template Balance balance_of(World<2>&);
template Balance balance_of(World<3>&);
template Relaxed relax(World<2>&, const Relaxation&);
template Relaxed relax(World<3>&, const Relaxation&);

}  // namespace halfspace
