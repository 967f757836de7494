/** @file
 *  @brief Meshes: bodies of finite elements (Wang et al. 2021, section 2.1; Li et al. 2015, section 2).
 *
 *  A mesh has nodes, and cells that share them. A mesh that is added to a world is a body: its nodes move by
 *  Newton's law with lumped masses, and its cells strain. As in affine blocks, the second Piola-Kirchhoff
 *  stress is linear in the Green strain, so rotations of any size cause no strain. Triangles and tetrahedra
 *  have uniform strain. Quads and hexahedra have incompatible bending modes, without locking; prisms have
 *  them along their height.
 *
 *  The surface cells of a body, divided into simplices, are blocks of the kind ::HS_BLOCK_MESH: they are in
 *  contact with other blocks by the laws of their materials, and are in all lists of blocks. Only nodes move
 *  them: functions that move, load or remove a single block refuse them. Two cells that share a node are
 *  never in contact.
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

/** Opaque, immutable mesh. */
typedef struct hs_mesh hs_mesh;

/** Id of a body in a world: index and generation. 0 is no body. */
typedef uint64_t hs_body;

/** Kinds of cells. Nodes are numbered as in Gmsh and VTK: triangles and quads counter-clockwise; the first
 *  three nodes of a tetrahedron counter-clockwise seen from the fourth; prisms and hexahedra with the bottom
 *  face first, counter-clockwise seen from above, then the top face in the same order. */
enum {
  HS_CELL_TRIANGLE = 0,    /**< 3 nodes, 2D */
  HS_CELL_QUAD = 1,        /**< 4 nodes, 2D, convex */
  HS_CELL_TETRAHEDRON = 2, /**< 4 nodes, 3D */
  HS_CELL_PRISM = 3,       /**< 6 nodes, 3D */
  HS_CELL_HEXAHEDRON = 4   /**< 8 nodes, 3D */
};

/** Axes along which nodes or blocks are held. Values may be added. */
enum {
  HS_AXIS_X = 1,       /**< x */
  HS_AXIS_Y = 2,       /**< y */
  HS_AXIS_Z = 4,       /**< z, 3D only */
  HS_AXIS_ROTATION = 8 /**< rotation about any axis, of blocks only */
};

/** Summary of a mesh. Later versions may append to it. */
typedef struct hs_mesh_properties {
  int32_t dimension;          /**< 2 or 3 */
  int32_t reserved;           /**< 0 */
  int64_t node_count;         /**< nodes */
  int64_t cell_count;         /**< cells */
  int64_t surface_face_count; /**< faces (2D: edges) that belong to one cell only */
  double volume;              /**< of all cells, m3; in 2D area, m2 */
} hs_mesh_properties;

/** Settings of a body. Fill it with hs_body_def_init(). */
typedef struct hs_body_def {
  uint32_t struct_size; /**< set by hs_body_def_init() */
  int32_t material;     /**< index of a material with elasticity, see hs_world_set_elasticity(); default 0 */
  hs_pose pose;         /**< pose of the frame of the mesh; default: identity */
  double velocity[3];   /**< of all nodes, m/s; default 0 */
} hs_body_def;

/** Motion and energy of a body. Later versions may append to it. */
typedef struct hs_body_state {
  int64_t node_count;     /**< nodes */
  int64_t cell_count;     /**< cells, including removed ones */
  double mass;            /**< kg, in 2D per unit thickness */
  double centroid[3];     /**< center of mass, m */
  double momentum[3];     /**< of all nodes, kg m/s */
  double kinetic_energy;  /**< of all nodes, J */
  double strain_energy;   /**< of all cells, J */
} hs_body_state;

/** Mean strain and stress of a cell. */
typedef struct hs_cell_state {
  double strain[9];     /**< Green strain relative to the cell as it was added to the world */
  double stress[9];     /**< elastic Cauchy stress, in space, Pa, tension > 0 */
  double strain_energy; /**< J, in 2D per unit thickness; including the bending modes */
} hs_cell_state;

/** @brief Creates a mesh. The arguments are copied.
 *  @param context allocates the mesh and keeps error texts @param dimension 2 or 3
 *  @param nodes positions of the nodes, m; at most 2^28
 *  @param cell_kinds one HS_CELL_ value of this dimension per cell @param cell_count from 1 to 2^28
 *  @param cell_nodes node indices of all cells, cell after cell
 *  @param cell_node_count length of cell_nodes: the number of nodes that all kinds have together
 *  @param mesh receives it; the caller destroys it with hs_mesh_destroy()
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_OUT_OF_MEMORY, or HS_ERROR_GEOMETRY if a cell uses a node
 *         twice, a node belongs to no cell, a cell is inverted or degenerate anywhere, or a face belongs to
 *         more than two cells */
HS_CHECKED hs_status hs_mesh_create(hs_context *context, int32_t dimension, hs_view nodes,
                                    const int32_t cell_kinds[], int64_t cell_count,
                                    const int32_t cell_nodes[], int64_t cell_node_count, hs_mesh **mesh);

/** @brief Destroys a mesh. Bodies made of it do not change. @param mesh may be NULL */
HS_API void hs_mesh_destroy(hs_mesh *mesh);

/** @brief Returns a summary of a mesh.
 *  @param mesh not NULL @param properties receives it
 *  @param size sizeof(hs_mesh_properties) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_mesh_get_properties(const hs_mesh *mesh, hs_mesh_properties *properties, size_t size);

/** @brief Fills a body definition with its defaults.
 *  @param def to fill @param size sizeof(hs_body_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_body_def_init(hs_body_def *def, size_t size);

/** @brief Adds a copy of a mesh to a world, as a body.
 *  @param world not NULL @param mesh of the world's dimension; may be destroyed afterwards
 *  @param def not NULL
 *  @param cell_materials one material index per cell, or NULL: def.material for all cells
 *  @param body receives its id
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, HS_ERROR_OUT_OF_MEMORY, HS_ERROR_GEOMETRY if rounding
 *         at def.pose inverts or flattens a cell, or HS_ERROR_STATE for a material without elasticity */
