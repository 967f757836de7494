/** @file
 *  @brief Borrowed strided arrays of points, and poses.
 *
 *  A view never owns memory; the library reads or writes it during the call only. Component pointers with
 *  one byte stride describe C arrays [n][3], Fortran x(3,n) and x(n,3), separate x, y, z arrays and slices
 *  alike.
 */
#ifndef HALFSPACE_VIEW_H
#define HALFSPACE_VIEW_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Points to read. Point i is (x[i], y[i], z[i]), each pointer advanced by i * stride bytes. */
typedef struct hs_view {
  const double *x; /**< first x component; not NULL unless count is 0 */
  const double *y; /**< first y component; not NULL unless count is 0 */
  const double *z; /**< first z component; may be NULL in 2D only */
  int64_t stride;  /**< bytes from one point to the next, a multiple of sizeof(double); may be negative */
  int64_t count;   /**< number of points, >= 0 */
} hs_view;

/** Points to write; the layout is that of ::hs_view, count is the capacity. */
typedef struct hs_mutable_view {
  double *x;      /**< first x component; not NULL unless count is 0 */
  double *y;      /**< first y component; not NULL unless count is 0 */
  double *z;      /**< first z component; may be NULL in 2D only, else is set to 0 there */
  int64_t stride; /**< bytes from one point to the next, a multiple of sizeof(double); may be negative */
  int64_t count;  /**< capacity in points, >= 0 */
} hs_mutable_view;

/** Where a shape is: its centroid, and its rotation about the centroid. */
typedef struct hs_pose {
  double position[3]; /**< of the centroid; finite, at most 1e75 */
  double rotation[4]; /**< unit quaternion x, y, z, w; its length may be off 1 by 1e-6 and is normalised */
} hs_pose;

#ifdef __cplusplus
}
#endif
#endif
