!> Ids of blocks.
module halfspace_blocks
  use, intrinsic :: iso_c_binding, only: c_int64_t
  implicit none
  private
  public :: halfspace_block, id_of, operator(==), operator(/=)

  !> Id of a block of a world. The default is no block; ids of removed blocks are not reused.
  type, bind(c) :: halfspace_block
    private
    integer(c_int64_t) :: id = 0
  end type halfspace_block

  interface operator(==)
    module procedure same_block
  end interface operator(==)

  interface operator(/=)
    module procedure other_block
  end interface operator(/=)

contains

  elemental logical function same_block(a, b)
    type(halfspace_block), intent(in) :: a, b
    same_block = a%id == b%id
  end function same_block

  elemental logical function other_block(a, b)
    type(halfspace_block), intent(in) :: a, b
    other_block = a%id /= b%id
  end function other_block

  elemental integer(c_int64_t) function id_of(block)
    type(halfspace_block), intent(in) :: block
    id_of = block%id
  end function id_of

end module halfspace_blocks
