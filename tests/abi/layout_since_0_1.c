/* Sizes and offsets of what has been added since the baseline of version 0.1: see layout_0_1.c. */
#include <halfspace/halfspace.h>
#include <stddef.h>

#define FIELD(type, field, offset, size) \
  _Static_assert(offsetof(type, field) == offset && sizeof(((type*)0)->field) == size, #type "." #field)

FIELD(hs_context_def, threads, 32, 4);
FIELD(hs_context_def, reserved_2, 36, 4);
FIELD(hs_context_def, run_tasks, 40, 8);
FIELD(hs_context_def, scheduler, 48, 8);
FIELD(hs_pair_options, margin, 24, 8);
FIELD(hs_pair_options, without_region, 32, 4);
FIELD(hs_pair_options, reserved_2, 36, 4);
FIELD(hs_world_def, potential_length, 88, 8);
FIELD(hs_world_def, fast_blocks, 96, 4);
FIELD(hs_world_def, reserved, 100, 4);
FIELD(hs_world_report, potential_length, 160, 8);
FIELD(hs_world_report, block_strain_energy, 168, 8);
FIELD(hs_world_report, block_damping_loss, 176, 8);
FIELD(hs_world_report, divided_steps, 184, 8);
FIELD(hs_world_report, deepest_stop, 192, 8);
FIELD(hs_world_report, peak_overlap, 200, 8);
FIELD(hs_world_report, peak_speed, 208, 8);

_Static_assert(sizeof(hs_elasticity_def) >= 32, "hs_elasticity_def");
FIELD(hs_elasticity_def, struct_size, 0, 4);
FIELD(hs_elasticity_def, plane, 4, 4);
FIELD(hs_elasticity_def, young_modulus, 8, 8);
FIELD(hs_elasticity_def, poisson_ratio, 16, 8);
FIELD(hs_elasticity_def, damping_time, 24, 8);

_Static_assert(sizeof(hs_deformation) == 296, "hs_deformation");
FIELD(hs_deformation, gradient, 0, 72);
FIELD(hs_deformation, rate, 72, 72);
FIELD(hs_deformation, strain, 144, 72);
FIELD(hs_deformation, stress, 216, 72);
FIELD(hs_deformation, strain_energy, 288, 8);

_Static_assert(HS_ERROR_TOO_FAST == -9, "HS_ERROR_TOO_FAST");
_Static_assert(HS_FAST_DIVIDE == 0, "HS_FAST_DIVIDE");
_Static_assert(HS_FAST_REFUSE == 1, "HS_FAST_REFUSE");
_Static_assert(HS_BLOCK_AFFINE == 3, "HS_BLOCK_AFFINE");
_Static_assert(HS_PLANE_STRAIN == 0, "HS_PLANE_STRAIN");
_Static_assert(HS_PLANE_STRESS == 1, "HS_PLANE_STRESS");
_Static_assert(HS_STIFFNESS_POTENTIAL == 2, "HS_STIFFNESS_POTENTIAL");

_Static_assert(sizeof(hs_motion_def) >= 256, "hs_motion_def");
FIELD(hs_motion_def, struct_size, 0, 4);
FIELD(hs_motion_def, reserved, 4, 4);
FIELD(hs_motion_def, start, 8, 56);
FIELD(hs_motion_def, velocity, 64, 24);
FIELD(hs_motion_def, angular_velocity, 88, 24);
FIELD(hs_motion_def, gradient, 112, 72);
FIELD(hs_motion_def, gradient_rate, 184, 72);

_Static_assert(sizeof(hs_impact) == 80, "hs_impact");
FIELD(hs_impact, state, 0, 4);
FIELD(hs_impact, pair_kind, 4, 4);
FIELD(hs_impact, feature_a, 8, 4);
FIELD(hs_impact, feature_b, 12, 4);
FIELD(hs_impact, time, 16, 8);
FIELD(hs_impact, gap, 24, 8);
FIELD(hs_impact, normal, 32, 24);
FIELD(hs_impact, point, 56, 24);

_Static_assert(HS_IMPACT_NEVER == 0, "HS_IMPACT_NEVER");
_Static_assert(HS_IMPACT_AT_START == 1, "HS_IMPACT_AT_START");
_Static_assert(HS_IMPACT_TOUCH == 2, "HS_IMPACT_TOUCH");
