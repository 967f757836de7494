/** @file
 *  @brief Shares of a world, for hosts that spread one world over processes.
 *
 *  Each process has a world of its own blocks, of copies of their neighbours, and of the fixed and prescribed
 *  blocks, which are everywhere. All processes make the same calls, and the host carries bytes between them:
 *
 *      plan ──▶ does any need a list or an assembly? ── yes: pack, carry, assemble, plan; renew the lists
 *        └────▶ move ──▶ get loads, carry, set loads ──▶ end the step
 *
 *  The motion has the same bits as by hs_world_step() of the whole world, for any number of shares. A pair
 *  across a border is computed by both owners; no force of a pair is carried. The loads on a block are summed
 *  in the order of keys by its owner, and carried to the shares that have a copy.
 *
 *  Shares hold rigid and affine blocks, laws with springs and potential laws, water, applied forces, and
 *  actions but for servos. hs_world_assemble() refuses, by name: meshes, bonds of bond.h, compounds, bolts,
 *  servos, sleep, laws without springs, and worlds without a given time step. A share cannot be relaxed, and no
 *  block or action is added to it or removed, and no block is placed: join the shares first. Between steps it
 *  can be saved by hs_world_save() with its copies and keys, and restored in another run.
 *
 *  A call that changes the world ends a planned motion: hs_world_move() then returns HS_ERROR_STATE until
 *  another is planned. From hs_world_begin() to hs_world_end_begin(), and from hs_world_move() to
 *  hs_world_end_step(), calls that would change the world return HS_ERROR_STATE, and so do hs_world_save(),
 *  hs_world_pack(), hs_world_assemble() and hs_world_get_balance(). Other queries are answered at any piece.
 *
 *  Laws, gravity, damping and the time step may be changed between steps, alike in all shares; then all shares
 *  are assembled, and hs_world_begin() and hs_world_end_begin() follow. Applied forces may be changed alike in
 *  all shares that hold the block. So may velocities, but then all shares have to begin: those that do not hold
 *  the block are given their time step again. A law of potentials that comes later needs a given
 *  potential_length where blocks are affine; shares with such blocks refuse it else. See docs/concepts/shares.md.
 */
#ifndef HALFSPACE_SHARE_H
#define HALFSPACE_SHARE_H

#include "halfspace/context.h"
#include "halfspace/status.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The role of a block in a share. */
enum {
  HS_ROLE_OWN = 0,       /**< this share loads, counts and packs it */
  HS_ROLE_NEIGHBOR = 1,  /**< a copy: it moves alike, and its loads come from the share that owns it */
  HS_ROLE_EVERYWHERE = 2 /**< fixed and prescribed blocks: in all shares, without loads of their own */
};

/** Number of values of hs_world_get_sums(). */
enum { HS_SUM_COUNT = 27 };

/** A block of a share to be assembled. */
typedef struct hs_packed {
  int64_t key;       /**< name of the block in all shares */
  const void *bytes; /**< from hs_world_pack(); NULL: as `from` has it, of which the block is its own or
                          everywhere */
  size_t size;       /**< of the bytes; 0 if they are NULL */
  int32_t role;      /**< an HS_ROLE_ value */
  int32_t reserved; /**< 0 */
} hs_packed;

/** A share, and how far its copies must reach. */
typedef struct hs_share_info {
  int64_t own_count;        /**< blocks by role, HS_ROLE_OWN; in a whole world all that move freely */
  int64_t neighbor_count;   /**< HS_ROLE_NEIGHBOR */
  int64_t everywhere_count; /**< HS_ROLE_EVERYWHERE */
  int64_t lost_pairs;       /**< pairs of own blocks and of their neighbours whose other block is not here:
                                 the copies do not reach far enough. 0 in a sound run */
  int32_t load_length;      /**< numbers per block of hs_world_get_loads(), the same in all shares */
  int32_t is_whole;         /**< 1: all blocks of the world are here and own */
  double halo; /**< a share needs copies of all blocks whose centroids are nearer than this to that of an own
                    block, m; of all shares the largest counts. Twice as far as a pair of the next list. Call
                    after hs_world_plan_motion() */
  int64_t whole_count; /**< blocks of the whole world: own ones of all shares, and those that are everywhere */
} hs_share_info;

/** The needs of the coming motion. */
typedef struct hs_share_plan {
  int32_t needs_list;     /**< 1: blocks may meet others that are not in the list of pairs: all shares are
                               assembled, plan again and renew their lists */
  int32_t needs_assembly; /**< 1: a pair has met in a way that copies cannot know: all shares are assembled and
                               plan again */
  int32_t refusal;        /**< HS_OK, or the error with which hs_world_move() would end: HS_ERROR_TOO_FAST, a
                               block moves by more than its radius, turns by more than 1 rad, or approaches
                               another so fast that the step would be divided; HS_ERROR_UNSTABLE, the motion is
                               not finite */
  int32_t reserved; /**< 0 */
} hs_share_plan;

