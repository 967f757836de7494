/* The public headers of version 0.1 without comments. */
#include <stddef.h>
#include <stdint.h>
typedef int32_t hs_status;
enum { HS_OK = 0, HS_NOTE_TRUNCATED = 1, HS_NOTE_NOT_AT_REST = 2, HS_ERROR_ARGUMENT = -1, HS_ERROR_GEOMETRY = -2, HS_ERROR_STALE_ID = -3, HS_ERROR_OUT_OF_MEMORY = -4, HS_ERROR_STATE = -5, HS_ERROR_UNSTABLE = -6, HS_ERROR_FORMAT = -7, HS_ERROR_INTERNAL = -8, HS_ERROR_TOO_FAST = -9, HS_ERROR_INVERTED = -10, };
__attribute__((visibility("default"))) const char *hs_status_string(hs_status status);
__attribute__((visibility("default"))) const char *hs_version(void);
enum {
  HS_CONTACT_NONE = 0,
  HS_CONTACT_VERTEX_VERTEX = 1,
  HS_CONTACT_VERTEX_EDGE = 2,
  HS_CONTACT_EDGE_EDGE = 3,
  HS_CONTACT_EDGE_FACE = 4,
  HS_CONTACT_FACE_FACE = 5,
  HS_CONTACT_VERTEX_FACE = 6
};
enum {
  HS_PAIR_FACE_VERTEX = 0,
  HS_PAIR_VERTEX_FACE = 1,
  HS_PAIR_EDGE_EDGE = 2,
  HS_PAIR_VERTEX_VERTEX = 3
};
enum { HS_CONTACT_POINTS = 8 };
typedef struct hs_contact {
  uint64_t block_a;
  uint64_t block_b;
  int32_t type;
  int32_t point_count;
  int32_t pair_kind;
  int32_t feature_a;
  int32_t feature_b;
  int32_t reserved;
  double normal[3];
  double gap;
  double area;
  double length;
  double center[3];
  double center_gap;
  double points[HS_CONTACT_POINTS][3];
  double gaps[HS_CONTACT_POINTS];
  double force[3];
  double torque[3];
  double force_point[3];
  double normal_force;
  double shear_force[3];
  double twist;
  double touched_at;
} hs_contact;
enum {
  HS_STIFFNESS_PER_CONTACT = 0,
  HS_STIFFNESS_PER_AREA = 1,
  HS_STIFFNESS_POTENTIAL = 2,
  HS_STIFFNESS_NONE = 3
};
typedef struct hs_law_def {
  uint32_t struct_size;
  int32_t stiffness_kind;
  double normal_stiffness;
  double shear_stiffness;
  double friction_angle;
  double cohesion;
  double tensile_strength;
  double normal_damping;
  double shear_damping;
} hs_law_def;
__attribute__((visibility("default"))) hs_status hs_law_def_init(hs_law_def *def, size_t size);
typedef struct hs_context hs_context;
typedef struct hs_task hs_task;
typedef struct hs_context_def {
  uint32_t struct_size;
  uint32_t reserved;
  void *(*allocate)(size_t bytes, size_t alignment, void *user);
  void (*release)(void *memory, size_t bytes, size_t alignment, void *user);
  void *user;
  int32_t threads;
  uint32_t reserved_2;
  void (*run_tasks)(hs_task *task, int32_t count, void *scheduler);
  void *scheduler;
} hs_context_def;
__attribute__((visibility("default"))) hs_status hs_context_def_init(hs_context_def *def, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_context_create(const hs_context_def *def, hs_context **context);
__attribute__((visibility("default"))) void hs_task_run(hs_task *task, int32_t index);
__attribute__((visibility("default"))) void hs_context_destroy(hs_context *context);
__attribute__((visibility("default"))) const char *hs_context_last_error(const hs_context *context);
typedef struct hs_view {
  const double *x;
  const double *y;
  const double *z;
  int64_t stride;
  int64_t count;
} hs_view;
typedef struct hs_mutable_view {
  double *x;
  double *y;
  double *z;
  int64_t stride;
  int64_t count;
} hs_mutable_view;
typedef struct hs_pose {
  double position[3];
  double rotation[4];
} hs_pose;
typedef struct hs_shape hs_shape;
enum {
  HS_FAULT_NONE = 0,
  HS_FAULT_TOO_FEW_VERTICES = 1,
  HS_FAULT_NOT_FINITE = 2,
  HS_FAULT_REPEATED_VERTEX = 3,
  HS_FAULT_COLLINEAR_VERTEX = 4,
  HS_FAULT_NOT_CONVEX = 5,
  HS_FAULT_SELF_CROSSING = 6,
  HS_FAULT_ZERO_AREA = 7,
  HS_FAULT_FEWER_THAN_FOUR = 8,
  HS_FAULT_FACE_TOO_SHORT = 9,
  HS_FAULT_NO_SUCH_VERTEX = 10,
  HS_FAULT_VERTEX_TWICE_IN_FACE = 11,
  HS_FAULT_UNUSED_VERTEX = 12,
  HS_FAULT_UNMATCHED_EDGE = 13,
  HS_FAULT_VERTEX_INSIDE_EDGE = 14,
  HS_FAULT_NOT_ONE_SURFACE = 15,
  HS_FAULT_OUT_OF_RANGE = 16,
  HS_FAULT_COINCIDING_VERTICES = 17,
  HS_FAULT_ZERO_VOLUME = 18,
  HS_FAULT_FACE_WITHOUT_AREA = 19,
  HS_FAULT_FACE_NOT_PLANE = 20,
  HS_FAULT_VERTEX_OUTSIDE_FACE = 21,
  HS_FAULT_COPLANAR_FACES = 22,
  HS_FAULT_HULL_FAILED = 23,
  HS_FAULT_NO_DIRECTION = 24,
  HS_FAULT_UNBOUNDED = 25,
  HS_FAULT_NO_COMMON_POINT = 26,
  HS_FAULT_BEYOND_TOLERANCE = 27
};
typedef struct hs_fault {
  int32_t kind;
  int32_t reserved;
  int64_t vertex;
  int64_t face;
} hs_fault;
typedef struct hs_shape_properties {
  int32_t dimension;
  int32_t reserved;
  int64_t vertex_count;
  int64_t edge_count;
  int64_t face_count;
  double volume;
  double centroid[3];
  double second_moment[6];
  double bounding_radius;
  double shortest_edge;
} hs_shape_properties;
typedef struct hs_clean_report {
  int64_t welded;
  int64_t straightened;
  int32_t reversed;
  int32_t reserved;
} hs_clean_report;
typedef struct hs_fit_report {
  hs_fault fault;
  int64_t merged;
  double deviation;
  double moved;
  double sufficient_tolerance;
} hs_fit_report;
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polygon_check(hs_context *context, hs_view vertices, hs_fault *fault);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polygon_create(hs_context *context, hs_view vertices, hs_shape **shape);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polygon_create_hull(hs_context *context, hs_view points, hs_shape **shape);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polygon_create_boundary(hs_context *context, const double before[3],
                                                const double first[3], const double second[3],
                                                const double after[3], double depth, hs_shape **shape);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polygon_clean(hs_context *context, hs_view vertices, double tolerance,
                                      hs_mutable_view cleaned, int64_t *count, hs_clean_report *report);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polyhedron_check(hs_context *context, hs_view vertices, const int32_t face_sizes[],
                                         int64_t face_count, const int32_t face_vertices[], hs_fault *fault);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polyhedron_create(hs_context *context, hs_view vertices, const int32_t face_sizes[],
                                          int64_t face_count, const int32_t face_vertices[],
                                          hs_shape **shape);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polyhedron_create_hull(hs_context *context, hs_view points, hs_shape **shape);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polyhedron_create_fitted(hs_context *context, hs_view vertices,
                                                 const int32_t face_sizes[], int64_t face_count,
                                                 const int32_t face_vertices[], double tolerance,
                                                 hs_shape **shape, hs_fit_report *report);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_polyhedron_create_from_halfspaces(hs_context *context, hs_view normals,
                                                          const double offsets[], hs_shape **shape);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_shape_cut(const hs_shape *shape, const double point[3], const double normal[3],
                                  hs_shape **behind, hs_shape **ahead);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_shape_get_properties(const hs_shape *shape, hs_shape_properties *properties,
                                             size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_shape_get_vertices(const hs_shape *shape, hs_mutable_view vertices, int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_shape_get_faces(const hs_shape *shape, int32_t first_of_face[], int64_t face_capacity,
                                        int32_t face_vertices[], int64_t vertex_capacity, int64_t *face_count,
                                        int64_t *vertex_count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_shape_get_edges(const hs_shape *shape, int32_t edge_vertices[], int64_t capacity,
                                        int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_shape_get_halfspaces(const hs_shape *shape, hs_mutable_view normals, double offsets[],
                                             int64_t *count);
__attribute__((visibility("default"))) void hs_shape_destroy(hs_shape *shape);
typedef struct hs_world hs_world;
typedef uint64_t hs_block;
enum {
  HS_BLOCK_FIXED = 0,
  HS_BLOCK_PRESCRIBED = 1,
  HS_BLOCK_RIGID = 2,
  HS_BLOCK_AFFINE = 3,
  HS_BLOCK_MESH = 4
};
enum {
  HS_FAST_DIVIDE = 0,
  HS_FAST_REFUSE = 1
};
typedef struct hs_world_def {
  uint32_t struct_size;
  int32_t dimension;
  double gravity[3];
  double time_step;
  double safety;
  double local_damping;
  double mass_damping;
  double skin;
  double parallel_angle;
  double vertex_zone;
  double potential_length;
  int32_t fast_blocks;
  int32_t reserved;
  double sleep_tolerance;
} hs_world_def;
typedef struct hs_block_def {
  uint32_t struct_size;
  int32_t kind;
  int32_t material;
  int32_t reserved;
  hs_pose pose;
  double velocity[3];
  double angular_velocity[3];
} hs_block_def;
typedef struct hs_block_state {
  int32_t kind;
  int32_t material;
  hs_pose pose;
  double angle;
  double velocity[3];
  double angular_velocity[3];
  double force[3];
  double torque[3];
  double mass;
} hs_block_state;
typedef struct hs_energy {
  double kinetic;
  double gravity;
  double strain;
  double friction_loss;
  double contact_damping_loss;
  double local_damping_loss;
  double mass_damping_loss;
  double outer_work;
  double residual;
} hs_energy;
typedef struct hs_world_report {
  int32_t dimension;
  int32_t reserved;
  int64_t steps;
  double time;
  double time_step;
  double stable_time_step;
  int64_t block_count;
  int64_t candidate_count;
  int64_t contact_count;
  int64_t list_builds;
  double largest_overlap;
  double largest_speed;
  hs_energy energy;
  double potential_length;
  double block_strain_energy;
  double block_damping_loss;
  int64_t divided_steps;
  double max_penetration_ratio;
  double peak_overlap;
  double peak_speed;
  int64_t sleeping_count;
  double max_sleep_error;
  int64_t touch_count;
  int64_t iteration_count;
  double impact_loss;
} hs_world_report;
__attribute__((visibility("default"))) hs_status hs_world_def_init(hs_world_def *def, size_t size, int32_t dimension);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_create(hs_context *context, const hs_world_def *def, hs_world **world);
__attribute__((visibility("default"))) void hs_world_destroy(hs_world *world);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_add_material(hs_world *world, double density, int32_t *material);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_default_law(hs_world *world, const hs_law_def *law);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_law(hs_world *world, int32_t material_a, int32_t material_b,
                                      const hs_law_def *law);
__attribute__((visibility("default"))) hs_status hs_block_def_init(hs_block_def *def, size_t size, const hs_shape *shape);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_add_block(hs_world *world, const hs_shape *shape, const hs_block_def *def,
                                        hs_block *block);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_remove_block(hs_world *world, hs_block block);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_blocks(const hs_world *world, hs_block blocks[], int64_t capacity,
                                         int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_block_state(const hs_world *world, hs_block block, hs_block_state *state);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_block_vertices(const hs_world *world, hs_block block,
                                                 hs_mutable_view vertices, int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_pose(hs_world *world, hs_block block, const hs_pose *pose);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_velocity(hs_world *world, hs_block block, const double velocity[3],
                                           const double angular_velocity[3]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_applied_force(hs_world *world, hs_block block, const double force[3],
                                                const double torque[3]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_poses(const hs_world *world, hs_pose poses[], int64_t capacity,
                                        int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_poses(hs_world *world, const hs_pose poses[], int64_t count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_velocities(const hs_world *world, hs_mutable_view velocities,
                                             hs_mutable_view angular_velocities);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_velocities(hs_world *world, hs_view velocities, hs_view angular_velocities);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_detect(hs_world *world, int64_t *touching);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_forces(hs_world *world, double elapsed, hs_mutable_view forces,
                                     hs_mutable_view torques);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_step(hs_world *world, int64_t steps);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_report(hs_world *world, hs_world_report *report, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_contacts(const hs_world *world, hs_contact contacts[], int64_t capacity,
                                           int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_shear_force(hs_world *world, hs_block block_a, hs_block block_b,
                                              const double shear_force[3]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_save(const hs_world *world, void *bytes, size_t capacity, size_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_restore(hs_context *context, const void *bytes, size_t count, hs_world **world);
enum {
  HS_PLANE_STRAIN = 0,
  HS_PLANE_STRESS = 1
};
typedef struct hs_elasticity_def {
  uint32_t struct_size;
  int32_t plane;
  double young_modulus;
  double poisson_ratio;
  double damping_time;
} hs_elasticity_def;
typedef struct hs_deformation {
  double gradient[9];
  double rate[9];
  double strain[9];
  double stress[9];
  double strain_energy;
} hs_deformation;
__attribute__((visibility("default"))) hs_status hs_elasticity_def_init(hs_elasticity_def *def, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_elasticity(hs_world *world, int32_t material,
                                             const hs_elasticity_def *elasticity);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_deformation(const hs_world *world, hs_block block,
                                              hs_deformation *deformation);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_deformations(const hs_world *world, hs_deformation deformations[],
                                               int64_t capacity, int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_deformation(hs_world *world, hs_block block, const double gradient[9],
                                              const double rate[9]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_stress(hs_world *world, hs_block block, const double stress[9]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_add_surface_load(hs_world *world, hs_block block, int32_t face,
                                               const double traction[3]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_clear_surface_loads(hs_world *world, hs_block block);
typedef struct hs_bond_def {
  uint32_t struct_size;
  int32_t reserved;
  double normal_stiffness;
  double shear_stiffness;
  double tensile_strength;
  double cohesion;
  double friction_angle;
  double residual_cohesion;
  double residual_friction_angle;
  double tensile_fracture_energy;
  double shear_fracture_energy;
} hs_bond_def;
enum {
  HS_BOND_HOLDS = 0,
  HS_BOND_TENSION = 1,
  HS_BOND_SHEAR = 2
};
typedef struct hs_bond {
  hs_block block_a;
  hs_block block_b;
  int32_t is_joint;
  int32_t point_count;
  int32_t broken_count;
  int32_t reserved;
  double area;
  double damage;
  double normal_force;
  double shear_force[3];
} hs_bond;
typedef struct hs_bond_event {
  int64_t bond;
  int64_t step;
  int32_t failure;
  int32_t point;
  double time;
  double position[3];
  double normal[3];
  double area;
  double normal_traction;
  double shear_traction;
  double energy;
} hs_bond_event;
typedef struct hs_bond_report {
  int64_t bond_count;
  int64_t joint_count;
  int64_t event_count;
  double crack_area;
  double strain_energy;
  double fracture_loss;
} hs_bond_report;
__attribute__((visibility("default"))) hs_status hs_bond_def_init(hs_bond_def *def, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_bond_blocks(hs_world *world, hs_block block_a, hs_block block_b, const hs_bond_def *def);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_bond_materials(hs_world *world, int32_t material_a, int32_t material_b, const hs_bond_def *def,
                                             int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_hold_bonds(hs_world *world, int32_t are_held);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_bonds(const hs_world *world, hs_bond bonds[], int64_t capacity, int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_bond_events(const hs_world *world, int64_t first, hs_bond_event events[], int64_t capacity,
                                              int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_bond_report(const hs_world *world, hs_bond_report *report, size_t size);
enum {
  HS_IMPACT_NEVER = 0,
  HS_IMPACT_AT_START = 1,
  HS_IMPACT_TOUCH = 2
};
typedef struct hs_motion_def {
  uint32_t struct_size;
  uint32_t reserved;
  hs_pose start;
  double velocity[3];
  double angular_velocity[3];
  double gradient[9];
  double gradient_rate[9];
} hs_motion_def;
typedef struct hs_impact {
  int32_t state;
  int32_t pair_kind;
  int32_t feature_a;
  int32_t feature_b;
  double time;
  double gap;
  double normal[3];
  double point[3];
} hs_impact;
__attribute__((visibility("default"))) hs_status hs_motion_def_init(hs_motion_def *def, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_pair_time_of_impact(const hs_shape *shape_a, const hs_motion_def *motion_a,
                                            const hs_shape *shape_b, const hs_motion_def *motion_b,
                                            double duration, hs_impact *impact);
typedef struct hs_mesh hs_mesh;
typedef uint64_t hs_body;
enum {
  HS_CELL_TRIANGLE = 0,
  HS_CELL_QUAD = 1,
  HS_CELL_TETRAHEDRON = 2,
  HS_CELL_PRISM = 3,
  HS_CELL_HEXAHEDRON = 4
};
enum {
  HS_AXIS_X = 1,
  HS_AXIS_Y = 2,
  HS_AXIS_Z = 4
};
typedef struct hs_mesh_properties {
  int32_t dimension;
  int32_t reserved;
  int64_t node_count;
  int64_t cell_count;
  int64_t surface_face_count;
  double volume;
} hs_mesh_properties;
typedef struct hs_body_def {
  uint32_t struct_size;
  int32_t material;
  hs_pose pose;
  double velocity[3];
} hs_body_def;
typedef struct hs_body_state {
  int64_t node_count;
  int64_t cell_count;
  double mass;
  double centroid[3];
  double momentum[3];
  double kinetic_energy;
  double strain_energy;
} hs_body_state;
typedef struct hs_cell_state {
  double strain[9];
  double stress[9];
  double strain_energy;
} hs_cell_state;
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_mesh_create(hs_context *context, int32_t dimension, hs_view nodes, const int32_t cell_kinds[],
                                    int64_t cell_count, const int32_t cell_nodes[], int64_t cell_node_count, hs_mesh **mesh);
__attribute__((visibility("default"))) void hs_mesh_destroy(hs_mesh *mesh);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_mesh_get_properties(const hs_mesh *mesh, hs_mesh_properties *properties, size_t size);
__attribute__((visibility("default"))) hs_status hs_body_def_init(hs_body_def *def, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_add_mesh(hs_world *world, const hs_mesh *mesh, const hs_body_def *def,
                                       const int32_t cell_materials[], hs_body *body);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_remove_body(hs_world *world, hs_body body);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_remove_cells(hs_world *world, hs_body body, const int32_t cells[], int64_t count,
                                           hs_mutable_view released);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_body_stress(hs_world *world, hs_body body, const double stress[9], const double gradient[27]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_body_state(const hs_world *world, hs_body body, hs_body_state *state, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_node_positions(const hs_world *world, hs_body body, hs_mutable_view positions, int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_node_velocities(const hs_world *world, hs_body body, hs_mutable_view velocities,
                                                  int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_node_forces(const hs_world *world, hs_body body, hs_mutable_view forces, int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_node_velocities(hs_world *world, hs_body body, hs_view velocities);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_hold_nodes(hs_world *world, hs_body body, const int32_t nodes[], int64_t count, int32_t axes,
                                         const double velocity[3]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_node_force(hs_world *world, hs_body body, const int32_t nodes[], int64_t count,
                                             const double force[3]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_cells(const hs_world *world, hs_body body, hs_cell_state cells[], int64_t capacity,
                                        int64_t *count);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_body_of_block(const hs_world *world, hs_block block, hs_body *body, int32_t *cell);
typedef struct hs_pair_cache {
  int32_t state;
  int32_t pair_kind;
  int32_t feature_a;
  int32_t feature_b;
  uint64_t shapes;
  double reach;
  double normal[3];
  double rotation_a[4];
  double rotation_b[4];
} hs_pair_cache;
typedef struct hs_pair_options {
  uint32_t struct_size;
  uint32_t reserved;
  double parallel_angle;
  double vertex_zone;
  double margin;
  int32_t without_region;
  int32_t reserved_2;
} hs_pair_options;
__attribute__((visibility("default"))) hs_status hs_pair_options_init(hs_pair_options *options, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_pair_detect(const hs_shape *shape_a, const hs_pose *pose_a, const hs_shape *shape_b,
                                    const hs_pose *pose_b, const hs_pair_options *options,
                                    hs_pair_cache *cache, hs_contact *contact);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_pairs_detect(hs_context *context, const hs_shape *const shapes[],
                                     const hs_pose poses[], int64_t body_count, const int32_t pairs[],
                                     int64_t pair_count, const hs_pair_options *options,
                                     hs_pair_cache caches[], hs_contact contacts[], int64_t *touching);
enum {
  HS_PART_FRICTION = 1,
  HS_PART_BONDS = 2,
  HS_PART_CONTACT_DAMPING = 4,
  HS_PART_AREA = 8,
  HS_PART_POTENTIAL = 16,
  HS_PART_STRAIN = 32,
  HS_PART_LOCAL_DAMPING = 64,
  HS_PART_MASS_DAMPING = 128,
  HS_PART_HARD_CONTACTS = 256,
  HS_PART_SLEEP = 512
};
typedef struct hs_world_plan {
  int32_t dimension;
  int32_t parts;
  int64_t fixed_count;
  int64_t prescribed_count;
  int64_t rigid_count;
  int64_t affine_count;
  int64_t candidate_count;
  int64_t contact_count;
  int64_t block_bytes;
  int64_t pair_bytes;
  double stable_time_step;
  hs_block limiting_block;
  hs_block limiting_neighbor;
  int64_t measured_steps;
  double search_seconds;
  double pair_seconds;
  double gather_seconds;
  double motion_seconds;
  double ledger_seconds;
  int64_t body_count;
  int64_t cell_count;
  int64_t node_count;
  int64_t bond_count;
  int64_t mesh_bytes;
  int64_t bond_bytes;
  int64_t limiting_bond;
  hs_body limiting_body;
  int64_t limiting_cell;
  double bond_seconds;
  double hard_contact_seconds;
} hs_world_plan;
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_plan(const hs_world *world, int64_t steps, hs_world_plan *plan, size_t size);
enum {
  HS_UNBALANCED_MEAN = 0,
  HS_UNBALANCED_LARGEST = 1
};
typedef struct hs_relaxation_def {
  uint32_t struct_size;
  int32_t measure;
  double ratio;
  int64_t max_steps;
  double local_damping;
  int32_t is_adaptive;
  int32_t hold_bonds;
} hs_relaxation_def;
typedef struct hs_balance {
  double mean;
  double largest;
  double largest_force;
  int64_t steps;
  hs_block largest_force_block;
} hs_balance;
__attribute__((visibility("default"))) hs_status hs_relaxation_def_init(hs_relaxation_def *def, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_relax(hs_world *world, const hs_relaxation_def *def, hs_balance *balance, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_get_balance(hs_world *world, hs_balance *balance, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_gravity(hs_world *world, const double gravity[3]);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_damping(hs_world *world, double local_damping, double mass_damping);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_time_step(hs_world *world, double time_step);
typedef struct hs_strength_def {
  uint32_t struct_size;
  int32_t reserved;
  double low;
  double high;
  double resolution;
  double ratio;
  double max_displacement;
  int64_t max_steps;
} hs_strength_def;
typedef struct hs_strength_report {
  double factor;
  double low;
  double high;
  int32_t stands_at_low;
  int32_t falls_at_high;
  int32_t trials;
  int32_t reserved;
} hs_strength_report;
__attribute__((visibility("default"))) hs_status hs_strength_def_init(hs_strength_def *def, size_t size);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_set_strength_factor(hs_world *world, double factor);
__attribute__((visibility("default"))) __attribute__((warn_unused_result)) hs_status hs_world_find_strength_factor(const hs_world *world, const hs_strength_def *def, hs_strength_report *report,
                                                   size_t size, hs_world **fallen);
