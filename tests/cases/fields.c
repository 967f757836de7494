#include "fields.h"

#define INT32(struct_name, field) \
  { #field, FIELD_INT32, 1, offsetof(struct_name, field) }
#define INT64(struct_name, field) \
  { #field, FIELD_INT64, 1, offsetof(struct_name, field) }
#define NUMBER(struct_name, field) \
  { #field, FIELD_DOUBLE, 1, offsetof(struct_name, field) }
#define NUMBERS(struct_name, field, count) \
  { #field, FIELD_DOUBLE, count, offsetof(struct_name, field) }
#define END_OF_TABLE \
  { NULL, FIELD_INT32, 0, 0 }

const Field world_def_fields[] = {INT32(hs_world_def, dimension),         NUMBER(hs_world_def, time_step),
                                  NUMBERS(hs_world_def, gravity, 3),      NUMBER(hs_world_def, safety),
                                  NUMBER(hs_world_def, potential_length), INT32(hs_world_def, fast_blocks),
                                  NUMBER(hs_world_def, sleep_tolerance),  END_OF_TABLE};

const Field law_def_fields[] = {INT32(hs_law_def, stiffness_kind),
                                NUMBER(hs_law_def, normal_stiffness),
                                NUMBER(hs_law_def, shear_stiffness),
                                NUMBER(hs_law_def, friction_angle),
                                NUMBER(hs_law_def, normal_damping),
                                NUMBER(hs_law_def, shear_damping),
                                END_OF_TABLE};

const Field elasticity_def_fields[] = {
    INT32(hs_elasticity_def, plane), NUMBER(hs_elasticity_def, young_modulus),
    NUMBER(hs_elasticity_def, poisson_ratio), NUMBER(hs_elasticity_def, damping_time), END_OF_TABLE};

const Field pair_options_fields[] = {NUMBER(hs_pair_options, parallel_angle),
                                     NUMBER(hs_pair_options, vertex_zone), NUMBER(hs_pair_options, margin),
                                     INT32(hs_pair_options, without_region), END_OF_TABLE};

const Field motion_def_fields[] = {
    NUMBERS(hs_motion_def, velocity, 3), NUMBERS(hs_motion_def, angular_velocity, 3),
    NUMBERS(hs_motion_def, gradient, 9), NUMBERS(hs_motion_def, gradient_rate, 9), END_OF_TABLE};

const Field shape_fields[] = {INT32(hs_shape_properties, dimension),
                              INT64(hs_shape_properties, vertex_count),
                              INT64(hs_shape_properties, edge_count),
                              INT64(hs_shape_properties, face_count),
                              NUMBER(hs_shape_properties, volume),
                              NUMBERS(hs_shape_properties, centroid, 3),
                              NUMBERS(hs_shape_properties, second_moment, 6),
                              NUMBER(hs_shape_properties, bounding_radius),
                              NUMBER(hs_shape_properties, shortest_edge),
                              END_OF_TABLE};

const Field contact_fields[] = {INT32(hs_contact, type),
                                INT32(hs_contact, pair_kind),
                                INT32(hs_contact, feature_a),
                                INT32(hs_contact, feature_b),
                                INT32(hs_contact, point_count),
                                NUMBERS(hs_contact, normal, 3),
                                NUMBER(hs_contact, gap),
                                NUMBER(hs_contact, area),
                                NUMBER(hs_contact, length),
                                NUMBERS(hs_contact, center, 3),
                                NUMBERS(hs_contact, force, 3),
                                NUMBER(hs_contact, normal_force),
                                NUMBERS(hs_contact, shear_force, 3),
                                END_OF_TABLE};

const Field impact_fields[] = {
    INT32(hs_impact, state),       INT32(hs_impact, pair_kind),  INT32(hs_impact, feature_a),
    INT32(hs_impact, feature_b),   NUMBER(hs_impact, time),      NUMBER(hs_impact, gap),
    NUMBERS(hs_impact, normal, 3), NUMBERS(hs_impact, point, 3), END_OF_TABLE};

const Field block_fields[] = {{"position", FIELD_DOUBLE, 3, offsetof(hs_block_state, pose.position)},
                              {"rotation", FIELD_DOUBLE, 4, offsetof(hs_block_state, pose.rotation)},
                              NUMBERS(hs_block_state, velocity, 3),
                              NUMBERS(hs_block_state, angular_velocity, 3),
                              NUMBERS(hs_block_state, force, 3),
                              NUMBERS(hs_block_state, torque, 3),
                              NUMBER(hs_block_state, mass),
                              END_OF_TABLE};

const Field deformation_fields[] = {NUMBERS(hs_deformation, gradient, 9),  NUMBERS(hs_deformation, rate, 9),
                                    NUMBERS(hs_deformation, strain, 9),    NUMBERS(hs_deformation, stress, 9),
                                    NUMBER(hs_deformation, strain_energy), END_OF_TABLE};

const Field report_fields[] = {INT32(hs_world_report, dimension),
                               INT64(hs_world_report, steps),
                               NUMBER(hs_world_report, time),
                               INT64(hs_world_report, contact_count),
                               NUMBER(hs_world_report, largest_overlap),
                               NUMBER(hs_world_report, potential_length),
                               NUMBER(hs_world_report, block_strain_energy),
                               NUMBER(hs_world_report, block_damping_loss),
                               INT64(hs_world_report, divided_steps),
                               NUMBER(hs_world_report, max_penetration_ratio),
                               NUMBER(hs_world_report, peak_overlap),
                               NUMBER(hs_world_report, peak_speed),
                               INT64(hs_world_report, sleeping_count),
                               NUMBER(hs_world_report, max_sleep_error),
                               END_OF_TABLE};

const Field energy_fields[] = {NUMBER(hs_energy, kinetic),
                               NUMBER(hs_energy, gravity),
                               NUMBER(hs_energy, strain),
                               NUMBER(hs_energy, friction_loss),
                               NUMBER(hs_energy, contact_damping_loss),
                               NUMBER(hs_energy, residual),
                               END_OF_TABLE};

const Field* field_at(const Field* fields, const Statement* statement, int word) {
  const char* name = word_at(statement, word);
  for (; fields->name; ++fields)
    if (is(fields->name, name)) return fields;
  malformed(statement, "unknown field");
  return NULL;
}

hs_status set_fields(const Field* fields, void* object, const Statement* statement, int first) {
  while (first < statement->count) {
    const Field* field = field_at(fields, statement, first++);
    char* at = (char*)object + field->offset;
    int i;
    for (i = 0; i < field->count; ++i, ++first) {
      const double number = number_at(statement, first);
      if (field->type == FIELD_INT32) {
        *(int32_t*)(void*)at = (int32_t)number;
      } else {
        ((double*)(void*)at)[i] = number;
      }
    }
  }
  return HS_OK;
}

double value_of(const Field* field, const void* object, int i) {
  const char* at = (const char*)object + field->offset;
  if (field->type == FIELD_INT32) return ((const int32_t*)(const void*)at)[i];
  if (field->type == FIELD_INT64) return (double)((const int64_t*)(const void*)at)[i];
  return ((const double*)(const void*)at)[i];
}
