/** @file
 *  @brief Status codes of every fallible function, and the library's version.
 */
#ifndef HALFSPACE_STATUS_H
#define HALFSPACE_STATUS_H

#include <stdint.h>

#include "halfspace/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/** 0: done. Greater than 0: done, with a note. Less than 0: an error; nothing was changed. */
typedef int32_t hs_status;

/** The one list of status codes: X(name, value, text). Bindings generate their constants from it. */
#define HS_STATUS_LIST(X)                                                                        \
  X(HS_OK, 0, "ok")                                                                              \
  X(HS_NOTE_TRUNCATED, 1, "the output did not fit: only as much as the capacity holds was written") \
  X(HS_NOTE_NOT_AT_REST, 2, "forces are still unbalanced after as many steps as were allowed")   \
  X(HS_ERROR_ARGUMENT, -1, "an argument is null, out of range or not finite")                    \
  X(HS_ERROR_GEOMETRY, -2, "the vertices do not describe a convex shape")                        \
  X(HS_ERROR_STALE_ID, -3, "the id does not name a living block, material or contact")           \
  X(HS_ERROR_OUT_OF_MEMORY, -4, "the allocator returned no memory")                              \
  X(HS_ERROR_STATE, -5, "the object is not in a state that allows this call")                    \
  X(HS_ERROR_UNSTABLE, -6, "the run became unstable: the time step is too large")                \
  X(HS_ERROR_FORMAT, -7, "the bytes are not a snapshot that this library can read")              \
  X(HS_ERROR_INTERNAL, -8, "a defect of the library: please report it")                          \
  X(HS_ERROR_TOO_FAST, -9, "two blocks meet too fast for the time step against their thickness")  \
  X(HS_ERROR_INVERTED, -10, "a cell of a mesh would be turned inside out")

/** One line of the list as an enumerator. */
#define HS_STATUS_ENUM(name, value, text) name = value,

/** The values behind ::hs_status. */
enum { HS_STATUS_LIST(HS_STATUS_ENUM) };
#undef HS_STATUS_ENUM

/** @brief The fixed text of a status code.
 *  @param status any value, also an unknown one
 *  @return a static string, never NULL; owned by the library. Thread rule: any thread, any time. */
HS_API const char *hs_status_string(hs_status status);

/* The version of these headers. */
#define HS_VERSION_MAJOR 0 /**< of these headers */
#define HS_VERSION_MINOR 1 /**< likewise; before 1.0 programs and library agree in it */
#define HS_VERSION_PATCH 0 /**< likewise */
/** The same as one number, for example 1203 for version 0.12.3. */
#define HS_VERSION (HS_VERSION_MAJOR * 10000 + HS_VERSION_MINOR * 100 + HS_VERSION_PATCH)

/** @brief The version of the library at run time, e.g. "0.1.0".
 *  @return a static string. Thread rule: any thread, any time. */
HS_API const char *hs_version(void);

#ifdef __cplusplus
}
#endif
#endif
