/** @file
 *  @brief A world: blocks, materials, laws, and time. Used whole (step) or stage by stage (detect, forces).
 *
 *  Stage by stage, a host with its own integrator sets poses and velocities, calls hs_world_detect(), then
 *  hs_world_forces(), and moves its bodies itself. hs_world_step() does all of it, by velocity Verlet. Only hs_world_step() strains
 *  affine blocks.
 */
#ifndef HALFSPACE_WORLD_H
#define HALFSPACE_WORLD_H

#include "halfspace/contact.h"
#include "halfspace/law.h"
#include "halfspace/shape.h"
#include "halfspace/status.h"
#include "halfspace/view.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Opaque. */
typedef struct hs_world hs_world;

/** Names a block: index and generation. 0 is no block; a removed block's id never names another. */
typedef uint64_t hs_block;

/** How a block moves. */
enum {
  HS_BLOCK_FIXED = 0,      /**< never */
  HS_BLOCK_PRESCRIBED = 1, /**< with the velocity and spin given, whatever the forces */
  HS_BLOCK_RIGID = 2,      /**< by Newton's law */
  HS_BLOCK_AFFINE = 3,     /**< by Newton's law, and straining as a whole: see affine.h */
  HS_BLOCK_MESH = 4        /**< as the nodes of its mesh do: see mesh.h, whose hs_world_add_mesh() makes it */
};

/** What becomes of a step in which two blocks would move far against the thinner of them: more than a quarter of its thickness. */
enum {
  HS_FAST_DIVIDE = 0, /**< when they meet, or are in touch, it is divided: up to their first touch, and on from there by small parts. After
                           16384 of these it is refused, too */
  HS_FAST_REFUSE = 1  /**< when they meet, or are in touch, it is refused with HS_ERROR_TOO_FAST */
};

/** How a world is made. Fill it with hs_world_def_init(). */
typedef struct hs_world_def {
  uint32_t struct_size;  /**< set by hs_world_def_init() */
  int32_t dimension;     /**< 2 or 3, as given to hs_world_def_init() */
  double gravity[3];     /**< acceleration; default 0, -9.81, 0 in 2D and 0, 0, -9.81 in 3D */
  double time_step;      /**< > 0, or 0 (default): safety times the stable time step, found when the first step begins and
                              again after each change of the world from outside */
  double safety;         /**< (0, 1]; default 0.5 */
  double local_damping;  /**< [0, 1): force opposing each velocity component, share of the force; default 0 */
  double mass_damping;   /**< 1/s, >= 0: force -mass_damping * mass * velocity; default 0 */
  double skin;           /**< reach of the neighbour list, share of a block's size; (0, 1]; default 0.1 */
  double parallel_angle; /**< see hs_pair_options */
  double vertex_zone;    /**< see hs_pair_options */
  double potential_length; /**< H of HS_STIFFNESS_POTENTIAL, m, > 0: one for all blocks; or 0 (default): the mean length of all blocks'
                                edges when forces are first used */
  int32_t fast_blocks;     /**< an HS_FAST_ value; default HS_FAST_DIVIDE */
  int32_t reserved;        /**< 0 */
  double sleep_tolerance;  /**< m, >= 0: the largest displacement error of a block by sleep over a run; blocks at rest
                                are then left out of steps. 0 (default): no block sleeps. Worlds with
                                HS_STIFFNESS_NONE or meshes do not sleep */
} hs_world_def;

/** How a block is made. Fill it with hs_block_def_init(). */
typedef struct hs_block_def {
  uint32_t struct_size;       /**< set by hs_block_def_init() */
  int32_t kind;               /**< an HS_BLOCK_ value; default HS_BLOCK_RIGID */
  int32_t material;           /**< from hs_world_add_material() */
  int32_t reserved;           /**< 0 */
  hs_pose pose;               /**< default: where the shape's vertices were given */
  double velocity[3];         /**< of the centroid; default 0 */
  double angular_velocity[3]; /**< rad/s; 2D uses z; default 0 */
} hs_block_def;

