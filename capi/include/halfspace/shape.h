/** @file
 *  @brief Convex shapes: checking, making, cleaning up, hull, cutting, mass properties, half-spaces.
 *
 *  A shape is immutable and may be used by any number of blocks. Its own frame has the centroid at the
 *  origin; hs_shape_properties.centroid says where that was in the coordinates it was made from.
 */
#ifndef HALFSPACE_SHAPE_H
#define HALFSPACE_SHAPE_H

#include <stddef.h>
#include <stdint.h>

#include "halfspace/context.h"
#include "halfspace/status.h"
#include "halfspace/view.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Opaque, immutable convex polygon (2D) or polyhedron (3D). */
typedef struct hs_shape hs_shape;

/** What can be wrong with what a shape is to be made from. */
enum {
  HS_FAULT_NONE = 0,                  /**< a valid convex polygon or polyhedron */
  /* A polygon's vertices. */
  HS_FAULT_TOO_FEW_VERTICES = 1,      /**< fewer than 3 */
  HS_FAULT_NOT_FINITE = 2,            /**< NaN, infinite, or too large or small to compute with */
  HS_FAULT_REPEATED_VERTEX = 3,       /**< two neighbours at the same place */
  HS_FAULT_COLLINEAR_VERTEX = 4,      /**< a vertex on the line of its neighbours, to rounding */
  HS_FAULT_NOT_CONVEX = 5,            /**< a corner that turns the other way */
  HS_FAULT_SELF_CROSSING = 6,         /**< the outline winds more than once or crosses itself */
  HS_FAULT_ZERO_AREA = 7,             /**< all vertices on one line */
  /* How a polyhedron's vertices and faces hang together. */
  HS_FAULT_FEWER_THAN_FOUR = 8,       /**< vertices or faces */
  HS_FAULT_FACE_TOO_SHORT = 9,        /**< a face of fewer than 3 vertices */
  HS_FAULT_NO_SUCH_VERTEX = 10,       /**< a face refers to a vertex that is not there */
  HS_FAULT_VERTEX_TWICE_IN_FACE = 11, /**< a face goes through the same vertex twice */
  HS_FAULT_UNUSED_VERTEX = 12,        /**< a vertex that belongs to no face */
  HS_FAULT_UNMATCHED_EDGE = 13,       /**< an edge not shared by two faces in opposite directions */
  HS_FAULT_VERTEX_INSIDE_EDGE = 14,   /**< a vertex of two faces only: not a corner */
  HS_FAULT_NOT_ONE_SURFACE = 15,      /**< several surfaces, or one with holes */
  /* Where a polyhedron's vertices are. */
  HS_FAULT_OUT_OF_RANGE = 16,         /**< not finite, or beyond 1e50, or the whole smaller than 1e-50 */
  HS_FAULT_COINCIDING_VERTICES = 17,  /**< two vertices at the same place */
  HS_FAULT_ZERO_VOLUME = 18,          /**< all vertices in one plane, to rounding */
  HS_FAULT_FACE_WITHOUT_AREA = 19,    /**< a face with all vertices on one line, to rounding */
  HS_FAULT_FACE_NOT_PLANE = 20,       /**< a vertex off the plane of its face by more than rounding */
  HS_FAULT_VERTEX_OUTSIDE_FACE = 21,  /**< a vertex before a face's plane: not convex */
  HS_FAULT_COPLANAR_FACES = 22,       /**< a face in one plane with a neighbour, to rounding */
  /* What keeps points or half-spaces from having a polyhedron. */
  HS_FAULT_HULL_FAILED = 23,          /**< points so close to degenerate that rounding hides their hull */
  HS_FAULT_NO_DIRECTION = 24,         /**< a half-space whose normal is 0 */
  HS_FAULT_UNBOUNDED = 25,            /**< half-spaces that do not bound a region */
  HS_FAULT_NO_COMMON_POINT = 26,      /**< half-spaces without a region, or with one flat to rounding */
  /* Facets that are to be fitted within a tolerance. */
  HS_FAULT_BEYOND_TOLERANCE = 27      /**< a dent deeper than the tolerance */
};