/** @brief Names the blocks, so that loads are summed in the same order in all shares. By default a block's key
 *  is its place in hs_world_get_blocks(), with gaps where blocks were removed. Blocks that are added or removed
 *  later end these keys.
 *  @param world whole, not a share
 *  @param keys ascending, in the order of hs_world_get_blocks()
 *  @param count the number of blocks
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_set_keys(hs_world *world, const int64_t keys[], int64_t count);

/** @brief Returns the keys of all blocks, in the order of hs_world_get_blocks(), which is ascending.
 *  @param world not NULL @param keys receives up to `capacity` keys; may be NULL if capacity is 0
 *  @param capacity in keys @param count receives the number of blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_keys(const hs_world *world, int64_t keys[], int64_t capacity,
                                       int64_t *count);

/** @brief Returns the roles of all blocks, HS_ROLE_ values, in the order of hs_world_get_blocks(). In a whole
 *  world fixed and prescribed blocks are everywhere, all others own.
 *  @param world not NULL @param roles receives up to `capacity` roles; may be NULL if capacity is 0
 *  @param capacity in roles @param count receives the number of blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_roles(const hs_world *world, int32_t roles[], int64_t capacity,
                                        int64_t *count);

/** @brief Describes a share.
 *  @param world a share or a whole world @param info receives it @param size sizeof(hs_share_info)
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_share_info(hs_world *world, hs_share_info *info, size_t size);

/** @brief Packs blocks, one after the other: their motion, their entries in the list of pairs, and the memory
 *  of their pairs, in the machine's format of numbers. Only a block's own share packs it, or any for blocks
 *  that are everywhere.
 *  @param world a share or a whole world
 *  @param keys of the blocks, in any order
 *  @param count number of keys
 *  @param with_shapes 1: with their outlines, for shares that do not have the block; 0: without
 *  @param bytes receives up to `capacity` bytes; may be NULL if capacity is 0
 *  @param capacity in bytes
 *  @param ends receives, per key, where its bytes end; may be NULL
 *  @param needed receives the number of bytes of all blocks
 *  @return HS_OK, HS_NOTE_TRUNCATED (then `bytes` is not written), HS_ERROR_ARGUMENT,
 *          HS_ERROR_STATE (within a step), HS_ERROR_STALE_ID (no own block has that key) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_pack(hs_world *world, const int64_t keys[], int64_t count, int32_t with_shapes,
                                   void *bytes, size_t capacity, size_t ends[], size_t *needed);

/** @brief Makes a world of blocks: a share, or the whole world again where all its blocks are own ones.
 *  Settings, laws, clock, and losses so far are those of `from`; of several shares of a whole world, that which
 *  owns its first free block takes the losses. The list of pairs in use stays in use, until it is renewed.
 *  @param context as that of `from`, or another one
 *  @param from a share or a whole world; it does not change, and may be destroyed afterwards
 *  @param blocks in ascending order of keys: all own blocks of the new share, copies of all blocks within its
 *         halo, and all blocks that are everywhere. Copies need bytes. Bytes are those of the present step.
 *         Ids of blocks are new, in this order
 *  @param count number of blocks
 *  @param share receives the world; destroy it with hs_world_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE (`from` has what shares cannot hold, or is within a step),
 *          HS_ERROR_STALE_ID (a block without bytes that `from` does not own), HS_ERROR_FORMAT (damaged bytes) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_assemble(hs_context *context, hs_world *from, const hs_packed blocks[],
                                       int64_t count, hs_world **share);

/** @brief Returns energies, losses and momentum of a share, as numbers that add up over shares to those of the
 *  whole world.
 *  @param world a share or a whole world
 *  @param sums receives HS_SUM_COUNT values: 16 energies and losses, J, 5 powers, W, then of rigid and affine
 *         blocks and compounds the linear momentum x, y, z, N s, and the angular one about the origin x, y, z,
 *         N m s
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_sums(const hs_world *world, double sums[]);

/** @brief Sets these sums: to those over the shares whose blocks the world has taken over, as it continues their
 *  losses; to zeros in a share without own blocks. The momentum is left as it is.
 *  @param world a share or a whole world @param sums HS_SUM_COUNT values, of which energies, losses and powers
 *         are finite; those of the momentum are ignored
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_sums(hs_world *world, const double sums[]);

/** @brief Begins after blocks were added, or laws, velocities or forces changed: contacts, bonds by laws, and
 *  forces where blocks are. Then loads are carried, and hs_world_end_begin() follows. A world that nothing has
 *  changed is left as it is.
 *  @param world a share or a whole world
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE (a share was not assembled after a change of laws, or is
 *          within a step) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_begin(hs_world *world);

/** @brief Computes accelerations and energies of the beginning, from the loads.
 *  @param world on which hs_world_begin() was called last
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_end_begin(hs_world *world);

/** @brief Plans the motion of a step, without moving any block. May be called again. The host combines the plans
 *  of all shares: the maximum of needs_list and of needs_assembly, the minimum of refusal.
 *  @param world a share or a whole world, begun @param plan receives what the motion needs
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_plan_motion(hs_world *world, hs_share_plan *plan);

/** @brief Renews the list of pairs for the planned motion: on all shares, where the plan of any needs it.
 *  @param world planned @param plan receives the plan with the new list: of it, `refusal` counts
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_renew_list(hs_world *world, hs_share_plan *plan);

/** @brief Makes the planned motion, which must be without a refusal: blocks move, and contacts and forces are those
 *  of their new places.
 *  @param world planned, without a refusal @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STATE */
HS_CHECKED hs_status hs_world_move(hs_world *world);

/** @brief Returns the loads of the contacts on own blocks: force, torque, and in worlds with elastic materials
 *  the virial, row by row.
 *  @param world begun or moved
 *  @param keys of own blocks @param count number of keys
 *  @param loads receives count * hs_share_info.load_length numbers
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_loads(const hs_world *world, const int64_t keys[], int64_t count,
                                        double loads[]);

/** @brief Sets the loads of the contacts on copies, as their owners have computed them.
 *  @param world begun or moved
 *  @param keys of copies @param count number of keys
 *  @param loads count * hs_share_info.load_length numbers
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_loads(hs_world *world, const int64_t keys[], int64_t count,
                                        const double loads[]);

/** @brief Ends the step: velocities and energies at the end of the motion, from the loads.
 *  @param world moved @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STATE */
HS_CHECKED hs_status hs_world_end_step(hs_world *world);

#ifdef __cplusplus
}
#endif
#endif
