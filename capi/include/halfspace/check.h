/** @file
 *  @brief Settings with unusual values: legal, but probably in another unit, as a density in t/m3.
 */
#ifndef HALFSPACE_CHECK_H
#define HALFSPACE_CHECK_H

#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Settings that have a usual range. */
enum {
  HS_SETTING_GRAVITY = 0,        /**< of a world, m/s2 */
  HS_SETTING_MASS_DAMPING = 1,   /**< of a world, 1/s */
  HS_SETTING_PARALLEL_ANGLE = 2, /**< of a world, rad */
  HS_SETTING_DENSITY = 3,        /**< of a material, kg/m3 */
  HS_SETTING_YOUNG_MODULUS = 4,  /**< of a material, Pa */
  HS_SETTING_POISSON_RATIO = 5,  /**< of a material */
  HS_SETTING_DAMPING_TIME = 6,   /**< of a material, s */
  HS_SETTING_NORMAL_STIFFNESS = 7, /**< of a law, N/m, Pa/m or Pa */
  HS_SETTING_SHEAR_STIFFNESS = 8,  /**< of a law, N/m or Pa/m */
  HS_SETTING_FRICTION_ANGLE = 9,   /**< of a law or a bond, rad */
  HS_SETTING_COHESION = 10,        /**< of a law or a bond, Pa */
  HS_SETTING_TENSILE_STRENGTH = 11, /**< of a law or a bond, Pa */
  HS_SETTING_NORMAL_DAMPING = 12,   /**< of a law or a bond, damping ratio */
  HS_SETTING_SHEAR_DAMPING = 13,    /**< of a law or a bond, damping ratio */
  HS_SETTING_BOND_NORMAL_STIFFNESS = 14, /**< Pa/m */
  HS_SETTING_BOND_SHEAR_STIFFNESS = 15,  /**< Pa/m */
  HS_SETTING_TENSILE_FRACTURE_ENERGY = 16, /**< of a bond, J/m2 */
  HS_SETTING_SHEAR_FRACTURE_ENERGY = 17,   /**< of a bond, J/m2 */
  HS_SETTING_VELOCITY = 18                 /**< of a block, m/s */
};

/** A setting with an unusual value. */
typedef struct hs_note {
  int32_t setting;    /**< an HS_SETTING_ value */
  int32_t material_a; /**< of a setting of a material or a law: index; -1: of the default law, and of others */
  int32_t material_b; /**< of a law of two materials: index of the second; -1: of others */
  int32_t reserved;   /**< 0 */
  hs_block block;     /**< of a setting of a block: id; 0: of others */
  double value;       /**< of the setting, in the unit of the setting; of a vector its length */
  double usual_low;   /**< smallest usual value but 0, which is usual, too */
  double usual_high;  /**< largest usual value */
} hs_note;

/** @brief Returns the usual range of a setting. 0 is usual, too.
 *  @param setting an HS_SETTING_ value
 *  @param low receives the smallest usual value, in the unit of the setting
 *  @param high receives the largest usual value
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_CHECKED hs_status hs_setting_get_usual(int32_t setting, double *low, double *high);

/** @brief Returns the usual range of a setting in words, e.g. "50 to 19500 kg/m3, 2700 of rock".
 *  @param setting any value; "" for those that are no HS_SETTING_ value
 *  @return a static string, never NULL; owned by the library. Thread rule: any thread, any time. */
HS_API const char *hs_setting_usual_text(int32_t setting);

/** @brief Bulk: notes on the settings of a world with unusual values: those of the world, of the default law, of
 *  materials, of laws of two materials, of blocks. Bonds are not looked at, as a world keeps no settings of them.
 *  @param world not NULL @param notes receives them; may be NULL if capacity is 0 @param capacity in notes
 *  @param count receives the number of notes; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT. Thread rule: as for the world. */
HS_CHECKED hs_status hs_world_check(const hs_world *world, hs_note notes[], int64_t capacity, int64_t *count);

#ifdef __cplusplus
}
#endif
#endif
