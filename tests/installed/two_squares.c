/* Two unit squares: one pair detected, then one square falling towards the other for a few steps. */
#include <halfspace/halfspace.h>
#include <stdio.h>

static hs_context* context = NULL;

static int fail(const char* what) {
  fprintf(stderr, "%s: %s\n", what, hs_context_last_error(context));
  return 1;
}

#define DO(call) \
  if ((call) != HS_OK) return fail(#call)
#define EXPECT(condition) \
  if (!(condition)) return fail("expected " #condition)

int main(void) {
  const double corners[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  const hs_view vertices = {&corners[0][0], &corners[0][1], NULL, sizeof corners[0], 4};
  const hs_pose below = {{0, 0, 0}, {0, 0, 0, 1}};
  const hs_pose touching = {{0.25, 0.75, 0}, {0, 0, 0, 1}}; /* overlaps by 0.25 in height, 0.75 in width */
  const hs_pose apart = {{0.25, 1.5, 0}, {0, 0, 0, 1}};     /* a gap of 0.5 */
  hs_shape* square = NULL;
  hs_world* world = NULL;
  hs_contact contact;
  hs_world_def world_def;
  hs_block_def block_def;
  hs_block block;
  hs_block_state state;
  hs_world_report report;
  int32_t stone;

  DO(hs_context_create(NULL, &context));
  DO(hs_polygon_create(context, vertices, &square));

  /* All numbers here are exact in binary, so the gaps are too. */
  DO(hs_pair_detect(square, &below, square, &touching, NULL, NULL, &contact));
  EXPECT(contact.type == HS_CONTACT_EDGE_EDGE);
  EXPECT(contact.gap == -0.25);
  EXPECT(contact.normal[1] == 1.0);
  EXPECT(contact.area == 0.75);
  DO(hs_pair_detect(square, &below, square, &apart, NULL, NULL, &contact));
  EXPECT(contact.type == HS_CONTACT_NONE);
  EXPECT(contact.gap == 0.5);

  DO(hs_world_def_init(&world_def, sizeof world_def, 2));
  world_def.time_step = 1e-3;
  DO(hs_world_create(context, &world_def, &world));
  DO(hs_world_add_material(world, 2000, &stone));
  DO(hs_block_def_init(&block_def, sizeof block_def, square));
  block_def.material = stone;
  block_def.kind = HS_BLOCK_FIXED;
  DO(hs_world_add_block(world, square, &block_def, &block));
  block_def.kind = HS_BLOCK_RIGID;
  block_def.pose = apart;
  DO(hs_world_add_block(world, square, &block_def, &block));
  DO(hs_world_step(world, 10));
  DO(hs_world_get_report(world, &report, sizeof report));
  DO(hs_world_get_block_state(world, block, &state));
  EXPECT(report.steps == 10);
  EXPECT(report.block_count == 2);
  EXPECT(state.velocity[1] < 0); /* in free fall */
  EXPECT(state.pose.position[1] < 1.5);

  printf("halfspace %s: after %g s the upper square is at %.6f\n", hs_version(), report.time,
         state.pose.position[1]);
  hs_world_destroy(world);
  hs_shape_destroy(square);
  hs_context_destroy(context);
  return 0;
}
