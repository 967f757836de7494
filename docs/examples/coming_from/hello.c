#include <halfspace/halfspace.h>
#include <stdio.h>

static hs_context *context;

static void check(hs_status status) {
  if (status < 0) fprintf(stderr, "%s\n", hs_context_last_error(context));
}

static hs_shape *rectangle(double half_width, double half_height) {
  const double x[] = {-half_width, half_width, half_width, -half_width};
  const double y[] = {-half_height, -half_height, half_height, half_height};
  const hs_view corners = {x, y, NULL, sizeof(double), 4};
  hs_shape *shape = NULL;
  check(hs_polygon_create(context, corners, &shape));
  return shape;
}

int main(void) {
  hs_world_def world_def;
  hs_law_def law;
  hs_block_def ground_def, body_def;
  hs_world *world = NULL;
  hs_shape *ground_box, *dynamic_box;
  hs_block ground, body;
  hs_block_state state;
  int32_t material;
  int i;

  check(hs_context_create(NULL, &context));
  hs_world_def_init(&world_def, sizeof world_def, 2);
  world_def.gravity[1] = -10;
  world_def.time_step = 1 / 60.0;
  check(hs_world_create(context, &world_def, &world));
  check(hs_world_add_material(world, 1, &material)); /* density 1 */
  hs_law_def_init(&law, sizeof law);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  law.friction_angle = 0.2915; /* atan of Box2D's 0.3 */
  check(hs_world_set_default_law(world, &law));

  ground_box = rectangle(50, 10);
  hs_block_def_init(&ground_def, sizeof ground_def, ground_box);
  ground_def.kind = HS_BLOCK_FIXED;
  ground_def.pose.position[1] = -10;
  check(hs_world_add_block(world, ground_box, &ground_def, &ground));

  dynamic_box = rectangle(1, 1);
  hs_block_def_init(&body_def, sizeof body_def, dynamic_box);
  body_def.pose.position[1] = 4;
  check(hs_world_add_block(world, dynamic_box, &body_def, &body));

  for (i = 1; i <= 60; ++i) {
    check(hs_world_step(world, 1));
    check(hs_world_get_block_state(world, body, &state));
    if (i % 15 == 0)
      printf("%4.2f %4.2f %4.2f\n", state.pose.position[0], state.pose.position[1], state.angle);
  }
  hs_context_destroy(context);
  return 0;
}
