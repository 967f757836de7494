#include "notes/notes.h"

#include "notes/kinds.h"

namespace halfspace::cli {

void note_start(const Context& context, const Scene& scene, const Model& model, Faults& faults) {
  const Start start(context, scene, model);
  for (const auto note :
       {note_overlaps, note_boundaries, note_times, note_weights, note_speeds, note_directions, note_falling,
        note_bonds, note_sizes, note_unused, note_without_effect, note_impulses})
    note(start, faults);
}

}  // namespace halfspace::cli
