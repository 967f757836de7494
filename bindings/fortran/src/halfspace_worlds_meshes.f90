!> Bodies of finite elements.
submodule(halfspace_worlds) halfspace_worlds_meshes
  use halfspace_bodies, only: count_rows_first, id_of_body
  use halfspace_contacts, only: id_of
  use halfspace_errors, only: conclude, refuse
  use halfspace_meshes, only: are_from_0, halfspace_mesh_properties
  use halfspace_views, only: address_of, are_points, is_vector, mutable_view, three_of, view
  implicit none

contains

  module procedure add_mesh
    type(hs_body_def) :: def
    integer(c_int32_t), allocatable, target :: from_0(:)
    type(c_ptr) :: materials
    integer(c_int32_t) :: status
    integer(c_int64_t) :: id
    if (present(velocity)) then
      if (.not. is_vector(velocity, 'velocity', 2, stat, errmsg)) return
    end if
    materials = c_null_ptr
    if (present(cell_materials)) then
      if (.not. are_one_for_each(cell_materials, mesh, stat, errmsg)) return
      if (.not. are_from_0(cell_materials, from_0, stat, errmsg)) return
      materials = c_loc(from_0)
    end if
    status = hs_body_def_init(def, c_sizeof(def))
    if (present(material)) def%material = material - 1
    if (present(pose)) def%pose = pose
    if (present(velocity)) def%velocity = three_of(velocity)
    status = hs_world_add_mesh(self%c_handle(), mesh%c_handle(), def, materials, id)
    if (status == HS_OK .and. present(body)) body = transfer(id, body)
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure add_mesh

  !> Is there one material per cell? C cannot check this. C refuses a missing mesh.
  logical function are_one_for_each(cell_materials, mesh, stat, errmsg)
    integer(c_int32_t), intent(in) :: cell_materials(:)
    type(halfspace_mesh), intent(in) :: mesh
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(halfspace_mesh_properties) :: properties
    character(100) :: text
    are_one_for_each = .not. mesh%exists()
    if (are_one_for_each) return
    call mesh%properties(properties, stat, errmsg)
    if (present(stat)) then
      if (stat /= HS_OK) return
    end if
    are_one_for_each = size(cell_materials, kind=c_int64_t) == properties%cell_count
    if (are_one_for_each) return
    write (text, '("cell_materials: has ", i0, " values; the mesh has ", i0, " cells")') &
      size(cell_materials), properties%cell_count
    call refuse(trim(text), stat, errmsg)
  end function are_one_for_each

  module procedure remove_body
    call conclude(hs_world_remove_body(self%c_handle(), id_of_body(body)), self%c_context(), stat, errmsg)
  end procedure remove_body

  module procedure body_state
    call conclude(hs_world_get_body_state(self%c_handle(), id_of_body(body), state, c_sizeof(state)), &
                  self%c_context(), stat, errmsg)
  end procedure body_state

  module procedure body_of_block
    integer(c_int32_t), target :: from_0
    integer(c_int32_t) :: status
    integer(c_int64_t) :: id
    status = hs_world_get_body_of_block(self%c_handle(), id_of(block), id, c_loc(from_0))
    if (present(cell)) cell = 0
    if (status == HS_OK) then
      body = transfer(id, body)
      if (present(cell)) cell = from_0 + 1
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure body_of_block

  module procedure node_positions
    if (.not. are_points(points, 'points', rows, stat, errmsg)) return
    call conclude(hs_world_get_node_positions(self%c_handle(), id_of_body(body), mutable_view(points, rows), &
                                              address_of(count)), self%c_context(), stat, errmsg)
  end procedure node_positions

  module procedure node_velocities
    if (.not. are_points(velocities, 'velocities', rows, stat, errmsg)) return
    call conclude(hs_world_get_node_velocities(self%c_handle(), id_of_body(body), mutable_view(velocities, rows), &
                                               address_of(count)), self%c_context(), stat, errmsg)
  end procedure node_velocities

  module procedure node_forces
    if (.not. are_points(forces, 'forces', rows, stat, errmsg)) return
    call conclude(hs_world_get_node_forces(self%c_handle(), id_of_body(body), mutable_view(forces, rows), &
                                           address_of(count)), self%c_context(), stat, errmsg)
  end procedure node_forces

  module procedure set_node_velocities
    if (.not. are_points(velocities, 'velocities', rows, stat, errmsg)) return
    call conclude(hs_world_set_node_velocities(self%c_handle(), id_of_body(body), view(velocities, rows)), &
                  self%c_context(), stat, errmsg)
  end procedure set_node_velocities

  module procedure hold_nodes
    integer(c_int32_t), allocatable, target :: from_0(:)
    real(c_double), target :: kept(3)
    kept = 0
    if (present(velocity)) then
      if (.not. is_vector(velocity, 'velocity', 2, stat, errmsg)) return
      kept = three_of(velocity)
    end if
    if (.not. are_from_0(nodes, from_0, stat, errmsg)) return
    call conclude(hs_world_hold_nodes(self%c_handle(), id_of_body(body), c_loc(from_0), &
                                      size(from_0, kind=c_int64_t), axes, c_loc(kept)), self%c_context(), stat, errmsg)
  end procedure hold_nodes

  module procedure set_node_force
    integer(c_int32_t), allocatable, target :: from_0(:)
    if (.not. is_vector(force, 'force', 2, stat, errmsg)) return
    if (.not. are_from_0(nodes, from_0, stat, errmsg)) return
    call conclude(hs_world_set_node_force(self%c_handle(), id_of_body(body), c_loc(from_0), &
                                          size(from_0, kind=c_int64_t), three_of(force)), self%c_context(), &
                  stat, errmsg)
  end procedure set_node_force

  module procedure remove_cells
    integer(c_int32_t), allocatable, target :: from_0(:)
    type(hs_mutable_view) :: room
    if (.not. are_from_0(cells, from_0, stat, errmsg)) return
    if (present(released)) then
      if (.not. are_points(released, 'released', rows, stat, errmsg)) return
      room = mutable_view(released, rows)
    end if
    call conclude(hs_world_remove_cells(self%c_handle(), id_of_body(body), c_loc(from_0), &
                                        size(from_0, kind=c_int64_t), room), self%c_context(), stat, errmsg)
  end procedure remove_cells

  module procedure set_body_stress
    real(c_double), target :: slopes(3,3,3)
    slopes = 0
    if (present(gradient)) slopes = gradient
    call conclude(hs_world_set_body_stress(self%c_handle(), id_of_body(body), stress, c_loc(slopes)), &
                  self%c_context(), stat, errmsg)
  end procedure set_body_stress

  module procedure cells
    integer(c_int64_t), target :: found
    integer(c_int32_t) :: status
    found = 0
    status = hs_world_get_cells(self%c_handle(), id_of_body(body), c_loc(values), size(values, kind=c_int64_t), &
                                c_loc(found))
    if (status >= HS_OK) call count_rows_first(values(:min(found, size(values, kind=c_int64_t))))
    if (present(count)) count = found
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure cells

end submodule halfspace_worlds_meshes
