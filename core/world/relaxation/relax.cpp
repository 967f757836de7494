#include <algorithm>

#include "world/copies.h"
#include "world/world.h"

// Dynamic relaxation: steps under damping until forces balance (Cundall 1987).

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

}  // namespace

/// If there is no stable time step, no block moves freely, and nothing is unbalanced.
template <int D>
Balance World<D>::balance() {
  BalanceRoom room(model_.blocks, own_memory());
  if (prepare() != StepResult::ok) return {};
  return balance_of(model_, contacts_, forces_, hard_contacts_, integrator_, room);
}

template <int D>
void World<D>::stop_all() {
  Blocks<D>& blocks = model_.blocks;
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
  for (std::size_t body = 0; body < meshes.bodies().size(); ++body) end_node_edits(std::int32_t(body));
  edit();
}

/// Damping may make a given time step unstable.
template <int D>
bool World<D>::leaves_room_for_damping(double time_step) {
  if (time_step == 0) return true;
  detect();
  return time_step <= safety_in_relaxation * stable_step_.bound();
}

/// If memory runs out before anything has moved, a world that was ready for its next step still is, with its
/// former damping.
template <int D>
Relaxed World<D>::relax(const Relaxation& relaxation) {
  const bool leaves_room = leaves_room_for_damping(model_.settings.time_step);
  Memory* memory = own_memory();
  RestMonitor<D> monitor(model_, memory);
  const auto known = [&] { return std::tuple_cat(state(), integrator_.state()); };
  const auto before = copies_of(known(), memory);
  const auto epoch = copies_of(clock_.epoch(), memory);
  const bool was_edited = edited_;
  const std::int64_t steps = clock_.steps();
  const WorldSettings<D> settings = model_.settings;
  const bool held_bonds = bonds().are_held();
  const auto restore = [&] {
    model_.settings = settings;
    hold_bonds(held_bonds);
    edit();
  };
  model_.settings.sleep_tolerance = 0;
  const bool has_jumps = model_.materials.laws().any(
      [](const ContactLaw& law) { return law.stiffness_kind == StiffnessKind::per_contact; });
  model_.settings.safety = has_jumps ? std::min(settings.safety, safety_in_relaxation) : safety_in_relaxation;
  if (!leaves_room) model_.settings.time_step = 0;
  set_damping(relaxation.local_damping, relaxation.is_adaptive ? 0 : settings.mass_damping);
  if (relaxation.holds_bonds) hold_bonds(true);
  Relaxed relaxed;
  try {
    relax_under_damping(relaxation, monitor, relaxed);
  } catch (...) {
    restore();
    if (!was_edited && clock_.steps() == steps && clock_.epoch() == epoch) known() = before;
    throw;
  }
  restore();
  if (relaxed.is_at_rest) stop_all();
  return relaxed;
}

template <int D>
template <class RestMonitor>
void World<D>::relax_under_damping(const Relaxation& relaxation, RestMonitor& monitor, Relaxed& relaxed) {
  while (!relaxed.is_at_rest && !relaxed.has_failed && relaxed.steps < relaxation.max_steps) {
    for (std::int64_t i = 0; i < steps_per_look && relaxed.steps < relaxation.max_steps; ++i) {
      relaxed.result = step();
      if (relaxed.result != StepResult::ok) return;
      ++relaxed.steps;
    }
    relaxed.balance = balance_of(model_, contacts_, forces_, hard_contacts_, integrator_, monitor.room);
    const double ratio = relaxation.by_largest ? relaxed.balance.largest : relaxed.balance.mean;
    relaxed.is_at_rest = ratio <= relaxation.ratio;
    relaxed.has_failed =
        relaxation.max_displacement > 0 && monitor.way.longest(model_.blocks) > relaxation.max_displacement;
    if (!relaxation.is_adaptive || relaxed.steps % steps_per_damping(relaxed.steps) != 0) continue;
    const double wanted = monitor.slowest.look();
    // The damping per step is limited, so that steps remain stable.
    if (wanted >= 0) model_.settings.mass_damping = std::min(wanted, 0.2 / clock_.time_step());
  }
}

template <int D>
void World<D>::set_gravity(const Vector<D>& gravity) {
  model_.settings.gravity = gravity;
  edit();
}

template <int D>
void World<D>::set_damping(double local_damping, double mass_damping) {
  model_.settings.local_damping = local_damping;
  model_.settings.mass_damping = mass_damping;
  edit();
}

template <int D>
void World<D>::set_strength_factor(double factor) {
  model_.materials.laws().weaken(factor / strength_factor_);
  model_.blocks.bonds().weaken(factor / strength_factor_);
  strength_factor_ = factor;
  edit();
}

template <int D>
void World<D>::set_time_step(double time_step) {
  model_.settings.time_step = time_step;
  edit();
}

#define HALFSPACE_MEMBERS(D)                               \
  template Balance World<D>::balance();                    \
  template void World<D>::stop_all();                      \
  template bool World<D>::leaves_room_for_damping(double); \
  template Relaxed World<D>::relax(const Relaxation&);     \
  template void World<D>::set_gravity(const Vector<D>&);   \
  template void World<D>::set_damping(double, double);     \
  template void World<D>::set_strength_factor(double);     \
  template void World<D>::set_time_step(double);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
