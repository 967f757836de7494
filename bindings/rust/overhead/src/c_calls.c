/* What the benchmark times in C: the same calls as in Rust. */
#define _POSIX_C_SOURCE 199309L
#include <halfspace/halfspace.h>
#include <time.h>

double c_thread_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The square at the first pose against itself at each of the others. */
hs_status c_detect_pairs(const hs_shape *square, const hs_pose *lower, const hs_pose uppers[], int64_t count,
                         hs_contact *contact) {
  hs_status status = HS_OK;
  int64_t i;
  for (i = 0; i < count && status == HS_OK; ++i) {
    status = hs_pair_detect(square, lower, square, &uppers[i], NULL, NULL, contact);
  }
  return status;
}

hs_status c_detect_pairs_cached(const hs_shape *square, const hs_pose *lower, const hs_pose uppers[],
                                int64_t count, hs_pair_cache *cache, hs_contact *contact) {
  hs_status status = HS_OK;
  int64_t i;
  for (i = 0; i < count && status == HS_OK; ++i) {
    status = hs_pair_detect(square, lower, square, &uppers[i], NULL, cache, contact);
  }
  return status;
}

hs_status c_step(hs_world *world) { return hs_world_step(world, 1); }

hs_status c_detect(hs_world *world, const hs_pose poses[], int64_t count) {
  const hs_status status = hs_world_set_poses(world, poses, count);
  return status == HS_OK ? hs_world_detect(world, NULL) : status;
}

hs_status c_forces(hs_world *world, hs_mutable_view forces, hs_mutable_view torques) {
  return hs_world_forces(world, 0, forces, torques);
}

hs_status c_poses(const hs_world *world, hs_pose poses[], int64_t count) {
  return hs_world_get_poses(world, poses, count, NULL);
}

hs_status c_contacts(const hs_world *world, hs_contact contacts[], int64_t capacity) {
  return hs_world_get_contacts(world, contacts, capacity, NULL);
}
