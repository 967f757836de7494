/** @file
 *  @brief A world: blocks, materials, laws and time.
 *
 *  hs_world_step() integrates a world by velocity Verlet. A host with its own integrator instead sets poses
 *  and velocities, calls hs_world_detect() and hs_world_forces(), and moves its bodies itself; affine blocks
 *  do not strain then.
 *
 *  A call that fails, and a query, change nothing: later snapshots have the same bytes. Queries of a changed
 *  world whose answers are forces or energies evaluate them in a copy.
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

/** Opaque world. */
typedef struct hs_world hs_world;

/** Id of a block: index and generation. 0 is no block; ids of removed blocks are not reused. */
typedef uint64_t hs_block;

/** Kinds of blocks. */
enum {
  HS_BLOCK_FIXED = 0,      /**< does not move */
  HS_BLOCK_PRESCRIBED = 1, /**< moves with the given velocity, whatever the forces */
  HS_BLOCK_RIGID = 2,      /**< moves by Newton's law */
  HS_BLOCK_AFFINE = 3,     /**< moves by Newton's law, with uniform strain: see affine.h */
  HS_BLOCK_MESH = 4        /**< surface cell of a mesh, moved by its nodes: made by hs_world_add_mesh(), see
                                mesh.h */
};

/** Continuous collision: treatment of a step in which two blocks in contact, or about to touch, would move by
 *  more than a quarter of the thinner block's thickness. */
enum {
  HS_FAST_DIVIDE = 0, /**< divide the step: one substep to the first touch, then small ones. More than 16384
                           substeps are HS_ERROR_TOO_FAST */
  HS_FAST_REFUSE = 1  /**< refuse the step with HS_ERROR_TOO_FAST */
};

/** Settings of a world. Fill it with hs_world_def_init(). */
typedef struct hs_world_def {
  uint32_t struct_size;  /**< set by hs_world_def_init() */
  int32_t dimension;     /**< 2 or 3, as given to hs_world_def_init() */
  double gravity[3];     /**< m/s2; default (0, -9.81, 0) in 2D, (0, 0, -9.81) in 3D */
  double time_step;      /**< s, > 0, or 0 (default): safety times the stable time step, computed at the first
                              step and after each change of the world by the host */
  double safety;         /**< factor of the stable time step, (0, 1]; default 0.5 */
  double local_damping;  /**< ratio of the damping force to the unbalanced force, per component, [0, 1);
                              default 0 */
  double mass_damping;   /**< 1/s, >= 0: force -mass_damping * mass * velocity; default 0 */
  double skin;           /**< skin of the neighbour list, as a fraction of a block's size, (0, 1]; default
                              0.1 */
  double parallel_angle; /**< rad, [0, 0.5]; default 0.01; see hs_pair_options */
  double vertex_zone;    /**< [0, 0.5]; default 1e-6; see hs_pair_options */
  double potential_length; /**< length H of HS_STIFFNESS_POTENTIAL, m, > 0; or 0 (default): mean length of all
                                edges at the first evaluation of forces */
  int32_t fast_blocks;     /**< an HS_FAST_ value; default HS_FAST_DIVIDE */
  int32_t reserved;        /**< 0 */
  double sleep_tolerance;  /**< max displacement error of a block by sleep over a run, m, >= 0; default 0: no
                                block sleeps. Meshes, and deformable worlds of HS_STIFFNESS_NONE, do not */
  double impulse_tolerance; /**< velocity that the impulses of rigid blocks without springs may leave
                                 unbalanced, over gravity times time step, > 0; default 1e-6 */
  int32_t max_impulse_iterations; /**< max sweeps of their solver per half step where blocks move past each
                                        other, >= 1; default 200 */
  int32_t locate_impacts;  /**< 1: steps are divided at the impacts of rigid blocks without springs, which makes
                                rebounds accurate; default 0 */
} hs_world_def;

