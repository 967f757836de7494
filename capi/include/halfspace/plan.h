/** @file
 *  @brief Plan of a world: its active parts, their cost in memory and time, and the limit of its time step.
 */
#ifndef HALFSPACE_PLAN_H
#define HALFSPACE_PLAN_H

#include <stddef.h>
#include <stdint.h>

#include "halfspace/mesh.h"
#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Optional parts of a step, in addition to detection and normal forces of rigid blocks. Inactive parts are
 *  neither stored nor computed. */
enum {
  HS_PART_FRICTION = 1,        /**< a law has friction or cohesion; pairs with springs store a shear spring */
  HS_PART_BONDS = 2,           /**< there are bonds, or a law has cohesion or tensile strength */
  HS_PART_CONTACT_DAMPING = 4, /**< a law has damping */
  HS_PART_AREA = 8,            /**< a law is per area: overlap areas (3D: volumes) are computed */
  HS_PART_POTENTIAL = 16,      /**< a law is a potential: overlaps are divided into cells */
  HS_PART_STRAIN = 32,         /**< a block is affine or of a mesh */
  HS_PART_LOCAL_DAMPING = 64,  /**< the world has local damping */
  HS_PART_MASS_DAMPING = 128,  /**< the world has mass damping */
  HS_PART_HARD_CONTACTS = 256, /**< a law has no spring: a solver computes the impulses of all its contact
                                    constraints */
  HS_PART_SLEEP = 512,         /**< sleep is enabled */
  HS_PART_WATER = 1024,        /**< there is water */
  HS_PART_BOLTS = 2048         /**< there are bolts */
};

/** Plan of a world. Later versions may append to it. */
typedef struct hs_world_plan {
  int32_t dimension;          /**< 2 or 3 */
  int32_t parts;              /**< sum of the HS_PART_ values that are active */
  int64_t fixed_count;        /**< fixed blocks */
  int64_t prescribed_count;   /**< prescribed blocks */
  int64_t rigid_count;        /**< rigid blocks */
  int64_t affine_count;       /**< affine blocks */
  int64_t candidate_count;    /**< pairs in the neighbour list */
  int64_t contact_count;      /**< pairs in contact by laws with springs */
  int64_t block_bytes;        /**< snapshot size of all blocks with their shapes, bytes */
  int64_t pair_bytes;         /**< snapshot size of all pairs: neighbour list and shear springs, bytes */
  double stable_time_step;    /**< s, as in hs_world_report; 0 without blocks that move freely */
  hs_block limiting_block;    /**< block of the largest stiffness per mass, which limits the step; 0: none
                                   moves freely */
  hs_block limiting_neighbor; /**< its neighbour at its stiffest contact or bond; 0: none, possible future
                                   contacts limit the step */
  int64_t measured_steps;     /**< number of steps measured for the times below */
  double search_seconds;      /**< s per step: neighbour search */
  double pair_seconds;        /**< s per step: detection and contact forces */
  double gather_seconds;      /**< s per step: sums of forces on blocks */
  double motion_seconds;      /**< s per step: time integration of blocks, nodes and elements */
  double ledger_seconds;      /**< s per step: energy ledger */
  int64_t body_count;         /**< bodies of finite elements */
  int64_t cell_count;         /**< cells of all bodies */
  int64_t node_count;         /**< nodes of all bodies */
  int64_t bond_count;         /**< bonds made so far, including failed ones */
  int64_t mesh_bytes;         /**< part of block_bytes: bodies with their nodes and cells */
  int64_t bond_bytes;         /**< part of block_bytes: bonds with their points and events */
  int64_t limiting_bond;      /**< index of the bond to the limiting neighbour, in the order of
                                   hs_world_get_bonds(); -1: contact */
  hs_body limiting_body;      /**< body of the limiting block, if its elements limit the step; 0: contacts or
                                   bonds do */
  int64_t limiting_cell;      /**< cell of limiting_body with the largest stiffness per mass; -1: none */
  double bond_seconds;        /**< s per step: forces of bonds */
  double hard_contact_seconds; /**< s per step: solver of contacts without springs */
  int64_t bolt_count;         /**< bolts */
  double water_seconds;       /**< s per step: loads of water */
  double bolt_seconds;        /**< s per step: forces of bolts */
} hs_world_plan;

/** @brief Returns the active parts of a world, the limit of its time step, and the times of steps. Steps are
 *  those of a temporary copy, which needs the memory of a second world.
 *  @param world not NULL
 *  @param steps number of steps to measure, >= 0; 0 measures no times. If the copy fails, times are of the
 *         completed steps
 *  @param plan receives it: a part is active if its HS_PART_ bit is in `parts`; fields unknown to this version of
 *         the library are 0
 *  @param size sizeof(hs_world_plan) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY. Thread rule: as for the world. */
HS_CHECKED hs_status hs_world_get_plan(const hs_world *world, int64_t steps, hs_world_plan *plan,
                                       size_t size);

#ifdef __cplusplus
}
#endif
#endif
