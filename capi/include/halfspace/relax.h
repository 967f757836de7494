/** @file
 *  @brief Dynamic relaxation to static equilibrium, and changes of gravity, damping and time step of an
 *  existing world.
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

/** Measures of the unbalanced ratio. */
enum {
  HS_UNBALANCED_MEAN = 0,   /**< sum of all unbalanced forces over sum of all forces (cells, contacts, bonds,
                                 weight, loads) */
  HS_UNBALANCED_LARGEST = 1 /**< largest ratio of a single block or node; for negligible forces relative to
                                 the mean force */
};

/** Settings of a dynamic relaxation. Fill it with hs_relaxation_def_init(). */
typedef struct hs_relaxation_def {
  uint32_t struct_size;  /**< set by hs_relaxation_def_init() */
  int32_t measure;       /**< an HS_UNBALANCED_ value; default HS_UNBALANCED_MEAN */
  double ratio;          /**< unbalanced ratio of equilibrium, > 0; default 1e-5 */
  int64_t max_steps;     /**< max number of steps, >= 1; default 1000000 */
  double local_damping;  /**< [0, 1); default 0.1, for adaptive damping; use 0.8 without it */
  int32_t is_adaptive;   /**< 1 (default): critical mass damping of the slowest mode, estimated while stepping
                              (Underwood 1983); 0: the world's mass damping */
  int32_t hold_bonds;    /**< 1 (default): bonds cannot fail during the relaxation; 0: they can */
} hs_relaxation_def;

/** Balance of forces of a world. Later versions may append to it. */
typedef struct hs_balance {
  double mean;           /**< see HS_UNBALANCED_MEAN; 0 without forces */
  double largest;        /**< see HS_UNBALANCED_LARGEST */
  double largest_force;  /**< largest unbalanced force, N */
  int64_t steps;         /**< steps done by hs_world_relax(); else 0 */
  hs_block largest_force_block; /**< block that largest_force acts on; for a node, one of its surface blocks;
                                     0: none */
} hs_balance;

/** @brief Fills a relaxation definition with its defaults.
 *  @param def to fill @param size sizeof(hs_relaxation_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_relaxation_def_init(hs_relaxation_def *def, size_t size);

/** @brief Steps a world until static equilibrium, then sets all velocities to 0. Damping and the state of
 *  hs_world_hold_bonds() are restored afterwards.
 *  @param world not NULL @param def not NULL
 *  @param balance receives the final balance; may be NULL
 *  @param size sizeof(hs_balance) as the caller was compiled
 *  @return HS_OK, HS_NOTE_NOT_AT_REST after def.max_steps, or the errors of hs_world_step(); the world keeps
 *         its last state */
HS_CHECKED hs_status hs_world_relax(hs_world *world, const hs_relaxation_def *def, hs_balance *balance,
                                    size_t size);

/** @brief Returns the current balance of forces. It costs as much as a step, and has no effect on the run.
 *  @param world not NULL @param balance receives it @param size sizeof(hs_balance) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE (a share, or within a step in pieces) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_get_balance(hs_world *world, hs_balance *balance, size_t size);

/** @brief Sets gravity. The change of potential energy counts as external work.
 *  @param world not NULL @param gravity 3 values, m/s2
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_gravity(hs_world *world, const double gravity[3]);

/** @brief Sets local and mass damping.
 *  @param world not NULL @param local_damping [0, 1) @param mass_damping >= 0, 1/s; see hs_world_def
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_damping(hs_world *world, double local_damping, double mass_damping);

/** @brief Sets the time step.
 *  @param world not NULL @param time_step s, > 0, or 0: hs_world_def.safety times the stable time step
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_time_step(hs_world *world, double time_step);

#ifdef __cplusplus
}
#endif
#endif