/** A block's motion. */
typedef struct hs_block_state {
  int32_t kind;               /**< an HS_BLOCK_ value */
  int32_t material;           /**< index */
  hs_pose pose;               /**< of the centroid */
  double angle;               /**< 2D: that of the pose, rad, counting whole turns, so that it is unbounded */
  double velocity[3];         /**< of the centroid */
  double angular_velocity[3]; /**< 2D: z */
  double force[3];            /**< contact force of the last force evaluation */
  double torque[3];           /**< contact torque about the centroid, likewise */
  double mass;                /**< 2D: per unit thickness */
} hs_block_state;

/** Where the energy is and where it went, since the world was made (J, in 2D per unit thickness). Adding or removing blocks and
 *  setting a motion are booked as outer work. */
typedef struct hs_energy {
  double kinetic;         /**< now */
  double gravity;         /**< potential, zero at the origin, now */
  double strain;          /**< in the contact springs, now */
  double friction_loss;   /**< by sliding and by breaking bonds, so far */
  double contact_damping_loss; /**< by viscous contact damping, so far */
  double local_damping_loss;   /**< by local damping, so far */
  double mass_damping_loss;    /**< by mass-proportional damping, so far */
  double outer_work;      /**< by prescribed blocks, applied forces, surface loads and edits, so far */
  double residual;        /**< all but outer_work, minus outer_work: the energy error of the time stepping */
} hs_energy;

/** The state of a world in numbers. Later versions may append to it. */
typedef struct hs_world_report {
  int32_t dimension;         /**< 2 or 3 */
  int32_t reserved;          /**< 0 */
  int64_t steps;             /**< done so far */
  double time;               /**< passed so far */
  double time_step;          /**< in use */
  double stable_time_step;   /**< safe bound from stiffness, viscosity and mass; 0 without blocks that move freely */
  int64_t block_count;       /**< living blocks */
  int64_t candidate_count;   /**< pairs in the neighbour list */
  int64_t contact_count;     /**< contacts: pairs by laws with springs, points by laws without */
  int64_t list_builds;       /**< how often the neighbour list was built */
  double largest_overlap;    /**< of the last detection */
  double largest_speed;      /**< of all blocks that move freely, now */
  hs_energy energy;          /**< the ledger */
  double potential_length;   /**< in use; 0 without a law of potentials */
  double block_strain_energy; /**< of affine blocks and meshes, now; counts in the residual */
  double block_damping_loss; /**< in affine blocks and meshes, so far; counts in the residual */
  int64_t divided_steps;     /**< steps so far that fast blocks have divided */
  double max_penetration_ratio; /**< largest penetration at which springs stop two blocks, over the thinner block's
                                  thickness, so far. Above 0.25 increase the normal stiffness; from 0.5 on blocks
                                  may pass through each other. See docs/concepts/impact.md */
  double peak_overlap;       /**< largest overlap so far, at every detection; by potentials in space, whose steps find no overlaps, now */
  double peak_speed;         /**< largest speed so far of all blocks that move freely, at the end of every step and part of one */
  int64_t sleeping_count;    /**< blocks that sleep now */
  double max_sleep_error;    /**< m: largest displacement error of a block by sleep, so far */
  int64_t touch_count;       /**< touches so far by laws without springs; a corner that slides from face to face touches anew */
  int64_t iteration_count;   /**< iterations so far of the solver of laws without springs: sweeps over all of their contacts */
  double impact_loss;        /**< J, in 2D per unit thickness: lost so far by their touches; counts in the residual */
} hs_world_report;

/** @brief Fills a world definition with its defaults.
 *  @param def to fill @param size sizeof(hs_world_def) as the caller was compiled
 *  @param dimension 2 or 3
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_world_def_init(hs_world_def *def, size_t size, int32_t dimension);

/** @brief Makes an empty world.
 *  @param context owner of the allocator
 *  @param def not NULL
 *  @param world receives it; end it with hs_world_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_create(hs_context *context, const hs_world_def *def, hs_world **world);

/** @brief Ends a world with all it holds. @param world may be NULL */
HS_API void hs_world_destroy(hs_world *world);

