!> Ids of bodies of finite elements.
module halfspace_bodies
  use, intrinsic :: iso_c_binding, only: c_int64_t
  implicit none
  private
  public :: halfspace_body, id_of_body, operator(==), operator(/=)

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

end module halfspace_bodies
