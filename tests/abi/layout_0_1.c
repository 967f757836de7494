/* Sizes, offsets and values that programs compiled with version 0.1 of the headers rely on, on machines
 * with 64-bit pointers. Written once, by write_layout, when that version was frozen. Do not regenerate it, and do not
 * mend it: where it does not compile, a program that is already linked breaks. Definitions and reports may have grown
 * since; nothing else may. */
#include <halfspace/halfspace.h>
#include <stddef.h>

#define FIELD(type, field, offset, size) \
  _Static_assert(offsetof(type, field) == offset && sizeof(((type *)0)->field) == size, #type "." #field)


_Static_assert(sizeof(hs_contact) == 496, "hs_contact");
FIELD(hs_contact, block_a, 0, 8);
FIELD(hs_contact, block_b, 8, 8);
FIELD(hs_contact, type, 16, 4);
FIELD(hs_contact, point_count, 20, 4);
FIELD(hs_contact, pair_kind, 24, 4);
FIELD(hs_contact, feature_a, 28, 4);
FIELD(hs_contact, feature_b, 32, 4);
FIELD(hs_contact, reserved, 36, 4);
FIELD(hs_contact, normal, 40, 24);
FIELD(hs_contact, gap, 64, 8);
FIELD(hs_contact, area, 72, 8);
FIELD(hs_contact, length, 80, 8);
FIELD(hs_contact, center, 88, 24);
FIELD(hs_contact, center_gap, 112, 8);
FIELD(hs_contact, points, 120, 192);
FIELD(hs_contact, gaps, 312, 64);
FIELD(hs_contact, force, 376, 24);
FIELD(hs_contact, torque, 400, 24);
FIELD(hs_contact, force_point, 424, 24);
FIELD(hs_contact, normal_force, 448, 8);
FIELD(hs_contact, shear_force, 456, 24);
FIELD(hs_contact, twist, 480, 8);
FIELD(hs_contact, touched_at, 488, 8);

_Static_assert(sizeof(hs_law_def) >= 64, "hs_law_def");
FIELD(hs_law_def, struct_size, 0, 4);
FIELD(hs_law_def, stiffness_kind, 4, 4);
FIELD(hs_law_def, normal_stiffness, 8, 8);
FIELD(hs_law_def, shear_stiffness, 16, 8);
FIELD(hs_law_def, friction_angle, 24, 8);
FIELD(hs_law_def, cohesion, 32, 8);
FIELD(hs_law_def, tensile_strength, 40, 8);
FIELD(hs_law_def, normal_damping, 48, 8);
FIELD(hs_law_def, shear_damping, 56, 8);

_Static_assert(sizeof(hs_context_def) >= 56, "hs_context_def");
FIELD(hs_context_def, struct_size, 0, 4);
FIELD(hs_context_def, reserved, 4, 4);
FIELD(hs_context_def, allocate, 8, 8);
FIELD(hs_context_def, release, 16, 8);
FIELD(hs_context_def, user, 24, 8);
FIELD(hs_context_def, threads, 32, 4);
FIELD(hs_context_def, reserved_2, 36, 4);
FIELD(hs_context_def, run_tasks, 40, 8);
FIELD(hs_context_def, scheduler, 48, 8);

_Static_assert(sizeof(hs_view) == 40, "hs_view");
FIELD(hs_view, x, 0, 8);
FIELD(hs_view, y, 8, 8);
FIELD(hs_view, z, 16, 8);
FIELD(hs_view, stride, 24, 8);
FIELD(hs_view, count, 32, 8);

_Static_assert(sizeof(hs_mutable_view) == 40, "hs_mutable_view");
FIELD(hs_mutable_view, x, 0, 8);
FIELD(hs_mutable_view, y, 8, 8);
FIELD(hs_mutable_view, z, 16, 8);
FIELD(hs_mutable_view, stride, 24, 8);
FIELD(hs_mutable_view, count, 32, 8);

_Static_assert(sizeof(hs_pose) == 56, "hs_pose");
FIELD(hs_pose, position, 0, 24);
FIELD(hs_pose, rotation, 24, 32);

_Static_assert(sizeof(hs_fault) == 24, "hs_fault");
FIELD(hs_fault, kind, 0, 4);
FIELD(hs_fault, reserved, 4, 4);
FIELD(hs_fault, vertex, 8, 8);
FIELD(hs_fault, face, 16, 8);

_Static_assert(sizeof(hs_shape_properties) >= 128, "hs_shape_properties");
FIELD(hs_shape_properties, dimension, 0, 4);
FIELD(hs_shape_properties, reserved, 4, 4);
FIELD(hs_shape_properties, vertex_count, 8, 8);
FIELD(hs_shape_properties, edge_count, 16, 8);
FIELD(hs_shape_properties, face_count, 24, 8);
FIELD(hs_shape_properties, volume, 32, 8);
FIELD(hs_shape_properties, centroid, 40, 24);
FIELD(hs_shape_properties, second_moment, 64, 48);
FIELD(hs_shape_properties, bounding_radius, 112, 8);
FIELD(hs_shape_properties, shortest_edge, 120, 8);

_Static_assert(sizeof(hs_clean_report) == 24, "hs_clean_report");
FIELD(hs_clean_report, welded, 0, 8);
FIELD(hs_clean_report, straightened, 8, 8);
FIELD(hs_clean_report, reversed, 16, 4);
FIELD(hs_clean_report, reserved, 20, 4);

_Static_assert(sizeof(hs_fit_report) == 56, "hs_fit_report");
FIELD(hs_fit_report, fault, 0, 24);
FIELD(hs_fit_report, merged, 24, 8);
FIELD(hs_fit_report, deviation, 32, 8);
FIELD(hs_fit_report, moved, 40, 8);
FIELD(hs_fit_report, sufficient_tolerance, 48, 8);

_Static_assert(sizeof(hs_world_def) >= 112, "hs_world_def");
FIELD(hs_world_def, struct_size, 0, 4);
FIELD(hs_world_def, dimension, 4, 4);
FIELD(hs_world_def, gravity, 8, 24);
FIELD(hs_world_def, time_step, 32, 8);
FIELD(hs_world_def, safety, 40, 8);
FIELD(hs_world_def, local_damping, 48, 8);
FIELD(hs_world_def, mass_damping, 56, 8);
FIELD(hs_world_def, skin, 64, 8);
FIELD(hs_world_def, parallel_angle, 72, 8);
FIELD(hs_world_def, vertex_zone, 80, 8);
FIELD(hs_world_def, potential_length, 88, 8);
FIELD(hs_world_def, fast_blocks, 96, 4);
FIELD(hs_world_def, reserved, 100, 4);
FIELD(hs_world_def, sleep_tolerance, 104, 8);

_Static_assert(sizeof(hs_block_def) >= 120, "hs_block_def");
FIELD(hs_block_def, struct_size, 0, 4);
FIELD(hs_block_def, kind, 4, 4);
FIELD(hs_block_def, material, 8, 4);
FIELD(hs_block_def, reserved, 12, 4);
FIELD(hs_block_def, pose, 16, 56);
FIELD(hs_block_def, velocity, 72, 24);
FIELD(hs_block_def, angular_velocity, 96, 24);

_Static_assert(sizeof(hs_block_state) == 176, "hs_block_state");
FIELD(hs_block_state, kind, 0, 4);
FIELD(hs_block_state, material, 4, 4);
FIELD(hs_block_state, pose, 8, 56);
FIELD(hs_block_state, angle, 64, 8);
FIELD(hs_block_state, velocity, 72, 24);
FIELD(hs_block_state, angular_velocity, 96, 24);
FIELD(hs_block_state, force, 120, 24);
FIELD(hs_block_state, torque, 144, 24);
FIELD(hs_block_state, mass, 168, 8);

_Static_assert(sizeof(hs_energy) == 72, "hs_energy");
FIELD(hs_energy, kinetic, 0, 8);
FIELD(hs_energy, gravity, 8, 8);
FIELD(hs_energy, strain, 16, 8);
FIELD(hs_energy, friction_loss, 24, 8);
FIELD(hs_energy, contact_damping_loss, 32, 8);
FIELD(hs_energy, local_damping_loss, 40, 8);
FIELD(hs_energy, mass_damping_loss, 48, 8);
FIELD(hs_energy, outer_work, 56, 8);
FIELD(hs_energy, residual, 64, 8);

_Static_assert(sizeof(hs_world_report) >= 256, "hs_world_report");
FIELD(hs_world_report, dimension, 0, 4);
FIELD(hs_world_report, reserved, 4, 4);
FIELD(hs_world_report, steps, 8, 8);
FIELD(hs_world_report, time, 16, 8);
FIELD(hs_world_report, time_step, 24, 8);
FIELD(hs_world_report, stable_time_step, 32, 8);
FIELD(hs_world_report, block_count, 40, 8);
FIELD(hs_world_report, candidate_count, 48, 8);
FIELD(hs_world_report, contact_count, 56, 8);
FIELD(hs_world_report, list_builds, 64, 8);
FIELD(hs_world_report, largest_overlap, 72, 8);
FIELD(hs_world_report, largest_speed, 80, 8);
FIELD(hs_world_report, energy, 88, 72);
FIELD(hs_world_report, potential_length, 160, 8);
FIELD(hs_world_report, block_strain_energy, 168, 8);
FIELD(hs_world_report, block_damping_loss, 176, 8);
FIELD(hs_world_report, divided_steps, 184, 8);
FIELD(hs_world_report, max_penetration_ratio, 192, 8);
FIELD(hs_world_report, peak_overlap, 200, 8);
FIELD(hs_world_report, peak_speed, 208, 8);
FIELD(hs_world_report, sleeping_count, 216, 8);
FIELD(hs_world_report, max_sleep_error, 224, 8);
FIELD(hs_world_report, touch_count, 232, 8);
FIELD(hs_world_report, iteration_count, 240, 8);
FIELD(hs_world_report, impact_loss, 248, 8);

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

_Static_assert(sizeof(hs_bond_def) >= 80, "hs_bond_def");
FIELD(hs_bond_def, struct_size, 0, 4);
FIELD(hs_bond_def, reserved, 4, 4);
FIELD(hs_bond_def, normal_stiffness, 8, 8);
FIELD(hs_bond_def, shear_stiffness, 16, 8);
FIELD(hs_bond_def, tensile_strength, 24, 8);
FIELD(hs_bond_def, cohesion, 32, 8);
FIELD(hs_bond_def, friction_angle, 40, 8);
FIELD(hs_bond_def, residual_cohesion, 48, 8);
FIELD(hs_bond_def, residual_friction_angle, 56, 8);
FIELD(hs_bond_def, tensile_fracture_energy, 64, 8);
FIELD(hs_bond_def, shear_fracture_energy, 72, 8);

_Static_assert(sizeof(hs_bond) == 80, "hs_bond");
FIELD(hs_bond, block_a, 0, 8);
FIELD(hs_bond, block_b, 8, 8);
FIELD(hs_bond, is_joint, 16, 4);
FIELD(hs_bond, point_count, 20, 4);
FIELD(hs_bond, broken_count, 24, 4);
FIELD(hs_bond, reserved, 28, 4);
FIELD(hs_bond, area, 32, 8);
FIELD(hs_bond, damage, 40, 8);
FIELD(hs_bond, normal_force, 48, 8);
FIELD(hs_bond, shear_force, 56, 24);

_Static_assert(sizeof(hs_bond_event) == 112, "hs_bond_event");
FIELD(hs_bond_event, bond, 0, 8);
FIELD(hs_bond_event, step, 8, 8);
FIELD(hs_bond_event, failure, 16, 4);
FIELD(hs_bond_event, point, 20, 4);
FIELD(hs_bond_event, time, 24, 8);
FIELD(hs_bond_event, position, 32, 24);
FIELD(hs_bond_event, normal, 56, 24);
FIELD(hs_bond_event, area, 80, 8);
FIELD(hs_bond_event, normal_traction, 88, 8);
FIELD(hs_bond_event, shear_traction, 96, 8);
FIELD(hs_bond_event, energy, 104, 8);

_Static_assert(sizeof(hs_bond_report) >= 48, "hs_bond_report");
FIELD(hs_bond_report, bond_count, 0, 8);
FIELD(hs_bond_report, joint_count, 8, 8);
FIELD(hs_bond_report, event_count, 16, 8);
FIELD(hs_bond_report, crack_area, 24, 8);
FIELD(hs_bond_report, strain_energy, 32, 8);
FIELD(hs_bond_report, fracture_loss, 40, 8);

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

_Static_assert(sizeof(hs_mesh_properties) >= 40, "hs_mesh_properties");
FIELD(hs_mesh_properties, dimension, 0, 4);
FIELD(hs_mesh_properties, reserved, 4, 4);
FIELD(hs_mesh_properties, node_count, 8, 8);
FIELD(hs_mesh_properties, cell_count, 16, 8);
FIELD(hs_mesh_properties, surface_face_count, 24, 8);
FIELD(hs_mesh_properties, volume, 32, 8);

_Static_assert(sizeof(hs_body_def) >= 88, "hs_body_def");
FIELD(hs_body_def, struct_size, 0, 4);
FIELD(hs_body_def, material, 4, 4);
FIELD(hs_body_def, pose, 8, 56);
FIELD(hs_body_def, velocity, 64, 24);

_Static_assert(sizeof(hs_body_state) >= 88, "hs_body_state");
FIELD(hs_body_state, node_count, 0, 8);
FIELD(hs_body_state, cell_count, 8, 8);
FIELD(hs_body_state, mass, 16, 8);
FIELD(hs_body_state, centroid, 24, 24);
FIELD(hs_body_state, momentum, 48, 24);
FIELD(hs_body_state, kinetic_energy, 72, 8);
FIELD(hs_body_state, strain_energy, 80, 8);

_Static_assert(sizeof(hs_cell_state) == 152, "hs_cell_state");
FIELD(hs_cell_state, strain, 0, 72);
FIELD(hs_cell_state, stress, 72, 72);
FIELD(hs_cell_state, strain_energy, 144, 8);

_Static_assert(sizeof(hs_pair_cache) == 120, "hs_pair_cache");
FIELD(hs_pair_cache, state, 0, 4);
FIELD(hs_pair_cache, pair_kind, 4, 4);
FIELD(hs_pair_cache, feature_a, 8, 4);
FIELD(hs_pair_cache, feature_b, 12, 4);
FIELD(hs_pair_cache, shapes, 16, 8);
FIELD(hs_pair_cache, reach, 24, 8);
FIELD(hs_pair_cache, normal, 32, 24);
FIELD(hs_pair_cache, rotation_a, 56, 32);
FIELD(hs_pair_cache, rotation_b, 88, 32);

_Static_assert(sizeof(hs_pair_options) >= 40, "hs_pair_options");
FIELD(hs_pair_options, struct_size, 0, 4);
FIELD(hs_pair_options, reserved, 4, 4);
FIELD(hs_pair_options, parallel_angle, 8, 8);
FIELD(hs_pair_options, vertex_zone, 16, 8);
FIELD(hs_pair_options, margin, 24, 8);
FIELD(hs_pair_options, without_region, 32, 4);
FIELD(hs_pair_options, reserved_2, 36, 4);

_Static_assert(sizeof(hs_world_plan) >= 232, "hs_world_plan");
FIELD(hs_world_plan, dimension, 0, 4);
FIELD(hs_world_plan, parts, 4, 4);
FIELD(hs_world_plan, fixed_count, 8, 8);
FIELD(hs_world_plan, prescribed_count, 16, 8);
FIELD(hs_world_plan, rigid_count, 24, 8);
FIELD(hs_world_plan, affine_count, 32, 8);
FIELD(hs_world_plan, candidate_count, 40, 8);
FIELD(hs_world_plan, contact_count, 48, 8);
FIELD(hs_world_plan, block_bytes, 56, 8);
FIELD(hs_world_plan, pair_bytes, 64, 8);
FIELD(hs_world_plan, stable_time_step, 72, 8);
FIELD(hs_world_plan, limiting_block, 80, 8);
FIELD(hs_world_plan, limiting_neighbor, 88, 8);
FIELD(hs_world_plan, measured_steps, 96, 8);
FIELD(hs_world_plan, search_seconds, 104, 8);
FIELD(hs_world_plan, pair_seconds, 112, 8);
FIELD(hs_world_plan, gather_seconds, 120, 8);
FIELD(hs_world_plan, motion_seconds, 128, 8);
FIELD(hs_world_plan, ledger_seconds, 136, 8);
FIELD(hs_world_plan, body_count, 144, 8);
FIELD(hs_world_plan, cell_count, 152, 8);
FIELD(hs_world_plan, node_count, 160, 8);
FIELD(hs_world_plan, bond_count, 168, 8);
FIELD(hs_world_plan, mesh_bytes, 176, 8);
FIELD(hs_world_plan, bond_bytes, 184, 8);
FIELD(hs_world_plan, limiting_bond, 192, 8);
FIELD(hs_world_plan, limiting_body, 200, 8);
FIELD(hs_world_plan, limiting_cell, 208, 8);
FIELD(hs_world_plan, bond_seconds, 216, 8);
FIELD(hs_world_plan, hard_contact_seconds, 224, 8);

_Static_assert(sizeof(hs_relaxation_def) >= 40, "hs_relaxation_def");
FIELD(hs_relaxation_def, struct_size, 0, 4);
FIELD(hs_relaxation_def, measure, 4, 4);
FIELD(hs_relaxation_def, ratio, 8, 8);
FIELD(hs_relaxation_def, max_steps, 16, 8);
FIELD(hs_relaxation_def, local_damping, 24, 8);
FIELD(hs_relaxation_def, is_adaptive, 32, 4);
FIELD(hs_relaxation_def, hold_bonds, 36, 4);

_Static_assert(sizeof(hs_balance) >= 40, "hs_balance");
FIELD(hs_balance, mean, 0, 8);
FIELD(hs_balance, largest, 8, 8);
FIELD(hs_balance, largest_force, 16, 8);
FIELD(hs_balance, steps, 24, 8);
FIELD(hs_balance, largest_force_block, 32, 8);

_Static_assert(sizeof(hs_strength_def) >= 56, "hs_strength_def");
FIELD(hs_strength_def, struct_size, 0, 4);
FIELD(hs_strength_def, reserved, 4, 4);
FIELD(hs_strength_def, low, 8, 8);
FIELD(hs_strength_def, high, 16, 8);
FIELD(hs_strength_def, resolution, 24, 8);
FIELD(hs_strength_def, ratio, 32, 8);
FIELD(hs_strength_def, max_displacement, 40, 8);
FIELD(hs_strength_def, max_steps, 48, 8);

_Static_assert(sizeof(hs_strength_report) >= 40, "hs_strength_report");
FIELD(hs_strength_report, factor, 0, 8);
FIELD(hs_strength_report, low, 8, 8);
FIELD(hs_strength_report, high, 16, 8);
FIELD(hs_strength_report, stands_at_low, 24, 4);
FIELD(hs_strength_report, falls_at_high, 28, 4);
FIELD(hs_strength_report, trials, 32, 4);
FIELD(hs_strength_report, reserved, 36, 4);

_Static_assert(HS_OK == 0, "HS_OK");
_Static_assert(HS_NOTE_TRUNCATED == 1, "HS_NOTE_TRUNCATED");
_Static_assert(HS_NOTE_NOT_AT_REST == 2, "HS_NOTE_NOT_AT_REST");
_Static_assert(HS_ERROR_ARGUMENT == -1, "HS_ERROR_ARGUMENT");
_Static_assert(HS_ERROR_GEOMETRY == -2, "HS_ERROR_GEOMETRY");
_Static_assert(HS_ERROR_STALE_ID == -3, "HS_ERROR_STALE_ID");
_Static_assert(HS_ERROR_OUT_OF_MEMORY == -4, "HS_ERROR_OUT_OF_MEMORY");
_Static_assert(HS_ERROR_STATE == -5, "HS_ERROR_STATE");
_Static_assert(HS_ERROR_UNSTABLE == -6, "HS_ERROR_UNSTABLE");
_Static_assert(HS_ERROR_FORMAT == -7, "HS_ERROR_FORMAT");
_Static_assert(HS_ERROR_INTERNAL == -8, "HS_ERROR_INTERNAL");
_Static_assert(HS_ERROR_TOO_FAST == -9, "HS_ERROR_TOO_FAST");
_Static_assert(HS_ERROR_INVERTED == -10, "HS_ERROR_INVERTED");

_Static_assert(HS_CONTACT_NONE == 0, "HS_CONTACT_NONE");
_Static_assert(HS_CONTACT_VERTEX_VERTEX == 1, "HS_CONTACT_VERTEX_VERTEX");
_Static_assert(HS_CONTACT_VERTEX_EDGE == 2, "HS_CONTACT_VERTEX_EDGE");
_Static_assert(HS_CONTACT_EDGE_EDGE == 3, "HS_CONTACT_EDGE_EDGE");
_Static_assert(HS_CONTACT_EDGE_FACE == 4, "HS_CONTACT_EDGE_FACE");
_Static_assert(HS_CONTACT_FACE_FACE == 5, "HS_CONTACT_FACE_FACE");
_Static_assert(HS_CONTACT_VERTEX_FACE == 6, "HS_CONTACT_VERTEX_FACE");

_Static_assert(HS_PAIR_FACE_VERTEX == 0, "HS_PAIR_FACE_VERTEX");
_Static_assert(HS_PAIR_VERTEX_FACE == 1, "HS_PAIR_VERTEX_FACE");
_Static_assert(HS_PAIR_EDGE_EDGE == 2, "HS_PAIR_EDGE_EDGE");
_Static_assert(HS_PAIR_VERTEX_VERTEX == 3, "HS_PAIR_VERTEX_VERTEX");

_Static_assert(HS_CONTACT_POINTS == 8, "HS_CONTACT_POINTS");

_Static_assert(HS_STIFFNESS_PER_CONTACT == 0, "HS_STIFFNESS_PER_CONTACT");
_Static_assert(HS_STIFFNESS_PER_AREA == 1, "HS_STIFFNESS_PER_AREA");
_Static_assert(HS_STIFFNESS_POTENTIAL == 2, "HS_STIFFNESS_POTENTIAL");
_Static_assert(HS_STIFFNESS_NONE == 3, "HS_STIFFNESS_NONE");

_Static_assert(HS_FAULT_NONE == 0, "HS_FAULT_NONE");
_Static_assert(HS_FAULT_TOO_FEW_VERTICES == 1, "HS_FAULT_TOO_FEW_VERTICES");
_Static_assert(HS_FAULT_NOT_FINITE == 2, "HS_FAULT_NOT_FINITE");
_Static_assert(HS_FAULT_REPEATED_VERTEX == 3, "HS_FAULT_REPEATED_VERTEX");
_Static_assert(HS_FAULT_COLLINEAR_VERTEX == 4, "HS_FAULT_COLLINEAR_VERTEX");
_Static_assert(HS_FAULT_NOT_CONVEX == 5, "HS_FAULT_NOT_CONVEX");
_Static_assert(HS_FAULT_SELF_CROSSING == 6, "HS_FAULT_SELF_CROSSING");
_Static_assert(HS_FAULT_ZERO_AREA == 7, "HS_FAULT_ZERO_AREA");
_Static_assert(HS_FAULT_FEWER_THAN_FOUR == 8, "HS_FAULT_FEWER_THAN_FOUR");
_Static_assert(HS_FAULT_FACE_TOO_SHORT == 9, "HS_FAULT_FACE_TOO_SHORT");
_Static_assert(HS_FAULT_NO_SUCH_VERTEX == 10, "HS_FAULT_NO_SUCH_VERTEX");
_Static_assert(HS_FAULT_VERTEX_TWICE_IN_FACE == 11, "HS_FAULT_VERTEX_TWICE_IN_FACE");
_Static_assert(HS_FAULT_UNUSED_VERTEX == 12, "HS_FAULT_UNUSED_VERTEX");
_Static_assert(HS_FAULT_UNMATCHED_EDGE == 13, "HS_FAULT_UNMATCHED_EDGE");
_Static_assert(HS_FAULT_VERTEX_INSIDE_EDGE == 14, "HS_FAULT_VERTEX_INSIDE_EDGE");
_Static_assert(HS_FAULT_NOT_ONE_SURFACE == 15, "HS_FAULT_NOT_ONE_SURFACE");
_Static_assert(HS_FAULT_OUT_OF_RANGE == 16, "HS_FAULT_OUT_OF_RANGE");
_Static_assert(HS_FAULT_COINCIDING_VERTICES == 17, "HS_FAULT_COINCIDING_VERTICES");
_Static_assert(HS_FAULT_ZERO_VOLUME == 18, "HS_FAULT_ZERO_VOLUME");
_Static_assert(HS_FAULT_FACE_WITHOUT_AREA == 19, "HS_FAULT_FACE_WITHOUT_AREA");
_Static_assert(HS_FAULT_FACE_NOT_PLANE == 20, "HS_FAULT_FACE_NOT_PLANE");
_Static_assert(HS_FAULT_VERTEX_OUTSIDE_FACE == 21, "HS_FAULT_VERTEX_OUTSIDE_FACE");
_Static_assert(HS_FAULT_COPLANAR_FACES == 22, "HS_FAULT_COPLANAR_FACES");
_Static_assert(HS_FAULT_HULL_FAILED == 23, "HS_FAULT_HULL_FAILED");
_Static_assert(HS_FAULT_NO_DIRECTION == 24, "HS_FAULT_NO_DIRECTION");
_Static_assert(HS_FAULT_UNBOUNDED == 25, "HS_FAULT_UNBOUNDED");
_Static_assert(HS_FAULT_NO_COMMON_POINT == 26, "HS_FAULT_NO_COMMON_POINT");
_Static_assert(HS_FAULT_BEYOND_TOLERANCE == 27, "HS_FAULT_BEYOND_TOLERANCE");

_Static_assert(HS_BLOCK_FIXED == 0, "HS_BLOCK_FIXED");
_Static_assert(HS_BLOCK_PRESCRIBED == 1, "HS_BLOCK_PRESCRIBED");
_Static_assert(HS_BLOCK_RIGID == 2, "HS_BLOCK_RIGID");
_Static_assert(HS_BLOCK_AFFINE == 3, "HS_BLOCK_AFFINE");
_Static_assert(HS_BLOCK_MESH == 4, "HS_BLOCK_MESH");

_Static_assert(HS_FAST_DIVIDE == 0, "HS_FAST_DIVIDE");
_Static_assert(HS_FAST_REFUSE == 1, "HS_FAST_REFUSE");

_Static_assert(HS_PLANE_STRAIN == 0, "HS_PLANE_STRAIN");
_Static_assert(HS_PLANE_STRESS == 1, "HS_PLANE_STRESS");

_Static_assert(HS_BOND_HOLDS == 0, "HS_BOND_HOLDS");
_Static_assert(HS_BOND_TENSION == 1, "HS_BOND_TENSION");
_Static_assert(HS_BOND_SHEAR == 2, "HS_BOND_SHEAR");

_Static_assert(HS_IMPACT_NEVER == 0, "HS_IMPACT_NEVER");
_Static_assert(HS_IMPACT_AT_START == 1, "HS_IMPACT_AT_START");
_Static_assert(HS_IMPACT_TOUCH == 2, "HS_IMPACT_TOUCH");

_Static_assert(HS_CELL_TRIANGLE == 0, "HS_CELL_TRIANGLE");
_Static_assert(HS_CELL_QUAD == 1, "HS_CELL_QUAD");
_Static_assert(HS_CELL_TETRAHEDRON == 2, "HS_CELL_TETRAHEDRON");
_Static_assert(HS_CELL_PRISM == 3, "HS_CELL_PRISM");
_Static_assert(HS_CELL_HEXAHEDRON == 4, "HS_CELL_HEXAHEDRON");

_Static_assert(HS_AXIS_X == 1, "HS_AXIS_X");
_Static_assert(HS_AXIS_Y == 2, "HS_AXIS_Y");
_Static_assert(HS_AXIS_Z == 4, "HS_AXIS_Z");

_Static_assert(HS_PART_FRICTION == 1, "HS_PART_FRICTION");
_Static_assert(HS_PART_BONDS == 2, "HS_PART_BONDS");
_Static_assert(HS_PART_CONTACT_DAMPING == 4, "HS_PART_CONTACT_DAMPING");
_Static_assert(HS_PART_AREA == 8, "HS_PART_AREA");
_Static_assert(HS_PART_POTENTIAL == 16, "HS_PART_POTENTIAL");
_Static_assert(HS_PART_STRAIN == 32, "HS_PART_STRAIN");
_Static_assert(HS_PART_LOCAL_DAMPING == 64, "HS_PART_LOCAL_DAMPING");
_Static_assert(HS_PART_MASS_DAMPING == 128, "HS_PART_MASS_DAMPING");
_Static_assert(HS_PART_HARD_CONTACTS == 256, "HS_PART_HARD_CONTACTS");
_Static_assert(HS_PART_SLEEP == 512, "HS_PART_SLEEP");

_Static_assert(HS_UNBALANCED_MEAN == 0, "HS_UNBALANCED_MEAN");
_Static_assert(HS_UNBALANCED_LARGEST == 1, "HS_UNBALANCED_LARGEST");