/** Settings of a block. Fill it with hs_block_def_init(). */
typedef struct hs_block_def {
  uint32_t struct_size;       /**< set by hs_block_def_init() */
  int32_t kind;               /**< an HS_BLOCK_ value; default HS_BLOCK_RIGID */
  int32_t material;           /**< index from hs_world_add_material(); default 0 */
  int32_t reserved;           /**< 0 */
  hs_pose pose;               /**< default: the coordinates of the shape's vertices */
  double velocity[3];         /**< of the centroid, m/s; default 0 */
  double angular_velocity[3]; /**< rad/s; 2D uses z; default 0 */
} hs_block_def;

/** Motion of a block. */
typedef struct hs_block_state {
  int32_t kind;               /**< an HS_BLOCK_ value */
  int32_t material;           /**< index */
  hs_pose pose;               /**< of the centroid */
  double angle;               /**< 2D: rotation, rad, including full turns */
  double velocity[3];         /**< of the centroid, m/s */
  double angular_velocity[3]; /**< rad/s; 2D: z */
  double force[3];            /**< force of contacts, bonds, bolts and water at the last force evaluation, N;
                                   of contacts without springs at the end of the last step */
  double torque[3];           /**< their torque about the centroid, N m */
  double mass;                /**< kg, in 2D per unit thickness; 0 for a part of a compound */
} hs_block_state;

/** Energy ledger since the world was made, J, in 2D per unit thickness. Changes by the host (added or removed
 *  blocks, set motions) count as external work. See docs/concepts/energy.md. */
typedef struct hs_energy {
  double kinetic;         /**< current kinetic energy */
  double gravity;         /**< current potential energy of gravity, 0 at the origin */
  double strain;          /**< current energy of contact springs, bonds and bolts */
  double friction_loss;   /**< dissipated by sliding and by failure of cohesive contacts */
  double contact_damping_loss; /**< dissipated by viscous contact damping */
  double local_damping_loss;   /**< dissipated by local damping */
  double mass_damping_loss;    /**< dissipated by mass damping */
  double outer_work;      /**< work of prescribed blocks, applied forces, surface loads and changes by the
                               host */
  double residual;        /**< numerical energy error: current energy plus losses minus outer_work */
} hs_energy;

/** State of a world. Later versions may append to it. */
typedef struct hs_world_report {
  int32_t dimension;         /**< 2 or 3 */
  int32_t reserved;          /**< 0 */
  int64_t steps;             /**< completed steps */
  double time;               /**< s */
  double time_step;          /**< current time step, s */
  double stable_time_step;   /**< bound by stiffness, viscosity and mass, s; 0 without blocks that move
                                  freely */
  int64_t block_count;       /**< living blocks */
  int64_t candidate_count;   /**< pairs in the neighbour list */
  int64_t contact_count;     /**< contacts: pairs of blocks; without springs, where a block deforms, is held
                                  or may be bonded, points */
  int64_t list_builds;       /**< number of builds of the neighbour list */
  double largest_overlap;    /**< max overlap of the last detection, m */
  double largest_speed;      /**< current max speed of blocks that move freely, m/s */
  hs_energy energy;          /**< energy ledger */
  double potential_length;   /**< current length H, m; 0 without a law of potentials */
  double block_strain_energy; /**< current strain energy of affine blocks and meshes, J; included in the
                                   residual */
  double block_damping_loss; /**< dissipated by damping in affine blocks and meshes, J; included in the
                                  residual */
  int64_t divided_steps;     /**< steps divided at impacts or fast rotations */
  double max_penetration_ratio; /**< max penetration that springs allow, over the thinner block's thickness;
                                     above 0.25 increase normal_stiffness, see docs/concepts/impact.md */
  double peak_overlap;       /**< max overlap of all detections so far, m; with potentials in 3D the current
                                  max overlap */
  double peak_speed;         /**< max speed so far of blocks that move freely, over all steps and substeps,
                                  m/s */
  int64_t sleeping_count;    /**< sleeping blocks */
  double max_sleep_error;    /**< max displacement error of a block by sleep so far, m */
  int64_t touch_count;       /**< contacts so far of laws without springs that began; a point that slides to
                                  another face counts again */
  int64_t iteration_count;   /**< iterations so far of the solvers of laws without springs: sweeps over all
                                  contacts */
  double impact_loss;        /**< dissipated by impacts of laws without springs, J, in 2D per unit thickness;
                                  included in the residual */
  double unbalanced_velocity; /**< largest velocity that the impulses of rigid blocks without springs left
                                   unbalanced in the last motion, m/s */
  double water_energy;       /**< current potential energy of blocks in water, J; included in the residual */
  double bolt_strain_energy; /**< current strain energy of bolts, J; part of energy.strain */
  double bolt_loss;          /**< dissipated by yield and rupture of bolts, J; included in the residual */
} hs_world_report;