/** The first fault found. */
typedef struct hs_fault {
  int32_t kind;     /**< an HS_FAULT_ value */
  int32_t reserved; /**< 0 */
  int64_t vertex;   /**< index of the offending vertex in the caller's list, -1 if it is the whole */
  int64_t face;     /**< index of the offending face in the caller's list, -1 if there is none */
} hs_fault;

/** Geometry and mass per unit density. Later versions may append to it. */
typedef struct hs_shape_properties {
  int32_t dimension;        /**< 2 or 3 */
  int32_t reserved;         /**< 0 */
  int64_t vertex_count;     /**< >= 3; in 3D >= 4 */
  int64_t edge_count;       /**< >= 3; in 3D >= 6 */
  int64_t face_count;       /**< half-spaces: edges in 2D, faces in 3D */
  double volume;            /**< area times unit thickness in 2D */
  double centroid[3];       /**< in the coordinates the shape was made from */
  double second_moment[6];  /**< about the centroid: xx, yy, zz, xy, yz, zx of the integral of r r^T; 2D: xx,
                                 yy, 0, xy, 0, 0. The moment of inertia about z is the density times
                                 (xx + yy), and so on */
  double bounding_radius;   /**< farthest vertex from the centroid */
  double shortest_edge;     /**< length */
} hs_shape_properties;

/** What hs_polygon_clean() changed. */
typedef struct hs_clean_report {
  int64_t welded;       /**< vertices dropped because they lay within the tolerance of the one before */
  int64_t straightened; /**< vertices dropped because they lay within it of their neighbours' line */
  int32_t reversed;     /**< 1 if the order was turned counter-clockwise */
  int32_t reserved;     /**< 0 */
} hs_clean_report;

/** The changes that hs_polyhedron_create_fitted() made or, when it refuses a dent, its place. */
typedef struct hs_fit_report {
  hs_fault fault;              /**< HS_FAULT_NONE, or what the text says; of a dent the lowest vertex */
  int64_t merged;              /**< facets given beyond the faces made */
  double deviation;            /**< largest distance of a vertex from the fitted plane of its face; of a
                                    dent its depth below the convex hull */
  double moved;                /**< largest distance of a corner from where it was given */
  double sufficient_tolerance; /**< of a dent: a tolerance that takes it, tried; 0 if there is none */
} hs_fit_report;

