/** @file
 *  @brief Meshes: bodies of finite elements, which bend and carry waves (Wang et al. 2021, section 2.1; Li et al. 2015, section 2).
 *
 *  A mesh is nodes and cells that share them. Put into a world it is a body: its nodes move by Newton's law, with the mass of the cells
 *  lumped at them, and strain its cells. Stress is linear in Green's strain, as in affine blocks: a rotation, however large, strains
 *  nothing. Triangles and tetrahedra strain uniformly. Quads and hexahedra bend as elements of incompatible modes do, without locking;
 *  prisms do so along their height.
 *
 *  The cells at the surface of a body are blocks of the kind ::HS_BLOCK_MESH, in simplices: they meet all other blocks by the laws of
 *  their materials, and stand in all lists of blocks. Their nodes move them: no call places, pushes or removes one by itself. Two that
 *  share a node never touch.
 *
 *  Thread rule: a mesh belongs to its context, a body to its world.
 */
#ifndef HALFSPACE_MESH_H
#define HALFSPACE_MESH_H

#include "halfspace/status.h"
#include "halfspace/view.h"
#include "halfspace/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Opaque; never changes. */
typedef struct hs_mesh hs_mesh;

/** Names a body in a world: index and generation. 0 is no body. */
typedef uint64_t hs_body;

/** Kinds of cells. Nodes are numbered as Gmsh and VTK do: those of triangles and quads counter-clockwise; of a tetrahedron the fourth
 *  lies where the first three run counter-clockwise seen from the other side; of prisms and hexahedra those at the bottom come first,
 *  counter-clockwise seen from above, then those above them in the same order. */
enum {
  HS_CELL_TRIANGLE = 0,    /**< 3 nodes, 2D */
  HS_CELL_QUAD = 1,        /**< 4 nodes, 2D, convex */
  HS_CELL_TETRAHEDRON = 2, /**< 4 nodes, 3D */
  HS_CELL_PRISM = 3,       /**< 6 nodes, 3D */
  HS_CELL_HEXAHEDRON = 4   /**< 8 nodes, 3D */
};

/** Axes along which nodes are held; their sum holds along several. */
enum {
  HS_AXIS_X = 1, /**< along x */
  HS_AXIS_Y = 2, /**< along y */
  HS_AXIS_Z = 4  /**< along z, in 3D */
};

/** A mesh in numbers. Later versions may append to it. */
typedef struct hs_mesh_properties {
  int32_t dimension;          /**< 2 or 3 */
  int32_t reserved;           /**< 0 */
  int64_t node_count;         /**< nodes */
  int64_t cell_count;         /**< cells */
  int64_t surface_face_count; /**< faces, in 2D edges, that only one cell has */
  double volume;              /**< of all cells, in 2D their area */
} hs_mesh_properties;

/** The way in which a mesh is put into a world. Fill it with hs_body_def_init(). */
typedef struct hs_body_def {
  uint32_t struct_size; /**< set by hs_body_def_init() */
  int32_t material;     /**< from hs_world_add_material(), made elastic by hs_world_set_elasticity(); default 0 */
  hs_pose pose;         /**< of the frame that the nodes were given in; default: where they were given */
  double velocity[3];   /**< of all nodes; default 0 */
} hs_body_def;

/** The motion of a body. Later versions may append to it. */
typedef struct hs_body_state {
  int64_t node_count;     /**< nodes */
  int64_t cell_count;     /**< cells, with those that have been removed */
  double mass;            /**< in 2D per unit thickness */
  double centroid[3];     /**< of the nodes' masses */
  double momentum[3];     /**< of all nodes */
  double kinetic_energy;  /**< of all nodes */
  double strain_energy;   /**< of all cells */
} hs_body_state;

/** Strain and stress of a cell, on average over it. */
typedef struct hs_cell_state {
  double strain[9];     /**< Green's, from the cell as it was put into the world */
  double stress[9];     /**< Cauchy's, elastic, in space, Pa, tension > 0 */
  double strain_energy; /**< J, in 2D per unit thickness; with that of bending */
} hs_cell_state;

/** @brief Makes a mesh. What is given is copied.
 *  @param context owner of the allocator @param dimension 2 or 3
 *  @param nodes their places, m
 *  @param cell_kinds an HS_CELL_ value for each cell of this dimension @param cell_count at least 1
 *  @param cell_nodes the nodes of all cells, those of one cell after those of the other, counted from 0
 *  @param cell_node_count their number: what the kinds need
 *  @param mesh receives it; end it with hs_mesh_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_OUT_OF_MEMORY, or HS_ERROR_GEOMETRY when a node is named twice in a cell or belongs to none,
 *          a cell is inside out or flat somewhere, or a face is in more than two cells */
HS_CHECKED hs_status hs_mesh_create(hs_context *context, int32_t dimension, hs_view nodes, const int32_t cell_kinds[],
                                    int64_t cell_count, const int32_t cell_nodes[], int64_t cell_node_count, hs_mesh **mesh);

/** @brief Ends a mesh. Bodies made of it stay as they are. @param mesh may be NULL */
HS_API void hs_mesh_destroy(hs_mesh *mesh);