/** @brief Fills a world definition with its defaults.
 *  @param def to fill @param size sizeof(hs_world_def) as the caller was compiled
 *  @param dimension 2 or 3
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_world_def_init(hs_world_def *def, size_t size, int32_t dimension);

/** @brief Creates an empty world.
 *  @param context allocates the world and keeps error texts
 *  @param def not NULL
 *  @param world receives it; the caller destroys it with hs_world_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_create(hs_context *context, const hs_world_def *def, hs_world **world);

/** @brief Destroys a world with all its blocks and bodies. @param world may be NULL */
HS_API void hs_world_destroy(hs_world *world);

/** @brief Adds a material.
 *  @param world not NULL
 *  @param density kg/m3, > 0
 *  @param material receives its index
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_add_material(hs_world *world, double density, int32_t *material);

/** @brief Sets the law of all pairs of materials without a law of their own.
 *  @param world not NULL @param law not NULL
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_set_default_law(hs_world *world, const hs_law_def *law);

/** @brief Sets the law of two materials, in either order.
 *  @param world not NULL @param material_a,material_b indices, may be the same @param law not NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_set_law(hs_world *world, int32_t material_a, int32_t material_b,
                                      const hs_law_def *law);

/** @brief Fills a block definition with its defaults for a shape.
 *  @param def to fill @param size sizeof(hs_block_def) as the caller was compiled
 *  @param shape not NULL; its centroid is the default position
 *  @return HS_OK or HS_ERROR_ARGUMENT */
HS_API hs_status hs_block_def_init(hs_block_def *def, size_t size, const hs_shape *shape);

/** @brief Adds a block. The world copies the shape. Components of its position are at most 2^32 times its
 *  bounding radius, which limits the rounding error relative to its size.
 *  @param world not NULL @param shape not NULL @param def not NULL @param block receives its id
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID (material), HS_ERROR_STATE (affine block of a material
 *         without elasticity) or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_add_block(hs_world *world, const hs_shape *shape, const hs_block_def *def,
                                        hs_block *block);

/** @brief Removes a block; its id becomes stale. The cost is proportional to the size of the world.
 *  @param world not NULL @param block id
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_remove_block(hs_world *world, hs_block block);

/** @brief Bulk: ids of all blocks. All arrays of blocks below have this order.
 *  @param world not NULL @param blocks receives them; may be NULL if capacity is 0 @param capacity in ids
 *  @param count receives the number of blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_blocks(const hs_world *world, hs_block blocks[], int64_t capacity,
                                         int64_t *count);

/** @brief Returns the motion of a block.
 *  @param world not NULL @param block id @param state receives it
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_block_state(const hs_world *world, hs_block block, hs_block_state *state);

/** @brief Bulk: motion of all blocks, in the order of hs_world_get_blocks().
 *  @param world not NULL @param states receives them; may be NULL if capacity is 0 @param capacity in states
 *  @param count receives the number of blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_block_states(const hs_world *world, hs_block_state states[],
                                               int64_t capacity, int64_t *count);

/** @brief Returns the current positions of a block's vertices, in 2D counter-clockwise.
 *  @param world not NULL @param block id @param vertices receives them; its count is the capacity
 *  @param count receives the number of vertices; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_block_vertices(const hs_world *world, hs_block block,
                                                 hs_mutable_view vertices, int64_t *count);

/** @brief Sets the pose of a block.
 *  @param world not NULL @param block id @param pose with a position in the range of hs_world_add_block()
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_pose(hs_world *world, hs_block block, const hs_pose *pose);

/** @brief Sets the velocity and angular velocity of a block. The strain rate of an affine block does not
 *  change.
 *  @param world not NULL @param block id @param velocity of the centroid, 3 values, m/s
 *  @param angular_velocity 3 values, rad/s; 2D uses z
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE for a fixed block */
HS_CHECKED hs_status hs_world_set_velocity(hs_world *world, hs_block block, const double velocity[3],
                                           const double angular_velocity[3]);

