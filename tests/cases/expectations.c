#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "fields.h"
#include "player.h"

/* Words from `first` on: values, and after `within` their tolerances, one for all or one for each. */
static int compare(const Field* field, const void* object, const Statement* statement, int first) {
  int within = first, tolerances, i, equal = 1;
  while (within < statement->count && !is(statement->words[within], "within")) ++within;
  tolerances = statement->count - within - 1;
  if (within - first != field->count) malformed(statement, "the field has another number of values");
  for (i = 0; i < field->count; ++i) {
    const double expected = number_at(statement, first + i);
    const double tolerance =
        tolerances < 1 ? 0 : number_at(statement, within + 1 + (tolerances == 1 ? 0 : i));
    const double got = value_of(field, object, i);
    if (!(fabs(got - expected) <= tolerance)) {
      printf("  line %d: %s[%d] is %.17g, expected %.17g within %g\n", statement->line, field->name, i, got,
             expected, tolerance);
      equal = 0;
    }
  }
  return equal;
}

/* FNV-1a over the bytes of all poses. */
static uint64_t hash_of_poses(const hs_world* world) {
  hs_pose poses[MOST_NAMES];
  const unsigned char* bytes = (const unsigned char*)poses;
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  int64_t count = 0;
  size_t i;
  if (hs_world_get_poses(world, poses, MOST_NAMES, &count) != HS_OK) count = 0;
  for (i = 0; i < (size_t)count * sizeof(hs_pose); ++i) hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
  return hash;
}

static int compare_hash(const Player* player, const Statement* statement) {
  char got[17];
  snprintf(got, sizeof got, "%016" PRIx64, hash_of_poses(player->world));
  if (is(got, word_at(statement, 2))) return 1;
  printf("  line %d: the hash is %s\n", statement->line, got);
  return 0;
}

int meets_expectation(Player* player, const Statement* statement) {
  const char* subject = word_at(statement, 1);
  hs_shape_properties properties;
  hs_block_state state;
  hs_deformation deformation;
  hs_world_report report;
  hs_status status;
  if (is(subject, "hash")) return compare_hash(player, statement);
  if (is(subject, "contact"))
    return compare(field_at(contact_fields, statement, 2), &player->contact, statement, 3);
  if (is(subject, "impact"))
    return compare(field_at(impact_fields, statement, 2), &player->impact, statement, 3);
  if (is(subject, "shape")) {
    status =
        hs_shape_get_properties(shape_named(player, statement, 2)->shape, &properties, sizeof properties);
    return status == HS_OK && compare(field_at(shape_fields, statement, 3), &properties, statement, 4);
  }
  if (is(subject, "block")) {
    status = hs_world_get_block_state(player->world, block_named(player, statement, 2)->block, &state);
    return status == HS_OK && compare(field_at(block_fields, statement, 3), &state, statement, 4);
  }
  if (is(subject, "deformation")) {
    status = hs_world_get_deformation(player->world, block_named(player, statement, 2)->block, &deformation);
    return status == HS_OK && compare(field_at(deformation_fields, statement, 3), &deformation, statement, 4);
  }
  status = hs_world_get_report(player->world, &report, sizeof report);
  if (is(subject, "report")) {
    return status == HS_OK && compare(field_at(report_fields, statement, 2), &report, statement, 3);
  }
  if (is(subject, "energy")) {
    return status == HS_OK && compare(field_at(energy_fields, statement, 2), &report.energy, statement, 3);
  }
  malformed(statement, "nothing is known of that subject");
  return 0;
}
