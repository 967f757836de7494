/** @file
 *  @brief Bonds: blocks of any kind hold together along their common faces until their strength is reached (Wang et al. 2021, section 3).
 *
 *  A bond has springs across and along the face at its integration points: in 2D at both ends (a sixth of the face each) and in the
 *  middle; in 3D at corners, middles of sides and centroids of the triangles that the common polygon is cut into. Each point fails by
 *  itself, by Mohr and Coulomb's criterion with a tension cut-off, so that bending opens a face from one side. A point that has failed
 *  bears no tension; pressed together it slides with the residual cohesion and friction. As long as any point of a bond holds or is
 *  closed, the bond stands in for the contact of its two blocks. When all of it has opened, or all of it has slid a tenth of its size,
 *  the two are a contact by the law of their materials.
 *
 *  Springs make a body softer: a row of blocks of size a and modulus E by the share 1 / (1 + kn a / E). Laws per area suit what is bonded:
 *  blocks that meet at a corner only are contacts by their law. Thread rule: as for the world.
 */
#ifndef HALFSPACE_BOND_H
#define HALFSPACE_BOND_H

#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The properties of a bond. Fill it with hs_bond_def_init(). */
typedef struct hs_bond_def {
  uint32_t struct_size;           /**< set by hs_bond_def_init() */
  int32_t reserved;               /**< 0 */
  double normal_stiffness;        /**< Pa/m, > 0; default 1e11 */
  double shear_stiffness;         /**< Pa/m, > 0, or 0 (default): as the normal one */
  double tensile_strength;        /**< Pa, >= 0; default 0 */
  double cohesion;                /**< Pa, >= 0; default 0 */
  double friction_angle;          /**< [0, pi/2), of what holds; default 0 */
  double residual_cohesion;       /**< Pa, from 0 to the cohesion, of what has failed and is pressed together; default 0 */
  double residual_friction_angle; /**< [0, pi/2), likewise; or below 0 (default): the friction angle */
  double tensile_fracture_energy; /**< J/m2, >= 0: tension fades linearly with opening and takes so much from its peak on; default 0: at once */
  double shear_fracture_energy;   /**< J/m2, >= 0: likewise what shear strength loses with slip; default 0: at once */
} hs_bond_def;

/** The ways in which a point of a bond fails. */
enum {
  HS_BOND_HOLDS = 0,     /**< it has not */
  HS_BOND_TENSION = 1,   /**< by opening */
  HS_BOND_SHEAR = 2      /**< by sliding */
};

/** A bond now. */
typedef struct hs_bond {
  hs_block block_a;      /**< 0 when one of both has been removed */
  hs_block block_b;      /**< likewise */
  int32_t is_joint;      /**< 1; or 0 when it has come apart and contact has taken over */
  int32_t point_count;   /**< integration points */
  int32_t broken_count;  /**< of them that have failed */
  int32_t reserved;      /**< 0 */
  double area;           /**< of the common face, in 2D its length */
  double damage;         /**< mean over the area: 0 whole, 1 failed */
  double normal_force;   /**< > 0 in tension */
  double shear_force[3]; /**< on block_b */
} hs_bond;

/** A point of a bond that has failed. */
typedef struct hs_bond_event {
  int64_t bond;            /**< its place in the list of bonds, counted from 0 */
  int64_t step;            /**< steps done before */
  int32_t failure;         /**< HS_BOND_TENSION or HS_BOND_SHEAR */
  int32_t point;           /**< of the bond, counted from 0 */
  double time;             /**< s */
  double position[3];      /**< m */
  double normal[3];        /**< of the face, from block_a to block_b */
  double area;             /**< of the point's share of the face, in 2D a length */
  double normal_traction;  /**< Pa, > 0 in tension, at the end of the step before */
  double shear_traction;   /**< Pa, likewise */
  double energy;           /**< J, lost in this step */
} hs_bond_event;

/** The bonds of a world in numbers. Later versions may append to it. */
typedef struct hs_bond_report {
  int64_t bond_count;      /**< made so far */
  int64_t joint_count;     /**< that have not come apart */
  int64_t event_count;     /**< points that have failed so far */
  double crack_area;       /**< of these points, in 2D their length */
  double strain_energy;    /**< in the springs of bonds now; part of hs_energy::strain */
  double fracture_loss;    /**< so far; counts in the residual */
} hs_bond_report;

/** @brief Fills a bond's definition with its defaults.
 *  @param def to fill @param size sizeof(hs_bond_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_bond_def_init(hs_bond_def *def, size_t size);

/** @brief Bonds two blocks along their common face, as they are now: all pairs of faces that lie in one plane but for rounding.
 *  @param world not NULL @param block_a,block_b two blocks of any kind @param def not NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, HS_ERROR_OUT_OF_MEMORY, or HS_ERROR_STATE when they have no common face, hold
 *          together already, or neither moves */
HS_CHECKED hs_status hs_world_bond_blocks(hs_world *world, hs_block block_a, hs_block block_b, const hs_bond_def *def);

/** @brief Bonds all pairs of blocks of two materials along their common faces; what holds together already stays as it is.
 *  @param world not NULL @param material_a,material_b indices, may be the same @param def not NULL
 *  @param count receives the number of bonds made; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_bond_materials(hs_world *world, int32_t material_a, int32_t material_b, const hs_bond_def *def,
                                             int64_t *count);

/** @brief Holds all bonds, which then never fail, while a world comes to rest; or lets them fail again.
 *  @param world not NULL @param are_held 1 or 0
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_hold_bonds(hs_world *world, int32_t are_held);

/** @brief Bulk: all bonds made so far, in their order.
 *  @param world not NULL @param bonds receives them; may be NULL if capacity is 0 @param capacity in bonds
 *  @param count receives their number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_bonds(const hs_world *world, hs_bond bonds[], int64_t capacity, int64_t *count);

/** @brief Bulk: what has failed so far, in order of time.
 *  @param world not NULL @param first the first event wanted, counted from 0
 *  @param events receives them; may be NULL if capacity is 0 @param capacity in events
 *  @param count receives the number of events from the first one on; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_bond_events(const hs_world *world, int64_t first, hs_bond_event events[], int64_t capacity,
                                              int64_t *count);

/** @brief The bonds in numbers, as of the last step.
 *  @param world not NULL @param report receives it @param size sizeof(hs_bond_report) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_bond_report(const hs_world *world, hs_bond_report *report, size_t size);

#ifdef __cplusplus
}
#endif
#endif
