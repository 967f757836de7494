!> Contacts of a world by laws without a spring.
submodule(halfspace_bonded_worlds) halfspace_worlds_reactions
  use halfspace_errors, only: conclude, had_memory
  use halfspace_reactions, only: count_features_from_1
  implicit none

contains

  module procedure reactions
    integer(c_int64_t), target :: count
    type(halfspace_reaction), allocatable, target :: found(:)
    integer(c_int32_t) :: status
    integer :: failure
    status = hs_world_get_reactions(self%c_handle(), c_null_ptr, 0_c_int64_t, c_loc(count))
    if (status >= HS_OK) then
      allocate (found(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_get_reactions(self%c_handle(), c_loc(found), count, c_null_ptr)
      if (status == HS_OK) then
        call count_features_from_1(found)
        call move_alloc(found, list)
      end if
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end procedure reactions

  module procedure reaction_report
    call conclude(hs_world_get_reaction_report(self%c_handle(), values, c_sizeof(values)), self%c_context(), stat, &
                  errmsg)
  end procedure reaction_report

end submodule halfspace_worlds_reactions
