/** @file
 *  @brief Compounds: concave blocks of several convex parts.
 *
 *  A compound is a block without vertices of its own. It has the mass and the inertia of its parts together,
 *  and is moved, loaded, read and removed like any block. Its parts are blocks that share its motion: they
 *  make its contacts, are in all lists of blocks after it unless slots of removed blocks are reused, and have
 *  a mass of 0 in hs_block_state. Functions that move, load or remove a single block refuse them, and those
 *  that set all poses or velocities skip them. Parts of one compound are never in contact. See
 *  docs/concepts/concave_blocks.md.
 *
 *  Thread rule: a compound belongs to its world.
 */
#ifndef HALFSPACE_COMPOUND_H
#define HALFSPACE_COMPOUND_H

#include "halfspace/shape.h"
#include "halfspace/status.h"
#include "halfspace/view.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @brief Fills a block definition with its defaults for a compound.
 *  @param def to fill @param size sizeof(hs_block_def) as the caller was compiled
 *  @param shapes of the parts, part_count pointers to shapes of one dimension
 *  @param poses of the parts in one frame, part_count poses; NULL: at the coordinates of their vertices. The
 *         centroid of all parts in this frame is the default position
 *  @param part_count >= 1
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_API hs_status hs_compound_def_init(hs_block_def *def, size_t size, const hs_shape *const shapes[],
                                      const hs_pose poses[], int64_t part_count);

/** @brief Adds a compound of convex parts of one material.
 *  @param world not NULL
 *  @param shapes of the parts, part_count pointers to shapes of the world's dimension
 *  @param poses of the parts in one frame, part_count poses; NULL: at the coordinates of their vertices. Parts
 *         may touch and may be apart; an overlap deeper than 1e-6 of the smaller part's radius is refused
 *  @param part_count from 1 to 2^20
 *  @param def from hs_compound_def_init(): kind HS_BLOCK_FIXED, HS_BLOCK_PRESCRIBED or HS_BLOCK_RIGID; its pose
 *         is that of the centroid of all parts, with the axes of their frame
 *  @param block receives the id of the compound
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID (material), HS_ERROR_GEOMETRY (parts that overlap) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_add_compound(hs_world *world, const hs_shape *const shapes[],
                                           const hs_pose poses[], int64_t part_count, const hs_block_def *def,
                                           hs_block *block);

/** @brief Returns the parts of a compound, in the order in which they were given.
 *  @param world not NULL @param block id
 *  @param parts receives their ids; may be NULL if capacity is 0 @param capacity in ids
 *  @param count receives the number of parts, 0 for other blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_compound_parts(const hs_world *world, hs_block block, hs_block parts[],
                                                 int64_t capacity, int64_t *count);

/** @brief Returns the compound of a part.
 *  @param world not NULL @param block id
 *  @param compound receives the id of the compound, or 0 for a block that is not a part
 *  @param part receives the index of the part, or -1; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_compound_of_block(const hs_world *world, hs_block block, hs_block *compound,
                                                    int32_t *part);

#ifdef __cplusplus
}
#endif
#endif
