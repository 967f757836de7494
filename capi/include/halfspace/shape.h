/** @file
 *  @brief Convex shapes: validation, creation, cleaning, convex hull, cutting, mass properties, half-spaces.
 *
 *  A shape may be used by any number of blocks; only hs_shape_set_vertices() changes it. The origin of its
 *  frame is its centroid; hs_shape_properties.centroid is the centroid in the coordinates that the shape was
 *  made from, or last set.
 *
 *  Thread rule: several threads may use the same shapes at once in functions that take them as const, in this
 *  header, pair.h, impact.h and query.h, while no other changes or destroys them and the allocator of their
 *  context may be called by several threads, as the default one may. If several calls fail at once, the text
 *  of the last error is that of one of them, or mixed.
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

/** Opaque convex polygon (2D) or polyhedron (3D). */
typedef struct hs_shape hs_shape;

/** Faults of the input of a shape. */
enum {
  HS_FAULT_NONE = 0,                  /**< a valid convex polygon or polyhedron */
  /* Vertices of a polygon. */
  HS_FAULT_TOO_FEW_VERTICES = 1,      /**< fewer than 3 vertices */
  HS_FAULT_NOT_FINITE = 2,            /**< a vertex is NaN, infinite, or out of range */
  HS_FAULT_REPEATED_VERTEX = 3,       /**< two neighbour vertices coincide */
  HS_FAULT_COLLINEAR_VERTEX = 4,      /**< a vertex is collinear with its neighbours, to rounding */
  HS_FAULT_NOT_CONVEX = 5,            /**< a reflex vertex */
  HS_FAULT_SELF_CROSSING = 6,         /**< the outline winds more than once or crosses itself */
  HS_FAULT_ZERO_AREA = 7,             /**< all vertices are collinear */
  /* Topology of a polyhedron. */
  HS_FAULT_FEWER_THAN_FOUR = 8,       /**< fewer than 4 vertices or faces */
  HS_FAULT_FACE_TOO_SHORT = 9,        /**< a face has fewer than 3 vertices */
  HS_FAULT_NO_SUCH_VERTEX = 10,       /**< a face has a vertex index out of range */
  HS_FAULT_VERTEX_TWICE_IN_FACE = 11, /**< a face uses a vertex twice */
  HS_FAULT_UNUSED_VERTEX = 12,        /**< a vertex belongs to no face */
  HS_FAULT_UNMATCHED_EDGE = 13,       /**< an edge is not shared by two faces in opposite directions */
  HS_FAULT_VERTEX_INSIDE_EDGE = 14,   /**< a vertex belongs to two faces only */
  HS_FAULT_NOT_ONE_SURFACE = 15,      /**< not one closed surface without holes */
  /* Geometry of a polyhedron. */
  HS_FAULT_OUT_OF_RANGE = 16,         /**< not finite, magnitude above 1e50, or total size below 1e-50 */
  HS_FAULT_COINCIDING_VERTICES = 17,  /**< two vertices coincide */
  HS_FAULT_ZERO_VOLUME = 18,          /**< all vertices are coplanar, to rounding */
  HS_FAULT_FACE_WITHOUT_AREA = 19,    /**< all vertices of a face are collinear, to rounding */
  HS_FAULT_FACE_NOT_PLANE = 20,       /**< a vertex is off the plane of its face by more than rounding */
  HS_FAULT_VERTEX_OUTSIDE_FACE = 21,  /**< a vertex is outside the plane of a face: not convex */
  HS_FAULT_COPLANAR_FACES = 22,       /**< two neighbour faces are coplanar, to rounding */
  /* Convex hull, and intersection of half-spaces. */
  HS_FAULT_HULL_FAILED = 23,          /**< nearly degenerate points: rounding prevents their hull */
  HS_FAULT_NO_DIRECTION = 24,         /**< the normal of a half-space is 0 */
  HS_FAULT_UNBOUNDED = 25,            /**< the intersection of the half-spaces is unbounded */
  HS_FAULT_NO_COMMON_POINT = 26,      /**< the intersection is empty, or flat to rounding */
  /* Fit within a tolerance. */
  HS_FAULT_BEYOND_TOLERANCE = 27      /**< a dent is deeper than the tolerance */
};

/** First fault of an input. */
typedef struct hs_fault {
  int32_t kind;     /**< an HS_FAULT_ value */
  int32_t reserved; /**< 0 */
  int64_t vertex;   /**< index of the faulty vertex in the caller's list; -1: the whole */
  int64_t face;     /**< index of the faulty face in the caller's list; -1: none */
} hs_fault;

