!> Stages, steps and what they give.
submodule(halfspace_worlds) halfspace_worlds_stages
  use halfspace_contacts, only: count_features_from_1, id_of
  use halfspace_errors, only: conclude, had_memory
  use halfspace_views, only: address_of, are_points, is_vector, mutable_view, three_of
  implicit none

contains

  module procedure detect
    call conclude(hs_world_detect(self%c_handle(), address_of(touching)), self%c_context(), stat, errmsg)
  end procedure detect

  module procedure forces
    type(hs_mutable_view) :: torques
    if (.not. are_points(force, 'force', rows, stat, errmsg)) return
    if (present(torque)) then
      if (.not. are_points(torque, 'torque', rows, stat, errmsg)) return
      torques = mutable_view(torque, rows)
    end if
    call conclude(hs_world_forces(self%c_handle(), elapsed, mutable_view(force, rows), torques), &
                  self%c_context(), stat, errmsg)
  end procedure forces

  module procedure step
    integer(c_int64_t) :: wanted
    wanted = 1
    if (present(steps)) wanted = steps
    call conclude(hs_world_step(self%c_handle(), wanted), self%c_context(), stat, errmsg)
  end procedure step

  module procedure report
    call conclude(hs_world_get_report(self%c_handle(), values, c_sizeof(values)), self%c_context(), &
                  stat, errmsg)
  end procedure report

  module procedure plan
    integer(c_int64_t) :: wanted
    wanted = 0
    if (present(steps)) wanted = steps
    call conclude(hs_world_get_plan(self%c_handle(), wanted, values, c_sizeof(values)), self%c_context(), &
                  stat, errmsg)
  end procedure plan

  module procedure contacts
    integer(c_int64_t), target :: count
    type(halfspace_contact), allocatable, target :: longer_or_shorter(:)
    logical :: fits
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_world_get_contacts(self%c_handle(), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      fits = .false.
      if (allocated(list)) fits = size(list, kind=c_int64_t) == count
      if (.not. fits) then
        allocate (longer_or_shorter(count), stat=failure)
        if (.not. had_memory(failure, stat, errmsg)) return
        call move_alloc(longer_or_shorter, list)
      end if
      status = hs_world_get_contacts(self%c_handle(), c_loc(list), count, c_null_ptr)
      call count_features_from_1(list)
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure contacts

  module procedure set_shear_force
    if (.not. is_vector(shear_force, 'shear_force', 2, stat, errmsg)) return
    call conclude(hs_world_set_shear_force(self%c_handle(), id_of(block_a), id_of(block_b), &
                                           three_of(shear_force)), self%c_context(), stat, errmsg)
  end procedure set_shear_force

end submodule halfspace_worlds_stages
