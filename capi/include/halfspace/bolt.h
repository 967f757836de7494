/** @file
 *  @brief Bolts and cables: lines between two places that blocks carry, or between a block and the ground.
 *
 *  A bolt transmits an axial force along the line between the current positions of its places. The tension is
 *  the stiffness times the elastic elongation; at the yield force the bolt elongates plastically, and beyond the
 *  rupture elongation it transmits nothing more. A bolt does not prevent the contact of its blocks. See
 *  docs/concepts/bolts.md. Thread rule: as for the world.
 */
#ifndef HALFSPACE_BOLT_H
#define HALFSPACE_BOLT_H

#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Properties of a bolt: an axial force, linear in its elongation. In 2D forces are per unit thickness. Fill it
 *  with hs_bolt_def_init(). */
typedef struct hs_bolt_def {
  uint32_t struct_size;      /**< set by hs_bolt_def_init() */
  int32_t is_tension_only;   /**< 1: slack instead of compressed, as a cable; 0: bears compression, too, as a
                                  strut; default 1 */
  hs_block block_a;          /**< carries place_a; 0 (default): the ground, place_a stays */
  hs_block block_b;          /**< carries place_b; 0 (default): the ground, place_b stays */
  double place_a[3];         /**< current position of the end, m; it may be outside of the block */
  double place_b[3];         /**< current position of the other end, m; not at place_a */
  double stiffness;          /**< N/m, > 0: force per elongation; default 1e8 */
  double pretension;         /**< N: current tension; default 0; below 0 only where it bears compression */
  double yield_force;        /**< N, >= 0: max magnitude of the force; default 0: does not yield */
  double rupture_elongation; /**< m, elongation from the unstressed length, above pretension / stiffness, beyond
                                  which it ruptures; default 0: does not rupture */
} hs_bolt_def;

/** Current state of a bolt. */
typedef struct hs_bolt {
  int64_t number;            /**< number that hs_world_add_bolt() has returned */
  hs_block block_a;          /**< 0: the ground */
  hs_block block_b;          /**< 0: the ground */
  double place_a[3];         /**< current position of the end, m */
  double place_b[3];         /**< current position of the other end, m */
  double tension;            /**< N, at the last evaluation of forces */
  double elongation;         /**< m, from the unstressed length, at the last evaluation of forces */
  double plastic_elongation; /**< m, part of elongation */
  double strain_energy;      /**< J, current */
  double loss;               /**< J, dissipated by yield and rupture */
  int32_t is_ruptured;       /**< 1: transmits nothing more */
  int32_t reserved;          /**< 0 */
} hs_bolt;

/** @brief Fills a bolt definition with its defaults.
 *  @param def to fill @param size sizeof(hs_bolt_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_bolt_def_init(hs_bolt_def *def, size_t size);

/** @brief Adds a bolt. Its energy of pretension is external work. The removal of a block removes its bolts.
 *  @param world not NULL @param def not NULL
 *  @param number receives the number of the bolt, >= 0, which no later bolt gets; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, HS_ERROR_OUT_OF_MEMORY, or HS_ERROR_STATE if neither
 *         block moves */
HS_CHECKED hs_status hs_world_add_bolt(hs_world *world, const hs_bolt_def *def, int64_t *number);

/** @brief Removes a bolt.
 *  @param world not NULL @param number of the bolt
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_STALE_ID if there is no such bolt */
HS_CHECKED hs_status hs_world_remove_bolt(hs_world *world, int64_t number);

/** @brief Bulk: all bolts, in ascending order of their numbers.
 *  @param world not NULL @param bolts receives them; may be NULL if capacity is 0 @param capacity in bolts
 *  @param count receives the number of bolts; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_bolts(const hs_world *world, hs_bolt bolts[], int64_t capacity,
                                        int64_t *count);

/** @brief Finds the block that contains a place, such as the end of a bolt.
 *  @param world not NULL @param place 3 values, m
 *  @param block receives the block in which the place is deepest, or 0 if it is outside of all blocks; of
 *         meshes, only cells at the surface are blocks, of a compound its parts
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_block_at(const hs_world *world, const double place[3], hs_block *block);

#ifdef __cplusplus
}
#endif
#endif
