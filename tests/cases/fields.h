/* Fields and constants of the library by their names. C99 that is C++ as well. */
#ifndef HALFSPACE_CASE_FIELDS_H
#define HALFSPACE_CASE_FIELDS_H

#include <halfspace/halfspace.h>
#include <stddef.h>

#include "case_file.h"

typedef enum FieldType { FIELD_INT32, FIELD_INT64, FIELD_DOUBLE } FieldType;

typedef struct Field {
  const char* name; /* NULL ends a table */
  FieldType type;
  int count;
  size_t offset;
} Field;

typedef struct Constant {
  const char* name; /* NULL ends a table */
  int32_t value;
} Constant;

/* Generated: field_tables.c. */
extern const Constant case_constants[];
extern const Field world_def_fields[], law_def_fields[], elasticity_def_fields[], pair_options_fields[],
    motion_def_fields[];
extern const Field shape_fields[], contact_fields[], impact_fields[], block_fields[], deformation_fields[],
    report_fields[], energy_fields[];

/* Writes the FIELD VALUE ... pairs that begin at a word into a struct; HS_OK or it ends the program. */
hs_status set_fields(const Field* fields, void* object, const Statement* statement, int first);

/* The field whose name is at a word. */
const Field* field_at(const Field* fields, const Statement* statement, int word);

/* Value i of a field. */
double value_of(const Field* field, const void* object, int i);

#endif
