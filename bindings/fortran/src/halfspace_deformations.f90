!> How blocks are turned and strained, and tensors as the C interface takes them: row by row.
module halfspace_deformations
  use, intrinsic :: iso_c_binding, only: c_double
  use halfspace_errors, only: refuse
  implicit none
  private
  public :: halfspace_deformation, count_rows_first, is_tensor, nine_of

  !> hs_deformation byte for byte, with tensors as they are written: t(row, column). In 2D xx, xy, yx and yy count; the
  !! others are 0, but zz of a gradient 1.
  type, bind(c) :: halfspace_deformation
    !> from places in the shape's frame to places about the centroid; else a rotation
    real(c_double) :: gradient(3, 3) = 0
    real(c_double) :: rate(3, 3) = 0  !< of the gradient, 1/s
    real(c_double) :: strain(3, 3) = 0  !< Green's, from the shape as it was given, in the shape's frame; else 0
    real(c_double) :: stress(3, 3) = 0  !< Cauchy's, elastic, in space, Pa, tension > 0; else 0
    real(c_double) :: strain_energy = 0  !< J, in 2D per unit thickness; 0 without stress
  end type halfspace_deformation

contains

  !> The library writes tensors row by row into what is column by column here.
  elemental subroutine count_rows_first(deformation)
    type(halfspace_deformation), intent(inout) :: deformation
    deformation%gradient = transpose(deformation%gradient)
    deformation%rate = transpose(deformation%rate)
    deformation%strain = transpose(deformation%strain)
    deformation%stress = transpose(deformation%stress)
  end subroutine count_rows_first

  !> A tensor has 3 rows and columns, or 2 as in the plane; another array is refused here.
  logical function is_tensor(values, name, stat, errmsg)
    real(c_double), intent(in) :: values(:,:)
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(len(name) + 80) :: text
    is_tensor = size(values, 1) == size(values, 2) .and. (size(values, 1) == 2 .or. size(values, 1) == 3)
    if (is_tensor) return
    write (text, '(a, ": has ", i0, " rows and ", i0, " columns, not 2 and 2 or 3 and 3")') name, shape(values)
    call refuse(trim(text), stat, errmsg)
  end function is_tensor

  !> Row by row; what the plane does not have is 0.
  pure function nine_of(tensor) result(nine)
    real(c_double), intent(in) :: tensor(:,:)
    real(c_double) :: nine(9), whole(3, 3)
    whole = 0
    whole(:size(tensor, 1), :size(tensor, 2)) = tensor
    nine = reshape(transpose(whole), [9])
  end function nine_of

end module halfspace_deformations
