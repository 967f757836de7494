/** @file
 *  @brief What a world computes, what that costs, and what limits its time step.
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

/** The parts of a step besides detection and normal forces of rigid blocks. One that is not active is neither stored nor computed. */
enum {
  HS_PART_FRICTION = 1,        /**< a law resists shear: each pair keeps a shear spring */
  HS_PART_BONDS = 2,           /**< a law has cohesion or tensile strength */
  HS_PART_CONTACT_DAMPING = 4, /**< a law has dashpots */
  HS_PART_AREA = 8,            /**< a law is per area: overlaps are measured */
  HS_PART_POTENTIAL = 16,      /**< a law is one of potentials: overlaps are divided; in space each pair keeps a plan of that */
  HS_PART_STRAIN = 32,         /**< a block is affine or a cell of a mesh */
  HS_PART_LOCAL_DAMPING = 64,  /**< the world has local damping */
  HS_PART_MASS_DAMPING = 128,  /**< the world has mass damping */
  HS_PART_HARD_CONTACTS = 256, /**< a law without a spring: one solver finds the impulses of all its contacts */
  HS_PART_SLEEP = 512          /**< blocks at rest may sleep */
};

/** The account of a world. Later versions may append to it. */
typedef struct hs_world_plan {
  int32_t dimension;          /**< 2 or 3 */
  int32_t parts;              /**< HS_PART_ bits: what is active */
  int64_t fixed_count;        /**< blocks that never move */
  int64_t prescribed_count;   /**< blocks with a prescribed motion */
  int64_t rigid_count;        /**< blocks that move by Newton's law */
  int64_t affine_count;       /**< blocks that strain */
  int64_t candidate_count;    /**< pairs in the neighbour list */
  int64_t contact_count;      /**< pairs in contact by laws with springs */
  int64_t block_bytes;        /**< state of all blocks with their shapes, as a snapshot holds it */
  int64_t pair_bytes;         /**< state of all pairs: neighbour list, shear springs, plans; likewise */
  double stable_time_step;    /**< as in the report; 0 without blocks that move freely */
  hs_block limiting_block;    /**< sets it: the stiffest for its mass; 0 without blocks that move freely */
  hs_block limiting_neighbor; /**< at its stiffest contact or bond; 0 while it has none: then contacts that it may get limit the step */
  int64_t measured_steps;     /**< done to measure the times below */
  double search_seconds;      /**< of a step: building neighbour lists */
  double pair_seconds;        /**< of a step: detecting pairs and loading contacts */
  double gather_seconds;      /**< of a step: adding up the forces on blocks */
  double motion_seconds;      /**< of a step: moving, turning and straining blocks, nodes and elements of meshes */
  double ledger_seconds;      /**< of a step: the energy ledger */
  int64_t body_count;         /**< bodies of finite elements */
  int64_t cell_count;         /**< of all of them */
  int64_t node_count;         /**< likewise */
  int64_t bond_count;         /**< bonds made, those that have come apart among them */
  int64_t mesh_bytes;         /**< of the bytes of blocks: bodies with their nodes and cells */
  int64_t bond_bytes;         /**< likewise: bonds with their points and events */
  int64_t limiting_bond;      /**< index of the bond to the limiting neighbour, in the order of hs_world_get_bonds(); -1: it is a contact */
  hs_body limiting_body;      /**< that the limiting block is of, where its elements have the greater part in the limit; 0: contacts and
                                   bonds have */
  int64_t limiting_cell;      /**< of that body: the stiffest for its mass */
  double bond_seconds;        /**< of a step: loading blocks by bonds */
  double hard_contact_seconds; /**< of a step: the solver of contacts without springs */
} hs_world_plan;

/** @brief Says what a world computes and what limits its step and, by steps, what that costs. All is found out on a copy, which
 *  takes as much memory again for as long: the world stays as it is.
 *  @param world not NULL
 *  @param steps to measure, >= 0; 0 measures no times. If the copy cannot go on, the times are of the steps that it did
 *  @param plan receives it; what this library does not know of a longer struct is 0
 *  @param size sizeof(hs_world_plan) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY. Thread rule: as for the world. */
HS_CHECKED hs_status hs_world_get_plan(const hs_world *world, int64_t steps, hs_world_plan *plan, size_t size);

#ifdef __cplusplus
}
#endif
#endif
