/** @file
 *  @brief Water below a table.
 *
 *  All faces of blocks below the table, joints included, bear the pressure
 *  factor * density * g * (height of the table - height), integrated exactly over the faces in their current
 *  positions. g is the component of gravity along -y in 2D, along -z in 3D. Contact forces are then effective,
 *  and no law changes. Water outside of blocks, as in a lake, is the same. Of meshes, the faces at the surface
 *  bear water. Fixed blocks bear none. See docs/concepts/water.md. Thread rule: as for the world.
 */
#ifndef HALFSPACE_WATER_H
#define HALFSPACE_WATER_H

#include "halfspace/status.h"
#include "halfspace/view.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Properties of water. Fill it with hs_water_def_init(). */
typedef struct hs_water_def {
  uint32_t struct_size; /**< set by hs_water_def_init() */
  int32_t columns;      /**< 3D: points in each row of a height map; default 0: the table is a plane */
  double density;       /**< kg/m3, >= 0; default 1000 */
  double factor;        /**< >= 0: multiplies the pressure; default 1 */
} hs_water_def;

/** @brief Fills a water definition with its defaults.
 *  @param def to fill @param size sizeof(hs_water_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_water_def_init(hs_water_def *def, size_t size);

/** @brief Sets the water of a world, in place of the water before. The change of energy is external work.
 *  @param world not NULL @param def not NULL
 *  @param table in 2D the corners of a polyline, in ascending order of x; it continues level beyond its ends,
 *         and two corners at the same x are a step. In 3D one point of a level plane, three points of a plane
 *         that is not vertical, or a height map: rows of def->columns points above a rectangular grid, in
 *         ascending order of y, in each row of x. A cell between four points is two triangles, divided from its
 *         smallest to its largest coordinates; beyond the grid heights are those at its border. Without points
 *         there is no water
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_set_water(hs_world *world, const hs_water_def *def, hs_view table);

/** @brief Bulk: the current loads of water on all blocks.
 *  @param world not NULL
 *  @param forces receives the force on each block, N, in the order of hs_world_get_blocks()
 *  @param torques receives the torques about the centroids, N m; may be empty
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_get_water_loads(const hs_world *world, hs_mutable_view forces,
                                              hs_mutable_view torques);

#ifdef __cplusplus
}
#endif
#endif
