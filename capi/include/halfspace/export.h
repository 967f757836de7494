/** @file
 *  @brief Export macros: the shared library exports the functions marked by them and hides all others.
 */
#ifndef HALFSPACE_EXPORT_H
#define HALFSPACE_EXPORT_H

#if defined(_WIN32) && defined(HALFSPACE_STATIC)
/** Exported by the shared library. */
#define HS_API
#elif defined(_WIN32) && defined(halfspace_EXPORTS)
/** Exported by the shared library. */
#define HS_API __declspec(dllexport)
#elif defined(_WIN32)
/** Exported by the shared library. */
#define HS_API __declspec(dllimport)
#elif defined(__GNUC__) || defined(__clang__)
/** Exported by the shared library. */
#define HS_API __attribute__((visibility("default")))
#else
/** Exported by the shared library. */
#define HS_API
#endif

/* [[nodiscard]] is preferred: a cast to void silences it, but not gcc's attribute for older C. */
#if (defined(__cplusplus) && __cplusplus >= 201703L) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 202311L)
/** Exported, and returns a status: compilers warn if the caller discards it. */
#define HS_CHECKED [[nodiscard]] HS_API
#elif defined(__GNUC__) || defined(__clang__)
/** Exported, and returns a status: compilers warn if the caller discards it. */
#define HS_CHECKED HS_API __attribute__((warn_unused_result))
#else
/** Exported, and returns a status: compilers warn if the caller discards it. */
#define HS_CHECKED HS_API
#endif

#endif