/** @brief Adds a material.
 *  @param world not NULL
 *  @param density > 0
 *  @param material receives its index, counted from 0
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_add_material(hs_world *world, double density, int32_t *material);

/** @brief Sets the law of all pairs of materials that have none of their own.
 *  @param world not NULL @param law not NULL
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_default_law(hs_world *world, const hs_law_def *law);

/** @brief Sets the law between two materials (either order).
 *  @param world not NULL @param material_a,material_b indices; the same one twice is legal @param law not NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_set_law(hs_world *world, int32_t material_a, int32_t material_b,
                                      const hs_law_def *law);

/** @brief Fills a block definition with its defaults for a shape.
 *  @param def to fill @param size sizeof(hs_block_def) as the caller was compiled
 *  @param shape gives the default pose; not NULL
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_API hs_status hs_block_def_init(hs_block_def *def, size_t size, const hs_shape *shape);

/** @brief Adds a block. The world copies the shape. No component of its position may exceed 2^32 of its bounding radius: farther
 *  off, rounding would move it by too large a part of its size.
 *  @param world not NULL @param shape not NULL @param def not NULL @param block receives its id
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID (material), HS_ERROR_STATE (an affine block of a material that is not
 *  elastic) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_add_block(hs_world *world, const hs_shape *shape, const hs_block_def *def,
                                        hs_block *block);

/** @brief Removes a block; its id becomes stale. The cost grows with the size of the world.
 *  @param world not NULL @param block id
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_remove_block(hs_world *world, hs_block block);

/** @brief The ids of all blocks in the order of the block arrays below.
 *  @param world not NULL @param blocks receives them; may be NULL if capacity is 0 @param capacity in ids
 *  @param count receives the number of blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_blocks(const hs_world *world, hs_block blocks[], int64_t capacity,
                                         int64_t *count);

/** @brief One block's motion.
 *  @param world not NULL @param block id @param state receives it
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_block_state(const hs_world *world, hs_block block, hs_block_state *state);

/** @brief One block's vertices where they are now, counter-clockwise.
 *  @param world not NULL @param block id @param vertices receives them @param count receives their number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_block_vertices(const hs_world *world, hs_block block,
                                                 hs_mutable_view vertices, int64_t *count);

/** @brief Puts a block elsewhere.
 *  @param world not NULL @param block id @param pose where to, no farther off than hs_world_add_block() allows
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_pose(hs_world *world, hs_block block, const hs_pose *pose);

/** @brief Sets a block's velocity and angular velocity (3 values each); a fixed block takes none, an affine one
 *  strains on as before.
 *  @param world not NULL @param block id @param velocity of the centroid @param angular_velocity rad/s; 2D uses z
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE for a fixed block */
HS_CHECKED hs_status hs_world_set_velocity(hs_world *world, hs_block block, const double velocity[3],
                                           const double angular_velocity[3]);

/** @brief Sets the force and torque (3 values each) that act on a rigid or affine block from outside until set again.
 *  @param world not NULL @param block id @param force at the centroid @param torque about the centroid; 2D uses z
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE for other kinds */
HS_CHECKED hs_status hs_world_set_applied_force(hs_world *world, hs_block block, const double force[3],
                                                const double torque[3]);

/** @brief Bulk: poses of all blocks, in the order of hs_world_get_blocks().
 *  @param world not NULL @param poses receives them; may be NULL if capacity is 0 @param capacity in poses @param count receives the number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_poses(const hs_world *world, hs_pose poses[], int64_t capacity,
                                        int64_t *count);

/** @brief Bulk: sets the poses of all blocks, in the order of hs_world_get_blocks().
 *  @param world not NULL @param poses one per block, no farther off than hs_world_add_block() allows @param count must be the number of blocks
 *  @return HS_OK or HS_ERROR_ARGUMENT, then no block has moved */
HS_CHECKED hs_status hs_world_set_poses(hs_world *world, const hs_pose poses[], int64_t count);

