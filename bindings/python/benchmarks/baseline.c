/* What the calls cost without Python: each is made in a loop, on a world that Python has built. */
#define _POSIX_C_SOURCE 199309L /* for clock_gettime() */
#include <halfspace/halfspace.h>
#include <time.h>

#define EXPORTED __attribute__((visibility("default")))

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds for `calls` steps, one at a time. */
EXPORTED double seconds_of_step(hs_world* world, int calls) {
  const double start = now();
  while (calls-- > 0) hs_world_step(world, 1);
  return now() - start;
}

/* With the poses set before each: without a change there is nothing to detect. */
EXPORTED double seconds_of_detect(hs_world* world, int calls, const hs_pose* poses, int64_t count) {
  const double start = now();
  while (calls-- > 0) {
    hs_world_set_poses(world, poses, count);
    hs_world_detect(world, NULL);
  }
  return now() - start;
}

EXPORTED double seconds_of_forces(hs_world* world, int calls, hs_mutable_view forces,
                                  hs_mutable_view torques) {
  const double start = now();
  while (calls-- > 0) hs_world_forces(world, 0, forces, torques);
  return now() - start;
}