/** @brief Sets the external force and torque on a rigid or affine block, until set again.
 *  @param world not NULL @param block id @param force at the centroid, 3 values, N
 *  @param torque about the centroid, 3 values, N m; 2D uses z
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, or HS_ERROR_STATE for other kinds */
HS_CHECKED hs_status hs_world_set_applied_force(hs_world *world, hs_block block, const double force[3],
                                                const double torque[3]);

/** @brief Bulk: poses of all blocks, in the order of hs_world_get_blocks().
 *  @param world not NULL @param poses receives them; may be NULL if capacity is 0 @param capacity in poses
 *  @param count receives the number of blocks; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_poses(const hs_world *world, hs_pose poses[], int64_t capacity,
                                        int64_t *count);

/** @brief Bulk: sets the poses of all blocks, in the order of hs_world_get_blocks().
 *  @param world not NULL @param poses one per block, with positions in the range of hs_world_add_block()
 *  @param count must be the number of blocks
 *  @return HS_OK or HS_ERROR_ARGUMENT (no block has moved) */
HS_CHECKED hs_status hs_world_set_poses(hs_world *world, const hs_pose poses[], int64_t count);

/** @brief Bulk: velocities and angular velocities of all blocks, in the order of hs_world_get_blocks().
 *  @param world not NULL @param velocities receives them, m/s; its count is the capacity
 *  @param angular_velocities receives them, rad/s; in 2D x and y are 0; a view with count 0 skips it
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_velocities(const hs_world *world, hs_mutable_view velocities,
                                             hs_mutable_view angular_velocities);

/** @brief Bulk: sets velocities and angular velocities of all blocks, in the order of hs_world_get_blocks().
 *  Entries of fixed and mesh blocks are ignored.
 *  @param world not NULL @param velocities one per block, m/s
 *  @param angular_velocities one per block, rad/s; 2D uses z; a view with count 0 keeps the current ones
 *  @return HS_OK or HS_ERROR_ARGUMENT (no velocity has changed) */
HS_CHECKED hs_status hs_world_set_velocities(hs_world *world, hs_view velocities, hs_view angular_velocities);

/** @brief Bulk: sets the external forces and torques on all rigid and affine blocks, until set again, in the
 *  order of hs_world_get_blocks(). Entries of other blocks, and of parts of compounds, are ignored.
 *  @param world not NULL @param forces one per block, at its centroid, N
 *  @param torques one per block, about its centroid, N m; 2D uses z; a view with count 0 sets them to 0
 *  @return HS_OK or HS_ERROR_ARGUMENT (no force has changed) */
HS_CHECKED hs_status hs_world_set_applied_forces(hs_world *world, hs_view forces, hs_view torques);

/** @brief Stage: neighbour search and detection at the current poses.
 *  @param world not NULL @param touching receives the number of pairs in contact; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE (a share that was not assembled after a change of laws) or
 *          HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_detect(hs_world *world, int64_t *touching);

/** @brief Stage: forces of contacts, bonds, bolts and water at the current poses and velocities, after
 *  hs_world_detect(). Contacts of laws without springs are left out: only steps have them.
 *  @param world not NULL
 *  @param elapsed time since the last call, s, >= 0: shear springs extend by velocity times this. If it is not 0,
 *         velocities are those of its middle, as a leapfrog's between two positions: they are turned to the
 *         present poses, so that two blocks that turn as one have no slip
 *  @param forces receives the force on each block, N, in the order of hs_world_get_blocks()
 *  @param torques receives the torque about each centroid, N m (2D: z); a view with count 0 skips it
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT, or HS_ERROR_STATE before detection at these poses */
HS_CHECKED hs_status hs_world_forces(hs_world *world, double elapsed, hs_mutable_view forces,
                                     hs_mutable_view torques);

