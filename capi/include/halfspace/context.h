/** @file
 *  @brief The context: allocator, threads and last error. Shapes, meshes and worlds are created in a context.
 */
#ifndef HALFSPACE_CONTEXT_H
#define HALFSPACE_CONTEXT_H

#include <stddef.h>
#include <stdint.h>

#include "halfspace/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Opaque. Owns the allocator settings and the text of the last error. */
typedef struct hs_context hs_context;

/** Opaque. Parallel work for the host's scheduler, in parts that are independent; hs_task_run() runs one
 *  part. */
typedef struct hs_task hs_task;

/** Settings of a context. Fill it with hs_context_def_init(). */
typedef struct hs_context_def {
  uint32_t struct_size; /**< set by hs_context_def_init() */
  uint32_t reserved;    /**< 0 */
  /** Returns memory aligned to `alignment` bytes, or NULL if there is none. Default NULL: the C library's
   *  allocator. */
  void *(*allocate)(size_t bytes, size_t alignment, void *user);
  /** Releases memory that `allocate` returned. Set both functions or neither. */
  void (*release)(void *memory, size_t bytes, size_t alignment, void *user);
  void *user; /**< passed to allocate and release */
  /** Number of threads that step a world, 1 to 256; default 1. Results are bit-identical for any number. The
   *  context owns threads - 1 worker threads, or none if `run_tasks` is set. Small worlds use one thread. */
  int32_t threads;
  uint32_t reserved_2; /**< 0 */
  /** The host's scheduler; default NULL: threads of the library. It must call hs_task_run(task, i) once for
   *  each i from 0 to count - 1, in any order and on any threads, and return after all calls have returned;
   *  count equals `threads`. Thread rule: called on the thread of an hs_world_ function; it must call no
   *  other function of the library. */
  void (*run_tasks)(hs_task *task, int32_t count, void *scheduler);
  void *scheduler; /**< passed to run_tasks */
  /** Returns other than 0 to end a call early; default NULL. It is called between the parts of a divided
   *  step, which may take long, and must call no function of the library. */
  int32_t (*interrupt)(void *host);
  void *host; /**< passed to interrupt */
} hs_context_def;

/** @brief Fills a context definition with its defaults.
 *  @param def to fill; not NULL
 *  @param size sizeof(hs_context_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_context_def_init(hs_context_def *def, size_t size);

/** @brief Makes a context.
 *  @param def NULL for all defaults
 *  @param context receives the context; the caller owns it and destroys it with hs_context_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY (no memory, or the system refuses a thread) */
HS_CHECKED hs_status hs_context_create(const hs_context_def *def, hs_context **context);

/** @brief Runs one part of a task.
 *  @param task as passed to hs_context_def.run_tasks, which has not returned yet
 *  @param index from 0 to count - 1, each once. Thread rule: any thread. */
HS_API void hs_task_run(hs_task *task, int32_t index);

/** @brief Destroys a context. All objects made from it must have been destroyed before.
 *  @param context may be NULL */
HS_API void hs_context_destroy(hs_context *context);

/** @brief Returns the text of the last error: function, argument and value.
 *  @param context NULL returns the text for a missing context
 *  @return a string owned by the context, valid until its next failing call; "" if no call has failed */
HS_API const char *hs_context_last_error(const hs_context *context);

#ifdef __cplusplus
}
#endif
#endif
