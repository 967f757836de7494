/** @file
 *  @brief What a world was given: settings, materials, laws, tables and actions.
 *
 *  Each is returned as the function that gave it takes it, so that another world can be given the same. What
 *  has changed since is included: settings, laws and elasticities are those that were set last. Snapshots keep
 *  them all. Thread rule: as for the world.
 */
#ifndef HALFSPACE_DEFINITION_H
#define HALFSPACE_DEFINITION_H

#include "halfspace/action.h"
#include "halfspace/affine.h"
#include "halfspace/law.h"
#include "halfspace/status.h"
#include "halfspace/view.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @brief Returns the settings of a world, with gravity, damping and time step as they were set last. A world of
 *  the same settings is made by hs_world_create() of what this returns.
 *  @param world not NULL @param def receives them @param size sizeof(hs_world_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_def(const hs_world *world, hs_world_def *def, size_t size);

/** @brief Bulk: densities of all materials, by their index. Their count is the number of materials.
 *  @param world not NULL @param densities receives them, kg/m3; may be NULL if capacity is 0
 *  @param capacity in densities @param count receives the number of materials; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_densities(const hs_world *world, double densities[], int64_t capacity,
                                            int64_t *count);

/** @brief Returns the elasticity of a material.
 *  @param world not NULL @param material index
 *  @param elasticity receives it; its young_modulus is 0 if the material has none
 *  @param size sizeof(hs_elasticity_def) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_elasticity(const hs_world *world, int32_t material,
                                             hs_elasticity_def *elasticity, size_t size);

/** @brief Returns the law of all pairs of materials without a law of their own. Strengths are those that were
 *  given, before division by the factor of hs_world_set_strength_factor().
 *  @param world not NULL @param law receives it @param size sizeof(hs_law_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_default_law(const hs_world *world, hs_law_def *law, size_t size);

/** @brief Returns the law of two materials, in either order: their own, or the default law. Strengths are those
 *  that were given, before division by the factor of hs_world_set_strength_factor().
 *  @param world not NULL @param material_a,material_b indices, may be the same @param law receives it
 *  @param size sizeof(hs_law_def) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_law(const hs_world *world, int32_t material_a, int32_t material_b,
                                      hs_law_def *law, size_t size);

/** @brief Returns the rows of a table.
 *  @param world not NULL @param table index from hs_world_add_table()
 *  @param times receives one per row, s; may be NULL if values.count is 0
 *  @param values receives one per row: its count is the capacity of both; without z, z is left out
 *  @param count receives the number of rows; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_table(const hs_world *world, int32_t table, double times[],
                                        hs_mutable_view values, int64_t *count);

/** @brief Bulk: the actions on a block, in the order in which they were added. Those that ended are left out. Where
 *  a later motion ended one along some axes, its scale is 0 there. A point of HS_PLACE_CARRIED is where it is now,
 *  to rounding.
 *  @param world not NULL @param block id, or 0: actions on all blocks
 *  @param actions receives them; may be NULL if capacity is 0
 *  @param size sizeof(hs_action_def) as the caller was compiled @param capacity in actions
 *  @param count receives the number of actions; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_actions(const hs_world *world, hs_block block, hs_action_def actions[],
                                          size_t size, int64_t capacity, int64_t *count);

#ifdef __cplusplus
}
#endif
#endif
