/** @file
 *  @brief Status codes of all functions that can fail, and the version of the library.
 */
#ifndef HALFSPACE_STATUS_H
#define HALFSPACE_STATUS_H

#include <stdint.h>

#include "halfspace/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/** 0: success. Above 0: success with a note. Below 0: error, see halfspace.h. */
typedef int32_t hs_status;

/** List of status codes: X(name, value, text). Constants of the bindings are generated from it. */
#define HS_STATUS_LIST(X)                                                                        \
  X(HS_OK, 0, "ok")                                                                              \
  X(HS_NOTE_TRUNCATED, 1, "the output is truncated to the capacity")                             \
  X(HS_NOTE_NOT_AT_REST, 2, "forces are still unbalanced after max_steps")                       \
  X(HS_ERROR_ARGUMENT, -1, "an argument is null, out of range or not finite")                    \
  X(HS_ERROR_GEOMETRY, -2, "the vertices do not describe a convex shape")                        \
  X(HS_ERROR_STALE_ID, -3, "the id does not name a living block, material or contact")           \
  X(HS_ERROR_OUT_OF_MEMORY, -4, "the allocator returned no memory")                              \
  X(HS_ERROR_STATE, -5, "the object is not in a state that allows this call")                    \
  X(HS_ERROR_UNSTABLE, -6, "the run became unstable: the time step is too large")                \
  X(HS_ERROR_FORMAT, -7, "the bytes are not a snapshot that this library can read")              \
  X(HS_ERROR_INTERNAL, -8, "internal error of the library; please report it")                    \
  X(HS_ERROR_TOO_FAST, -9, "two blocks approach too fast for the time step and their thickness") \
  X(HS_ERROR_INVERTED, -10, "a mesh cell would be inverted")                                     \
  X(HS_ERROR_INTERRUPTED, -11, "the host has interrupted the call")

/** An entry of the list as an enumerator. */
#define HS_STATUS_ENUM(name, value, text) name = value,

/** Values of ::hs_status. */
enum { HS_STATUS_LIST(HS_STATUS_ENUM) };
#undef HS_STATUS_ENUM

/** @brief Returns the text of a status code.
 *  @param status any value, including unknown ones
 *  @return a static string, never NULL; owned by the library. Thread rule: any thread, any time. */
HS_API const char *hs_status_string(hs_status status);

/* The version of these headers. */
#define HS_VERSION_MAJOR 0 /**< major version of these headers */
#define HS_VERSION_MINOR 1 /**< minor version; before 1.0 program and library need the same one */
#define HS_VERSION_PATCH 0 /**< patch version */
/** Version as one number, for example 1203 for 0.12.3. */
#define HS_VERSION (HS_VERSION_MAJOR * 10000 + HS_VERSION_MINOR * 100 + HS_VERSION_PATCH)

/** @brief Returns the version of the library at run time, e.g. "0.1.0".
 *  @return a static string. Thread rule: any thread, any time. */
HS_API const char *hs_version(void);

#ifdef __cplusplus
}
#endif
#endif
