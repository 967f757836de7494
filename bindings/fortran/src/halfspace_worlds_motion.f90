!> Poses and velocities of blocks.
submodule(halfspace_block_worlds) halfspace_worlds_motion
  use halfspace_contacts, only: id_of
  use halfspace_errors, only: conclude, had_memory
  use halfspace_views, only: address_of, are_points, is_vector, mutable_view, three_of, view
  implicit none

contains

  module procedure blocks
    integer(c_int64_t), target :: count
    type(halfspace_block), allocatable, target :: found(:)
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_world_get_blocks(self%handle%object(), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      allocate (found(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_get_blocks(self%handle%object(), c_loc(found), count, c_null_ptr)
      if (status == HS_OK) call move_alloc(found, names)
    end if
    call conclude(status, self%handle%context(), stat, errmsg)
  end procedure blocks

  module procedure block_count
    integer(c_int64_t), target :: found
    count = 0
    if (hs_world_get_blocks(self%handle%object(), c_null_ptr, 0_c_int64_t, c_loc(found)) >= HS_OK) count = found
  end procedure block_count

  module procedure block_state
    integer(c_int32_t) :: status
    status = hs_world_get_block_state(self%handle%object(), id_of(block), state)
    if (status == HS_OK) state%material = state%material + 1
    call conclude(status, self%handle%context(), stat, errmsg)
  end procedure block_state

  module procedure block_states
    integer(c_int32_t) :: status
    status = hs_world_get_block_states(self%handle%object(), c_loc(states), size(states, kind=c_int64_t), c_null_ptr)
    if (status >= HS_OK) states%material = states%material + 1
    call conclude(status, self%handle%context(), stat, errmsg)
  end procedure block_states

  module procedure block_vertices
    if (.not. are_points(points, 'points', rows, stat, errmsg)) return
    call conclude(hs_world_get_block_vertices(self%handle%object(), id_of(block), mutable_view(points, rows), &
                                              address_of(count)), self%handle%context(), stat, errmsg)
  end procedure block_vertices

  module procedure set_pose
    call conclude(hs_world_set_pose(self%handle%object(), id_of(block), pose), self%handle%context(), stat, errmsg)
  end procedure set_pose

  module procedure set_velocity
    real(c_double) :: spin(3)
    if (.not. is_vector(velocity, 'velocity', 2, stat, errmsg)) return
    spin = 0
    if (present(angular_velocity)) then
      if (.not. is_vector(angular_velocity, 'angular_velocity', 1, stat, errmsg)) return
      spin = three_of(angular_velocity)
    end if
    call conclude(hs_world_set_velocity(self%handle%object(), id_of(block), three_of(velocity), spin), &
                  self%handle%context(), stat, errmsg)
  end procedure set_velocity

  module procedure set_applied_force
    real(c_double) :: turning(3)
    if (.not. is_vector(force, 'force', 2, stat, errmsg)) return
    turning = 0
    if (present(torque)) then
      if (.not. is_vector(torque, 'torque', 1, stat, errmsg)) return
      turning = three_of(torque)
    end if
    call conclude(hs_world_set_applied_force(self%handle%object(), id_of(block), three_of(force), turning), &
                  self%handle%context(), stat, errmsg)
  end procedure set_applied_force

  module procedure poses
    call conclude(hs_world_get_poses(self%handle%object(), c_loc(values), size(values, kind=c_int64_t), c_null_ptr), &
                  self%handle%context(), stat, errmsg)
  end procedure poses

  module procedure set_poses
    call conclude(hs_world_set_poses(self%handle%object(), c_loc(values), size(values, kind=c_int64_t)), &
                  self%handle%context(), stat, errmsg)
  end procedure set_poses

  module procedure velocities
    type(hs_mutable_view) :: spins
    if (.not. are_points(linear, 'linear', rows, stat, errmsg)) return
    if (present(angular)) then
      if (.not. are_points(angular, 'angular', rows, stat, errmsg)) return
      spins = mutable_view(angular, rows)
    end if
    call conclude(hs_world_get_velocities(self%handle%object(), mutable_view(linear, rows), spins), &
                  self%handle%context(), stat, errmsg)
  end procedure velocities

  module procedure set_velocities
    type(hs_view) :: spins
    if (.not. are_points(linear, 'linear', rows, stat, errmsg)) return
    if (present(angular)) then
      if (.not. are_points(angular, 'angular', rows, stat, errmsg)) return
      spins = view(angular, rows)
    end if
    call conclude(hs_world_set_velocities(self%handle%object(), view(linear, rows), spins), self%handle%context(), &
                  stat, errmsg)
  end procedure set_velocities

  module procedure set_applied_forces
    type(hs_view) :: turning
    if (.not. are_points(force, 'force', rows, stat, errmsg)) return
    if (present(torque)) then
      if (.not. are_points(torque, 'torque', rows, stat, errmsg)) return
      turning = view(torque, rows)
    end if
    call conclude(hs_world_set_applied_forces(self%handle%object(), view(force, rows), turning), &
                  self%handle%context(), stat, errmsg)
  end procedure set_applied_forces

end submodule halfspace_worlds_motion
