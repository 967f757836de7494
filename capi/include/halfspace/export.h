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

/* [[nodiscard]], where there is it, lets a cast to void pass; the attribute of older C does not, by gcc. */
#if (defined(__cplusplus) && __cplusplus >= 201703L) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 202311L)
/** Likewise, and returns a status that is to be read: compilers warn where it is not. */
#define HS_CHECKED [[nodiscard]] HS_API
#elif defined(__GNUC__) || defined(__clang__)
/** Likewise, and returns a status that is to be read: compilers warn where it is not. */
#define HS_CHECKED HS_API __attribute__((warn_unused_result))
#else
/** Likewise, and returns a status that is to be read: compilers warn where it is not. */
#define HS_CHECKED HS_API
#endif

#endif
