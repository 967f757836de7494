/** @file
 *  @brief Queries without contact: rays, closest points, pairs of overlapping boxes, and an order of points.
 *
 *  They read shapes and worlds and change nothing. Worlds are seen in their current state, deformed blocks as
 *  they are now. See docs/concepts/queries.md. Thread rule: as for shapes and worlds.
 */
#ifndef HALFSPACE_QUERY_H
#define HALFSPACE_QUERY_H

#include "halfspace/context.h"
#include "halfspace/shape.h"
#include "halfspace/status.h"
#include "halfspace/view.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** First point of a ray in a shape or in a world. */
typedef struct hs_ray_hit {
  int32_t is_hit;   /**< 1: the ray meets a shape within its length; 0: all other fields are 0, face is -1 */
  int32_t face;     /**< index of the face (2D: edge) that the ray enters through; -1: it starts inside */
  hs_block block;   /**< id, in a world; else 0 */
  double distance;  /**< from the origin of the ray, m; 0 if it starts inside or on the boundary */
  double point[3];  /**< where it enters; its origin if it starts inside */
  double normal[3]; /**< outer unit normal of the face; 0 if it starts inside */
} hs_ray_hit;

/** Closest points of two shapes. */
typedef struct hs_closest_points {
  double distance;   /**< m; 0 when hs_pair_detect() finds a contact with its default options */
  double point_a[3]; /**< point of a; when the shapes overlap, a common point of both */
  double point_b[3]; /**< point of b; when the shapes overlap, the same point, to rounding */
  double normal[3];  /**< unit vector from a to b; 0 when the distance is 0 */
} hs_closest_points;

/** @brief Casts a ray at a shape. A ray that touches the shape to rounding hits it.
 *  @param shape not NULL @param pose of the shape
 *  @param origin start of the ray, 3 values, m
 *  @param direction 3 values, of any length except 0
 *  @param max_distance length of the ray, m, from 0 to 1e75
 *  @param hit receives the point where the ray enters, or that there is none
 *  @return HS_OK (also without a hit) or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_cast_ray(const hs_shape *shape, const hs_pose *pose, const double origin[3],
                                       const double direction[3], double max_distance, hs_ray_hit *hit);

/** @brief Casts a ray into a world. All blocks are tested: fixed ones, parts of compounds, and cells at the
 *  surfaces of meshes. At equal distances the block added first is hit.
 *  @param world not NULL
 *  @param origin,direction,max_distance as for hs_shape_cast_ray()
 *  @param hit receives the first block on the ray, or that there is none
 *  @return HS_OK (also without a hit) or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_cast_ray(const hs_world *world, const double origin[3],
                                       const double direction[3], double max_distance, hs_ray_hit *hit);

/** @brief Finds the closest points of two shapes, by GJK. Shapes with parallel faces may have many; one pair
 *  is returned. The depth of an overlap is the gap of hs_pair_detect().
 *  @param shape_a,shape_b the shapes, of the same dimension; may be the same shape
 *  @param pose_a,pose_b their poses
 *  @param points receives distance, points and normal
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY (polygons of more than 32 vertices) */
HS_CHECKED hs_status hs_pair_distance(const hs_shape *shape_a, const hs_pose *pose_a, const hs_shape *shape_b,
                                      const hs_pose *pose_b, hs_closest_points *points);

/** @brief Broad phase alone: finds all pairs of overlapping boxes, at any ratio of sizes, in time linear in
 *  boxes and pairs. Boxes that touch overlap.
 *  @param context allocates temporary memory and keeps the error text
 *  @param dimension 2 or 3
 *  @param lower lower corners of the boxes, m, at most 2^30
 *  @param upper upper corners, as many; no component is below that of the lower corner
 *  @param pairs receives the indices a < b of each pair, 2 * capacity values, in an order that depends on the
 *         boxes only; may be NULL if capacity is 0
 *  @param capacity in pairs
 *  @param count receives the number of pairs; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_boxes_find_pairs(hs_context *context, int32_t dimension, hs_view lower, hs_view upper,
                                         int32_t pairs[], int64_t capacity, int64_t *count);

/** @brief Orders points along a Hilbert curve through their box. Blocks that are added in this order have
 *  their neighbours close in memory: a world of 1e5 blocks in random order takes more than twice the time per
 *  step.
 *  @param context allocates temporary memory and keeps the error text
 *  @param dimension 2 or 3
 *  @param points e.g. the centroids of blocks, m, finite, at most 2^30
 *  @param order receives the indices of the points, points.count values: order[0] is the first point along the
 *         curve. Points in one place keep their order. May be NULL if there are no points
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_points_order_along_curve(hs_context *context, int32_t dimension, hs_view points,
                                                 int32_t order[]);

#ifdef __cplusplus
}
#endif
#endif
