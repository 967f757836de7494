#include "player.h"

#include <stdlib.h>
#include <string.h>

#include "fields.h"

void begin_case(Player* player) {
  int i;
  hs_world_destroy(player->world);
  for (i = 0; i < player->shape_count; ++i) hs_shape_destroy(player->shapes[i].shape);
  player->world = NULL;
  player->shape_count = player->block_count = player->face_count = 0;
  hs_pair_options_init(&player->options, sizeof player->options);
}

NamedShape* shape_named(Player* player, const Statement* statement, int word) {
  int i;
  for (i = 0; i < player->shape_count; ++i)
    if (is(player->shapes[i].name, word_at(statement, word))) return &player->shapes[i];
  malformed(statement, "no shape has that name");
  return NULL;
}

NamedBlock* block_named(Player* player, const Statement* statement, int word) {
  int i;
  for (i = 0; i < player->block_count; ++i)
    if (is(player->blocks[i].name, word_at(statement, word))) return &player->blocks[i];
  malformed(statement, "no block has that name");
  return NULL;
}

static void name_shape(Player* player, const Statement* statement, int word, hs_shape* shape) {
  NamedShape* named = &player->shapes[player->shape_count++];
  if (player->shape_count == MOST_NAMES) malformed(statement, "too many shapes");
  memset(named, 0, sizeof *named);
  strncpy(named->name, word_at(statement, word), sizeof named->name - 1);
  named->shape = shape;
  named->pose.rotation[3] = 1;
  hs_motion_def_init(&named->motion, sizeof named->motion);
}

/* ---- shapes and pairs ---- */

static hs_status keep_faces(Player* player, const Statement* statement) {
  int i = 1, corner = 0, left;
  player->face_count = 0;
  while (i < statement->count) {
    left = (int)number_at(statement, i++);
    player->face_sizes[player->face_count++] = left;
    for (; left > 0; --left) player->face_vertices[corner++] = (int32_t)number_at(statement, i++);
  }
  return HS_OK;
}

static hs_status make_shape(Player* player, const Statement* statement) {
  const char* kind = word_at(statement, 2);
  const int in_plane = strncmp(kind, "polygon", 7) == 0 || is(kind, "boundary");
  const int stride = is(kind, "halfspaces") ? 4 : in_plane ? 2 : 3;
  double numbers[MOST_WORDS] = {0}, offsets[MOST_WORDS];
  const int count = numbers_from(statement, 3, numbers, MOST_WORDS) / stride;
  hs_view view;
  hs_shape* shape = NULL;
  hs_status status = HS_ERROR_INTERNAL;
  int i;
  view.x = numbers;
  view.y = numbers + 1;
  view.z = stride == 2 ? NULL : numbers + 2;
  view.stride = stride * (int64_t)sizeof(double);
  view.count = count;
  for (i = 0; stride == 4 && i < count; ++i) offsets[i] = numbers[4 * i + 3];

  if (is(kind, "polygon")) {
    status = hs_polygon_create(player->context, view, &shape);
  } else if (is(kind, "polygon_hull")) {
    status = hs_polygon_create_hull(player->context, view, &shape);
  } else if (is(kind, "boundary")) {
    const double first[3] = {numbers[0], numbers[1], 0}, second[3] = {numbers[2], numbers[3], 0};
    const double before[3] = {numbers[5], numbers[6], 0}, after[3] = {numbers[7], numbers[8], 0};
    const int in_chain = statement->count > 8;
    status = hs_polygon_create_boundary(player->context, in_chain ? before : NULL, first, second,
                                        in_chain ? after : NULL, numbers[4], &shape);
  } else if (is(kind, "polyhedron")) {
    status = hs_polyhedron_create(player->context, view, player->face_sizes, player->face_count,
                                  player->face_vertices, &shape);
  } else if (is(kind, "polyhedron_hull")) {
    status = hs_polyhedron_create_hull(player->context, view, &shape);
  } else if (is(kind, "halfspaces")) {
    status = hs_polyhedron_create_from_halfspaces(player->context, view, offsets, &shape);
  } else {
    malformed(statement, "unknown kind of shape");
  }
  if (status == HS_OK) name_shape(player, statement, 1, shape);
  return status;
}

static hs_status cut_shape(Player* player, const Statement* statement) {
  double point[3], normal[3];
  hs_shape *behind = NULL, *ahead = NULL;
  hs_status status;
  int i;
  for (i = 0; i < 3; ++i) {
    point[i] = number_at(statement, 2 + i);
    normal[i] = number_at(statement, 5 + i);
  }
  status = hs_shape_cut(shape_named(player, statement, 1)->shape, point, normal, &behind, &ahead);
  if (status == HS_OK) {
    name_shape(player, statement, 8, behind);
    name_shape(player, statement, 9, ahead);
  }
  return status;
}

