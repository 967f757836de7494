!> End of a call: sets stat= and errmsg= as allocate does; without stat= an error stops the program with its text.
module halfspace_errors
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int32_t, c_ptr, c_size_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use halfspace_c, only: hs_context_last_error, hs_status_string, HS_ERROR_ARGUMENT, HS_ERROR_OUT_OF_MEMORY, HS_OK
  implicit none
  private
  public :: conclude, had_memory, refuse, text_at

  interface
    function strlen(text) bind(c)
      import
      type(c_ptr), value :: text
      integer(c_size_t) :: strlen
    end function strlen
  end interface

contains

  !> Ends a call whose C function has returned.
  subroutine conclude(status, context, stat, errmsg)
    integer(c_int32_t), intent(in) :: status
    type(c_ptr), intent(in) :: context  !< with the error text
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (present(stat)) stat = status
    if (status /= HS_OK) call tell(status, text_of(status, context), present(stat), errmsg)
  end subroutine conclude

  !> Ends a call without an error text of a context.
  subroutine refuse(text, stat, errmsg, status)
    character(*), intent(in) :: text
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t), intent(in), optional :: status  !< default: HS_ERROR_ARGUMENT
    integer(c_int32_t) :: refusal
    refusal = HS_ERROR_ARGUMENT
    if (present(status)) refusal = status
    if (present(stat)) stat = refusal
    call tell(refusal, text, present(stat), errmsg)
  end subroutine refuse

  !> True if allocate with stat=failure succeeded; otherwise ends the call.
  logical function had_memory(failure, stat, errmsg)
    integer, intent(in) :: failure
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    had_memory = failure == 0
    if (.not. had_memory) call refuse('there is no memory for the result', stat, errmsg, HS_ERROR_OUT_OF_MEMORY)
  end function had_memory

  subroutine tell(status, text, handled, errmsg)
    integer(c_int32_t), intent(in) :: status
    character(*), intent(in) :: text
    logical, intent(in) :: handled
    character(*), intent(inout), optional :: errmsg
    if (present(errmsg)) errmsg = text
    if (handled) return
    write (error_unit, '(a, " (status ", i0, ")")') text, status
    error stop
  end subroutine tell

  function text_of(status, context) result(text)
    integer(c_int32_t), intent(in) :: status
    type(c_ptr), intent(in) :: context
    character(:), allocatable :: text
    if (status > HS_OK) then
      text = text_at(hs_status_string(status))
    else if (c_associated(context)) then
      text = text_at(hs_context_last_error(context))
    else
      text = 'a context, shape, mesh or world was not created, or is a bitwise copy without assignment'
    end if
  end function text_of

  !> Copies a C string.
  function text_at(address) result(text)
    type(c_ptr), intent(in) :: address
    character(:), allocatable :: text
    character(kind=c_char), pointer :: characters(:)
    integer :: i
    call c_f_pointer(address, characters, [strlen(address)])
    allocate (character(size(characters)) :: text)
    do i = 1, size(characters)
      text(i:i) = characters(i)
    end do
  end function text_at

end module halfspace_errors
