/* What the benchmarks of the bindings compare with: the same calls made from C, on what the binding has
 * built. Each function returns the seconds of processor time that its calls have taken, and ends the program
 * if one fails. */
#define _POSIX_C_SOURCE 199309L /* for clock_gettime() */
#include <halfspace/halfspace.h>
#include <stdlib.h>
#include <time.h>

/* Of this thread. */
double thread_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void require_ok(hs_status status) {
  if (status != HS_OK) abort();
}

/* One step at a time. */
double seconds_of_step(hs_world* world, int64_t calls) {
  const double start = thread_seconds();
  while (calls-- > 0) require_ok(hs_world_step(world, 1));
  return thread_seconds() - start;
}

/* With the poses set before each: without a change there is nothing to detect. */
double seconds_of_detect(hs_world* world, int64_t calls, const hs_pose poses[], int64_t count) {
  const double start = thread_seconds();
  while (calls-- > 0) {
    require_ok(hs_world_set_poses(world, poses, count));
    require_ok(hs_world_detect(world, NULL));
  }
  return thread_seconds() - start;
}

double seconds_of_forces(hs_world* world, int64_t calls, hs_mutable_view forces, hs_mutable_view torques) {
  const double start = thread_seconds();
  while (calls-- > 0) require_ok(hs_world_forces(world, 0, forces, torques));
  return thread_seconds() - start;
}

double seconds_of_poses(const hs_world* world, int64_t calls, hs_pose poses[], int64_t count) {
  const double start = thread_seconds();
  while (calls-- > 0) require_ok(hs_world_get_poses(world, poses, count, NULL));
  return thread_seconds() - start;
}

double seconds_of_contacts(const hs_world* world, int64_t calls, hs_contact contacts[], int64_t capacity) {
  const double start = thread_seconds();
  while (calls-- > 0) require_ok(hs_world_get_contacts(world, contacts, capacity, NULL));
  return thread_seconds() - start;
}

/* The shape at the lower pose against itself at each of the upper ones; the cache may be NULL. */
double seconds_of_pairs(const hs_shape* shape, const hs_pose* lower, const hs_pose uppers[], int64_t count,
                        hs_pair_cache* cache, hs_contact* contact) {
  const double start = thread_seconds();
  int64_t i;
  for (i = 0; i < count; ++i)
    require_ok(hs_pair_detect(shape, lower, shape, &uppers[i], NULL, cache, contact));
  return thread_seconds() - start;
}
