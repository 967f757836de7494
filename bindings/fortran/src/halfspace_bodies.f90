!> Names of bodies of finite elements, and how these move and are strained.
module halfspace_bodies
  use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
  use halfspace_c, only: halfspace_body_state => hs_body_state
  implicit none
  private
  public :: halfspace_body, halfspace_body_state, halfspace_cell_state, count_rows_first, id_of_body
  public :: operator(==), operator(/=)

  !> Names a body of a world. One that was never set is no body; a removed body's never names another.
  type, bind(c) :: halfspace_body
    private
    integer(c_int64_t) :: id = 0
  end type halfspace_body

  !> hs_cell_state byte for byte, with tensors as they are written: t(row, column). In 2D xx, xy, yx and yy count; the
  !! others are 0. Strain and stress are means over the cell.
  type, bind(c) :: halfspace_cell_state
    real(c_double) :: strain(3, 3) = 0  !< Green's, from the cell as it was put into the world
    real(c_double) :: stress(3, 3) = 0  !< Cauchy's, elastic, in space, Pa, tension > 0
    real(c_double) :: strain_energy = 0  !< J, in 2D per unit thickness; with that of bending
  end type halfspace_cell_state

  interface operator(==)
    module procedure same_body
  end interface operator(==)

  interface operator(/=)
    module procedure other_body
  end interface operator(/=)

contains

  elemental logical function same_body(a, b)
    type(halfspace_body), intent(in) :: a, b
    same_body = a%id == b%id
  end function same_body

  elemental logical function other_body(a, b)
    type(halfspace_body), intent(in) :: a, b
    other_body = a%id /= b%id
  end function other_body

  elemental integer(c_int64_t) function id_of_body(body)
    type(halfspace_body), intent(in) :: body
    id_of_body = body%id
  end function id_of_body

  !> The library writes tensors row by row into what is column by column here.
  elemental subroutine count_rows_first(cell)
    type(halfspace_cell_state), intent(inout) :: cell
    cell%strain = transpose(cell%strain)
    cell%stress = transpose(cell%stress)
  end subroutine count_rows_first

end module halfspace_bodies
