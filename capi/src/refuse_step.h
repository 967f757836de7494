#pragma once

#include "world_handle.h"

namespace halfspace::capi {

/// Refuses what a step has come to, in words; returns where it went well.
template <int D>
void require_stepped(World<D>& w, StepResult result) {
  if (result == StepResult::no_time_step) {
    refuse(HS_ERROR_STATE,
           "no time step was given and none can be derived, as no free block meets springs or is elastic");
  }
  if (result == StepResult::too_fast) {
    const FastPair& pair = w.fast_pair();
    refuse(
        HS_ERROR_TOO_FAST,
        "blocks %#llx and %#llx meet at time %g (step %lld) by up to %g m/s: too fast for the time step %g "
        "where the thinner is %g m thick; a step of %g would do",
        static_cast<unsigned long long>(id_of(w.blocks(), std::size_t(pair.a))),
        static_cast<unsigned long long>(id_of(w.blocks(), std::size_t(pair.b))), w.time(),
        static_cast<long long>(w.steps()), pair.speed, w.time_step(), pair.thickness, pair.time_step);
  }
  if (result == StepResult::inverted) {
    refuse(HS_ERROR_INVERTED, "cell %d of body %#llx would be turned inside out at time %g (step %lld)",
           w.inverted_cell().cell, static_cast<unsigned long long>(id_of(w.meshes(), w.inverted_cell().body)),
           w.time(), static_cast<long long>(w.steps()));
  }
  if (result == StepResult::unstable) {
    refuse(HS_ERROR_UNSTABLE, "unstable at time %g (step %lld): time step %g, stable time step %g", w.time(),
           static_cast<long long>(w.steps()), w.time_step(), w.stable_time_step());
  }
}

}  // namespace halfspace::capi
