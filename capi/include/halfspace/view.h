/** @file
 *  @brief Borrowed strided arrays of points, and poses.
 *
 *  A view does not own memory; the library accesses it during the call only. Component pointers with one byte
 *  stride describe C arrays [n][3], Fortran arrays x(3,n) and x(n,3), separate x, y, z arrays, and slices.
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

/** Points to write, with the layout of ::hs_view. */
typedef struct hs_mutable_view {
  double *x;      /**< first x component; not NULL unless count is 0 */
  double *y;      /**< first y component; not NULL unless count is 0 */
  double *z;      /**< first z component; may be NULL in 2D only; in 2D 0 is written */
  int64_t stride; /**< bytes from one point to the next, a multiple of sizeof(double); may be negative */
  int64_t count;  /**< capacity in points, >= 0 */
} hs_mutable_view;

/** Pose of a shape: position of its centroid and rotation about the centroid. */
typedef struct hs_pose {
  double position[3]; /**< of the centroid, m; finite, max 1e75 */
  double rotation[4]; /**< unit quaternion x, y, z, w; a length within 1e-6 of 1 is normalised */
} hs_pose;

#ifdef __cplusplus
}
#endif
#endif
