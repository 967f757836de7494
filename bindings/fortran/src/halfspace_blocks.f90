!> Ids of blocks.
module halfspace_blocks
  use, intrinsic :: iso_c_binding, only: c_int64_t
  use halfspace_errors, only: refuse
  implicit none
  private
  public :: halfspace_block, id_of, names_block, operator(==), operator(/=)

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

  !> The id of a block, or 0, which stands for all blocks, if it is absent. Refuses a block that was never added.
  logical function names_block(block, id, stat, errmsg)
    type(halfspace_block), intent(in), optional :: block
    integer(c_int64_t), intent(out) :: id
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    id = 0
    if (present(block)) id = id_of(block)
    names_block = id /= 0 .or. .not. present(block)
    if (.not. names_block) call refuse('block: is none; it must be of the world, or absent for all', stat, errmsg)
  end function names_block

end module halfspace_blocks
