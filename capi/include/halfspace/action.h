/** @file
 *  @brief Motions and loads in time: tables that blocks and nodes follow, force control, and held axes.
 *
 *  A table has values at times, linear between them. An action gives the values of a table to a block, to all
 *  blocks, or to nodes of a body. Within a step a load is constant, the mean of its table, and a prescribed
 *  block moves by the integral of its velocity. So impulses and displacements are exact for any time step.
 *  Snapshots contain tables and actions. A world with actions does not sleep. Thread rule: as for the world.
 */
#ifndef HALFSPACE_ACTION_H
#define HALFSPACE_ACTION_H

#include "halfspace/mesh.h"
#include "halfspace/status.h"
#include "halfspace/view.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What an action gives. Loads of one block add up. Motions along different axes act together; a motion ends
 *  the earlier ones along its axes, and a servo that has one of them as a whole. */
enum {
  HS_ACTION_VELOCITY = 0,         /**< m/s, of a prescribed block, or along held axes of a rigid block or of
                                       nodes */
  HS_ACTION_ANGULAR_VELOCITY = 1, /**< rad/s, of a prescribed block; 2D uses z */
  HS_ACTION_ACCELERATION = 2,     /**< m/s2, likewise as HS_ACTION_VELOCITY; of all blocks: a body force,
                                       besides gravity */
  HS_ACTION_ANGULAR_ACCELERATION = 3, /**< rad/s2, of a prescribed block; 2D uses z */
  HS_ACTION_FORCE = 4,            /**< N, on a rigid or affine block or on nodes */
  HS_ACTION_TORQUE = 5,           /**< N m, on a rigid or affine block; 2D uses z */
  HS_ACTION_SERVO = 6             /**< N: a prescribed block, or a rigid one along held axes, moves so that it
                                       presses on its contacts with this force; they need springs */
};

/** Where a force acts. */
enum {
  HS_PLACE_CENTROID = 0, /**< at the centroid */
  HS_PLACE_CARRIED = 1,  /**< at a point of the block, which moves with it */
  HS_PLACE_FIXED = 2     /**< at a point in space */
};

/** Settings of an action. Fill it with hs_action_def_init(). */
typedef struct hs_action_def {
  uint32_t struct_size; /**< set by hs_action_def_init() */
  int32_t kind;         /**< an HS_ACTION_ value; default HS_ACTION_FORCE */
  int32_t table;        /**< index from hs_world_add_table(); default 0 */
  int32_t place;        /**< HS_ACTION_FORCE: an HS_PLACE_ value; default HS_PLACE_CENTROID */
  double start;         /**< time of the world at time 0 of the table, s; default 0 */
  double scale[3];      /**< factor of each component; a motion does not change components of scale 0; a servo
                             presses along the scale as a vector; default 1, 1, 1. Nodes have their own */
  double point[3];      /**< of HS_PLACE_CARRIED (where it is now) and HS_PLACE_FIXED, m; default 0 */
  double max_speed;     /**< of a servo, m/s, > 0 */
} hs_action_def;

/** @brief Fills an action definition with its defaults.
 *  @param def to fill @param size sizeof(hs_action_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_action_def_init(hs_action_def *def, size_t size);

/** @brief Adds a table. Before its first and after its last time it is constant.
 *  @param world not NULL @param times one per row, s, in ascending order; two equal ones are a jump
 *  @param values one per row; without z, z is 0
 *  @param table receives its index
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_add_table(hs_world *world, const double times[], hs_view values,
                                        int32_t *table);

/** @brief Adds an action on a block.
 *  @param world not NULL @param block id, or 0: all blocks that move freely, only HS_ACTION_ACCELERATION
 *  @param def not NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID (block or table), HS_ERROR_OUT_OF_MEMORY, or
 *         HS_ERROR_STATE for a kind of block that cannot follow it */
HS_CHECKED hs_status hs_world_add_action(hs_world *world, hs_block block, const hs_action_def *def);

/** @brief Ends all actions on a block. A prescribed block keeps its last velocity.
 *  @param world not NULL @param block id, or 0: ends those on all blocks
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_end_actions(hs_world *world, hs_block block);

/** @brief Adds an action on nodes of a body, e.g. a traction: each node with a share of the area as scale.
 *  @param world not NULL @param body id @param nodes indices of nodes
 *  @param scales factor of each component, one per node: its count is the number of nodes
 *  @param def HS_ACTION_FORCE, HS_ACTION_VELOCITY or HS_ACTION_ACCELERATION; its scale is ignored. Motions
 *         need axes held by hs_world_hold_nodes()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_add_node_action(hs_world *world, hs_body body, const int32_t nodes[],
                                              hs_view scales, const hs_action_def *def);

/** @brief Ends all actions on the nodes of a body. Held nodes keep their last velocity.
 *  @param world not NULL @param body id
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_end_node_actions(hs_world *world, hs_body body);

/** @brief Sets the viscosity of nodes of a body: a dashpot connects each with the ground, whose force is minus
 *  the viscosity times the velocity. On the nodes of a face, with density times the speeds of compression and
 *  shear waves times each node's share of the area, waves leave the body (Lysmer and Kuhlemeyer 1969). The work
 *  of the dashpots counts as outer_work. They do not limit the time step.
 *  @param world not NULL @param body id @param nodes indices of nodes @param count in nodes
 *  @param viscosity of each node, 9 values row by row, symmetric, N s/m; all 0 removes the dashpot
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_set_node_viscosity(hs_world *world, hs_body body, const int32_t nodes[],
                                                 int64_t count, const double viscosity[9]);

/** @brief Holds axes of a rigid block: the velocity along them stays, whatever the forces; a block whose
 *  rotation is held does not rotate. Its contacts of laws without springs are points, without restitution.
 *  @param world not NULL @param block id of a rigid block @param axes sum of HS_AXIS_ values, or 0: frees it
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE for other kinds */
HS_CHECKED hs_status hs_world_hold_block(hs_world *world, hs_block block, int32_t axes);

/** @brief Bulk: sets the velocities of prescribed blocks between steps. Contacts and forces are kept, so it
 *  may be called at each step.
 *  @param world not NULL @param blocks ids of prescribed blocks
 *  @param velocities of the centroids, m/s: its count is the number of blocks
 *  @param angular_velocities rad/s; 2D uses z; a view with count 0 keeps the current ones
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE for other kinds (no velocity has
 *         changed) */
HS_CHECKED hs_status hs_world_prescribe_velocities(hs_world *world, const hs_block blocks[],
                                                   hs_view velocities, hs_view angular_velocities);

#ifdef __cplusplus
}
#endif
#endif
