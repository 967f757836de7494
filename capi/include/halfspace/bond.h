/** @file
 *  @brief Bonds: breakable connections of blocks along their common faces (Wang et al. 2021, section 3).
 *
 *  A bond has normal and shear springs at its integration points: in 2D at both ends (weight 1/6 each) and at
 *  the midpoint of the common face; in 3D at the vertices, midpoints of edges and centroids of a
 *  triangulation of the common face. Each point fails on its own, by the Mohr-Coulomb criterion with a
 *  tension cut-off, so bending opens a face from one side. A failed point transmits no tension; under
 *  compression it slides with residual cohesion and friction. While any point is intact or closed, the bond
 *  replaces the contact of its two blocks. Once all points have opened, or all have slid by a tenth of the
 *  bond's size, the contact law of the materials applies.
 *
 *  Bonds make a body more compliant: a row of blocks of size a, modulus E and bonds of normal stiffness kn
 *  has the modulus E / (1 + E / (kn a)). Blocks that meet only at a corner are in contact, unless a ring of
 *  bonds connects them around it; contact laws per area suit them. Thread rule: as for the world.
 */
#ifndef HALFSPACE_BOND_H
#define HALFSPACE_BOND_H

#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Properties of a bond: springs at the integration points of a common face. Each point fails on its own, by the
 *  Mohr-Coulomb criterion with a tension cut-off. Fill it with hs_bond_def_init(). */
typedef struct hs_bond_def {
  uint32_t struct_size;           /**< set by hs_bond_def_init() */
  int32_t reserved;               /**< 0 */
  double normal_stiffness;        /**< Pa/m, > 0; default 1e11 */
  double shear_stiffness;         /**< Pa/m, >= 0; default 0: as normal_stiffness */
  double tensile_strength;        /**< Pa, >= 0; default 0 */
  double cohesion;                /**< Pa, >= 0; default 0 */
  double friction_angle;          /**< rad, [0, pi/2), of intact points; default 0 */
  double residual_cohesion;       /**< Pa, from 0 to cohesion; default 0; of failed points */
  double residual_friction_angle; /**< rad, [0, pi/2), of failed points; default -1: friction_angle */
  double tensile_fracture_energy; /**< J/m2, >= 0, dissipated as tension decreases linearly with opening after
                                       the peak; default 0: sudden failure */
  double shear_fracture_energy;   /**< J/m2, >= 0, dissipated as shear strength decreases linearly with slip
                                       after the peak; default 0: sudden failure */
} hs_bond_def;

/** Failure modes of a point of a bond. */
enum {
  HS_BOND_HOLDS = 0,     /**< intact */
  HS_BOND_TENSION = 1,   /**< failed by opening */
  HS_BOND_SHEAR = 2      /**< failed by sliding */
};

/** Current state of a bond. */
typedef struct hs_bond {
  hs_block block_a;      /**< 0 if either block has been removed */
  hs_block block_b;      /**< 0 if either block has been removed */
  int32_t is_joint;      /**< 1: the bond connects its blocks; 0: it has failed, the contact law applies */
  int32_t point_count;   /**< integration points */
  int32_t broken_count;  /**< failed integration points */
  int32_t reserved;      /**< 0 */
  double area;           /**< of the common face, m2; in 2D its length, m */
  double damage;         /**< mean over the area, [0, 1]: 0 intact, 1 failed */
  double normal_force;   /**< N, > 0 in tension */
  double shear_force[3]; /**< on block_b, N */
} hs_bond;

/** Failure of a point of a bond. */
typedef struct hs_bond_event {
  int64_t bond;            /**< index of the bond, in the order of hs_world_get_bonds() */
  int64_t step;            /**< number of steps completed before the failure */
  int32_t failure;         /**< HS_BOND_TENSION or HS_BOND_SHEAR */
  int32_t point;           /**< index of the point in its bond */
  double time;             /**< s */
  double position[3];      /**< m */
  double normal[3];        /**< unit normal of the face, from block_a to block_b */
  double area;             /**< tributary area of the point, m2; in 2D a length, m */
  double normal_traction;  /**< Pa, > 0 in tension, at the end of the step before the failure */
  double shear_traction;   /**< Pa, at the end of the step before the failure */
  double energy;           /**< J, dissipated by the failure in this step */
} hs_bond_event;

/** Summary of all bonds of a world. Later versions may append to it. */
typedef struct hs_bond_report {
  int64_t bond_count;      /**< bonds made so far */
  int64_t joint_count;     /**< bonds that still connect their blocks */
  int64_t event_count;     /**< failed points so far */
  double crack_area;       /**< total area of the failed points, m2; in 2D a length, m */
  double strain_energy;    /**< J, current, of the springs of bonds; part of hs_energy.strain */
  double fracture_loss;    /**< J, dissipated so far; included in the residual */
} hs_bond_report;

/** @brief Fills a bond definition with its defaults.
 *  @param def to fill @param size sizeof(hs_bond_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_bond_def_init(hs_bond_def *def, size_t size);

/** @brief Bonds two blocks along their common faces in their current positions: every pair of faces that is
 *  coplanar to rounding.
 *  @param world not NULL @param block_a,block_b two different blocks of any kind @param def not NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, HS_ERROR_OUT_OF_MEMORY, or HS_ERROR_STATE if they
 *         have no common face, are bonded already, or neither moves */
HS_CHECKED hs_status hs_world_bond_blocks(hs_world *world, hs_block block_a, hs_block block_b,
                                          const hs_bond_def *def);

/** @brief Bonds all pairs of blocks of two materials along their common faces. Existing bonds do not change.
 *  @param world not NULL @param material_a,material_b indices, may be the same @param def not NULL
 *  @param count receives the number of bonds made; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_bond_materials(hs_world *world, int32_t material_a, int32_t material_b,
                                             const hs_bond_def *def, int64_t *count);

/** @brief Suspends or resumes the failure of all bonds, e.g. while a world settles.
 *  @param world not NULL @param are_held 1: no bond can fail; 0: bonds can fail
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_hold_bonds(hs_world *world, int32_t are_held);

/** @brief Bulk: all bonds made so far, in their order of creation.
 *  @param world not NULL @param bonds receives them; may be NULL if capacity is 0 @param capacity in bonds
 *  @param count receives the number of bonds; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_bonds(const hs_world *world, hs_bond bonds[], int64_t capacity,
                                        int64_t *count);

/** @brief Bulk: all failures of bond points so far, in order of time.
 *  @param world not NULL @param first index of the first event to return, >= 0
 *  @param events receives them; may be NULL if capacity is 0 @param capacity in events
 *  @param count receives the number of events from the first one on; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_bond_events(const hs_world *world, int64_t first, hs_bond_event events[],
                                              int64_t capacity, int64_t *count);

/** @brief Returns a summary of all bonds, as of the last step.
 *  @param world not NULL @param report receives it
 *  @param size sizeof(hs_bond_report) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_bond_report(const hs_world *world, hs_bond_report *report, size_t size);

#ifdef __cplusplus
}
#endif
#endif
