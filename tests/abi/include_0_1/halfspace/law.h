/** @file
 *  @brief Contact laws between materials.
 */
#ifndef HALFSPACE_LAW_H
#define HALFSPACE_LAW_H

#include <stddef.h>

#include "halfspace/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a stiffness refers to. */
enum {
  HS_STIFFNESS_PER_CONTACT = 0, /**< N/m for the whole contact, shared over the points of its region */
  HS_STIFFNESS_PER_AREA = 1     /**< Pa/m: the normal force is the stiffness times the overlap area behind the contact plane */
};

/** Penalty spring with Mohr-Coulomb friction (Wang et al. 2021, section 3). Fill it with hs_law_def_init(). */
typedef struct hs_law_def {
  uint32_t struct_size;     /**< set by hs_law_def_init() */
  int32_t stiffness_kind;   /**< HS_STIFFNESS_PER_CONTACT (default) or HS_STIFFNESS_PER_AREA */
  double normal_stiffness;  /**< > 0; N/m or Pa/m; default 1e9 */
  double shear_stiffness;   /**< >= 0; N/m or Pa/m; default 1e9 */
  double friction_angle;    /**< rad, [0, pi/2); default 0 */
  double cohesion;          /**< Pa, >= 0; of contacts that exist when a block's first step begins, until they fail; default 0 */
  double tensile_strength;  /**< Pa, >= 0; likewise; default 0 */
  double normal_damping;    /**< share of critical viscous damping, >= 0; default 0 */
  double shear_damping;     /**< share of critical viscous damping, >= 0; default 0 */
} hs_law_def;

/** @brief Fills a law with its defaults.
 *  @param def to fill
 *  @param size sizeof(hs_law_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_law_def_init(hs_law_def *def, size_t size);

#ifdef __cplusplus
}
#endif
#endif
