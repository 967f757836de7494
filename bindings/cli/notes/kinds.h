#pragma once

#include "notes/start.h"
#include "scene/faults.h"

// The kinds of notes about a scene that is ready to run, a file for each kind.

namespace halfspace::cli {

void note_overlaps(const Start& start, Faults& faults);
void note_boundaries(const Start& start, Faults& faults);
/// Springs too soft for the weights.
void note_weights(const Start& start, Faults& faults);
/// Springs too soft for the speeds.
void note_speeds(const Start& start, Faults& faults);
/// Time steps too long or too short, tables that go on after the end, durations of too few or too many steps,
/// output too rare or too frequent.
void note_times(const Start& start, Faults& faults);
/// Gravity and stresses in situ along unusual directions.
void note_directions(const Start& start, Faults& faults);
/// Blocks and meshes without a support, at the start or after an excavation.
void note_falling(const Start& start, Faults& faults);
/// [[bond]] tables that make no bond.
void note_bonds(const Start& start, Faults& faults);
/// Inconsistent lengths: files in other units, a tolerance as large as blocks.
void note_sizes(const Start& start, Faults& faults);
/// Materials, laws and strengths without a use.
void note_unused(const Start& start, Faults& faults);
/// Generators without blocks, water and pictures away from all blocks, cells larger than their block.
void note_without_effect(const Start& start, Faults& faults);
/// Servos whose block can press on none of the blocks ahead.
void note_servos(const Start& start, Faults& faults);
/// Keys of the impulses between rigid blocks where these have no such impulses.
void note_impulses(const Start& start, Faults& faults);

}  // namespace halfspace::cli
