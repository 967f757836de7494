/** @file
 *  @brief Dynamic relaxation, and changes of a living world: settle it under its loads, then excavate, load or release.
 *
 *  Dynamic relaxation steps a world under strong damping until all forces are balanced (Cundall 1987,
 *  Underwood 1983). Its time has no physical meaning. Thread rule: as for the world.
 */
#ifndef HALFSPACE_RELAX_H
#define HALFSPACE_RELAX_H

#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The ratios by which forces are compared. */
enum {
  HS_UNBALANCED_MEAN = 0,   /**< all unbalanced forces over all forces: of cells, contacts, bonds, weight and loads */
  HS_UNBALANCED_LARGEST = 1 /**< the largest such ratio of a single block or node; where next to nothing acts, over the mean force */
};

/** The way in which a world is brought to rest. Fill it with hs_relaxation_def_init(). */
typedef struct hs_relaxation_def {
  uint32_t struct_size;  /**< set by hs_relaxation_def_init() */
  int32_t measure;       /**< an HS_UNBALANCED_ value; default HS_UNBALANCED_MEAN */
  double ratio;          /**< at which it is at rest, > 0; default 1e-5 */
  int64_t max_steps;     /**< >= 1; default 1000000 */
  double local_damping;  /**< [0, 1) meanwhile; default 0.1, beside adaptive damping; by itself 0.8 does best */
  int32_t is_adaptive;   /**< 1 (default): critical mass damping of the slowest motion, estimated while stepping
                              (Underwood 1983); or 0: the world's mass damping */
  int32_t hold_bonds;    /**< 1 (default): bonds do not fail while the world relaxes; or 0 */
} hs_relaxation_def;

/** The balance of a world. Later versions may append to it. */
typedef struct hs_balance {
  double mean;           /**< see HS_UNBALANCED_MEAN; 0 where no force acts */
  double largest;        /**< see HS_UNBALANCED_LARGEST */
  double largest_force;  /**< largest unbalanced force, N */
  int64_t steps;         /**< taken by hs_world_relax(); else 0 */
  hs_block largest_force_block; /**< the block that it acts on; of a node, a cell at the surface. 0: none */
} hs_balance;

/** @brief Fills a relaxation's definition with its defaults.
 *  @param def to fill @param size sizeof(hs_relaxation_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_relaxation_def_init(hs_relaxation_def *def, size_t size);

/** @brief Steps a world until it is at rest. Its own damping, and whether bonds are held, come back afterwards; at rest,
 *  velocities are set to 0.
 *  @param world not NULL @param def not NULL
 *  @param balance receives how balanced it is then; may be NULL @param size sizeof(hs_balance) as the caller was compiled
 *  @return HS_OK, HS_NOTE_NOT_AT_REST after def.max_steps, or what hs_world_step() returns: the world stays where it has come to */
HS_CHECKED hs_status hs_world_relax(hs_world *world, const hs_relaxation_def *def, hs_balance *balance, size_t size);

/** @brief How balanced a world is now. Takes as long as a step.
 *  @param world not NULL @param balance receives it @param size sizeof(hs_balance) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_get_balance(hs_world *world, hs_balance *balance, size_t size);

/** @brief Sets gravity from now on; what that changes of the energy is booked as outer work.
 *  @param world not NULL @param gravity 3 values, m/s2
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_gravity(hs_world *world, const double gravity[3]);

/** @brief Sets damping from now on.
 *  @param world not NULL @param local_damping [0, 1) @param mass_damping >= 0, 1/s; see hs_world_def
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_damping(hs_world *world, double local_damping, double mass_damping);

/** @brief Sets the time step from now on.
 *  @param world not NULL @param time_step > 0, s, or 0: def.safety times the stable one
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_time_step(hs_world *world, double time_step);

#ifdef __cplusplus
}
#endif
#endif
