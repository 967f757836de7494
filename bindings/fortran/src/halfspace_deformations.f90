!> Conversion of tensors to the row by row layout of the C interface.
module halfspace_deformations
  use, intrinsic :: iso_c_binding, only: c_double
  use halfspace_errors, only: refuse
  implicit none
  private
  public :: is_tensor, nine_of

contains

  !> True for 3 x 3 and 2 x 2 arrays; refuses others.
  logical function is_tensor(values, name, stat, errmsg)
    real(c_double), intent(in) :: values(:,:)
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(len(name) + 80) :: text
    is_tensor = size(values, 1) == size(values, 2) .and. (size(values, 1) == 2 .or. size(values, 1) == 3)
    if (is_tensor) return
    write (text, '(a, ": has ", i0, " rows and ", i0, " columns; it must have 2 x 2 or 3 x 3")') name, shape(values)
    call refuse(trim(text), stat, errmsg)
  end function is_tensor

  !> Nine values, row by row; components missing in 2D are 0.
  pure function nine_of(tensor) result(nine)
    real(c_double), intent(in) :: tensor(:,:)
    real(c_double) :: nine(9), whole(3, 3)
    whole = 0
    whole(:size(tensor, 1), :size(tensor, 2)) = tensor
    nine = reshape(transpose(whole), [9])
  end function nine_of

end module halfspace_deformations
