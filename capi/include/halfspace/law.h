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
  HS_STIFFNESS_PER_CONTACT = 0, /**< N/m of a face on a face, shared over the corners of the region, each a spring on its own:
                                     in 2D a vertex alone has half of it, in 3D the corner of a square a quarter */
  HS_STIFFNESS_PER_AREA = 1,    /**< Pa/m: the normal force is the stiffness times the overlap area behind the contact plane */
  HS_STIFFNESS_POTENTIAL = 2,   /**< Pa: the potential force of Zheng et al. 2020, section 3. A point inside a block has its distance to the
                                     nearest face as potential, times the stiffness over the world's `potential_length`; what two blocks
                                     share is pushed down both. The force is the gradient of an energy, whichever way the blocks meet. */
  HS_STIFFNESS_NONE = 3         /**< no spring: blocks are kept apart by just the force that does, from the moment of their touch on (Li et
                                     al. 2015). Stiffnesses and dampings count for nothing, and the stable time step is that of the blocks */
};

/** Normal force with Mohr-Coulomb friction, by a penalty spring or a potential. Fill it with hs_law_def_init(). Springs are
 *  those of Wang et al. 2021, section 3; potentials those of Zheng et al. 2020, section 3.
 *
 *  The potential force acts along a line of its own, which between faces that meet squarely is the contact's normal. Friction acts across
 *  that line, where it passes the centroid of what the blocks share. The normal and shear forces that hs_contact tells are the parts of
 *  the whole force along and across the contact's normal. Potentials hold nothing together: they take neither cohesion nor tensile
 *  strength.
 *
 *  The damping that a law has by default is there for friction: without any, friction on springs feeds the vibration of what it should
 *  hold, and a block on a slope that is not steep enough for it to slide hops down. Set both dampings to 0 for bounces without loss. */
typedef struct hs_law_def {
  uint32_t struct_size;     /**< set by hs_law_def_init() */
  int32_t stiffness_kind;   /**< an HS_STIFFNESS_ value; default HS_STIFFNESS_PER_CONTACT */
  double normal_stiffness;  /**< > 0; N/m of a face on a face (a vertex is softer), Pa/m or Pa; default 1e9 */
  double shear_stiffness;   /**< >= 0; N/m or Pa/m, of potentials N/m; 0, the default: the same number as normal_stiffness */
  double friction_angle;    /**< rad, [0, pi/2); default 0 */
  double cohesion;          /**< Pa, >= 0; of contacts that exist when a block's first step begins, until they fail; default 0 */
  double tensile_strength;  /**< Pa, >= 0; likewise; default 0 */
  double normal_damping;    /**< share of critical viscous damping, >= 0; default 0.1 */
  double shear_damping;     /**< share of critical viscous damping, >= 0; default 0.1 */
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
