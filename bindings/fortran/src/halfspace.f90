!> Fortran interface of libhalfspace: contact detection of convex blocks by half-space inclusion, and block dynamics.
!!
!! - Units: SI or any consistent set. Angles in radians. Right-handed axes. Quaternions are x, y, z, w.
!! - A normal points from block a to block b; a gap below 0 is an overlap.
!! - All indices start at 1: vertices, faces, edges, nodes, cells, materials, bodies, bonds. Indices in error texts of
!!   the library start at 0.
!! - stat= receives 0, a note > 0 (HS_NOTE_) or an error < 0, and errmsg= its text, as in allocate. Without stat=, a
!!   note or an error stops the program with the text. After an error nothing has changed, except steps and
!!   contacts of halfspace_detect_pairs() that were completed before it.
!! - halfspace_context, halfspace_shape, halfspace_mesh and halfspace_world are reference-counted owners: assignment
!!   adds a reference, and the last one to go out of scope destroys the object.
!! - A context and everything made from it must be used by one thread at a time.
module halfspace
  use halfspace_constants
  use halfspace_blocks, only: halfspace_block, operator(==), operator(/=)
  use halfspace_bodies, only: halfspace_body, operator(==), operator(/=)
  use halfspace_checks, only: halfspace_check_polygon, halfspace_check_polyhedron, halfspace_clean_polygon, &
    halfspace_clean_report, halfspace_fault
  use halfspace_contexts, only: halfspace_allocator, halfspace_context, halfspace_version
  use halfspace_definitions, only: halfspace_angle, halfspace_motion, halfspace_pose
  use halfspace_forwarding_worlds, only: halfspace_action, halfspace_block_state, halfspace_body_state, &
    halfspace_bond_event, halfspace_bond_report, halfspace_share_plan, halfspace_world_def, halfspace_world_report
  use halfspace_impacts, only: halfspace_impact, halfspace_time_of_impact
  use halfspace_meshes, only: halfspace_mesh, halfspace_mesh_properties
  use halfspace_pairs, only: halfspace_detect_pair, halfspace_detect_pairs, halfspace_pair_cache
  use halfspace_properties, only: halfspace_bolt, halfspace_bond, halfspace_elasticity, halfspace_law
  use halfspace_queries, only: halfspace_cast_ray, halfspace_find_box_pairs, halfspace_find_closest_points, &
    halfspace_order_along_curve
  use halfspace_records, only: halfspace_balance, halfspace_bolt_state, halfspace_bond_state, halfspace_cell_state, &
    halfspace_closest_points, halfspace_contact, halfspace_deformation, halfspace_note, halfspace_ray_hit, &
    halfspace_world_plan
  use halfspace_relaxed_worlds, only: halfspace_strength_report
  use halfspace_settings, only: halfspace_usual_range, halfspace_usual_text
  use halfspace_shapes, only: halfspace_fit_report, halfspace_shape, halfspace_shape_properties
  use halfspace_spread_worlds, only: halfspace_packed, halfspace_share_info
  use halfspace_worlds, only: halfspace_energy, halfspace_world
  implicit none
  public
end module halfspace
