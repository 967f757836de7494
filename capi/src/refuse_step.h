#pragma once

#include <cmath>

#include "world_handle.h"

namespace halfspace::capi {

/// Refuses the call if a step has failed; returns otherwise.
template <int D>
void require_stepped(World<D>& w, StepResult result) {
  State<D>& state = w.state();
  const double time = state.clock.time(), step = state.clock.time_step();
  const auto steps = static_cast<long long>(state.clock.steps());
  if (result == StepResult::no_time_step) {
    refuse(HS_ERROR_STATE,
           "no time step is given and none can be derived: no free block has springs or elasticity; set "
           "time_step");
  }
  if (result == StepResult::too_fast) {
    const FastPair& pair = state.continuous_collision.pair();
    refuse(HS_ERROR_TOO_FAST,
           "blocks %#llx and %#llx approach at time %g (step %lld) with up to %g m/s: too fast for the time "
           "step %g and the thickness %g m of the thinner block; a time step of %g is sufficient",
           static_cast<unsigned long long>(id_of(w.blocks(), std::size_t(pair.a))),
           static_cast<unsigned long long>(id_of(w.blocks(), std::size_t(pair.b))), time, steps, pair.speed,
           step, pair.thickness, pair.time_step);
  }
  if (result == StepResult::inverted) {
    const InvertedCell& cell = state.integrator.inverted();
    refuse(HS_ERROR_INVERTED, "cell %d of body %#llx would be inverted at time %g (step %lld)", cell.cell,
           static_cast<unsigned long long>(id_of(w.blocks().meshes(), cell.body)), time, steps);
  }
  const auto id = [&](std::int32_t slot) {
    return static_cast<unsigned long long>(id_of(w.blocks(), std::size_t(slot)));
  };
  if (result == StepResult::interrupted)
    refuse(HS_ERROR_INTERRUPTED, "the host has interrupted step %lld at time %g", steps, time);
  if (result == StepResult::overworked) {
    const PressedPair pair = state.hard_contacts.deepest_pressed();
    refuse(HS_ERROR_UNSTABLE,
           "unstable at time %g (step %lld): the step has been divided into %d parts or %lld iterations; the "
           "largest contact force, %g N, is between blocks %#llx and %#llx; reduce the time step %g",
           time, steps, max_motions, static_cast<long long>(w.stages().max_divided_iterations()), pair.force,
           pair.a < 0 ? 0 : id(pair.a), pair.b < 0 ? 0 : id(pair.b), step);
  }
  if (const auto& jam = state.hard_contacts.jam(); jam && result == StepResult::unstable) {
    refuse(HS_ERROR_UNSTABLE,
           "unstable at time %g (step %lld): prescribed block %#llx presses on blocks that cannot move away; "
           "the "
           "force between blocks %#llx and %#llx would exceed %g N; stop the block there, or give it a force",
           time, steps, id(jam->block), id(jam->pair.a), id(jam->pair.b), jam->pair.force);
  }
  // Without any spring a shorter step may not help.
  if (result == StepResult::unstable && !std::isfinite(state.stable_step.bound())) {
    refuse(
        HS_ERROR_UNSTABLE,
        "unstable at time %g (step %lld): energy has been created; the largest speed so far is %g m/s, and "
        "contacts without springs left %g m/s unbalanced in the last step",
        time, steps, state.peak_speed, state.hard_contacts.unbalanced_velocity());
  }
  if (result == StepResult::unstable) {
    refuse(HS_ERROR_UNSTABLE,
           "unstable at time %g (step %lld): time step %g, stable time step %g; reduce the time step or the "
           "safety",
           time, steps, step, state.stable_step.bound());
  }
}

}  // namespace halfspace::capi
