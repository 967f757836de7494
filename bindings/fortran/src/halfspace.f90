!> Contact of convex blocks by half-space inclusion: libhalfspace in Fortran.
!!
!! - Units: SI or any consistent set. Angles in radians. Right-handed axes. Quaternions are x, y, z, w.
!! - A normal points from block a to block b; a gap below 0 is an overlap.
!! - Everything is counted from 1: vertices, faces, edges, nodes, cells, materials, bodies, bonds. Texts of errors come
!!   from the library and count from 0.
!! - stat= receives 0, a note > 0 (HS_NOTE_) or an error < 0, and errmsg= its text, as with allocate.
!!   Without stat=, both stop the program with the text. After an error nothing has changed but the contacts of
!!   halfspace_detect_pairs().
!! - halfspace_context, halfspace_shape, halfspace_mesh and halfspace_world own what they name and end it when the last
!!   copy goes out of scope. Assignment shares.
!! - A context and everything made from it belong to one thread at a time.
module halfspace
  use halfspace_c, only: &
    HS_OK, HS_NOTE_TRUNCATED, HS_NOTE_NOT_AT_REST, HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY, HS_ERROR_STALE_ID, &
    HS_ERROR_OUT_OF_MEMORY, HS_ERROR_STATE, HS_ERROR_UNSTABLE, HS_ERROR_TOO_FAST, HS_ERROR_FORMAT, &
    HS_ERROR_INTERNAL, HS_ERROR_INVERTED, HS_CONTACT_NONE, HS_CONTACT_VERTEX_VERTEX, HS_CONTACT_VERTEX_EDGE, &
    HS_CONTACT_EDGE_EDGE, HS_CONTACT_EDGE_FACE, HS_CONTACT_FACE_FACE, HS_CONTACT_VERTEX_FACE, HS_PAIR_FACE_VERTEX, &
    HS_PAIR_VERTEX_FACE, HS_PAIR_EDGE_EDGE, HS_PAIR_VERTEX_VERTEX, HS_CONTACT_POINTS, HS_STIFFNESS_PER_CONTACT, &
    HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL, HS_STIFFNESS_NONE, HS_PLANE_STRAIN, HS_PLANE_STRESS, HS_FAULT_NONE, &
    HS_FAULT_TOO_FEW_VERTICES, HS_FAULT_NOT_FINITE, HS_FAULT_REPEATED_VERTEX, HS_FAULT_COLLINEAR_VERTEX, &
    HS_FAULT_NOT_CONVEX, HS_FAULT_SELF_CROSSING, HS_FAULT_ZERO_AREA, HS_FAULT_FEWER_THAN_FOUR, &
    HS_FAULT_FACE_TOO_SHORT, HS_FAULT_NO_SUCH_VERTEX, HS_FAULT_VERTEX_TWICE_IN_FACE, HS_FAULT_UNUSED_VERTEX, &
    HS_FAULT_UNMATCHED_EDGE, HS_FAULT_VERTEX_INSIDE_EDGE, HS_FAULT_NOT_ONE_SURFACE, HS_FAULT_OUT_OF_RANGE, &
    HS_FAULT_COINCIDING_VERTICES, HS_FAULT_ZERO_VOLUME, HS_FAULT_FACE_WITHOUT_AREA, HS_FAULT_FACE_NOT_PLANE, &
    HS_FAULT_VERTEX_OUTSIDE_FACE, HS_FAULT_COPLANAR_FACES, HS_FAULT_HULL_FAILED, HS_FAULT_NO_DIRECTION, &
    HS_FAULT_UNBOUNDED, HS_FAULT_NO_COMMON_POINT, HS_FAULT_BEYOND_TOLERANCE, HS_BLOCK_FIXED, &
    HS_BLOCK_PRESCRIBED, HS_BLOCK_RIGID, HS_BLOCK_AFFINE, HS_BLOCK_MESH, HS_CELL_TRIANGLE, &
    HS_CELL_QUAD, HS_CELL_TETRAHEDRON, HS_CELL_PRISM, HS_CELL_HEXAHEDRON, HS_AXIS_X, HS_AXIS_Y, HS_AXIS_Z, &
    HS_IMPACT_NEVER, HS_IMPACT_AT_START, HS_IMPACT_TOUCH, HS_FAST_DIVIDE, HS_FAST_REFUSE, HS_PART_FRICTION, &
    HS_PART_BONDS, HS_PART_CONTACT_DAMPING, HS_PART_AREA, HS_PART_POTENTIAL, HS_PART_STRAIN, &
    HS_PART_LOCAL_DAMPING, HS_PART_MASS_DAMPING, HS_PART_HARD_CONTACTS, HS_PART_SLEEP, HS_BOND_HOLDS, &
    HS_BOND_TENSION, HS_BOND_SHEAR, HS_UNBALANCED_MEAN, HS_UNBALANCED_LARGEST
  use halfspace_bodies, only: halfspace_body, halfspace_body_state, halfspace_cell_state, operator(==), operator(/=)
  use halfspace_bonded_worlds, only: halfspace_balance, halfspace_strength_report
  use halfspace_bonds, only: halfspace_bond, halfspace_bond_event, halfspace_bond_report, halfspace_bond_state
  use halfspace_checks, only: halfspace_check_polygon, halfspace_check_polyhedron, halfspace_clean_polygon, &
    halfspace_clean_report, halfspace_fault
  use halfspace_contacts, only: halfspace_block, halfspace_contact, operator(==), operator(/=)
  use halfspace_contexts, only: halfspace_allocator, halfspace_context, halfspace_version
  use halfspace_definitions, only: halfspace_angle, halfspace_elasticity, halfspace_law, &
    halfspace_motion, halfspace_pose
  use halfspace_deformations, only: halfspace_deformation
  use halfspace_impacts, only: halfspace_impact, halfspace_time_of_impact
  use halfspace_meshes, only: halfspace_mesh, halfspace_mesh_properties
  use halfspace_pairs, only: halfspace_detect_pair, halfspace_detect_pairs, halfspace_pair_cache
  use halfspace_shapes, only: halfspace_fit_report, halfspace_shape, halfspace_shape_properties
  use halfspace_worlds, only: halfspace_block_state, halfspace_energy, halfspace_world, halfspace_world_plan, &
    halfspace_world_report
  implicit none
  public
end module halfspace
