/** @file
 *  @brief Contact of one pair of blocks: type, region and force.
 */
#ifndef HALFSPACE_CONTACT_H
#define HALFSPACE_CONTACT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Contact types (Wang et al. 2021, section 2.5). */
enum {
  HS_CONTACT_NONE = 0,          /**< separated: a violated potential contact pair or a separating plane proves
                                     it */
  HS_CONTACT_VERTEX_VERTEX = 1, /**< a vertex touches a vertex; in 2D an end of the edge */
  HS_CONTACT_VERTEX_EDGE = 2,   /**< a vertex touches the interior of an edge */
  HS_CONTACT_EDGE_EDGE = 3,     /**< 2D: edges parallel within the parallel angle; 3D: edges that cross */
  HS_CONTACT_EDGE_FACE = 4,     /**< 3D: an edge and a face parallel within the parallel angle */
  HS_CONTACT_FACE_FACE = 5,     /**< 3D: two faces parallel within the parallel angle */
  HS_CONTACT_VERTEX_FACE = 6    /**< 3D: a vertex touches the interior of a face */
};

/** Kinds of potential contact pairs, by the features of the two blocks. In 2D an edge takes the place of a
 *  face. */
enum {
  HS_PAIR_FACE_VERTEX = 0,  /**< a face of block a (2D: an edge), a vertex of block b */
  HS_PAIR_VERTEX_FACE = 1,  /**< a vertex of block a, a face of block b (2D: an edge) */
  HS_PAIR_EDGE_EDGE = 2,    /**< 3D: one edge of each block */
  HS_PAIR_VERTEX_VERTEX = 3 /**< 3D, separated only: the vertices closest to a separating plane */
};

/** Max number of points of a contact region (2 in 2D). In 3D a region with more corners returns those that
 *  are farthest in 8 directions, equally spaced in the contact plane. */
enum { HS_CONTACT_POINTS = 8 };

/** One contact, or the proof of separation. Points and directions are in the frame of the given poses.
 *  Detection of single pairs does not write fields that have no meaning there: ids, forces, torque and twist;
 *  `area` and all later fields if the blocks are separated or hs_pair_options.without_region is 1; points
 *  and gaps beyond `point_count`. */
typedef struct hs_contact {
  uint64_t block_a;    /**< id, in a world */
  uint64_t block_b;    /**< id, in a world */
  int32_t type;        /**< an HS_CONTACT_ value */
  int32_t point_count; /**< number of points of the region; 0 when separated */
  int32_t pair_kind;   /**< an HS_PAIR_ value, of the pair that defines the contact plane; when separated, of
                            the violated pair */
  int32_t feature_a;   /**< index of block a's vertex, edge or face in that pair; -1 for the vertex when a
                            face separates the blocks, as no vertex is behind it */
  int32_t feature_b;   /**< index of block b's feature, likewise */
  int32_t reserved;    /**< 0 */
  double normal[3];    /**< unit vector from a to b */
  double gap;          /**< signed distance along the normal at the deepest point, m; < 0 is overlap. When
                            separated, a lower bound of the distance */
  double area;         /**< area of an edge-edge region in 2D (length times unit thickness) or of a face-face
                            region in 3D; else 0 */
  double length;       /**< length of an edge-edge region in 2D or of an edge-face region in 3D; else 0 */
  double center[3];    /**< centroid of the region, on the contact plane */
  double center_gap;   /**< gap at the center */
  double points[HS_CONTACT_POINTS][3]; /**< corners of the region, on the contact plane; in 3D
                                            counter-clockwise about the normal */
  double gaps[HS_CONTACT_POINTS];      /**< gap at each point */
  double force[3];       /**< total contact force on block b, N; in a world */
  double torque[3];      /**< couple on block b in addition to the force at force_point, N m */
  double force_point[3]; /**< point of application of the force */
  double normal_force;   /**< N, compression > 0 */
  double shear_force[3]; /**< on block b, in the contact plane, N; without friction 0 to rounding */
  double twist;          /**< 3D: torque on block b about the normal, N m */
  double touched_at;     /**< time of first touch within a step, s, for laws without springs; else 0 */
} hs_contact;

#ifdef __cplusplus
}
#endif
#endif
