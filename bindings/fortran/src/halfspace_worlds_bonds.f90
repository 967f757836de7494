!> Bonds of a world.
submodule(halfspace_bonded_worlds) halfspace_worlds_bonds
  use halfspace_bonds, only: count_from_1
  use halfspace_contacts, only: id_of
  use halfspace_errors, only: conclude, had_memory
  use halfspace_views, only: address_of
  implicit none

contains

  module procedure bond_blocks
    call conclude(hs_world_bond_blocks(self%c_handle(), id_of(block_a), id_of(block_b), bond), self%c_context(), &
                  stat, errmsg)
  end procedure bond_blocks

  module procedure bond_materials
    if (present(count)) count = 0
    call conclude(hs_world_bond_materials(self%c_handle(), material_a - 1, material_b - 1, bond, address_of(count)), &
                  self%c_context(), stat, errmsg)
  end procedure bond_materials

  module procedure keep_bonds
    call conclude(hs_world_hold_bonds(self%c_handle(), merge(1_c_int32_t, 0_c_int32_t, are_held)), self%c_context(), &
                  stat, errmsg)
  end procedure keep_bonds

  module procedure bonds
    integer(c_int64_t), target :: count
    type(halfspace_bond_state), allocatable, target :: longer_or_shorter(:)
    logical :: fits
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_world_get_bonds(self%c_handle(), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      fits = .false.
      if (allocated(list)) fits = size(list, kind=c_int64_t) == count
      if (.not. fits) then
        allocate (longer_or_shorter(count), stat=failure)
        if (.not. had_memory(failure, stat, errmsg)) return
        call move_alloc(longer_or_shorter, list)
      end if
      status = hs_world_get_bonds(self%c_handle(), c_loc(list), count, c_null_ptr)
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure bonds

  module procedure bond_events
    integer(c_int64_t) :: from_0
    integer(c_int64_t), target :: count
    type(halfspace_bond_event), allocatable, target :: found(:)
    integer(c_int32_t) :: status
    integer :: failure
    from_0 = 0
    if (present(first)) from_0 = first - 1
    status = hs_world_get_bond_events(self%c_handle(), from_0, c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      allocate (found(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_get_bond_events(self%c_handle(), from_0, c_loc(found), count, c_null_ptr)
      if (status == HS_OK) then
        call count_from_1(found)
        call move_alloc(found, list)
      end if
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure bond_events

  module procedure bond_report
    call conclude(hs_world_get_bond_report(self%c_handle(), values, c_sizeof(values)), self%c_context(), stat, errmsg)
  end procedure bond_report

end submodule halfspace_worlds_bonds
