#pragma once

#include "faults.h"
#include "notes/start.h"

// The kinds of notes about a scene that is ready to run, a file for each kind.

namespace halfspace::cli {

void note_overlaps(const Start& start, Faults& faults);
void note_boundaries(const Start& start, Faults& faults);
/// Springs too soft for weights,
void note_weights(const Start& start, Faults& faults);
/// or for speeds.
void note_speeds(const Start& start, Faults& faults);
/// Time steps too long or too short, durations of too few or too many of them, output too seldom or too
/// often.
void note_times(const Start& start, Faults& faults);
/// Gravity and stresses in situ along unusual directions.
void note_directions(const Start& start, Faults& faults);
/// Blocks and meshes that nothing holds up, and cells that excavation leaves loose.
void note_falling(const Start& start, Faults& faults);
/// Bonds between materials that make none.
void note_bonds(const Start& start, Faults& faults);
/// Lengths that do not fit each other: files in other units, a tolerance as large as blocks.
void note_sizes(const Start& start, Faults& faults);
/// Materials, laws and strengths that nothing uses.
void note_unused(const Start& start, Faults& faults);

}  // namespace halfspace::cli