/** Geometry and mass properties per unit density. Later versions may append to it. */
typedef struct hs_shape_properties {
  int32_t dimension;        /**< 2 or 3 */
  int32_t reserved;         /**< 0 */
  int64_t vertex_count;     /**< >= 3; in 3D >= 4 */
  int64_t edge_count;       /**< >= 3; in 3D >= 6 */
  int64_t face_count;       /**< half-spaces: faces, in 2D edges */
  double volume;            /**< m3; in 2D area times unit thickness */
  double centroid[3];       /**< in the coordinates that the shape was made from, m */
  double second_moment[6];  /**< integral of r r^T about the centroid: xx, yy, zz, xy, yz, zx; 2D: xx, yy, 0,
                                 xy, 0, 0. Moment of inertia about z: density times (xx + yy) */
  double bounding_radius;   /**< max distance of a vertex from the centroid, m */
  double shortest_edge;     /**< length of the shortest edge, m */
} hs_shape_properties;

/** Changes by hs_polygon_clean(). */
typedef struct hs_clean_report {
  int64_t welded;       /**< vertices removed: within the tolerance of the previous vertex */
  int64_t straightened; /**< vertices removed: within the tolerance of their neighbours' line */
  int32_t reversed;     /**< 1: the order was reversed to counter-clockwise */
  int32_t reserved;     /**< 0 */
} hs_clean_report;

/** Changes by hs_polyhedron_create_fitted(), or the dent that it refuses. */
typedef struct hs_fit_report {
  hs_fault fault;              /**< HS_FAULT_NONE, or the fault; for a dent its deepest vertex */
  int64_t merged;              /**< number of facets minus number of faces */
  double deviation;            /**< max distance of a vertex from the fitted plane of its face, m; for a dent
                                    its depth below the convex hull, m */
  double moved;                /**< max displacement of a corner, m */
  double sufficient_tolerance; /**< for a dent: a tolerance that suffices (tested), m; 0: none */
} hs_fit_report;