static hs_pose pose_from(const Statement* statement, int first) {
  hs_pose pose;
  int i;
  for (i = 0; i < 3; ++i) pose.position[i] = number_at(statement, first + i);
  for (i = 0; i < 4; ++i) pose.rotation[i] = number_at(statement, first + 3 + i);
  return pose;
}

static hs_status detect_pair(Player* player, const Statement* statement) {
  const NamedShape *a = shape_named(player, statement, 1), *b = shape_named(player, statement, 2);
  return hs_pair_detect(a->shape, &a->pose, b->shape, &b->pose, &player->options, NULL, &player->contact);
}

static hs_status keep_motion(Player* player, const Statement* statement) {
  hs_motion_def* motion = &shape_named(player, statement, 1)->motion;
  hs_motion_def_init(motion, sizeof *motion);
  return set_fields(motion_def_fields, motion, statement, 2);
}

static hs_status find_impact(Player* player, const Statement* statement) {
  NamedShape *a = shape_named(player, statement, 1), *b = shape_named(player, statement, 2);
  a->motion.start = a->pose;
  b->motion.start = b->pose;
  return hs_pair_time_of_impact(a->shape, &a->motion, b->shape, &b->motion, number_at(statement, 3),
                                &player->impact);
}

/* ---- worlds ---- */

static hs_status make_world(Player* player, const Statement* statement) {
  hs_world_def def;
  hs_world* world = NULL;
  hs_status status;
  hs_world_def_init(&def, sizeof def, 2);
  set_fields(world_def_fields, &def, statement, 1);
  if (def.dimension == 3) {
    hs_world_def_init(&def, sizeof def, 3);
    set_fields(world_def_fields, &def, statement, 1);
  }
  status = hs_world_create(player->context, &def, &world);
  if (status != HS_OK) return status;
  hs_world_destroy(player->world);
  player->world = world;
  return HS_OK;
}

static hs_status set_law(Player* player, const Statement* statement, int first_field) {
  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  set_fields(law_def_fields, &law, statement, first_field);
  if (first_field == 1) return hs_world_set_default_law(player->world, &law);
  return hs_world_set_law(player->world, (int32_t)number_at(statement, 1), (int32_t)number_at(statement, 2),
                          &law);
}

static hs_status set_elasticity(Player* player, const Statement* statement) {
  hs_elasticity_def elasticity;
  hs_elasticity_def_init(&elasticity, sizeof elasticity);
  set_fields(elasticity_def_fields, &elasticity, statement, 2);
  return hs_world_set_elasticity(player->world, (int32_t)number_at(statement, 1), &elasticity);
}

static hs_status add_block(Player* player, const Statement* statement) {
  const hs_shape* shape = shape_named(player, statement, 2)->shape;
  NamedBlock* named = &player->blocks[player->block_count];
  hs_block_def def;
  hs_status status;
  hs_block_def_init(&def, sizeof def, shape);
  def.kind = (int32_t)number_at(statement, 3);
  def.material = (int32_t)number_at(statement, 4);
  def.pose = pose_from(statement, 5);
  memset(named->name, 0, sizeof named->name);
  strncpy(named->name, word_at(statement, 1), sizeof named->name - 1);
  status = hs_world_add_block(player->world, shape, &def, &named->block);
  if (status == HS_OK && ++player->block_count == MOST_NAMES) malformed(statement, "too many blocks");
  return status;
}

static hs_status set_vectors(Player* player, const Statement* statement) {
  const hs_block block = block_named(player, statement, 1)->block;
  double first[3], second[3];
  int i;
  for (i = 0; i < 3; ++i) {
    first[i] = number_at(statement, 2 + i);
    second[i] = number_at(statement, 5 + i);
  }
  return is(statement->words[0], "velocity")
             ? hs_world_set_velocity(player->world, block, first, second)
             : hs_world_set_applied_force(player->world, block, first, second);
}

/* So many numbers, neither fewer nor more. */
static void read_numbers(const Statement* statement, int first, double* numbers, int count) {
  if (numbers_from(statement, first, numbers, count) < count) malformed(statement, "too few numbers");
}

static hs_status set_deformation(Player* player, const Statement* statement) {
  double gradient_and_rate[18];
  read_numbers(statement, 2, gradient_and_rate, 18);
  return hs_world_set_deformation(player->world, block_named(player, statement, 1)->block, gradient_and_rate,
                                  gradient_and_rate + 9);
}

