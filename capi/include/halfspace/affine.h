/** @file
 *  @brief Affine blocks: blocks with uniform strain and stress (Zheng et al. 2020, section 2). They have 6
 *  unknowns in 2D, 12 in 3D.
 *
 *  A material point X (its position in the shape's frame, relative to the centroid) is at centroid + gradient
 *  X. The material is isotropic: the second Piola-Kirchhoff stress is linear in the Green strain, so a
 *  rotation of any size causes neither strain nor energy.
 *
 *  Tensors are 9 values, row by row. In 2D only xx, xy, yx and yy are read; in results the other components
 *  are 0, except zz of a gradient, which is 1. Thread rule: as for the world.
 */
#ifndef HALFSPACE_AFFINE_H
#define HALFSPACE_AFFINE_H

#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Assumption about the third direction in 2D. */
enum {
  HS_PLANE_STRAIN = 0, /**< no strain perpendicular to the plane */
  HS_PLANE_STRESS = 1  /**< no stress perpendicular to the plane */
};

/** Elasticity of a material, for affine blocks and meshes. It is isotropic: the second Piola-Kirchhoff stress is
 *  linear in the Green strain, so a rotation of any size causes neither strain nor energy. Fill it with
 *  hs_elasticity_def_init(). */
typedef struct hs_elasticity_def {
  uint32_t struct_size;  /**< set by hs_elasticity_def_init() */
  int32_t plane;         /**< HS_PLANE_STRAIN or, in 2D, HS_PLANE_STRESS; default HS_PLANE_STRAIN */
  double young_modulus;  /**< Pa, > 0; default 1e9 */
  double poisson_ratio;  /**< (-1, 0.5); default 0.25 */
  double damping_time;   /**< s, >= 0; default 0. Stiffness-proportional (Rayleigh) damping: the viscous
                              stress is the elastic stress of the strain rate times this */
} hs_elasticity_def;

/** Deformation and stress of a block. */
typedef struct hs_deformation {
  double gradient[9];    /**< deformation gradient, from the shape's frame to space; a rotation unless the
                              block is affine or of a mesh */
  double rate[9];        /**< time derivative of the gradient, 1/s */
  double strain[9];      /**< Green strain relative to the shape as it was given, in the shape's frame; 0
                              unless affine or of a mesh */
  double stress[9];      /**< elastic Cauchy stress, in space, Pa, tension > 0; 0 unless affine or of a
                              mesh */
  double strain_energy;  /**< J, in 2D per unit thickness; 0 without stress */
} hs_deformation;

/** @brief Fills an elasticity with its defaults.
 *  @param def to fill @param size sizeof(hs_elasticity_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_elasticity_def_init(hs_elasticity_def *def, size_t size);

/** @brief Sets the elasticity of a material. Affine blocks and meshes use it. Existing blocks keep their
 *  strain.
 *  @param world not NULL @param material index @param elasticity not NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_elasticity(hs_world *world, int32_t material,
                                             const hs_elasticity_def *elasticity);

/** @brief Returns deformation and stress of a block of any kind.
 *  @param world not NULL @param block id @param deformation receives it
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_deformation(const hs_world *world, hs_block block,
                                              hs_deformation *deformation);

/** @brief Bulk: deformation and stress of all blocks, in the order of hs_world_get_blocks().
 *  @param world not NULL @param deformations receives them; may be NULL if capacity is 0
 *  @param capacity in deformations @param count receives the number of blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_deformations(const hs_world *world, hs_deformation deformations[],
                                               int64_t capacity, int64_t *count);

/** @brief Sets the deformation gradient of an affine block and its rate. Centroid and velocity do not change.
 *  @param world not NULL @param block id
 *  @param gradient 9 values, max 1e75, with a determinant > 0; the entries of its inverse at most 1e75, and
 *         its norm times that of the inverse at most 2^40: a flatter block would be flat to rounding
 *  @param rate time derivative of the gradient, 9 values, max 1e75, 1/s
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE unless affine */
HS_CHECKED hs_status hs_world_set_deformation(hs_world *world, hs_block block, const double gradient[9],
                                              const double rate[9]);

/** @brief Sets the current stress of an affine block, e.g. the in situ stress. Later strain adds to it.
 *  @param world not NULL @param block id
 *  @param stress Cauchy stress, 9 values, symmetric, max 1e75, Pa, tension > 0
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE unless affine */
HS_CHECKED hs_status hs_world_set_stress(hs_world *world, hs_block block, const double stress[9]);

/** @brief Adds a permanent load on one face of an affine block. Its direction does not change as the block
 *  moves, nor its magnitude as the face is strained.
 *  @param world not NULL @param block id
 *  @param face index; in 2D of the edge that starts at the vertex of that index
 *  @param traction force per area of the face as it was given, 3 values, Pa
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE unless affine */
HS_CHECKED hs_status hs_world_add_surface_load(hs_world *world, hs_block block, int32_t face,
                                               const double traction[3]);

/** @brief Removes all surface loads of an affine block.
 *  @param world not NULL @param block id
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE unless affine */
HS_CHECKED hs_status hs_world_clear_surface_loads(hs_world *world, hs_block block);

#ifdef __cplusplus
}
#endif
#endif
