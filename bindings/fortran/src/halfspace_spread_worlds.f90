!> Shares of a world, for hosts that spread one world over processes.
module halfspace_spread_worlds
  use, intrinsic :: iso_c_binding, only: c_double, c_int8_t, c_int32_t, c_int64_t, c_loc, c_null_ptr, c_ptr, c_size_t, &
    c_sizeof
  use halfspace_block_worlds, only: row_length_of, takes_world
  use halfspace_c, only: hs_world_assemble, hs_world_get_loads, hs_world_get_share_info, hs_world_pack, &
    hs_world_set_loads, HS_OK, HS_ROLE_OWN, halfspace_packed => hs_packed, halfspace_share_info => hs_share_info
  use halfspace_errors, only: conclude, had_memory, refuse
  use halfspace_plane_worlds, only: plane_world
  implicit none
  private
  public :: halfspace_packed, halfspace_share_info, spread_world

  !> halfspace_packed(key, role, bytes): a block of a share to be assembled.
  interface halfspace_packed
    module procedure packed
  end interface

  !> A world of which each process holds a share: its own blocks, copies of their neighbours, and the fixed and
  !! prescribed blocks, which are everywhere. All processes make the same calls, and the host carries packed blocks and
  !! loads between them, as by MPI:
  !!
  !!     plan --> does any need a list or an assembly? -- yes: pack, carry, assemble, plan; renew the lists
  !!       `----> move --> loads, carry, set_loads --> end_step
  !!
  !! The motion has the same bits as by step() of the whole world, for any number of shares. Shares hold rigid and
  !! affine blocks, laws with springs and potential laws, water and applied forces; the world needs a given time step.
  !! halfspace_world extends it.
  type, extends(plane_world) :: spread_world
  contains
    procedure :: share_info
    procedure :: pack => pack_blocks
    procedure :: assemble
    procedure :: loads
    procedure :: set_loads
  end type spread_world

contains

  !> It refers to the bytes, which must keep their place until assemble() returns: pass a variable or a contiguous
  !! section of one, with the attribute target.
  function packed(key, role, bytes)
    integer(c_int64_t), intent(in) :: key  !< name of the block in all shares
    integer(c_int32_t), intent(in), optional :: role  !< HS_ROLE_OWN (default), _NEIGHBOR or _EVERYWHERE
    !> from pack() of the share that owns the block; default: as the world that assembles the share has it, of which the
    !! block is its own or everywhere
    integer(c_int8_t), intent(in), target, contiguous, optional :: bytes(:)
    type(halfspace_packed) :: packed
    packed%key = key
    packed%role = HS_ROLE_OWN
    if (present(role)) packed%role = role
    if (.not. present(bytes)) return
    packed%bytes = c_loc(bytes)
    packed%size = size(bytes, kind=c_size_t)
  end function packed

  !> Numbers of blocks, and how far copies must reach, after plan_motion().
  subroutine share_info(self, info, stat, errmsg)
    class(spread_world), intent(in) :: self
    type(halfspace_share_info), intent(out) :: info
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call conclude(hs_world_get_share_info(self%c_handle(), info, c_sizeof(info)), self%c_context(), stat, errmsg)
  end subroutine share_info

  !> Packs own blocks, or blocks that are everywhere: their motion, and the memory of their pairs, in the machine's
  !! format of numbers. HS_ERROR_STALE_ID if no such block has a key.
  subroutine pack_blocks(self, keys, bytes, ends, with_shapes, stat, errmsg)
    class(spread_world), intent(in) :: self
    integer(c_int64_t), intent(in), target, contiguous :: keys(:)  !< in any order
    integer(c_int8_t), intent(inout), allocatable, target :: bytes(:)  !< of all blocks, one after the other
    integer(c_size_t), intent(inout), allocatable, target :: ends(:)  !< index of the last byte of each block
    logical, intent(in), optional :: with_shapes  !< default .true.: with outlines, for shares without the block
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int8_t), allocatable, target :: written(:)
    integer(c_size_t), allocatable, target :: last(:)
    integer(c_size_t) :: needed, again
    integer(c_int64_t) :: count
    integer(c_int32_t) :: shapes, status
    integer :: failure
    shapes = 1
    if (present(with_shapes)) shapes = merge(1, 0, with_shapes)
    count = size(keys, kind=c_int64_t)
    needed = 0
    status = hs_world_pack(self%c_handle(), c_loc(keys), count, shapes, c_null_ptr, 0_c_size_t, c_null_ptr, needed)
    if (status >= HS_OK) then
      allocate (written(needed), last(count), stat=failure)
      if (.not. had_memory(failure, stat, errmsg)) return
      status = hs_world_pack(self%c_handle(), c_loc(keys), count, shapes, c_loc(written), needed, c_loc(last), again)
      if (status == HS_OK) then
        call move_alloc(written, bytes)
        call move_alloc(last, ends)
      end if
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine pack_blocks

  !> Makes a world of blocks, in the same context: a share, or the whole world again where all its blocks are own ones.
  !! Settings, laws, clock, list of pairs and losses are those of self, which does not change. HS_ERROR_STATE if it has
  !! what shares cannot hold, HS_ERROR_FORMAT for damaged bytes.
  subroutine assemble(self, blocks, share, stat, errmsg)
    class(spread_world), intent(in) :: self
    !> in ascending order of keys: all own blocks of the share, copies of all blocks within its halo, packed in the
    !! present motion, and all blocks that are everywhere
    type(halfspace_packed), intent(in), target, contiguous :: blocks(:)
    class(spread_world), intent(inout) :: share  !< another variable than self; it may be assigned to it afterwards
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: object
    integer(c_int32_t) :: status
    status = hs_world_assemble(self%c_context(), self%c_handle(), c_loc(blocks), size(blocks, kind=c_int64_t), object)
    if (status == HS_OK) then
      if (.not. takes_world(share, object, self, stat, errmsg)) return
    end if
    call conclude(status, self%c_context(), stat, errmsg)
  end subroutine assemble

  !> Returns the loads of the contacts on own blocks, for the shares that have copies.
  subroutine loads(self, keys, values, stat, errmsg)
    class(spread_world), intent(in) :: self
    integer(c_int64_t), intent(in), target, contiguous :: keys(:)
    !> a column per key, of load_length numbers of share_info(): force, torque, and in worlds with elastic materials
    !! the virial
    real(c_double), intent(inout), target, contiguous :: values(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_loads(self, keys, values, stat, errmsg)) return
    call conclude(hs_world_get_loads(self%c_handle(), c_loc(keys), size(keys, kind=c_int64_t), c_loc(values)), &
                  self%c_context(), stat, errmsg)
  end subroutine loads

  !> Sets the loads of the contacts on copies, as loads() of their owner returned them.
  subroutine set_loads(self, keys, values, stat, errmsg)
    class(spread_world), intent(inout) :: self
    integer(c_int64_t), intent(in), target, contiguous :: keys(:)
    real(c_double), intent(in), target, contiguous :: values(:,:)  !< a column per key
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. are_loads(self, keys, values, stat, errmsg)) return
    call conclude(hs_world_set_loads(self%c_handle(), c_loc(keys), size(keys, kind=c_int64_t), c_loc(values)), &
                  self%c_context(), stat, errmsg)
  end subroutine set_loads

  !> Have the loads a column per key, as long as the library's? Refuses others.
  logical function are_loads(self, keys, values, stat, errmsg)
    class(spread_world), intent(in) :: self
    integer(c_int64_t), intent(in) :: keys(:)
    real(c_double), intent(in) :: values(:,:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer :: length
    character(120) :: text
    length = row_length_of(self)
    are_loads = length == 0 .or. (size(values, 1) == length .and. size(values, 2) == size(keys))
    if (are_loads) return  ! without a world the library refuses
    write (text, '("values: has the shape (", i0, ", ", i0, "); it must be (", i0, ", ", i0, ")")') &
      shape(values), length, size(keys)
    call refuse(trim(text), stat, errmsg)
  end function are_loads

end module halfspace_spread_worlds
