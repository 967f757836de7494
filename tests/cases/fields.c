#include "fields.h"

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