static hs_status set_stress(Player* player, const Statement* statement) {
  double stress[9];
  read_numbers(statement, 2, stress, 9);
  return hs_world_set_stress(player->world, block_named(player, statement, 1)->block, stress);
}

static hs_status add_surface_load(Player* player, const Statement* statement) {
  double traction[3];
  read_numbers(statement, 3, traction, 3);
  return hs_world_add_surface_load(player->world, block_named(player, statement, 1)->block,
                                   (int32_t)number_at(statement, 2), traction);
}

static hs_status evaluate_forces(Player* player, const Statement* statement) {
  double forces[MOST_NAMES][3];
  hs_mutable_view view, none;
  memset(&none, 0, sizeof none);
  view.x = &forces[0][0];
  view.y = &forces[0][1];
  view.z = &forces[0][2];
  view.stride = sizeof forces[0];
  view.count = MOST_NAMES;
  return hs_world_forces(player->world, number_at(statement, 1), view, none);
}

static hs_status reopen(Player* player) {
  size_t count = 0;
  void* bytes;
  hs_status status = hs_world_save(player->world, NULL, 0, &count);
  if (status < 0) return status;
  bytes = malloc(count);
  status = hs_world_save(player->world, bytes, count, &count);
  hs_world_destroy(player->world);
  player->world = NULL;
  if (status == HS_OK) status = hs_world_restore(player->context, bytes, count, &player->world);
  free(bytes);
  return status;
}

static hs_status restore_bytes(Player* player, const Statement* statement) {
  unsigned char bytes[MOST_WORDS];
  hs_world* world = NULL;
  int i;
  for (i = 1; i < statement->count; ++i) bytes[i - 1] = (unsigned char)number_at(statement, i);
  return hs_world_restore(player->context, bytes, (size_t)(statement->count - 1), &world);
}

static hs_status stage(Player* player, const Statement* statement) {
  const char* verb = statement->words[0];
  hs_status status = is(verb, "detect")   ? hs_world_detect(player->world, NULL)
                     : is(verb, "forces") ? evaluate_forces(player, statement)
                                          : hs_world_step(player->world, (int64_t)number_at(statement, 1));
  if (status < 0) return status;
  status = hs_world_get_contacts(player->world, &player->contact, 1, NULL);
  return status < 0 ? status : HS_OK;
}

hs_status call(Player* player, const Statement* statement) {
  const char* verb = statement->words[0];
  hs_pose pose;
  int32_t material;
  if (is(verb, "faces")) return keep_faces(player, statement);
  if (is(verb, "shape")) return make_shape(player, statement);
  if (is(verb, "cut")) return cut_shape(player, statement);
  if (is(verb, "options")) return set_fields(pair_options_fields, &player->options, statement, 1);
  if (is(verb, "pose")) {
    shape_named(player, statement, 1)->pose = pose_from(statement, 2);
    return HS_OK;
  }
  if (is(verb, "pair")) return detect_pair(player, statement);
  if (is(verb, "motion")) return keep_motion(player, statement);
  if (is(verb, "impact")) return find_impact(player, statement);
  if (is(verb, "world")) return make_world(player, statement);
  if (is(verb, "material")) return hs_world_add_material(player->world, number_at(statement, 1), &material);
  if (is(verb, "default_law")) return set_law(player, statement, 1);
  if (is(verb, "law")) return set_law(player, statement, 3);
  if (is(verb, "elasticity")) return set_elasticity(player, statement);
  if (is(verb, "block")) return add_block(player, statement);
  if (is(verb, "set_pose")) {
    pose = pose_from(statement, 2);
    return hs_world_set_pose(player->world, block_named(player, statement, 1)->block, &pose);
  }
  if (is(verb, "velocity") || is(verb, "applied_force")) return set_vectors(player, statement);
  if (is(verb, "set_deformation")) return set_deformation(player, statement);
  if (is(verb, "set_stress")) return set_stress(player, statement);
  if (is(verb, "surface_load")) return add_surface_load(player, statement);
  if (is(verb, "clear_surface_loads"))
    return hs_world_clear_surface_loads(player->world, block_named(player, statement, 1)->block);
  if (is(verb, "remove"))
    return hs_world_remove_block(player->world, block_named(player, statement, 1)->block);
  if (is(verb, "detect") || is(verb, "forces") || is(verb, "step")) return stage(player, statement);
  if (is(verb, "reopen")) return reopen(player);
  if (is(verb, "restore")) return restore_bytes(player, statement);
  malformed(statement, "unknown statement");
  return HS_ERROR_INTERNAL;
}