HS_CHECKED hs_status hs_world_add_mesh(hs_world *world, const hs_mesh *mesh, const hs_body_def *def,
                                       const int32_t cell_materials[], hs_body *body);

/** @brief Removes a body and its surface blocks from the world. Its id becomes stale.
 *  @param world not NULL @param body id
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_remove_body(hs_world *world, hs_body body);

/** @brief Removes cells of a body (excavation). Indices of the other cells and nodes do not change; the faces
 *  of neighbour cells become surface. A node without cells has no mass and stays at rest.
 *  @param world not NULL @param body id @param cells indices of cells; removed ones are allowed
 *  @param count in cells
 *  @param released receives, per node of the body, the force that these cells exerted on it by their stress
 *         and weight, to be applied by hs_world_set_node_force() and reduced gradually; 0 for a node without
 *         cells; a view with count 0 skips it
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT, HS_ERROR_STALE_ID, HS_ERROR_OUT_OF_MEMORY,
 *         HS_ERROR_GEOMETRY if a new surface cell is too flat for contact, or HS_ERROR_STATE if no cell would
 *         remain */
HS_CHECKED hs_status hs_world_remove_cells(hs_world *world, hs_body body, const int32_t cells[],
                                           int64_t count, hs_mutable_view released);

/** @brief Sets the current stress of the cells of a body, e.g. the in situ stress, linear in space: each cell
 *  gets the stress at its center.
 *  @param world not NULL @param body id
 *  @param stress Cauchy stress at the origin, in space, 9 values row by row, symmetric, Pa, tension > 0
 *  @param gradient derivatives of the stress along x, y and z, Pa/m, 3 x 9 values as stress; may be NULL
 *  @return HS_OK, HS_ERROR_STALE_ID, or HS_ERROR_ARGUMENT, also for a stress that strains a cell by more than
 *         1e6 */
HS_CHECKED hs_status hs_world_set_body_stress(hs_world *world, hs_body body, const double stress[9],
                                              const double gradient[27]);

/** @brief Returns motion and energy of a body.
 *  @param world not NULL @param body id @param state receives it
 *  @param size sizeof(hs_body_state) as the caller was compiled
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_body_state(const hs_world *world, hs_body body, hs_body_state *state,
                                             size_t size);

/** @brief Bulk: positions of a body's nodes, m, in the order of its mesh.
 *  @param world not NULL @param body id @param positions receives as many as fit
 *  @param count receives the number of nodes; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_node_positions(const hs_world *world, hs_body body,
                                                 hs_mutable_view positions, int64_t *count);

/** @brief Bulk: velocities of a body's nodes, m/s, in the order of its mesh.
 *  @param world not NULL @param body id @param velocities receives as many as fit
 *  @param count receives the number of nodes; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_node_velocities(const hs_world *world, hs_body body,
                                                  hs_mutable_view velocities, int64_t *count);

/** @brief Bulk: total forces on a body's nodes at the end of the last step (cells, contacts, gravity,
 *  applied), N, in 2D per unit thickness. In equilibrium they are 0, except at held nodes: there they are the
 *  forces on the support.
 *  @param world not NULL @param body id @param forces receives as many as fit
 *  @param count receives the number of nodes; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_node_forces(const hs_world *world, hs_body body, hs_mutable_view forces,
                                              int64_t *count);

/** @brief Sets the velocities of all nodes of a body, including held ones.
 *  @param world not NULL @param body id @param velocities one per node, m/s
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_node_velocities(hs_world *world, hs_body body, hs_view velocities);

/** @brief Prescribes a constant velocity of nodes along axes, in addition to axes held before; or frees the
 *  nodes along all axes.
 *  @param world not NULL @param body id @param nodes indices of nodes @param count in nodes
 *  @param axes sum of HS_AXIS_ values, or 0: frees the nodes
 *  @param velocity 3 values, m/s; components along other axes are ignored; may be NULL if axes is 0
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_hold_nodes(hs_world *world, hs_body body, const int32_t nodes[], int64_t count,
                                         int32_t axes, const double velocity[3]);

/** @brief Sets the external force on each of these nodes, until set again.
 *  @param world not NULL @param body id @param nodes indices of nodes @param count in nodes
 *  @param force 3 values, N, in 2D per unit thickness
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_set_node_force(hs_world *world, hs_body body, const int32_t nodes[],
                                             int64_t count, const double force[3]);

/** @brief Bulk: strain and stress of a body's cells, in the order of its mesh; 0 for removed cells.
 *  @param world not NULL @param body id @param cells receives them; may be NULL if capacity is 0
 *  @param capacity in cells
 *  @param count receives the number of cells; may be NULL
 *  @return HS_OK, HS_NOTE_TRUNCATED, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_cells(const hs_world *world, hs_body body, hs_cell_state cells[],
                                        int64_t capacity, int64_t *count);

/** @brief Returns the body and cell of a surface block.
 *  @param world not NULL @param block id
 *  @param body receives the id of the body, or 0 for a block of another kind
 *  @param cell receives the index of the cell, or -1; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STALE_ID */
HS_CHECKED hs_status hs_world_get_body_of_block(const hs_world *world, hs_block block, hs_body *body,
                                                int32_t *cell);

#ifdef __cplusplus
}
#endif
#endif