/** @brief Steps the world. After an error it keeps the last valid state, and can be read or saved. Within a
 *  divided step (docs/concepts/impact.md) this is the last valid substep, and the next call completes the
 *  step.
 *  @param world not NULL
 *  @param steps number of steps, >= 0; 0: contacts and forces of a changed world are evaluated, if it has a time
 *         step
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE (no time step given and none can be derived),
 *         HS_ERROR_OUT_OF_MEMORY, HS_ERROR_UNSTABLE, HS_ERROR_TOO_FAST, HS_ERROR_INVERTED or
 *         HS_ERROR_INTERRUPTED */
HS_CHECKED hs_status hs_world_step(hs_world *world, int64_t steps);

/** @brief Returns time, time step, counts and energies. After a change of the world it detects contacts and
 *  evaluates forces first, without any effect on the run. Without a time step, or in a share until it has
 *  begun, the energies are those before the change.
 *  @param world not NULL @param report receives it; fields unknown to this version of the library are 0
 *  @param size sizeof(hs_world_report) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_get_report(hs_world *world, hs_world_report *report, size_t size);

/** @brief Bulk: contacts of the last detection, with block a before b; none after a change of poses, blocks
 *  or laws. Contacts of laws with springs are first, one per pair, sorted by block index; their forces are 0
 *  until evaluated. Contacts of laws without springs follow, at the end of the last step: of blocks that
 *  deform, are held or may be bonded one per point (vertex-face or edge-edge), then of rigid blocks one per
 *  pair. In the step of a touch their force is the remaining impulse divided by half the step (Li et al. 2015,
 *  sections 3 and 4).
 *  @param world not NULL @param contacts receives them; may be NULL if capacity is 0
 *  @param capacity in contacts
 *  @param count receives their number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED or HS_ERROR_ARGUMENT */
HS_CHECKED hs_status hs_world_get_contacts(const hs_world *world, hs_contact contacts[], int64_t capacity,
                                           int64_t *count);

/** @brief Preloads the shear spring of a contact, e.g. to start from equilibrium.
 *  @param world after hs_world_detect() or a step
 *  @param block_a,block_b the pair, either order
 *  @param shear_force on block_b, 3 values, N; only the component in the contact plane is used
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID if they are not in contact, or HS_ERROR_STATE before
 *         detection at these poses and laws, or if their law has neither friction nor cohesion */
HS_CHECKED hs_status hs_world_set_shear_force(hs_world *world, hs_block block_a, hs_block block_b,
                                              const double shear_force[3]);

/** @brief Saves a snapshot of the complete state. A restored world continues bit for bit.
 *  @param world not NULL, not within a step in pieces (share.h)
 *  @param bytes receives it; may be NULL if capacity is 0 @param capacity in bytes
 *  @param count receives the size of the snapshot in bytes; not NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED (nothing was written), HS_ERROR_ARGUMENT or HS_ERROR_STATE (within
 *          a step) */
HS_CHECKED hs_status hs_world_save(const hs_world *world, void *bytes, size_t capacity, size_t *count);

/** @brief Creates a world from a snapshot, with the same ids, materials and laws.
 *  @param context allocates the world and keeps error texts @param bytes from hs_world_save()
 *  @param count number of bytes
 *  @param world receives it; the caller destroys it with hs_world_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_FORMAT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_world_restore(hs_context *context, const void *bytes, size_t count, hs_world **world);

#ifdef __cplusplus
}
#endif
#endif
