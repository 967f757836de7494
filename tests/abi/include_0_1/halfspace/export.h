/** @file
 *  @brief Marks what the shared library exports; everything else is hidden.
 */
#ifndef HALFSPACE_EXPORT_H
#define HALFSPACE_EXPORT_H

#if defined(__GNUC__) || defined(__clang__)
/** Visible outside the shared library. */
#define HS_API __attribute__((visibility("default")))
#else
/** Visible outside the shared library. */
#define HS_API
#endif

#endif
