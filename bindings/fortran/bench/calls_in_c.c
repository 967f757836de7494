/* The calls of bench_overhead.f90 made from C, each timed: seconds of processor time of this thread. */
#define _POSIX_C_SOURCE 199309L
#include <halfspace/halfspace.h>
#include <stdlib.h>
#include <time.h>

double thread_seconds(void);
double c_detect(hs_world* world);
double c_forces(hs_world* world, double* forces, double* torques, int64_t count);
double c_pairs(const hs_shape* shape, const hs_pose* pose_a, const hs_pose* pose_b, int64_t calls);
double c_step(hs_world* world, int64_t steps);

double thread_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void require_ok(hs_status status) {
  if (status != HS_OK) abort();
}

double c_step(hs_world* world, int64_t steps) {
  const double start = thread_seconds();
  require_ok(hs_world_step(world, steps));
  return thread_seconds() - start;
}

double c_detect(hs_world* world) {
  int64_t touching;
  const double start = thread_seconds();
  require_ok(hs_world_detect(world, &touching));
  return thread_seconds() - start;
}

double c_forces(hs_world* world, double* forces, double* torques, int64_t count) {
  const hs_mutable_view force = {forces, forces + 1, forces + 2, 3 * sizeof(double), count};
  const hs_mutable_view torque = {torques, torques + 1, torques + 2, 3 * sizeof(double), count};
  const double start = thread_seconds();
  require_ok(hs_world_forces(world, 0, force, torque));
  return thread_seconds() - start;
}

double c_pairs(const hs_shape* shape, const hs_pose* pose_a, const hs_pose* pose_b, int64_t calls) {
  hs_contact contact;
  hs_pair_cache cache = {0};
  int64_t i;
  const double start = thread_seconds();
  for (i = 0; i < calls; ++i)
    require_ok(hs_pair_detect(shape, pose_a, shape, pose_b, NULL, &cache, &contact));
  return thread_seconds() - start;
}
