/* Sizes and offsets of what has been added since the baseline of version 0.1: see layout_0_1.c. */
#include <halfspace/halfspace.h>
#include <stddef.h>

#define FIELD(type, field, offset, size) \
  _Static_assert(offsetof(type, field) == offset && sizeof(((type *)0)->field) == size, #type "." #field)

FIELD(hs_pair_options, margin, 24, 8);
FIELD(hs_pair_options, without_region, 32, 4);
FIELD(hs_pair_options, reserved_2, 36, 4);
FIELD(hs_world_def, potential_length, 88, 8);
FIELD(hs_world_report, potential_length, 160, 8);
FIELD(hs_world_report, block_strain_energy, 168, 8);
FIELD(hs_world_report, block_damping_loss, 176, 8);
