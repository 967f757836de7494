/* A unit square falls onto a fixed one and comes to rest there. */
#include <halfspace/halfspace.h>
#include <stdio.h>

static hs_context *context = NULL;

/* Every call that can fail returns a status; the context keeps the text of the last error. */
static int failed(hs_status status) {
  if (status < 0) fprintf(stderr, "%s\n", hs_context_last_error(context));
  return status < 0;
}

int main(void) {
  const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const hs_view vertices = {&corners[0][0], &corners[0][1], NULL, sizeof corners[0], 4};
  hs_shape *square = NULL;
  hs_world *world = NULL;
  hs_world_def world_def;
  hs_law_def law;
  hs_block_def block_def;
  hs_block block;
  hs_block_state state;
  hs_world_report report;
  int32_t stone;
  int line;

  /* A definition is filled with its defaults first, then changed where the scene differs. */
  hs_world_def_init(&world_def, sizeof world_def, 2);
  world_def.time_step = 5e-4;
  hs_law_def_init(&law, sizeof law);
  law.normal_stiffness = law.shear_stiffness = 1e7;
  law.normal_damping = law.shear_damping = 0.2;
  if (failed(hs_context_create(NULL, &context)) || failed(hs_polygon_create(context, vertices, &square)) ||
      failed(hs_world_create(context, &world_def, &world)) ||
      failed(hs_world_add_material(world, 2500, &stone)) || failed(hs_world_set_default_law(world, &law)))
    return 1;

  hs_block_def_init(&block_def, sizeof block_def, square);
  block_def.material = stone;
  block_def.kind = HS_BLOCK_FIXED;
  if (failed(hs_world_add_block(world, square, &block_def, &block))) return 1;
  block_def.kind = HS_BLOCK_RIGID;
  block_def.pose.position[1] += 1.5; /* half a metre above the fixed one */
  if (failed(hs_world_add_block(world, square, &block_def, &block))) return 1;

  for (line = 0; line <= 10; ++line) {
    if (line > 0 && failed(hs_world_step(world, 400))) return 1;
    if (failed(hs_world_get_report(world, &report, sizeof report)) ||
        failed(hs_world_get_block_state(world, block, &state)))
      return 1;
    printf("%4.1f s: %7.4f m above the fixed square, %7.4f m/s, %d contacts\n", report.time,
           state.pose.position[1] - 1.5, state.velocity[1], (int)report.contact_count);
  }
  hs_world_destroy(world);
  hs_shape_destroy(square);
  hs_context_destroy(context);
  return 0;
}
