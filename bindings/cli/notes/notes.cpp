#include "notes/notes.h"

#include "model/library.h"
#include "notes/kinds.h"

namespace halfspace::cli {

void note_start(const Context& context, const Scene& scene, const Model& model, Faults& faults) {
  const Start start(context, scene, model);
  for (const auto note :
       {note_overlaps, note_boundaries, note_times, note_weights, note_speeds, note_directions, note_falling,
        note_bonds, note_sizes, note_unused, note_without_effect, note_servos, note_impulses})
    note(start, faults);
}

void require_time_step(const Context& context, const Scene& scene, const Model& model) {
  const bool changes_laws =
      !scene.stages.empty() && (scene.stages[0].default_law || !scene.stages[0].laws.empty());
  if (scene.world.time_step > 0 || model.report().stable_time_step > 0 || changes_laws) return;
  const World world = restored(context, model.snapshot());
  if (hs_world_step(world.get(), 1) != HS_ERROR_STATE) return;
  throw SceneFault(scene.places.time_step, "world.time_step",
                   "no time step is given and none can be derived: no free block has springs or elasticity; "
                   "required: a number above 0");
}

}  // namespace halfspace::cli
