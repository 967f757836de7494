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

/** Kinds of contact stiffness. */
enum {
  HS_STIFFNESS_PER_CONTACT = 0, /**< N/m, of a face on a face, distributed over springs at the corners of the
                                     region: 1/2 for a 2D vertex, 1/4 for a right-angled corner in 3D */
  HS_STIFFNESS_PER_AREA = 1,    /**< Pa/m: the owner of the contact face is a fluid, whose pressure, stiffness times
                                     depth, acts on the other block's surface; for aligned faces the force is
                                     stiffness times the overlap's area (3D: volume) */
  HS_STIFFNESS_POTENTIAL = 2,   /**< Pa: gradient of the energy of the overlap (Zheng et al. 2020, section 3).
                                     Potential: distance to the nearest face times stiffness /
                                     potential_length */
  HS_STIFFNESS_NONE = 3         /**< no spring: a unilateral constraint keeps blocks apart (Li et al. 2015).
                                     Stiffnesses and damping are ignored; blocks alone limit the time step */
};

/** Contact law: normal force by a penalty spring (Wang et al. 2021, section 3), a potential (Zheng et al.
 *  2020, section 3) or a unilateral constraint, with Mohr-Coulomb friction. Fill it with hs_law_def_init().
 *
 *  The force of a potential acts along its own line of action, which for aligned faces is the contact normal.
 *  Friction acts perpendicular to that line, at the centroid of the overlap. hs_contact reports the
 *  components of the total force along and perpendicular to the contact normal.
 *
 *  Friction on springs needs damping: without it friction feeds vibrations, and a block that friction could
 *  hold hops down a slope. Set both damping ratios to 0 for a rebound without loss. */
typedef struct hs_law_def {
  uint32_t struct_size;     /**< set by hs_law_def_init() */
  int32_t stiffness_kind;   /**< an HS_STIFFNESS_ value; default HS_STIFFNESS_PER_CONTACT */
  double normal_stiffness;  /**< N/m, Pa/m or Pa by stiffness_kind, > 0; default 1e9; ignored with
                                 HS_STIFFNESS_NONE */
  double shear_stiffness;   /**< N/m or Pa/m (potentials: N/m), >= 0; default 0: as normal_stiffness; ignored with
                                 HS_STIFFNESS_NONE */
  double friction_angle;    /**< rad, [0, pi/2); default 0 */
  double cohesion;          /**< Pa, >= 0; default 0; not with HS_STIFFNESS_POTENTIAL; of contacts that exist when
                                 a block's first step begins, flush faces among them, until they fail */
  double tensile_strength;  /**< Pa, >= 0; default 0; not with HS_STIFFNESS_POTENTIAL; of the same contacts as
                                 cohesion */
  double normal_damping;    /**< damping ratio along the normal (fraction of critical viscous damping), >= 0;
                                 default 0.1; ignored with HS_STIFFNESS_NONE */
  double shear_damping;     /**< damping ratio in shear (likewise), >= 0; default 0.1; ignored with
                                 HS_STIFFNESS_NONE */
  double restitution;       /**< coefficient of restitution of rigid blocks, [0, 1]; default 0; only with
                                 HS_STIFFNESS_NONE, without cohesion and tensile_strength */
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