/** @brief Says what is wrong with a polygon's vertices without making a shape.
 *  @param context for the error text
 *  @param vertices clockwise or counter-clockwise
 *  @param fault receives the first fault, or HS_FAULT_NONE
 *  @return HS_OK (also when there is a fault), HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_check(hs_context *context, hs_view vertices, hs_fault *fault);

/** @brief Makes a convex polygon. Nothing is welded or repaired: faulty input is refused with its reason.
 *  Small edges and small angles are legal, and there is no limit to the number of vertices.
 *  @param context owner of the allocator
 *  @param vertices clockwise or counter-clockwise, 3 or more
 *  @param shape receives the shape; end it with hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text names fault and vertex) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_create(hs_context *context, hs_view vertices, hs_shape **shape);

/** @brief Makes the convex hull of points as a polygon.
 *  @param context owner of the allocator
 *  @param points any order, inner and repeated points allowed
 *  @param shape receives the shape
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (all on one line) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_create_hull(hs_context *context, hs_view points, hs_shape **shape);

/** @brief Makes a boundary segment: the virtual polygon of which it is an edge, for a block that is fixed or
 *  prescribed (Zheng et al. 2020, section 3.3). A line is a segment that reaches beyond the scene.
 *  The inside is at the left on the way from first to second, as along every edge of a counter-clockwise
 *  polygon: a floor under blocks runs towards -x, the walls of a container run clockwise.
 *  Segments may form a chain, each a block of its own: say what comes before and after, so that the flanks of
 *  the polygon go under the neighbours, 60 degrees steep to these. Then nothing stands out and no gap is left,
 *  and where two segments are in line their potentials add up to those of one. Springs per contact slow down
 *  what crosses a joint, by up to 2 k d^2 of its energy at a depth d: make what is straight one segment.
 *  Give hs_world_def.potential_length: these edges count in the mean that it is by default.
 *  @param context owner of the allocator
 *  @param before other end of the segment before; may be NULL: the flank then goes as if one came in line
 *  @param first where the segment begins, like all ends 3 values of which the last is not read
 *  @param second where it ends
 *  @param after other end of the segment after; may be NULL, likewise. Neither may lie straight back
 *  @param depth how far the polygon reaches behind the segment, > 0: above twice the deepest overlap, so that
 *         the segment is the nearest way out, and above what blocks cross in a step
 *  @param shape receives the shape; end it with hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (too large, too small or too thin to compute with) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_create_boundary(hs_context *context, const double before[3],
                                                const double first[3], const double second[3],
                                                const double after[3], double depth, hs_shape **shape);

/** @brief Cleans up a vertex list on request: drops repeated vertices and vertices on the line of their
 *  neighbours, and turns the order counter-clockwise. It reports what it changed and never moves a vertex.
 *  @param context for the error text
 *  @param vertices as found, in outline order
 *  @param tolerance distance, >= 0; 0 drops exact repetitions and what is straight to rounding
 *  @param cleaned receives the vertices; its count is the capacity, vertices.count always suffices
 *  @param count receives the number of vertices that remain
 *  @param report receives what was changed; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_clean(hs_context *context, hs_view vertices, double tolerance,
                                      hs_mutable_view cleaned, int64_t *count, hs_clean_report *report);

/** @brief Says what is wrong with a polyhedron's vertices and faces without making a shape.
 *  @param context for the error text
 *  @param vertices the corners
 *  @param face_sizes number of vertices of each face, >= 0; face_count values
 *  @param face_count number of faces, >= 0
 *  @param face_vertices the faces one after the other: indices of their vertices in the order of their
 *         outlines, all faces counter-clockwise seen from outside, or all clockwise; as many values as the
 *         sizes add up to
 *  @param fault receives the first fault, or HS_FAULT_NONE
 *  @return HS_OK (also when there is a fault), HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_check(hs_context *context, hs_view vertices, const int32_t face_sizes[],
                                         int64_t face_count, const int32_t face_vertices[], hs_fault *fault);

/** @brief Makes a convex polyhedron. Nothing is welded, merged or repaired: faulty input is refused with its
 *  reason. Faces may have any number of vertices, all in one plane to rounding; two neighbours in one plane
 *  are refused, as they are one face. Small edges and small angles are legal.
 *  @param context owner of the allocator
 *  @param vertices,face_sizes,face_count,face_vertices as for hs_polyhedron_check()
 *  @param shape receives the shape, its vertices and faces in the order given; end it with hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text names fault, face and vertex) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_create(hs_context *context, hs_view vertices, const int32_t face_sizes[],
                                          int64_t face_count, const int32_t face_vertices[],
                                          hs_shape **shape);

/** @brief Makes the convex hull of points as a polyhedron, with whole faces: what is in one plane to rounding
 *  is one face. While it works, it takes memory from malloc as well, for qhull.
 *  @param context owner of the allocator
 *  @param points any order, inner and repeated points allowed; at most 2^26
 *  @param shape receives the shape, whose vertices are points, in their order
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (all in one plane, out of range, or so close to
 *          degenerate that rounding hides the hull) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_create_hull(hs_context *context, hs_view points, hs_shape **shape);

/** @brief Makes a polyhedron of facets that are plane and convex within a tolerance, such as a file states
 *  them by a few digits. Facets whose vertices lie within the tolerance of a common plane are one face, its
 *  plane is fitted by least squares, and the shape is what the fitted half-spaces have in common. Each vertex
 *  given lies within the tolerance of the planes of its facets, and in front of none by more. A corner may
 *  move farther than that where planes meet at a small angle: see the report. Shapes that are plane and convex
 *  to rounding keep their vertices. Memory as for the hull.
 *  @param context owner of the allocator
 *  @param vertices the corners; they may lie within an edge or a face
 *  @param face_sizes,face_count,face_vertices the facets, as for hs_polyhedron_check(). Without any, those of
 *         the convex hull are taken
 *  @param tolerance distance, >= 0; 0 is for rounding alone. 2 units of the last digit of a file are above the
 *         rounding of its vertices
 *  @param shape receives the shape
 *  @param report receives the changes, or the place of a fault of the geometry; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text names the largest dent, its place and a
 *          tolerance that would do, or another fault) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_create_fitted(hs_context *context, hs_view vertices,
                                                 const int32_t face_sizes[], int64_t face_count,
                                                 const int32_t face_vertices[], double tolerance,
                                                 hs_shape **shape, hs_fit_report *report);

/** @brief Makes the polyhedron that half-spaces have in common. A half-space that cuts nothing off but
 *  rounding makes no face, so that the shape's face_count may be below their number. Memory as for the hull.
 *  @param context owner of the allocator
 *  @param normals outer normals, of any length but 0: p is inside when dot(normal, p) <= offset; at most 2^26
 *  @param offsets one per normal
 *  @param shape receives the shape, in the coordinates of the half-spaces
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text says what keeps them from bounding a region,
 *          or names the half-space that is faulty) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_create_from_halfspaces(hs_context *context, hs_view normals,
                                                          const double offsets[], hs_shape **shape);

/** @brief Cuts a shape by a plane (a line in 2D) into two.
 *  Coordinates are those the shape was made from, and so are those of the parts. In 3D the new face is the
 *  last of either part. A part that the plane touches only to rounding is none, and one so thin that rounding
 *  leaves no valid shape of it; the other part is then a copy of the whole. One of both there always is.
 *  @param shape what to cut; it stays as it is
 *  @param point a point of the plane, 3 values; the nearer to the shape, the smaller the rounding
 *  @param normal the plane's normal, 3 values, any length but 0
 *  @param behind receives the part against the normal, or NULL if there is none
 *  @param ahead receives the part along the normal, or NULL if there is none
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (2D: a part too small to compute with) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_shape_cut(const hs_shape *shape, const double point[3], const double normal[3],
                                  hs_shape **behind, hs_shape **ahead);

/** @brief Geometry and mass properties.
 *  @param shape not NULL
 *  @param properties receives them; what this library does not know of a longer struct is 0
 *  @param size sizeof(hs_shape_properties) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_properties(const hs_shape *shape, hs_shape_properties *properties,
                                             size_t size);

/** @brief The vertices in the coordinates the shape was made from; in 2D counter-clockwise.
 *  @param shape not NULL
 *  @param vertices receives them; its count is the capacity
 *  @param count receives the number of vertices; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_vertices(const hs_shape *shape, hs_mutable_view vertices, int64_t *count);

/** @brief The faces as lists of vertices, counter-clockwise seen from outside; in 2D each edge with its two
 *  ends. Face f has the vertices face_vertices[first_of_face[f]] to face_vertices[first_of_face[f + 1]], the
 *  latter excluded.
 *  @param shape not NULL
 *  @param first_of_face receives hs_shape_properties.face_count + 1 values; may be NULL if its capacity is 0
 *  @param face_capacity in values of first_of_face
 *  @param face_vertices receives the lists; may be NULL if its capacity is 0
 *  @param vertex_capacity in values of face_vertices
 *  @param face_count receives the number of faces; may be NULL
 *  @param vertex_count receives the length of all lists, 2 * hs_shape_properties.edge_count; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_faces(const hs_shape *shape, int32_t first_of_face[], int64_t face_capacity,
                                        int32_t face_vertices[], int64_t vertex_capacity, int64_t *face_count,
                                        int64_t *vertex_count);

/** @brief The edges by which HS_PAIR_EDGE_EDGE names them: the vertices at their two ends.
 *  @param shape not NULL
 *  @param edge_vertices receives start and end of each, 2 * capacity values; may be NULL if capacity is 0
 *  @param capacity in edges
 *  @param count receives the number of edges; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_edges(const hs_shape *shape, int32_t edge_vertices[], int64_t capacity,
                                        int64_t *count);

/** @brief The half-spaces: p is inside when dot(normal, p) <= offset, with outer unit normals.
 *  Half-space i belongs to face i, that of a polygon to the edge from vertex i to vertex i + 1. The frame is
 *  the shape's own: the centroid is at the origin.
 *  @param shape not NULL
 *  @param normals receives the outer unit normals; its count is the capacity
 *  @param offsets receives the offsets, normals.count values; may be NULL
 *  @param count receives the number of half-spaces; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_halfspaces(const hs_shape *shape, hs_mutable_view normals, double offsets[],
                                             int64_t *count);

/** @brief Ends a shape. Blocks made from it keep their own copy.
 *  @param shape may be NULL */
HS_API void hs_shape_destroy(hs_shape *shape);

#ifdef __cplusplus
}
#endif
#endif