/** @brief What a mesh is.
 *  @param mesh not NULL @param properties receives it @param size sizeof(hs_mesh_properties) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_mesh_get_properties(const hs_mesh *mesh, hs_mesh_properties *properties, size_t size);

/** @brief Fills a body's definition with its defaults.
 *  @param def to fill @param size sizeof(hs_body_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_body_def_init(hs_body_def *def, size_t size);

/** @brief Puts a mesh into a world.
 *  @param world not NULL @param mesh of the world's dimension; may be ended afterwards @param def not NULL
 *  @param cell_materials a material for each cell, or NULL: def.material for all
 *  @param body receives its id
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, HS_ERROR_OUT_OF_MEMORY, HS_ERROR_GEOMETRY when a cell is inside out or flat where
 *          it is put, or HS_ERROR_STATE for a material that is not elastic */
HS_CHECKED hs_status hs_world_add_mesh(hs_world *world, const hs_mesh *mesh, const hs_body_def *def,
                                       const int32_t cell_materials[], hs_body *body);

/** @brief Takes a body out of the world, with the blocks at its surface.
 *  @param world not NULL @param body id
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_remove_body(hs_world *world, hs_body body);

/** @brief Takes cells out of a body: excavation. Cells and nodes that stay keep their numbers; what the cells bordered on is surface
 *  from now on. A node without any cell stays where it is, held for good, and weighs nothing.
 *  @param world not NULL @param body id @param cells of the mesh, counted from 0; what is gone already may be named @param count in cells
 *  @param released receives, for each node of the body, the force that these cells exerted on it by their stress and weight, so that
 *         hs_world_set_node_force() can fade it out; 0 where no cell is left; a view with count 0 skips it
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, HS_ERROR_OUT_OF_MEMORY, HS_ERROR_GEOMETRY when a cell that
 *          comes to the surface is too flat to touch anything, or HS_ERROR_STATE when no cell would be left */
HS_CHECKED hs_status hs_world_remove_cells(hs_world *world, hs_body body, const int32_t cells[], int64_t count,
                                           hs_mutable_view released);

/** @brief Stresses the cells of a body as they are now, e.g. as the rock around was before: each by the stress at its middle.
 *  @param world not NULL @param body id
 *  @param stress 9 values row by row, symmetric: Cauchy's at the origin, in space, Pa, tension > 0
 *  @param gradient 27 values: how that changes along x, then along y, then along z, Pa/m, each 9 values as stress; may be NULL
 *  @return HS_OK, HS_ERROR_STALE_ID, or HS_ERROR_ARGUMENT, also for a stress that strains a cell by more than 1e6 */
HS_CHECKED hs_status hs_world_set_body_stress(hs_world *world, hs_body body, const double stress[9], const double gradient[27]);

/** @brief How a body moves.
 *  @param world not NULL @param body id @param state receives it @param size sizeof(hs_body_state) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_body_state(const hs_world *world, hs_body body, hs_body_state *state, size_t size);

/** @brief Bulk: where a body's nodes are, in the order of its mesh.
 *  @param world not NULL @param body id @param positions receives as many as fit @param count receives their number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_node_positions(const hs_world *world, hs_body body, hs_mutable_view positions, int64_t *count);

/** @brief Bulk: how fast a body's nodes are.
 *  @param world not NULL @param body id @param velocities receives as many as fit @param count receives their number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_node_velocities(const hs_world *world, hs_body body, hs_mutable_view velocities,
                                                  int64_t *count);

/** @brief Bulk: all forces on a body's nodes at the end of the last step: of cells, contacts, gravity, and applied ones. At rest they are 0,
 *  but at nodes that are held: there they are what these press on their support.
 *  @param world not NULL @param body id @param forces receives as many as fit @param count receives their number; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_node_forces(const hs_world *world, hs_body body, hs_mutable_view forces, int64_t *count);

/** @brief Sets the velocities of all nodes of a body, also of those that are held.
 *  @param world not NULL @param body id @param velocities one for each node
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_node_velocities(hs_world *world, hs_body body, hs_view velocities);

/** @brief Holds nodes along axes, besides those along which they are held already: there they go on with a velocity that stays, whatever
 *  the forces. Without axes they are free from now on, along all of them.
 *  @param world not NULL @param body id @param nodes of the mesh, counted from 0 @param count in nodes
 *  @param axes a sum of HS_AXIS_ values, or 0: free
 *  @param velocity along these axes, m/s; what it has along others is not read; may be NULL without axes
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_hold_nodes(hs_world *world, hs_body body, const int32_t nodes[], int64_t count, int32_t axes,
                                         const double velocity[3]);

/** @brief Sets the force that acts on each of these nodes from outside, from now on.
 *  @param world not NULL @param body id @param nodes of the mesh, counted from 0 @param count in nodes @param force N, in 2D per unit thickness
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_node_force(hs_world *world, hs_body body, const int32_t nodes[], int64_t count,
                                             const double force[3]);

/** @brief Bulk: how a body's cells are strained and stressed, in the order of its mesh. All is 0 of a cell that has been removed.
 *  @param world not NULL @param body id @param cells receives them; may be NULL if capacity is 0 @param capacity in cells
 *  @param count receives the number of cells; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_cells(const hs_world *world, hs_body body, hs_cell_state cells[], int64_t capacity,
                                        int64_t *count);

/** @brief The body that a block is at the surface of.
 *  @param world not NULL @param block id @param body receives the body's id, or 0 for a block of another kind
 *  @param cell receives the cell of the body's mesh, or -1; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_body_of_block(const hs_world *world, hs_block block, hs_body *body, int32_t *cell);

#ifdef __cplusplus
}
#endif
#endif
