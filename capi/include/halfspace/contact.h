/** @file
 *  @brief What detection and force say of one pair of blocks.
 */
#ifndef HALFSPACE_CONTACT_H
#define HALFSPACE_CONTACT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Contact types (Wang et al. 2021, section 2.5). */
enum {
  HS_CONTACT_NONE = 0,          /**< separated: one violated potential pair, or a plane between, proves it */
  HS_CONTACT_VERTEX_VERTEX = 1, /**< a vertex meets a vertex; in 2D an end of the edge */
  HS_CONTACT_VERTEX_EDGE = 2,   /**< a vertex meets an edge between its ends */
  HS_CONTACT_EDGE_EDGE = 3,     /**< 2D: edges parallel within the parallel angle; 3D: edges that cross */
  HS_CONTACT_EDGE_FACE = 4,     /**< 3D: an edge and a face parallel within the parallel angle */
  HS_CONTACT_FACE_FACE = 5,     /**< 3D: two faces parallel within the parallel angle */
  HS_CONTACT_VERTEX_FACE = 6    /**< 3D: a vertex meets a face between its edges */
};

/** Which features of the two blocks make a potential contact pair. In 2D an edge is what a face is in 3D. */
enum {
  HS_PAIR_FACE_VERTEX = 0,  /**< a face of block a (2D: an edge), a vertex of block b */
  HS_PAIR_VERTEX_FACE = 1,  /**< a vertex of block a, a face of block b (2D: an edge) */
  HS_PAIR_EDGE_EDGE = 2,    /**< 3D: an edge of each */
  HS_PAIR_VERTEX_VERTEX = 3 /**< 3D, separated only: the vertices nearest to a plane between the blocks */
};

/** Most points that are given of a contact region: 2 in 2D; in 3D, of a region with more corners, those that
 *  lie farthest in as many directions spread evenly round the contact plane. */
enum { HS_CONTACT_POINTS = 8 };

/** One contact, or the proof that there is none. Points are in the frame of the poses given, directions in
 *  its orientation. Detection of single pairs leaves what has no meaning there as it was: ids, forces, torque
 *  and twist always; `area` and all that follows it when the blocks are separated or no region was asked for; points and gaps past
 *  `point_count`. */
typedef struct hs_contact {
  uint64_t block_a;    /**< id, in a world */
  uint64_t block_b;    /**< id, in a world */
  int32_t type;        /**< an HS_CONTACT_ value */
  int32_t point_count; /**< points of the region, 0 when separated */
  int32_t pair_kind;   /**< an HS_PAIR_ value: of the pair whose half-space is the contact plane; separated:
                            of the violated pair */
  int32_t feature_a;   /**< index of block a's vertex, edge or face in that pair. When a face separates, the
                            vertex is -1: none is behind the face, which is all of the proof */
  int32_t feature_b;   /**< index of block b's, likewise */
  int32_t reserved;    /**< 0 */
  double normal[3];    /**< unit, from a to b */
  double gap;          /**< of the pair along the normal, or at the deepest point of the region; < 0 is
                            overlap. When separated it is the separation that proves the verdict: a lower
                            bound of the distance. */
  double area;         /**< 2D: overlap length of an edge-edge region times unit thickness; 3D: of a face-face
                            region; else 0 */
  double length;       /**< overlap length; 2D: of an edge-edge region; 3D: of an edge-face region; else 0 */
  double center[3];    /**< centroid of the region, on the contact plane */
  double center_gap;   /**< gap there */
  double points[HS_CONTACT_POINTS][3]; /**< of the region, on the contact plane; 3D: its corners,
                                            counter-clockwise about the normal */
  double gaps[HS_CONTACT_POINTS];      /**< gap at each point */
  double force[3];       /**< on block b, normal and shear together; in a world */
  double torque[3];      /**< couple on block b besides the force, about force_point */
  double force_point[3]; /**< where the force acts */
  double normal_force;   /**< compression > 0 */
  double shear_force[3]; /**< in the contact plane, on block b; without friction 0 to rounding */
  double twist;          /**< 3D: torque about the normal, on block b */
  double touched_at;     /**< s: time of the touch, inside of a step, by a law without springs; else 0 */
} hs_contact;

#ifdef __cplusplus
}
#endif
#endif
