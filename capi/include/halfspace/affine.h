/** @file
 *  @brief Affine blocks: they turn and strain as a whole (Zheng et al. 2020, section 2), in 2D with 6 unknowns, in 3D with 12.
 *
 *  An affine block's points are at gradient * X from its centroid, X being their place in the shape's frame: the shape's vertices
 *  relative to its centroid. Stress and strain are uniform in the block. Its material is isotropic: the second Piola stress is linear in
 *  Green's strain, so that a rotation, however large, neither strains a block nor costs energy.
 *
 *  Tensors are 9 values, row by row. In 2D xx, xy, yx and yy count; of those that come out, the others are 0, but zz of a gradient 1.
 *  Thread rule: as for the world.
 */
#ifndef HALFSPACE_AFFINE_H
#define HALFSPACE_AFFINE_H

#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What 2D is a section of. */
enum {
  HS_PLANE_STRAIN = 0, /**< a body that cannot strain across the plane */
  HS_PLANE_STRESS = 1  /**< a sheet without stress across the plane */
};

/** Elasticity of a material. Fill it with hs_elasticity_def_init(). */
typedef struct hs_elasticity_def {
  uint32_t struct_size;  /**< set by hs_elasticity_def_init() */
  int32_t plane;         /**< 2D: HS_PLANE_STRAIN (default) or HS_PLANE_STRESS; 3D: HS_PLANE_STRAIN */
  double young_modulus;  /**< Pa, > 0; default 1e9 */
  double poisson_ratio;  /**< (-1, 0.5); default 0.25 */
  double damping_time;   /**< s, >= 0: viscous stress is the elastic one of the strain rate times this (Rayleigh's beta); default 0 */
} hs_elasticity_def;

/** How a block is turned and strained. */
typedef struct hs_deformation {
  double gradient[9];    /**< from places in the shape's frame to places about the centroid; of other than affine blocks a rotation */
  double rate[9];        /**< of the gradient, 1/s */
  double strain[9];      /**< Green's, from the shape as it was given, in the shape's frame; of other than affine blocks 0 */
  double stress[9];      /**< Cauchy's, elastic, in space, Pa, tension > 0; of other than affine blocks 0 */
  double strain_energy;  /**< J, in 2D per unit thickness; 0 without stress */
} hs_deformation;

/** @brief Fills an elasticity with its defaults.
 *  @param def to fill @param size sizeof(hs_elasticity_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_elasticity_def_init(hs_elasticity_def *def, size_t size);

/** @brief Makes a material elastic, for affine blocks and meshes; others do not read it. What has the material keeps its strain.
 *  @param world not NULL @param material index @param elasticity not NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_elasticity(hs_world *world, int32_t material,
                                             const hs_elasticity_def *elasticity);

/** @brief How a block of any kind is turned and strained.
 *  @param world not NULL @param block id @param deformation receives it
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_deformation(const hs_world *world, hs_block block,
                                              hs_deformation *deformation);

/** @brief Bulk: how all blocks are turned and strained, in the order of hs_world_get_blocks().
 *  @param world not NULL @param deformations receives them; may be NULL if capacity is 0 @param capacity in deformations
 *  @param count receives the number of blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_deformations(const hs_world *world, hs_deformation deformations[],
                                               int64_t capacity, int64_t *count);

/** @brief Turns and strains an affine block, and sets how fast it goes on. Its centroid and velocity stay.
 *  @param world not NULL @param block id
 *  @param gradient 9 values, at most 1e75, with a determinant above 0; its inverse likewise at most 1e75, and its norm times that of the
 *         inverse at most 2^40: a block pressed flatter would be flat to rounding
 *  @param rate of the gradient, 9 values, at most 1e75, 1/s
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE unless affine */
HS_CHECKED hs_status hs_world_set_deformation(hs_world *world, hs_block block, const double gradient[9],
                                              const double rate[9]);

/** @brief Says how an affine block is stressed as it is now, e.g. in situ. What the block is strained by from now on adds to that.
 *  @param world not NULL @param block id @param stress Cauchy's, 9 values, symmetric, at most 1e75, Pa, tension > 0
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE unless affine */
HS_CHECKED hs_status hs_world_set_stress(hs_world *world, hs_block block, const double stress[9]);

/** @brief Adds a load that acts on one face of an affine block from now on. It keeps its direction as the block moves, and its size as the
 *  face is strained.
 *  @param world not NULL @param block id @param face index, in 2D of the edge that starts at the vertex of that index
 *  @param traction force per area of the face as it was given, 3 values, Pa
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE unless affine */
HS_CHECKED hs_status hs_world_add_surface_load(hs_world *world, hs_block block, int32_t face,
                                               const double traction[3]);

/** @brief Takes all surface loads off an affine block.
 *  @param world not NULL @param block id
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE unless affine */
HS_CHECKED hs_status hs_world_clear_surface_loads(hs_world *world, hs_block block);

#ifdef __cplusplus
}
#endif
#endif
