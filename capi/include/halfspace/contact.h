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
  HS_CONTACT_NONE = 0,          /**< separated: one violated potential pair proves it */
  HS_CONTACT_VERTEX_VERTEX = 1, /**< the vertex meets an end of the edge */
  HS_CONTACT_VERTEX_EDGE = 2,   /**< the vertex meets the edge between its ends */
  HS_CONTACT_EDGE_EDGE = 3      /**< two edges parallel within the parallel angle */
};

/** Most points that a contact region has in 2D. */
enum { HS_CONTACT_POINTS_2D = 2 };

/** One contact, or the proof that there is none. The layout is frozen. Detection of single pairs leaves what has no meaning
 *  there as it was: ids and forces always, area and points when the blocks are separated. */
typedef struct hs_contact {
  uint64_t block_a;    /**< id, in a world */
  uint64_t block_b;    /**< id, in a world */
  int32_t type;        /**< an HS_CONTACT_ value */
  int32_t point_count; /**< points of the region, 0 when separated */
  int32_t edge_owner;  /**< whose edge is the contact plane: 0 block a, 1 block b */
  int32_t edge;        /**< index of that edge; when separated, the edge of the violated pair */
  int32_t vertex;      /**< the other block's vertex deepest behind it; -1 when separated: no vertex of the other block is
                            behind the edge, which is all of the proof */
  int32_t reserved;    /**< 0 */
  double normal[3];    /**< unit, from a to b */
  double gap;          /**< of the pair (edge, vertex) along the normal, or at the deeper end of an edge-edge region; < 0 is
                            overlap. When separated it is the
                            separation that proves the verdict: a lower bound of the distance. */
  double area;         /**< of the contact region: overlap length x unit thickness; 0 unless edge-edge */
  double points[2][3]; /**< points of the region on the contact plane, in the frame of the poses given */
  double gaps[2];      /**< gap at each point */
  double force[3];     /**< on block b, normal and shear together; in a world */
  double force_point[3]; /**< where the force acts */
  double normal_force; /**< compression > 0 */
  double shear_force;  /**< along the tangent (-normal[1], normal[0]), on block b */
} hs_contact;

#ifdef __cplusplus
}
#endif
#endif
