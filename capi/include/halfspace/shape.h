/** @file
 *  @brief Convex shapes: checking, making, cleaning up, hull, cutting, mass properties, half-spaces.
 *
 *  A shape is immutable and may be used by any number of blocks. Its own frame has the centroid at the origin;
 *  hs_shape_properties.centroid says where that was in the coordinates it was made from.
 */
#ifndef HALFSPACE_SHAPE_H
#define HALFSPACE_SHAPE_H

#include "halfspace/context.h"
#include "halfspace/status.h"
#include "halfspace/view.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Opaque, immutable convex polygon (2D). */
typedef struct hs_shape hs_shape;

/** What can be wrong with a list of vertices. */
enum {
  HS_FAULT_NONE = 0,             /**< a valid convex polygon */
  HS_FAULT_TOO_FEW_VERTICES = 1, /**< fewer than 3 */
  HS_FAULT_NOT_FINITE = 2,       /**< NaN or infinite coordinate, or too large or small to compute with */
  HS_FAULT_REPEATED_VERTEX = 3,  /**< two neighbours at the same place */
  HS_FAULT_COLLINEAR_VERTEX = 4, /**< a vertex on the line of its neighbours, to rounding */
  HS_FAULT_NOT_CONVEX = 5,       /**< a corner that turns the other way */
  HS_FAULT_SELF_CROSSING = 6,    /**< the outline winds more than once or crosses itself */
  HS_FAULT_ZERO_AREA = 7         /**< all vertices on one line */
};

/** The first fault found in a list of vertices. */
typedef struct hs_fault {
  int32_t kind;    /**< an HS_FAULT_ value */
  int32_t reserved; /**< 0 */
  int64_t vertex;  /**< index of the offending vertex in the caller's list, -1 if it is the whole */
} hs_fault;

/** Geometry and mass per unit density. */
typedef struct hs_shape_properties {
  int32_t dimension;        /**< 2 */
  int32_t reserved;         /**< 0 */
  int64_t vertex_count;     /**< >= 3 */
  int64_t face_count;       /**< half-spaces: edges in 2D */
  double volume;            /**< area times unit thickness in 2D */
  double centroid[3];       /**< in the coordinates the shape was made from */
  double second_moment[6];  /**< about the centroid: xx, yy, zz, xy, yz, zx of the integral of r r^T; 2D: xx, yy, 0, xy, 0, 0 */
  double bounding_radius;   /**< farthest vertex from the centroid */
  double shortest_edge;     /**< length */
} hs_shape_properties;

/** What hs_polygon_clean() changed. */
typedef struct hs_clean_report {
  int64_t welded;    /**< vertices dropped because they lay within the tolerance of the one before */
  int64_t straightened; /**< vertices dropped because they lay within the tolerance of their neighbours' line */
  int32_t reversed;  /**< 1 if the order was turned counter-clockwise */
  int32_t reserved;  /**< 0 */
} hs_clean_report;

/** @brief Says what is wrong with a polygon's vertices without making a shape.
 *  @param context for the error text
 *  @param vertices clockwise or counter-clockwise
 *  @param fault receives the first fault, or HS_FAULT_NONE
 *  @return HS_OK (also when there is a fault), HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_API hs_status hs_polygon_check(hs_context *context, hs_view vertices, hs_fault *fault);

/** @brief Makes a convex polygon. Nothing is welded or repaired: faulty input is refused with its reason.
 *  Small edges and small angles are legal, and there is no limit to the number of vertices.
 *  @param context owner of the allocator
 *  @param vertices clockwise or counter-clockwise, 3 or more
 *  @param shape receives the shape; end it with hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text names fault and vertex) or HS_ERROR_OUT_OF_MEMORY */
HS_API hs_status hs_polygon_create(hs_context *context, hs_view vertices, hs_shape **shape);

/** @brief Makes the convex hull of points as a polygon.
 *  @param context owner of the allocator
 *  @param points any order, inner and repeated points allowed
 *  @param shape receives the shape
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (all on one line) or HS_ERROR_OUT_OF_MEMORY */
HS_API hs_status hs_polygon_create_hull(hs_context *context, hs_view points, hs_shape **shape);

/** @brief Cleans up a vertex list on request: drops repeated vertices and vertices on the line of their neighbours, and
 *  turns the order counter-clockwise. It reports what it changed and never moves a vertex.
 *  @param context for the error text
 *  @param vertices as found, in outline order
 *  @param tolerance distance, >= 0; 0 drops exact repetitions and what is straight to rounding
 *  @param cleaned receives the vertices; its count is the capacity, vertices.count always suffices
 *  @param count receives the number of vertices that remain
 *  @param report receives what was changed; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_API hs_status hs_polygon_clean(hs_context *context, hs_view vertices, double tolerance, hs_mutable_view cleaned,
                                  int64_t *count, hs_clean_report *report);

/** @brief Cuts a shape by a plane (a line in 2D) into two.
 *  Coordinates are those the shape was made from, and so are those of the parts.
 *  @param shape what to cut; it stays as it is
 *  @param point a point of the plane, 3 values
 *  @param normal the plane's normal, 3 values, any length but 0
 *  @param behind receives the part against the normal, or NULL if there is none
 *  @param ahead receives the part along the normal, or NULL if there is none
 *  A part that the plane touches only to rounding is none, and the other part is then a copy of the whole.
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (a part too small to compute with) or HS_ERROR_OUT_OF_MEMORY */
HS_API hs_status hs_shape_cut(const hs_shape *shape, const double point[3], const double normal[3], hs_shape **behind,
                              hs_shape **ahead);

/** @brief Geometry and mass properties.
 *  @param shape not NULL
 *  @param properties receives them
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_API hs_status hs_shape_get_properties(const hs_shape *shape, hs_shape_properties *properties);

/** @brief The vertices, counter-clockwise, in the coordinates the shape was made from.
 *  @param shape not NULL
 *  @param vertices receives them; its count is the capacity
 *  @param count receives the number of vertices; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_API hs_status hs_shape_get_vertices(const hs_shape *shape, hs_mutable_view vertices, int64_t *count);

/** @brief The half-spaces: p is inside when dot(normal, p) <= offset, with outer unit normals.
 *  Half-space i of a polygon belongs to the edge from vertex i to vertex i + 1. The frame is the shape's own: the centroid
 *  is at the origin.
 *  @param shape not NULL
 *  @param normals receives the outer unit normals; its count is the capacity
 *  @param offsets receives the offsets, normals.count values; may be NULL
 *  @param count receives the number of half-spaces; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_API hs_status hs_shape_get_halfspaces(const hs_shape *shape, hs_mutable_view normals, double *offsets, int64_t *count);

/** @brief Ends a shape. Blocks made from it keep their own copy.
 *  @param shape may be NULL */
HS_API void hs_shape_destroy(hs_shape *shape);

#ifdef __cplusplus
}
#endif
#endif