/** @brief Bulk: velocities and angular velocities of all blocks, in the order of hs_world_get_blocks().
 *  @param world not NULL @param velocities receives them; its count is the capacity
 *  @param angular_velocities 2D: z only, x and y are 0; a view with count 0 skips it
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_velocities(const hs_world *world, hs_mutable_view velocities,
                                             hs_mutable_view angular_velocities);

/** @brief Bulk: sets velocities and angular velocities of all blocks; entries of fixed blocks are ignored.
 *  @param world not NULL @param velocities one per block @param angular_velocities one per block; 2D uses z
 *  @return HS_OK or HS_ERROR_ARGUMENT, then no velocity has changed */
HS_CHECKED hs_status hs_world_set_velocities(hs_world *world, hs_view velocities, hs_view angular_velocities);

/** @brief Stage: neighbour search and detection at the present poses.
 *  @param world not NULL @param touching receives the number of pairs in contact; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_detect(hs_world *world, int64_t *touching);

/** @brief Stage: contact forces at the present poses and velocities, after hs_world_detect().
 *  @param world not NULL
 *  @param elapsed time since the last call, >= 0: shear springs grow by velocity times this
 *  @param forces receives the force on each block, in the order of hs_world_get_blocks()
 *  @param torques receives the torque about each centroid (2D: z); a view with count 0 skips it
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT, or HS_ERROR_STATE before detection at these poses */
HS_CHECKED hs_status hs_world_forces(hs_world *world, double elapsed, hs_mutable_view forces,
                                     hs_mutable_view torques);

/** @brief Steps the world.
 *  @param world not NULL
 *  @param steps >= 0
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE (no time step given and none can be derived), or HS_ERROR_OUT_OF_MEMORY or
 *  HS_ERROR_UNSTABLE or HS_ERROR_TOO_FAST: the world stays at the last good step and can be read, saved or restored. Where fast blocks had
 *  divided a step (docs/concepts/impact.md), it stays at the last good part of it, and the next call ends that step. */
HS_CHECKED hs_status hs_world_step(hs_world *world, int64_t steps);

/** @brief Time, time step, counts, energies. After a change of the world it detects and evaluates forces first, as a step would; that
 *  leaves no trace in the run. Without a time step the energies are those of before the change.
 *  @param world not NULL @param report receives them; what this library does not know of a longer struct is 0
 *  @param size sizeof(hs_world_report) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_get_report(hs_world *world, hs_world_report *report, size_t size);

/** @brief The contacts of the last detection, block a before b; none after a change of poses, blocks or laws.
 *  Contacts by laws with springs come first, one per pair, sorted by block index; their forces are 0 until they
 *  are evaluated. Contacts by laws without springs follow, one per point, as of the end of the last step: a
 *  vertex at a face, or two edges. In the step of a touch their force is the impulse that is left at the end of
 *  the step, over half the step (Li et al. 2015, sections 3 and 4).
 *  @param world not NULL @param contacts receives them; may be NULL if capacity is 0 @param capacity in contacts
 *  @param count receives their number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_contacts(const hs_world *world, hs_contact contacts[], int64_t capacity,
                                           int64_t *count);

/** @brief Preloads the shear spring of a contact, e.g. to start from equilibrium.
 *  @param world after hs_world_detect() or a step
 *  @param block_a,block_b the pair, either order
 *  @param shear_force on block_b, 3 finite values; what lies in the contact plane counts
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID if the two are not in contact, or HS_ERROR_STATE before detection at these
 *  poses and laws, or when their law has neither friction nor cohesion */
HS_CHECKED hs_status hs_world_set_shear_force(hs_world *world, hs_block block_a, hs_block block_b,
                                              const double shear_force[3]);

/** @brief Saves the whole state of motion and contact. A restored world goes on bit for bit.
 *  @param world not NULL @param bytes receives it; may be NULL if capacity is 0 @param capacity in bytes
 *  @param count receives the number of bytes; not NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED (nothing was written) or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_save(const hs_world *world, void *bytes, size_t capacity, size_t *count);

/** @brief Makes a world from saved bytes, with its blocks, ids, materials and laws.
 *  @param context owner of the allocator @param bytes from hs_world_save() @param count number of bytes
 *  @param world receives it
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_FORMAT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_restore(hs_context *context, const void *bytes, size_t count, hs_world **world);

#ifdef __cplusplus
}
#endif
#endif