/** @brief Validates the vertices of a polygon without making a shape.
 *  @param context keeps the error text
 *  @param vertices clockwise or counter-clockwise
 *  @param fault receives the first fault, or HS_FAULT_NONE
 *  @return HS_OK (also for a fault), HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_check(hs_context *context, hs_view vertices, hs_fault *fault);

/** @brief Creates a convex polygon. Faulty vertices are refused, not repaired. Short edges, small angles and
 *  any number of vertices are allowed.
 *  @param context allocates the shape and keeps error texts
 *  @param vertices clockwise or counter-clockwise, 3 or more, m
 *  @param shape receives the shape; the caller destroys it with hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text names fault and vertex) or
 *         HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_create(hs_context *context, hs_view vertices, hs_shape **shape);

/** @brief Creates the convex hull of points as a polygon.
 *  @param context allocates the shape and keeps error texts
 *  @param points in any order; inner and repeated points are allowed
 *  @param shape receives the shape; the caller destroys it with hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (collinear points) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_create_hull(hs_context *context, hs_view points, hs_shape **shape);

/** @brief Creates a boundary segment for a fixed or prescribed block: a virtual polygon with the segment as
 *  one edge (Zheng et al. 2020, section 3.3). Its inside is on the left of the direction from first to
 *  second: a floor runs towards -x, the walls of a container run clockwise. Segments of a chain are separate
 *  blocks; with `before` and `after` the flanks of the polygon lie under the neighbours, at 60 degrees,
 *  without gaps or protrusions. Potentials of collinear segments add up to that of one; springs per contact
 *  take up to 2 k d^2 of the energy of a block that crosses a joint at depth d, so make a straight line one
 *  segment. Set hs_world_def.potential_length, as its default includes these edges. See
 *  docs/concepts/boundaries.md.
 *  @param context allocates the shape and keeps error texts
 *  @param before other end of the previous segment; may be NULL: the flank is that of a collinear neighbour
 *  @param first start of the segment, 3 values, m; z of all ends is ignored
 *  @param second end of the segment, 3 values
 *  @param after other end of the next segment; may be NULL, likewise. The chain must not reverse its
 *         direction
 *  @param depth of the polygon behind the segment, m, > 0: more than twice the largest overlap and than the
 *         displacement of blocks per step
 *  @param shape receives the shape; the caller destroys it with hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (too large, too small or too thin) or
 *         HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_create_boundary(hs_context *context, const double before[3],
                                                const double first[3], const double second[3],
                                                const double after[3], double depth, hs_shape **shape);

/** @brief Cleans the vertices of a polygon: removes repeated and collinear vertices, and reverses a clockwise
 *  order. It moves no vertex.
 *  @param context keeps the error text
 *  @param vertices in outline order
 *  @param tolerance distance, m, >= 0; 0 removes exact repetitions and vertices collinear to rounding
 *  @param cleaned receives the remaining vertices; a capacity of vertices.count is sufficient
 *  @param count receives the number of remaining vertices
 *  @param report receives the changes; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polygon_clean(hs_context *context, hs_view vertices, double tolerance,
                                      hs_mutable_view cleaned, int64_t *count, hs_clean_report *report);

/** @brief Validates the vertices and faces of a polyhedron without making a shape.
 *  @param context keeps the error text
 *  @param vertices at most 2^26, m
 *  @param face_sizes number of vertices of each face, >= 0; face_count values
 *  @param face_count number of faces, from 0 to 2^26
 *  @param face_vertices vertex indices of the faces, face after face, in outline order; all faces
 *         counter-clockwise seen from outside, or all clockwise; sum of face_sizes values
 *  @param fault receives the first fault, or HS_FAULT_NONE
 *  @return HS_OK (also for a fault), HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_check(hs_context *context, hs_view vertices, const int32_t face_sizes[],
                                         int64_t face_count, const int32_t face_vertices[], hs_fault *fault);

/** @brief Creates a convex polyhedron. Faulty input is refused, not repaired. Faces may have any number of
 *  vertices, coplanar to rounding; coplanar neighbour faces are refused. Short edges and small angles are
 *  allowed.
 *  @param context allocates the shape and keeps error texts
 *  @param vertices,face_sizes,face_count,face_vertices as for hs_polyhedron_check()
 *  @param shape receives the shape, with vertices and faces in the given order; the caller destroys it with
 *         hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text names fault, face and vertex) or
 *         HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_create(hs_context *context, hs_view vertices, const int32_t face_sizes[],
                                          int64_t face_count, const int32_t face_vertices[],
                                          hs_shape **shape);

/** @brief Creates the convex hull of points as a polyhedron. Facets that are coplanar to rounding are merged
 *  into one face. Qhull uses malloc temporarily.
 *  @param context allocates the shape and keeps error texts
 *  @param points in any order, at most 2^26; inner and repeated points are allowed
 *  @param shape receives the shape; its vertices keep the order of the points; the caller destroys it with
 *         hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (coplanar, out of range, or nearly degenerate points)
 *         or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_create_hull(hs_context *context, hs_view points, hs_shape **shape);

/** @brief Creates a polyhedron from facets that are plane and convex within a tolerance, e.g. from a file
 *  with rounded coordinates. Facets whose vertices are within the tolerance of a common plane form one face,
 *  with a plane fitted by least squares; the shape is the intersection of the fitted half-spaces. Vertices
 *  are within the tolerance of the planes of their facets and at most that far outside all others. Corners
 *  between planes at a small angle may move farther (see the report). Shapes that are plane and convex to
 *  rounding keep their vertices. Memory as for hs_polyhedron_create_hull().
 *  @param context allocates the shape and keeps error texts
 *  @param vertices at most 2^26, m; they may lie inside an edge or a face
 *  @param face_sizes,face_count,face_vertices the facets, as for hs_polyhedron_check(); face_count 0: the
 *         facets of the convex hull
 *  @param tolerance distance, m, >= 0; 0 allows rounding only. For a file use 2 units of its last digit
 *  @param shape receives the shape; the caller destroys it with hs_shape_destroy()
 *  @param report receives the changes, or the fault of HS_ERROR_GEOMETRY; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text names the deepest dent, its vertex and a
 *         sufficient tolerance, or another fault) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_create_fitted(hs_context *context, hs_view vertices,
                                                 const int32_t face_sizes[], int64_t face_count,
                                                 const int32_t face_vertices[], double tolerance,
                                                 hs_shape **shape, hs_fit_report *report);

/** @brief Creates the intersection of half-spaces as a polyhedron. A half-space that is redundant to rounding
 *  makes no face, so face_count may be less than their number. Memory as for hs_polyhedron_create_hull().
 *  @param context allocates the shape and keeps error texts
 *  @param normals outer normals, of any length except 0, at most 2^26: p is inside if dot(normal, p) <=
 *         offset
 *  @param offsets one per normal
 *  @param shape receives the shape, in the coordinates of the half-spaces; the caller destroys it with
 *         hs_shape_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (unbounded, empty or flat intersection, or a faulty
 *         half-space, which the text names) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_polyhedron_create_from_halfspaces(hs_context *context, hs_view normals,
                                                          const double offsets[], hs_shape **shape);

/** @brief Cuts a shape by a plane (2D: a line) into two shapes. Coordinates are those that the shape was made
 *  from. In 3D the cut face is the last face of each part. If a part is empty or degenerate to rounding, it
 *  is NULL and the other part is a copy of the shape; at most one part is NULL.
 *  @param shape not NULL; it does not change
 *  @param point a point of the plane, 3 values, m; points close to the shape have less rounding error
 *  @param normal normal of the plane, 3 values, of any length except 0
 *  @param behind receives the part on the negative side of the normal, or NULL
 *  @param ahead receives the part on the positive side, or NULL; the caller destroys both parts
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (2D: a part is too small) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_shape_cut(const hs_shape *shape, const double point[3], const double normal[3],
                                  hs_shape **behind, hs_shape **ahead);

/** @brief Moves the vertices of a shape in place, for hosts whose bodies deform. The number of vertices and
 *  the faces stay, so pair caches remain valid; worlds keep the copies that they have. The new centroid,
 *  without rotation, is the pose at which the vertices are where they were given.
 *  @param shape not NULL
 *  @param vertices as many as hs_shape_get_vertices() returns, in that order, m; in 2D also in the reverse
 *         order. In 3D faces must be plane to rounding, and all faces counter-clockwise seen from outside
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY (the text names fault, vertex and face; the shape has
 *         not changed), or HS_ERROR_OUT_OF_MEMORY (only large shapes need memory) */
