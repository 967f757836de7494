/** @file
 *  @brief Contacts by a law without a spring (HS_STIFFNESS_NONE): the points that are kept apart, and by which force.
 *
 *  Where a corner comes to a face, or in space an edge to an edge, both move on together from the moment of their touch on. The force
 *  between them is the one that it takes, so that there is no stiffness to choose, no overlap and no smaller time step. A touch is a blow
 *  without rebound between the masses that meet: two nodes of a mesh, which rebound by the elements behind them, or a rigid block as seen
 *  from the point, which does not rebound. See docs/concepts/reactions.md. Source: Li et al. 2015, sections 3 and 4.
 */
#ifndef HALFSPACE_REACTION_H
#define HALFSPACE_REACTION_H

#include "halfspace/contact.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Two points that are in touch by a law without a spring. */
typedef struct hs_reaction {
  uint64_t block_a;   /**< id of the block whose corner it is; of two edges that of the first */
  uint64_t block_b;   /**< id of the block whose face it is (in 2D its edge); of two edges that of the second */
  int32_t pair_kind;  /**< HS_PAIR_VERTEX_FACE or, in 3D, HS_PAIR_EDGE_EDGE */
  int32_t feature_a;  /**< index of block a's vertex; of two edges, of blocks of a mesh too, block a's edge */
  int32_t feature_b;  /**< index of block b's face (in 2D its edge) or edge */
  int32_t reserved;   /**< 0 */
  double point[3];    /**< where they touch */
  double normal[3];   /**< unit, outwards from block b */
  double force[3];    /**< on block a at the end of the last step, normal and shear together. In the step of the touch it is that of the
                           blow: the impulse that was left of it at the step's end, over half the step */
  double gap;         /**< > 0 apart: what rounding and turning have left */
  double touched_at;  /**< time of the touch, inside of a step */
} hs_reaction;

/** Contacts without springs in numbers. Later versions may append to it. */
typedef struct hs_reaction_report {
  int64_t reaction_count; /**< in touch now */
  int64_t touch_count;    /**< touches so far; a corner that slides from face to face touches anew */
  int64_t round_count;    /**< so far: how often all contacts of a kick have been gone through until none changed any more */
  double impact_loss;     /**< J, in 2D per unit thickness: lost so far where points met. It counts in the world's residual */
} hs_reaction_report;

/** @brief The contacts by laws without a spring at the end of the last step, sorted by block a, block b and features.
 *  @param world not NULL @param reactions receives them; may be NULL if capacity is 0 @param capacity in reactions
 *  @param count receives their number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_reactions(const hs_world *world, hs_reaction reactions[], int64_t capacity,
                                            int64_t *count);

/** @brief Their numbers, and the energy that touches have taken.
 *  @param world not NULL @param report receives them; what this library does not know of a longer struct is 0
 *  @param size sizeof(hs_reaction_report) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_reaction_report(const hs_world *world, hs_reaction_report *report, size_t size);

#ifdef __cplusplus
}
#endif
#endif
