/** @file
 *  @brief The context: allocator, threads and last error. Everything else is made from one.
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

/** Opaque. Work in parts that may be done at the same time, for a host with a scheduler of its own: hs_task_run() does
 *  one. */
typedef struct hs_task hs_task;

/** How a context is made. Fill it with hs_context_def_init(), then change what you need. */
typedef struct hs_context_def {
  uint32_t struct_size; /**< set by hs_context_def_init() */
  uint32_t reserved;    /**< 0 */
  /** Returns memory aligned to `alignment`, or NULL. NULL here means the C library's allocator. */
  void *(*allocate)(size_t bytes, size_t alignment, void *user);
  /** Gives back what `allocate` returned. Set both or neither. */
  void (*release)(void *memory, size_t bytes, size_t alignment, void *user);
  void *user; /**< passed to both */
  /** How many threads step a world, 1 to 256; default 1. Results have the same bits for any number. The library makes
   *  and keeps one less than that, which wait for work; with `run_tasks` it makes none. Below some hundred contacts one
   *  is used. */
  int32_t threads;
  uint32_t reserved_2; /**< 0 */
  /** The host's own scheduler, or NULL (default) for threads of the library. Calls hs_task_run(task, i) for i from 0 to
   *  count - 1, each once, in whatever order and on whatever threads, and returns when all have ended. `count` is
   *  `threads`. It is called within hs_world_ functions, on their thread, and calls nothing else of the library. */
  void (*run_tasks)(hs_task *task, int32_t count, void *scheduler);
  void *scheduler; /**< passed to run_tasks */
} hs_context_def;

/** @brief Fills a definition with its defaults.
 *  @param def to fill; not NULL
 *  @param size sizeof(hs_context_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_context_def_init(hs_context_def *def, size_t size);

/** @brief Makes a context.
 *  @param def NULL for all defaults
 *  @param context receives the context, which the caller owns and ends with hs_context_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY, also when the system has no more threads */
HS_CHECKED hs_status hs_context_create(const hs_context_def *def, hs_context **context);

/** @brief Does one part of what hs_context_def::run_tasks was given.
 *  @param task as given to run_tasks, which has not returned yet
 *  @param index from 0 to count - 1, each once. Thread rule: any thread. */
HS_API void hs_task_run(hs_task *task, int32_t index);

/** @brief Ends a context. Its shapes and worlds must have been destroyed before.
 *  @param context may be NULL */
HS_API void hs_context_destroy(hs_context *context);

/** @brief What went wrong last: function, argument, value.
 *  @param context NULL gives the text for a missing context
 *  @return a string owned by the context, valid until its next failing call; "" if nothing failed yet */
HS_API const char *hs_context_last_error(const hs_context *context);

#ifdef __cplusplus
}
#endif
#endif
