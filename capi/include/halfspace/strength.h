/** @file
 *  @brief The factor of safety by strength reduction: how many times weaker all materials could be until something moves (Zienkiewicz,
 *  Humpheson and Lewis 1975).
 *
 *  Friction (its tangent), cohesion and tensile strength of all laws and bonds are divided by one factor. Thread rule: as for the world.
 */
#ifndef HALFSPACE_STRENGTH_H
#define HALFSPACE_STRENGTH_H

#include "halfspace/relax.h"
#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The search for the factor of safety. Fill it with hs_strength_def_init(). */
typedef struct hs_strength_def {
  uint32_t struct_size; /**< set by hs_strength_def_init() */
  int32_t reserved;     /**< 0 */
  double low;           /**< >= 1e-75: a factor at which the world should stand; default 0.5 */
  double high;          /**< above low: one at which it should fall; default 5 */
  double resolution;    /**< > 0: the bracket that is narrow enough; default 0.005 */
  double ratio;         /**< > 0: unbalanced forces at which a world stands, see hs_relaxation_def; default 1e-5 */
  double max_displacement; /**< > 0: displacement of a block, over its size, that counts as failure; default 0.1 */
  int64_t max_steps;    /**< >= 1: a world that is not at rest by then has failed; default 100000 */
} hs_strength_def;

/** The result of that search. Later versions may append to it. */
typedef struct hs_strength_report {
  double factor;         /**< the middle of the bracket */
  double low;            /**< the world stands at it, if stands_at_low */
  double high;           /**< the world falls at it, if falls_at_high */
  int32_t stands_at_low; /**< 1; or 0: it falls even at def.low, and nothing else was tried */
  int32_t falls_at_high; /**< 1; or 0: it stands even at def.high */
  int32_t trials;        /**< worlds tried */
  int32_t reserved;      /**< 0 */
} hs_strength_report;

/** @brief Fills a search's definition with its defaults.
 *  @param def to fill @param size sizeof(hs_strength_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_strength_def_init(hs_strength_def *def, size_t size);

/** @brief Divides all strengths, as they were given, by a factor, from now on.
 *  @param world not NULL @param factor from 1e-75 to 1e75; 1 gives them back but for rounding
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_strength_factor(hs_world *world, double factor);

/** @brief Looks for the factor of safety by bisection. Each trial relaxes a copy of the world, see hs_world_relax(), with bonds that may
 *  fail: the world stays as it is. It should be at rest.
 *  @param world not NULL @param def not NULL
 *  @param report receives what was found @param size sizeof(hs_strength_report) as the caller was compiled
 *  @param fallen receives the copy that fell last, as it was then, or NULL where none did: its velocities and bond events show how; end it
 *         with hs_world_destroy(); may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_OUT_OF_MEMORY, or HS_ERROR_STATE without blocks that move. A trial that becomes unstable has
 *          fallen */
HS_CHECKED hs_status hs_world_find_strength_factor(const hs_world *world, const hs_strength_def *def, hs_strength_report *report,
                                                   size_t size, hs_world **fallen);

#ifdef __cplusplus
}
#endif
#endif
