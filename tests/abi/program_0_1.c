/* A program of version 0.1: compiled with the headers of that version, run on this library. Frozen with them;
 * its answers are known from analysis. What the library may grow by it must not write here: behind each
 * definition and report lies a guard. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "halfspace_0_1.h"

#define GUARD 0x5a

/* A struct of version 0.1 with memory behind it that is not the library's. */
#define GUARDED(type)         \
  struct {                    \
    type value;               \
    unsigned char behind[64]; \
  }

static void expect(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "FAILED: %s\n", what);
  exit(1);
}

static void expect_ok(hs_status status, const char* what, const hs_context* context) {
  if (status == HS_OK) return;
  fprintf(stderr, "FAILED: %s: %s\n", what, hs_context_last_error(context));
  exit(1);
}

static void expect_guard(const unsigned char behind[64], const char* what) {
  int i;
  for (i = 0; i < 64; ++i) expect(behind[i] == GUARD, what);
}

static hs_shape* make_square(hs_context* context) {
  const double corners[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  const hs_view vertices = {&corners[0][0], &corners[0][1], NULL, sizeof corners[0], 4};
  hs_shape* shape = NULL;
  expect_ok(hs_polygon_create(context, vertices, &shape), "hs_polygon_create", context);
  return shape;
}

static void check_shape(hs_context* context, const hs_shape* square) {
  GUARDED(hs_shape_properties) p;
  memset(&p, GUARD, sizeof p);
  expect_ok(hs_shape_get_properties(square, &p.value, sizeof p.value), "hs_shape_get_properties", context);
  expect_guard(p.behind, "hs_shape_get_properties wrote behind its report");
  expect(p.value.dimension == 2 && p.value.vertex_count == 4 && p.value.volume == 1,
         "properties of a unit square");
  expect(fabs(p.value.second_moment[0] - 1.0 / 12) < 1e-15 && p.value.shortest_edge == 1,
         "moment and edge of a unit square");
}

static void check_pair(hs_context* context, const hs_shape* square) {
  const hs_pose lower = {{0, 0, 0}, {0, 0, 0, 1}}, upper = {{0.25, 0.875, 0}, {0, 0, 0, 1}};
  GUARDED(hs_pair_options) options;
  GUARDED(hs_contact) contact;
  GUARDED(hs_pair_cache) cache;
  memset(&options, GUARD, sizeof options);
  memset(&contact, GUARD, sizeof contact);
  memset(&cache, GUARD, sizeof cache);
  memset(&cache.value, 0, sizeof cache.value);
  expect_ok(hs_pair_options_init(&options.value, sizeof options.value), "hs_pair_options_init", context);
  expect_guard(options.behind, "hs_pair_options_init wrote behind its definition");
  expect_ok(hs_pair_detect(square, &lower, square, &upper, &options.value, &cache.value, &contact.value),
            "hs_pair_detect", context);
  expect_guard(contact.behind, "hs_pair_detect wrote behind its contact");
  expect_guard(cache.behind, "hs_pair_detect wrote behind its cache");
  expect(contact.value.type == HS_CONTACT_EDGE_EDGE && contact.value.gap == -0.125, "type and gap of a pair");
  expect(contact.value.normal[1] == 1 && contact.value.area == 0.75 && cache.value.state == 2,
         "region of a pair");
}

static hs_world* make_world(hs_context* context, const hs_shape* square, hs_block blocks[2]) {
  GUARDED(hs_world_def) settings;
  GUARDED(hs_law_def) law;
  GUARDED(hs_block_def) block;
  hs_world* world = NULL;
  int32_t material = -1;
  int i;
  memset(&settings, GUARD, sizeof settings);
  memset(&law, GUARD, sizeof law);
  memset(&block, GUARD, sizeof block);
  expect_ok(hs_world_def_init(&settings.value, sizeof settings.value, 2), "hs_world_def_init", context);
  settings.value.gravity[1] = -10;
  settings.value.time_step = 1.0 / 1024;
  expect_ok(hs_world_create(context, &settings.value, &world), "hs_world_create", context);
  expect_ok(hs_world_add_material(world, 1000, &material), "hs_world_add_material", context);
  expect_ok(hs_law_def_init(&law.value, sizeof law.value), "hs_law_def_init", context);
  law.value.normal_stiffness = 1e6;
  law.value.friction_angle = 0.5;
  expect_ok(hs_world_set_default_law(world, &law.value), "hs_world_set_default_law", context);
  expect_ok(hs_block_def_init(&block.value, sizeof block.value, square), "hs_block_def_init", context);
  for (i = 0; i < 2; ++i) {
    block.value.kind = i == 0 ? HS_BLOCK_FIXED : HS_BLOCK_RIGID;
    block.value.pose.position[1] = 10 * i;
    expect_ok(hs_world_add_block(world, square, &block.value, &blocks[i]), "hs_world_add_block", context);
  }
  expect_guard(settings.behind, "hs_world_def_init wrote behind its definition");
  expect_guard(law.behind, "hs_law_def_init wrote behind its definition");
  expect_guard(block.behind, "hs_block_def_init wrote behind its definition");
  return world;
}

/* Free fall, which velocity Verlet has exactly: after 0.25 s the block is 0.3125 m lower and falls at 2.5
 * m/s. */
static void check_fall(hs_context* context, hs_world* world, hs_block falling) {
  GUARDED(hs_world_report) report;
  GUARDED(hs_block_state) state;
  memset(&report, GUARD, sizeof report);
  memset(&state, GUARD, sizeof state);
  expect_ok(hs_world_step(world, 256), "hs_world_step", context);
  expect_ok(hs_world_get_report(world, &report.value, sizeof report.value), "hs_world_get_report", context);
  expect_ok(hs_world_get_block_state(world, falling, &state.value), "hs_world_get_block_state", context);
  expect_guard(report.behind, "hs_world_get_report wrote behind its report");
  expect_guard(state.behind, "hs_world_get_block_state wrote behind its state");
  expect(report.value.dimension == 2 && report.value.steps == 256 && report.value.time == 0.25,
         "the report's time");
  expect(report.value.block_count == 2 && report.value.contact_count == 0, "the report's counts");
  expect(fabs(report.value.energy.kinetic - 0.5 * 1000 * 2.5 * 2.5) < 1e-9, "kinetic energy");
  expect(state.value.mass == 1000 && fabs(state.value.velocity[1] + 2.5) < 1e-12, "velocity");
  expect(fabs(state.value.pose.position[1] - (10 - 0.3125)) < 1e-12, "position");
}

int main(void) {
  GUARDED(hs_context_def) def;
  hs_context* context = NULL;
  hs_shape *square, *refused = NULL;
  hs_world* world;
  hs_block blocks[2];
  const hs_view nothing = {NULL, NULL, NULL, 0, 0};

  memset(&def, GUARD, sizeof def);
  expect(hs_context_def_init(&def.value, sizeof def.value) == HS_OK, "hs_context_def_init");
  expect_guard(def.behind, "hs_context_def_init wrote behind its definition");
  expect(hs_context_create(&def.value, &context) == HS_OK, "hs_context_create");
  square = make_square(context);
  check_shape(context, square);
  check_pair(context, square);
  world = make_world(context, square, blocks);
  check_fall(context, world, blocks[1]);
  expect(hs_polygon_create(context, nothing, &refused) < 0 && refused == NULL,
         "a polygon of nothing is refused");
  expect(strstr(hs_context_last_error(context), "hs_polygon_create") != NULL, "the text of a refusal");
  hs_world_destroy(world);
  hs_shape_destroy(square);
  hs_context_destroy(context);
  printf("a program of version 0.1 runs on version %s\n", hs_version());
  return 0;
}
