!> Ids of bodies of finite elements, and states of bodies and cells.
module halfspace_bodies
  use, intrinsic :: iso_c_binding, only: c_int64_t
  use halfspace_c, only: halfspace_body_state => hs_body_state
  use halfspace_records, only: halfspace_cell_state
  implicit none
  private
  public :: halfspace_body, halfspace_body_state, halfspace_cell_state, count_rows_first, id_of_body
  public :: operator(==), operator(/=)

  !> Id of a body of a world. The default is no body; ids of removed bodies are not reused.
  type, bind(c) :: halfspace_body
    private
    integer(c_int64_t) :: id = 0
  end type halfspace_body

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

  !> Transposes the tensors, which the library writes row by row.
  elemental subroutine count_rows_first(cell)
    type(halfspace_cell_state), intent(inout) :: cell
    cell%strain = transpose(cell%strain)
    cell%stress = transpose(cell%stress)
  end subroutine count_rows_first

end module halfspace_bodies
