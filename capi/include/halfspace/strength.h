/** @file
 *  @brief Factor of safety by strength reduction (Zienkiewicz, Humpheson and Lewis 1975).
 *
 *  The tangent of the friction angle, the cohesion and the tensile strength of all laws and bonds are divided
 *  by one factor. The factor of safety is the largest one without failure. Thread rule: as for the world.
 */
#ifndef HALFSPACE_STRENGTH_H
#define HALFSPACE_STRENGTH_H

#include "halfspace/relax.h"
#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Settings of the search for the factor of safety. Fill it with hs_strength_def_init(). */
typedef struct hs_strength_def {
  uint32_t struct_size; /**< set by hs_strength_def_init() */
  int32_t reserved;     /**< 0 */
  double low;           /**< >= 1e-75: lower bound of the bracket, at which the world should be stable;
                             default 0.5 */
  double high;          /**< > low: upper bound, at which it should fail; default 5 */
  double resolution;    /**< > 0: width of the final bracket; default 0.005 */
  double ratio;         /**< > 0: unbalanced ratio of a stable world, see hs_relaxation_def; default 1e-5 */
  double max_displacement; /**< > 0: displacement of a block, divided by its size, that is failure; default
                                0.1 */
  int64_t max_steps;    /**< >= 1: a world not in equilibrium after these steps has failed; default 100000 */
} hs_strength_def;

/** Result of the search. Later versions may append to it. */
typedef struct hs_strength_report {
  double factor;         /**< factor of safety: midpoint of the final bracket */
  double low;            /**< lower bound of the bracket: stable, if stands_at_low */
  double high;           /**< upper bound of the bracket: failed, if falls_at_high */
  int32_t stands_at_low; /**< 1; 0: the world fails at def.low, and the search has ended there */
  int32_t falls_at_high; /**< 1; 0: the world is stable at def.high */
  int32_t trials;        /**< number of relaxations */
  int32_t reserved;      /**< 0 */
} hs_strength_report;

/** @brief Fills a search definition with its defaults.
 *  @param def to fill @param size sizeof(hs_strength_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_strength_def_init(hs_strength_def *def, size_t size);

/** @brief Divides the given friction (tangent of its angle), cohesion and tensile strength of all laws and bonds
 *  by a factor. Calls do not accumulate.
 *  @param world not NULL @param factor from 1e-75 to 1e75; 1 restores the given strengths, to rounding
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_strength_factor(hs_world *world, double factor);

/** @brief Computes the factor of safety by bisection. Each trial relaxes a copy of the world
 *  (hs_world_relax()) in which bonds can fail. The world, which should be in equilibrium, does not change.
 *  @param world not NULL @param def not NULL
 *  @param report receives the result @param size sizeof(hs_strength_report) as the caller was compiled
 *  @param fallen receives the last failed copy in its final state, or NULL if no trial failed; the caller
 *         destroys it with hs_world_destroy(); may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_OUT_OF_MEMORY, or HS_ERROR_STATE without blocks that move. A
 *         trial that becomes unstable has failed */
HS_CHECKED hs_status hs_world_find_strength_factor(const hs_world *world, const hs_strength_def *def,
                                                   hs_strength_report *report, size_t size,
                                                   hs_world **fallen);

#ifdef __cplusplus
}
#endif
#endif