HS_CHECKED hs_status hs_shape_set_vertices(hs_shape *shape, hs_view vertices);

/** @brief Returns geometry and mass properties of a shape.
 *  @param shape not NULL
 *  @param properties receives them; fields unknown to this version of the library are 0
 *  @param size sizeof(hs_shape_properties) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_properties(const hs_shape *shape, hs_shape_properties *properties,
                                             size_t size);

/** @brief Returns the vertices, in the coordinates that the shape was made from; in 2D counter-clockwise.
 *  @param shape not NULL
 *  @param vertices receives them; its count is the capacity
 *  @param count receives the number of vertices; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_vertices(const hs_shape *shape, hs_mutable_view vertices, int64_t *count);

/** @brief Returns the faces as lists of vertex indices, counter-clockwise seen from outside; in 2D the two
 *  ends of each edge. Face f has the vertices face_vertices[i] for first_of_face[f] <= i < first_of_face[f +
 *  1].
 *  @param shape not NULL
 *  @param first_of_face receives hs_shape_properties.face_count + 1 values; may be NULL if its capacity is 0
 *  @param face_capacity in values of first_of_face
 *  @param face_vertices receives the lists; may be NULL if its capacity is 0
 *  @param vertex_capacity in values of face_vertices
 *  @param face_count receives the number of faces; may be NULL
 *  @param vertex_count receives the total length of the lists, 2 * hs_shape_properties.edge_count; may be
 *         NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_faces(const hs_shape *shape, int32_t first_of_face[], int64_t face_capacity,
                                        int32_t face_vertices[], int64_t vertex_capacity, int64_t *face_count,
                                        int64_t *vertex_count);

/** @brief Returns the edges as pairs of vertex indices. HS_PAIR_EDGE_EDGE uses their indices.
 *  @param shape not NULL
 *  @param edge_vertices receives start and end of each, 2 * capacity values; may be NULL if capacity is 0
 *  @param capacity in edges
 *  @param count receives the number of edges; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_edges(const hs_shape *shape, int32_t edge_vertices[], int64_t capacity,
                                        int64_t *count);

/** @brief Returns the half-spaces: p is inside if dot(normal, p) <= offset. Half-space i belongs to face i;
 *  in 2D to the edge from vertex i to i + 1. The origin of the frame is the centroid.
 *  @param shape not NULL
 *  @param normals receives the outer unit normals; its count is the capacity
 *  @param offsets receives the offsets, normals.count values; may be NULL
 *  @param count receives the number of half-spaces; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_shape_get_halfspaces(const hs_shape *shape, hs_mutable_view normals, double offsets[],
                                             int64_t *count);

/** @brief Destroys a shape. Blocks made from it have their own copies.
 *  @param shape may be NULL */
HS_API void hs_shape_destroy(hs_shape *shape);

#ifdef __cplusplus
}
#endif
#endif
