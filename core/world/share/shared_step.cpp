#include "world/share/shared_step.h"

#include <new>

namespace halfspace {

template <int D>
StepResult SharedStep<D>::begin() {
  state_.drop_shared_motion();
  const bool has_new_blocks = state_.contacts.has_new_blocks();
  if (!state_.is_edited() && !has_new_blocks) return StepResult::ok;
  stages_.renew_neighbors_if_needed();
  if (has_new_blocks) stages_.bond_new_blocks();
  return state_.is_edited() ? stages_.load_changed() : StepResult::ok;
}

/// Would the predicted motion have to be divided?
template <int D>
StepResult SharedStep<D>::division() {
  const Blocks<D>& blocks = state_.model.blocks;
  const auto goes_far = [&](std::size_t i) {
    return blocks.moves(i) && state_.contacts.neighbors().announced_motion(i) > blocks.radius[i];
  };
  bool is_far = state_.integrator.max_rotation() > max_turn;
  for (std::size_t i = 0; i < blocks.slot_count() && !is_far; ++i) is_far = goes_far(i);
  ContinuousCollision<D>& fast = state_.continuous_collision;
  const bool is_fast = is_far || (fast.any() && fast.safe_fraction() < 1);
  return is_fast ? StepResult::too_fast : StepResult::ok;
}

template <int D>
SharedMotion SharedStep<D>::predict() {
  state_.drop_shared_motion();
  state_.share.enter(ShareStage::planned);
  try {
    const SharedMotion motion = needs_of_motion();
    if (motion.result != StepResult::ok) state_.drop_shared_motion();
    return motion;
  } catch (const std::bad_alloc&) {
    state_.drop_shared_motion();
    throw;
  }
}

template <int D>
SharedMotion SharedStep<D>::needs_of_motion() {
  SharedMotion needs;
  needs.needs_assembly = state_.share.needs_assembly();
  Motion motion{.duration = state_.clock.rest()};
  if (stages_.run(StageName::actions, StageName::search, motion) != StepResult::ok) {
    needs.result = StepResult::unstable;
    return needs;
  }
  needs.needs_list = state_.contacts.neighbors().needs_rebuild();
  if (!needs.needs_list) needs.result = division();
  return needs;
}

template <int D>
SharedMotion SharedStep<D>::renew_list() {
  stages_.renew_neighbors();
  state_.share.find_idle(state_.contacts.neighbors().pairs());
  SharedMotion needs;
  needs.result = division();
  if (needs.result != StepResult::ok) state_.drop_shared_motion();
  return needs;
}

template <int D>
void SharedStep<D>::move() {
  Motion motion{.duration = state_.integrator.duration()};
  stages_.run(StageName::drift, StageName::impacts, motion);
}

template <int D>
void SharedStep<D>::end() {
  Motion motion{.duration = state_.integrator.duration()};
  stages_.run(StageName::impacts, StageName::end, motion);
  state_.clock.complete_step();
}

template <int D>
void SharedStep<D>::set_loads(std::size_t slot, const Vector<D>& force, const Angular<D>& torque,
                              const Tensor<D>& virial) {
  state_.forces.set_load(slot, force, torque);
  if (state_.model.blocks.is_affine(slot)) state_.model.blocks.deformation(slot).virial = virial;
}

template class SharedStep<2>;
template class SharedStep<3>;

}  // namespace halfspace
